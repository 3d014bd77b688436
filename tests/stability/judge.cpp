#include "libmpm/verification/problems/scenes.hpp"
#include "tests/stability/case.hpp"

namespace stability {

using mpm::verification::scenes::metric;

Outcome judge(const mpm::RunResult& r, double largest_energy_error) {
  Outcome o;
  o.verdict = r.status == mpm::RunStatus::done ? "held" : "broke";
  o.note = r.reason;
  o.particles = r.particles;
  o.steps = r.steps;
  o.energy_error = r.energy_error;
  o.smallest_density = metric(r, "smallest_density_ratio", 1);
  o.largest_density = metric(r, "largest_density_ratio", 1);
  o.largest_cfl = metric(r, "largest_cfl", 0);
  o.as_expected = r.status == mpm::RunStatus::done && r.energy_error <= largest_energy_error;
  return o;
}

}  // namespace stability
