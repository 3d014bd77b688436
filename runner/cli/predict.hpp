#pragma once
/// `mpmstudy predict STUDY --at KEY=VALUE ...`: what a result would be where there is no run, by a surface
/// through the runs of a study.
#include <string>
#include <vector>

#include "runner/cli/cli.hpp"

namespace mpmstudy {

struct Estimate;
struct ResultSurface;

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

/// The results to make surfaces of: those that are named, else those of the study's fits and figures.
std::vector<std::string> results_to_show(const Study&, const std::vector<std::string>& named);
/// "0.137 µm², 0.0566 to 0.218": an estimate and the ends of its interval, in one unit; `between`: before the
/// ends.
std::string interval_text(const Estimate&, const std::string& si_unit, const char* between);
/// "  from 24 runs; each left out: error 0.031 (rms) ...": what a surface is worth.
std::string quality_text(const ResultSurface&);

}  // namespace mpmstudy
