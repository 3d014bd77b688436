#pragma once
/// `mpmstudy report [STUDY...]`: one self-contained HTML page from the catalog, and the table of claims. Of
/// the studies named, or of all that the catalog has, each in the form of its last run.
#include <string>
#include <vector>

#include "runner/cli/cli.hpp"

namespace mpmstudy {

struct ReportOptions {
  std::vector<std::string> files;
  std::string results;
  std::string output;  ///< "": report.html in the results folder
  bool json = false;   ///< print the claims as JSON
  StudyOptions study;
};

void setup_report(CLI::App&);
int run_report(const ReportOptions&);

}  // namespace mpmstudy
