#pragma once
/// `mpmstudy figures [STUDY...]`: draws the figures of studies from the catalog, without running anything:
/// those named, or all that the catalog has, each in the form of its last run.
#include <string>
#include <vector>

#include "runner/cli/cli.hpp"

namespace mpmstudy {

struct FiguresOptions {
  std::vector<std::string> files;
  std::string results;
  StudyOptions study;
};

void setup_figures(CLI::App&);
/// Throws StudyError, CatalogError, std::runtime_error (gnuplot, disk).
int run_figures(const FiguresOptions&);

}  // namespace mpmstudy
