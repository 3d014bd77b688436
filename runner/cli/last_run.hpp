#pragma once
/// The form in which a study was last run: its --set and --cells, which the catalog has recorded.
#include <optional>
#include <string>
#include <vector>

#include "runner/catalog/stored_jobs.hpp"
#include "runner/cli/cli.hpp"
#include "runner/plan/plan.hpp"

namespace mpmstudy {

/// A study file with the options that it is read with.
struct StudyForm {
  std::string path;
  StudyOptions options;
};

/// What a verb that reads the catalog shows of a study file: the form of its last run, unless --set or
/// --cells say another one. Says in one line on stderr which form that is, if it is not the file's own. With
/// `--set name=...` alone, the last run of the study with that name. Throws StudyError.
StudyForm last_form(const std::string& path, const StudyOptions&, const std::string& results);

/// A study of the catalog in the form of its last run. Where its file is gone, the one of the same name in a
/// folder directly below, if that is a file of the study. Empty: there is none.
std::optional<StudyForm> recorded_form(const StoredStudy&);

/// Every study that the catalog has a file of, in the form of its last run. A file that was moved is named on
/// stderr; so is a study whose file is gone, or is now a file of another study, which makes `complete` false.
std::vector<StudyForm> all_forms(const std::string& results, bool& complete);

/// The forms of the files named, or of all studies of the catalog where none is. Throws StudyError where two
/// of them have one name: their figures would have one folder.
std::vector<StudyForm> forms_of(const std::vector<std::string>& files, const StudyOptions&,
                                const std::string& results, bool& complete);

/// The form of a study that is given by the path of its file, or by its name in the catalog. Throws
/// StudyError.
StudyForm form_named(const std::string& study, const StudyOptions&, const std::string& results);

/// A form without what changes the physics of the file: only the options on cells, numerics, snapshots, the
/// tolerance of a search, and name and title stay. Statements on the results of a file are judged on this.
StudyForm as_written(StudyForm);

/// " --cells 1.4 --set impact_speed=\"150 m/s\"": as one would type it; "" for the file as it is.
std::string options_text(const std::vector<std::string>& set, double cells);

/// Before `run` registers a study: says in one line that it takes the place of one that another file has
/// registered under its name, and how many done jobs this form of it does not have. Nothing where neither is
/// so. `plan`: of the study; null for a search, whose jobs follow from what it finds. `only_planned`: of a
/// dry run, which changes nothing.
void say_what_is_replaced(const Study&, const Plan* plan, const StudyOptions&, const std::string& results,
                          bool only_planned);

/// For `plan`, which plans what `run` with the same options would run: says in one line that the catalog has
/// the study in another form, if it has.
void say_last_form(const Study&, const StudyOptions&, const std::string& results);

}  // namespace mpmstudy
