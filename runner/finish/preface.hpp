#pragma once
/// What a report says before its studies: statements on their results, for example those of a publication,
/// and whether they hold. The program is given the function that makes it (runner/main.cpp); without one, a
/// report has its studies only.
#include <filesystem>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "analysis/page.hpp"
#include "runner/study/study.hpp"

namespace mpmstudy {

struct PrefaceRequest {
  std::filesystem::path results;
  /// Names of the studies that the report is of; where no files were given, of all that the catalog has, if
  /// only by name.
  std::set<std::string> shown;
  bool files_given = false;
  /// A study as its file says, without what --set changed of its physics; empty where neither the report nor
  /// the catalog has a file of this name. Throws StudyError.
  std::function<std::optional<Study>(const std::string& name)> as_written;
};

struct Preface {
  std::string title, subtitle;                  ///< of the page; title "": the names of the studies
  std::vector<analysis::PageSection> sections;  ///< before those of the studies
  std::string text;                             ///< what the verb prints: lines, each with its end
  std::string json = "[]\n";                    ///< ... with --json
};

using MakePreface = std::function<Preface(const PrefaceRequest&)>;

}  // namespace mpmstudy
