#include "tests/stability/case.hpp"

namespace stability {

Outcome judge(const mpm::RunResult& r, double largest_energy_error) {
  const auto metric = [&](const char* name, double otherwise) {
    for (const mpm::Metric& m : r.metrics)
      if (m.name == name) return m.value;
    return otherwise;
  };
  Outcome o;
  o.verdict = r.status == mpm::RunStatus::done ? "held" : "broke";
  o.note = r.reason;
  o.particles = r.particles;
  o.steps = r.steps;
  o.energy_error = r.energy_error;
  o.smallest_density = metric("smallest_density_ratio", 1);
  o.largest_density = metric("largest_density_ratio", 1);
  o.largest_cfl = metric("largest_cfl", 0);
  o.as_expected = r.status == mpm::RunStatus::done && r.energy_error <= largest_energy_error;
  return o;
}

}  // namespace stability
