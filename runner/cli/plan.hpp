#pragma once
/// `mpmstudy plan FILE`: which jobs a study has, what they are, what they will cost. Runs nothing.
#include <string>

#include "runner/cli/cli.hpp"

namespace mpmstudy {

struct PlanOptions {
  std::string file;
  std::string results;  ///< its catalog, if there is one, says how fast this host is
  StudyOptions study;
  int workers = 0;  ///< 0: as many as there are processors
  bool json = false;
};
void setup_plan(CLI::App&);
int run_plan(const PlanOptions&);

}  // namespace mpmstudy
