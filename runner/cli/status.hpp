#pragma once
/// `mpmstudy status [STUDY...]`: how far the studies of a catalog are. Reads only.
#include <optional>
#include <string>
#include <vector>

#include "runner/catalog/garbage.hpp"
#include "runner/catalog/reader.hpp"
#include "runner/cli/cli.hpp"
#include "runner/slurm/queue.hpp"

namespace mpmstudy {

struct StatusOptions {
  std::vector<std::string> studies;  ///< names, or study files; none: all
  std::string results;
  bool json = false;
};

/// Names of studies, some of them said by their files. Throws StudyError for a file.
std::vector<std::string> study_names(const std::vector<std::string>& names_or_files);

/// What `status` says, from one moment.
struct StudiesReport {
  CatalogState state;
  std::vector<Submission> submissions;
  std::optional<DiskUse> disk;  ///< of a report that is made once, not again and again
  bool missed = false;  ///< a study has an accuracy that was not reached, or a search that found no bracket
  bool all = true;      ///< of every study

  /// The state of the studies: exit_stopped if jobs are planned or running, else exit_failed if jobs failed
  /// or something was missed, else exit_ok. Jobs that no study has do not count.
  int exit_code() const;
};
/// Throws CatalogError; StudyError for a file.
StudiesReport read_report(const StatusOptions&);
void print_report(const StudiesReport&, bool json);

void setup_status(CLI::App&);
/// Ends with the exit code of the report. Throws as read_report does.
int run_status(const StatusOptions&);

}  // namespace mpmstudy
