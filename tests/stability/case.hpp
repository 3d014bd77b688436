#pragma once
/// One hard case and what came of it.
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "libmpm/simulation.hpp"

namespace stability {

/// What a case came to. Numbers that it does not have are 0.
struct Outcome {
  bool as_expected = false;
  std::string verdict;  ///< "held", "broke", "refused"
  std::string note;     ///< what else was measured, or why it broke
  std::int64_t particles = 0, steps = 0;
  double energy_error = 0;
  double smallest_density = 1, largest_density = 1;  ///< rho/rho0 over the run
  double largest_cfl = 0;
  double cpu_s = 0;
};

struct Case {
  std::string name;
  std::string variant;   ///< values of what the case sweeps; empty for one run
  std::string expected;  ///< "holds", "breaks", "refused"
  std::string why;       ///< why it is hard
  double cost = 0;       ///< estimated particle updates
  std::function<Outcome()> run;
};

/// The verdict and the health of a run, as expected if it is done with an energy error below the limit.
Outcome judge(const mpm::RunResult&, double largest_energy_error);

/// The studies of a folder that have an [expect]: a case a job. Throws if one cannot be read, or has none.
std::vector<Case> study_cases(const std::string& folder);

/// Bodies that no study describes: at rest for long, turning, flying, cut in two, alone, on the edges of
/// cells.
std::vector<Case> body_cases();

/// How long a step may be, for each scheme: measured against theory, and what becomes of longer ones.
std::vector<Case> step_limit_cases();

/// Runs that must give the same: in single precision, on several threads, scaled by powers of two, from
/// velocities that are next to nothing.
std::vector<Case> same_cases();

/// Scenes drawn from the whole range that find_problems() allows: of the kinds in plane strain; in three
/// dimensions; of bodies of one's own, in any space.
std::vector<Case> random_cases(int count, std::uint64_t seed);
std::vector<Case> random_solid_cases(int count, std::uint64_t seed);
std::vector<Case> random_body_cases(int count, std::uint64_t seed);

class Dice;
/// A case for each of so many legal scenes. Whatever comes of one, it is said: done with its health in order,
/// or failed with a reason; otherwise the note describes it.
std::vector<Case> drawn_cases(const std::string& name, int count, std::uint64_t seed,
                              const std::function<mpm::Scene(Dice&)>& draw,
                              const std::function<std::string(const mpm::Scene&)>& described);

}  // namespace stability
