#pragma once
/// What a study wants: jobs with their keys and costs. Pure: no clock, no disk.
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "libmpm/scene/parameters.hpp"
#include "libmpm/scene/scene.hpp"
#include "runner/plan/cost_model.hpp"
#include "runner/study/study.hpp"

namespace mpmstudy {

/// Canonical text of everything that decides a result: one "name=value" line per parameter of the scene's
/// kind, numbers as hexadecimal floats, in the order of libmpm/scene/parameters.hpp, and the physics version.
/// Rows whose value is the implied one are left out. A parameter without an effect in this scene
/// (libmpm/scene/effect.hpp) has the same value in all of them.
std::string canonical_text(const mpm::Scene&, std::span<const mpm::Quantity> = mpm::quantities());
/// The same with every parameter as the scene has it: equal for equal scenes only.
std::string scene_text(const mpm::Scene&);

/// 32 hexadecimal digits: XXH3-128 of canonical_text. Same key, same result.
std::string job_key(const mpm::Scene&);

/// The key that programs gave the scene while parameters without an effect were part of it. Mostly the same.
std::string former_key(const mpm::Scene&);

struct Job {
  std::string key;
  mpm::Scene scene;
  mpm::Estimate estimate;
  double predicted_seconds = 0;  ///< on one core of this machine
  /// The position in its study of the job that this one is a coarser cell of; no number: it is a job of the
  /// study itself.
  std::optional<std::int64_t> rung_of = {};
  /// With rung_of: finer than the cells before it, and from now on the study's own job there.
  bool finer = false;
  std::string reason = {};  ///< why it is wanted, for people; the catalog keeps it
};

Job make_job(const mpm::Scene&, const CostModel& = {}, std::string reason = {});

struct Plan {
  std::string study;
  std::vector<Job> jobs;  ///< order of the sweep, equal keys only once
  /// Of every job, if the study asks for more than one cell: its rungs, coarse to fine. Without an accuracy
  /// the job is the last of them; with one it is the last that is always run, and finer ones may follow.
  std::vector<std::vector<Job>> ladders;
  LadderRequest ladder;
  CostModel cost;                    ///< that the predictions are of
  std::vector<Job> candidates = {};  ///< of which a [surface] may add some
};

Plan make_plan(const Study&, const CostModel& = {});

/// The scenes of a ladder, coarse to fine; those from `first_answer` on can be a job of the study itself, and
/// only they keep their snapshots.
struct LadderScenes {
  std::vector<mpm::Scene> scenes;
  std::size_t first_answer = 0;
};
LadderScenes ladder_scenes(const mpm::Scene&, const LadderRequest&);

/// What runs in any case: the jobs of the study, then the coarser cells under them; every key once.
std::vector<Job> first_jobs(const Plan&);
/// All that may run: beside those, the finer cells that an accuracy, and the places that a [surface] may ask
/// for. Every key once.
std::vector<Job> all_jobs(const Plan&);

/// Sum of the predictions [s].
double cpu_seconds(const std::vector<Job>&);
/// The same, with its interval.
Prediction total_cost(const CostModel&, const std::vector<Job>&);

/// The predicted time of jobs on `workers` threads, the longest job first [s].
double wall_seconds(const std::vector<Job>&, int workers);

}  // namespace mpmstudy
