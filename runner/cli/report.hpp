#pragma once
/// `mpmstudy report [STUDY...]`: one self-contained HTML page from the catalog, and a table of the
/// statements that its preface judges, if it has one. Of the studies named, or of all that the catalog has,
/// each in the form of its last run.
#include <string>
#include <vector>

#include "runner/cli/cli.hpp"
#include "runner/finish/preface.hpp"

namespace mpmstudy {

struct ReportOptions {
  std::vector<std::string> files;
  std::string results;
  std::string output;  ///< "": report.html in the results folder
  bool json = false;   ///< print what the preface judges as JSON
  StudyOptions study;
};

/// What the program joins to a report.
struct ReportSeams {
  std::string of;  ///< what the preface judges, in the words of the help
  MakePreface make_preface;
};

void setup_report(CLI::App&, ReportSeams);
int run_report(const ReportOptions&, const MakePreface&);

}  // namespace mpmstudy
