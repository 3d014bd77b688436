#pragma once
/// What a study wants: jobs with their keys and costs. Pure: no clock, no disk.
#include <string>
#include <vector>

#include "libmpm/scene/scene.hpp"
#include "runner/study/study.hpp"

namespace mpmstudy {

/// Canonical text of everything that decides a result: one "name=value" line per parameter of the scene's
/// kind, numbers as hexadecimal floats, in the order of libmpm/scene/parameters.hpp, and the physics version.
std::string canonical_text(const mpm::Scene&);

/// 32 hexadecimal digits: XXH3-128 of canonical_text. Same key, same result.
std::string job_key(const mpm::Scene&);

struct Job {
  std::string key;
  mpm::Scene scene;
  mpm::Estimate estimate;
  double predicted_seconds = 0;  ///< on one core of this machine
};

struct Plan {
  std::string study;
  std::vector<Job> jobs;  ///< order of the sweep, equal keys only once
};

/// What one core is taken to do until the catalog has seen jobs of this host [particle updates/s].
inline constexpr double assumed_updates_per_second = 5e6;

/// updates_per_second: particle updates a second and core that the prediction assumes.
Plan make_plan(const Study&, double updates_per_second = assumed_updates_per_second);

/// Sum of the predictions [s].
double cpu_seconds(const Plan&);

/// The predicted time of all jobs on `workers` threads, the longest job first [s].
double wall_seconds(const Plan&, int workers);

}  // namespace mpmstudy
