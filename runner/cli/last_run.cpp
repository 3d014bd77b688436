#include "runner/cli/last_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>
#include <set>

#include "runner/catalog/connection.hpp"
#include "runner/catalog/job_states.hpp"
#include "runner/catalog/stored_jobs.hpp"
#include "runner/plan/plan.hpp"
#include "runner/search/search_planner.hpp"
#include "runner/status/label.hpp"
#include "runner/study/moved.hpp"
#include "runner/study/schema.hpp"

namespace mpmstudy {
namespace {

namespace fs = std::filesystem;

/// "material.yield_stress=..." -> "yield_stress".
std::string key_of(const std::string& set) {
  const std::string key = set.substr(0, set.find('='));
  return key.substr(key.find('.') == std::string::npos ? 0 : key.find('.') + 1);
}

bool is_name(const std::string& set) { return key_of(set) == "name"; }

std::optional<StudySource> recorded_source(const std::string& results, const std::string& name) {
  if (!has_catalog(results)) return std::nullopt;
  for (StoredStudy& study : read_studies(results))
    if (study.name == name) return std::move(study.source);
  return std::nullopt;
}

/// A file that was moved is still the study's; another file that happens to have the name is not.
bool is_file_of(const std::string& path, const StudySource& source) {
  std::error_code error;
  return source.path.empty() || !fs::exists(source.path, error) || fs::equivalent(path, source.path, error);
}

StudyForm form_of(std::string path, StudySource source) {
  StudyOptions options;
  options.set = std::move(source.set);
  options.cells = source.cells;
  options.yes = true;  // it has been allowed once
  return {std::move(path), std::move(options)};
}

void check_names(const std::vector<StudyForm>& forms) {
  std::map<std::string, std::string> seen;
  for (const StudyForm& form : forms) {
    const std::string name = read_study(form.path, form.options).name;
    if (const auto [other, is_new] = seen.emplace(name, form.path); !is_new && other->second == form.path)
      throw StudyError(form.path + ": is given twice");
    else if (!is_new)
      throw StudyError(form.path + ": name = \"" + name + "\": is also the name of " + other->second +
                       "; studies that share a catalog have names of their own");
  }
}

std::string quoted(const std::string& text) {
  const bool plain = text.find_first_of(" '\"[]{}$") == std::string::npos;
  if (plain) return text;
  const char mark = text.find('\'') == std::string::npos ? '\'' : '"';
  return mark + text + mark;
}

}  // namespace

std::string options_text(const std::vector<std::string>& set, double cells) {
  std::string text;
  if (cells != 1) text += fmt::format(" --cells {:g}", cells);
  for (const std::string& one : set) text += " --set " + quoted(one);
  return text;
}

StudyForm last_form(const std::string& path, const StudyOptions& options, const std::string& results) {
  if (options.cells_told || !std::ranges::all_of(options.set, is_name)) return {path, options};
  const std::string name = read_study(path, options).name;
  const auto source = recorded_source(results, name);
  if (!source || !is_file_of(path, *source)) return {path, options};
  StudyForm form = form_of(path, *source);
  if (std::string text = options_text(form.options.set, form.options.cells); !text.empty())
    fmt::print(stderr, "{}: as it was last run, with{} (--cells 1 takes the file as it is)\n", name, text);
  return form;
}

std::optional<StudyForm> recorded_form(const StoredStudy& study) {
  std::error_code error;
  const std::string& path = study.source.path;
  if (path.empty()) return std::nullopt;
  if (fs::exists(path, error)) return form_of(path, study.source);
  for (const fs::path& file : same_name_below(path)) {
    StudyForm form = form_of(file.string(), study.source);
    try {
      if (read_study(form.path, form.options).name == study.name) return form;
    } catch (const StudyError&) {
      continue;  // a file that is no study, or of another kind, is not the one that was recorded
    }
  }
  return std::nullopt;
}

std::vector<StudyForm> all_forms(const std::string& results, bool& complete) {
  std::vector<StudyForm> forms;
  for (StoredStudy& study : read_studies(results)) {
    if (study.name.ends_with("-audit")) continue;  // runs of a search again; it has no file of its own
    StudyForm form = form_of(study.source.path, study.source);
    std::string wrong;
    try {
      if (const auto found = recorded_form(study); found && found->path != form.path) {
        fmt::print(stderr, "{}: {} is not there any longer; {} is taken in its place\n", study.name,
                   form.path, found->path);
        form = *found;
      }
      if (form.path.empty())
        wrong = "the catalog does not know its file";
      else if (!fs::exists(form.path))
        wrong = form.path + ": is not there any longer";
      else if (const std::string name = read_study(form.path, form.options).name; name != study.name)
        wrong = form.path + ": is now the file of " + name;
    } catch (const StudyError& error) {
      wrong = error.what();
    }
    if (wrong.empty()) {
      forms.push_back(std::move(form));
    } else {
      fmt::print(stderr, "{}: left out; {}\n", study.name, wrong);
      complete = false;
    }
  }
  return forms;
}

std::vector<StudyForm> forms_of(const std::vector<std::string>& files, const StudyOptions& options,
                                const std::string& results, bool& complete) {
  if (files.empty()) {
    if (options.cells_told || !options.set.empty())
      throw StudyError("--set, --cells: say of which study; give its file");
    return all_forms(results, complete);
  }
  std::vector<StudyForm> forms;
  for (const std::string& file : files) forms.push_back(last_form(file, options, results));
  check_names(forms);
  return forms;
}

StudyForm form_named(const std::string& name, const StudyOptions& options, const std::string& results) {
  if (fs::exists(name)) return last_form(name, options, results);
  if (options.cells_told || !options.set.empty())
    throw StudyError("--set, --cells: say of which file; " + name + " is none");
  std::string known;
  for (const StoredStudy& study : read_studies(results)) {
    known += (known.empty() ? "" : ", ") + study.name;
    if (study.name != name) continue;
    if (auto form = recorded_form(study)) return *form;
    throw StudyError(name + ": its file " + study.source.path + " is gone; give the path of its file");
  }
  throw StudyError(name + ": no such file, and no study of the catalog; it has: " + known);
}

StudyForm as_written(StudyForm form) {
  std::erase_if(form.options.set, [](const std::string& set) {
    const std::string key = key_of(set);
    const auto table = table_of(key);
    return !(table && *table == "numerics") && key != "snapshots" && key != "tolerance" && key != "name" &&
           key != "title";
  });
  return form;
}

void say_what_is_replaced(const Study& study, const Plan* plan, const StudyOptions& options,
                          const std::string& results, bool only_planned) {
  const auto before = recorded_source(results, study.name);
  if (!before) return;
  const bool own_file = is_file_of(study.path.string(), *before);
  const bool same = before->set == options.set && before->cells == options.cells;
  if (!plan && same && own_file) return;
  const auto done = keys_of(results, study.name, JobStatus::done);
  std::set<std::string> leave(done.begin(), done.end());
  if (plan)
    for (const Job& job : all_jobs(*plan)) leave.erase(job.key);
  else
    possible_scenes(study, [&](const std::string& key) { return leave.erase(key) > 0; });
  const auto leaving = std::ssize(leave);
  if (leaving == 0 && own_file) return;
  const std::string were = options_text(before->set, before->cells);
  std::string text = fmt::format("{}: {} the place of the study of this name that was run before{}",
                                 study.name, only_planned ? "would take" : "takes",
                                 !own_file      ? " from " + before->path + were
                                 : same         ? ", before its file was changed"
                                 : were.empty() ? " as its file is"
                                                : " with" + were);
  if (leaving > 0)
    text += fmt::format(": {} {} it, and its fits and figures {}", counted(leaving, "done job"),
                        only_planned   ? "would leave"
                        : leaving == 1 ? "leaves"
                                       : "leave",
                        only_planned ? "would be replaced" : "are replaced");
  fmt::print(stderr, "{}; `--set name=...` keeps both\n", text);
}

void say_last_form(const Study& study, const StudyOptions& options, const std::string& results) {
  const auto before = recorded_source(results, study.name);
  if (!before || (before->set == options.set && before->cells == options.cells)) return;
  const std::string were = options_text(before->set, before->cells);
  fmt::print(stderr, "{}: was last run{}; this is the plan of `mpmstudy run {}{}`\n", study.name,
             were.empty() ? " as its file is" : " with" + were, study.path.string(),
             options_text(options.set, options.cells));
}

}  // namespace mpmstudy
