#pragma once
/// `mpmstudy predict STUDY --at KEY=VALUE ...`: what a result would be where there is no run, by a surface
/// through the runs of a study.
#include <string>
#include <vector>

#include "runner/cli/cli.hpp"

namespace mpmstudy {

struct PredictOptions {
  std::string name;             ///< of the study, or its file
  std::vector<std::string> at;  ///< "impact_speed=250 m/s"
  std::string points;           ///< a CSV file of many places; "": none
  std::vector<std::string> of;  ///< results; empty: what the study's fits and figures show
  std::string results;
  StudyOptions study;
  bool json = false;
};

void setup_predict(CLI::App&);
/// Throws StudyError, CatalogError.
int run_predict(const PredictOptions&);

}  // namespace mpmstudy
