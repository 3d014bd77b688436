#include <cmath>
#include <cstring>

#include "libmpm/verification/problems/scenes.hpp"
#include "tests/stability/bodies.hpp"

namespace stability {
namespace {

using mpm::verification::scenes::metric;

/// A collapse, all the way.
mpm::Scene collapse(double speed) {
  mpm::Scene s = frame(speed, 0.1 * um, 6 * ns);
  s.block_width = 10 * um, s.block_height = 6 * um;
  s.cavity_radius = 1.5 * um, s.cavity_center_height = 3 * um;
  return s;
}

Outcome in_single_precision(double speed, double tolerance) {
  mpm::Scene s = collapse(speed);
  const mpm::RunResult exact = mpm::run(s);
  s.numerics.precision = mpm::Precision::single_precision;
  const mpm::RunResult single = mpm::run(s);
  const double off = metric(single, "largest_collapsibility") - metric(exact, "largest_collapsibility");
  return also(judge(single, 0.001), std::abs(off) < tolerance,
              text("largest collapsibility differs from double by", off));
}

bool same_bits(double a, double b) { return std::memcmp(&a, &b, sizeof a) == 0; }

/// Areas of b are those of a times the square of a scale that is a power of two.
bool same_history(const mpm::RunResult& a, const mpm::RunResult& b, double scale) {
  bool same = a.steps == b.steps && a.area_history.size() == b.area_history.size() &&
              same_bits(a.energy_error, b.energy_error);
  for (std::size_t k = 0; same && k < a.area_history.size(); ++k)
    same = same_bits(scale * scale * a.area_history[k].area, b.area_history[k].area);
  return same;
}

class Helped : public mpm::Observer {
 public:
  int threads() override { return 2; }
};

Outcome on_two_threads() {
  const mpm::Scene s = [] {
    mpm::Scene fine = collapse(1120);
    fine.numerics.cell_size = 0.05 * um;
    fine.end_time = 2 * ns;
    return fine;
  }();
  Helped helped;
  const mpm::RunResult two = mpm::run(s, helped);
  const bool same = two.helper_seconds > 0 && same_history(mpm::run(s), two, 1);
  return also(judge(two, 0.01), same, same ? "the same bits" : "other bits than on one");
}

Outcome scaled(double scale, mpm::Precision precision) {
  mpm::Scene s = collapse(500);
  s.numerics.precision = precision;
  const mpm::RunResult plain = mpm::run(s);
  for (double* length : {&s.block_width, &s.block_height, &s.cavity_radius, &s.cavity_center_height,
                         &s.numerics.cell_size, &s.end_time, &s.measures.area_every})
    *length *= scale;
  const mpm::RunResult r = mpm::run(s);
  const bool same = same_history(plain, r, scale);
  return also(judge(r, 0.01), same, same ? "the same bits, times the scale" : "not the same bits");
}

/// Velocities whose squares are next to nothing, or denormal numbers.
Outcome next_to_nothing(double speed) {
  mpm::Scene s = collapse(speed);
  s.numerics.cell_size = 0.2 * um;
  const mpm::RunResult r = mpm::run(s);
  return also(judge(r, 1), std::abs(*r.collapsibility) < 1e-6, text("collapsibility", *r.collapsibility));
}

/// Energies are less than the least number of single precision: their balance says so.
Outcome below_single_precision() {
  mpm::Scene s = collapse(1e-30);
  s.numerics.precision = mpm::Precision::single_precision;
  const mpm::RunResult r = mpm::run(s);
  Outcome o = judge(r, 0);
  o.as_expected = r.status == mpm::RunStatus::failed && r.reason.starts_with("energy error");
  return o;
}

}  // namespace

std::vector<Case> same_cases() {
  constexpr auto twice = mpm::Precision::double_precision, single = mpm::Precision::single_precision;
  const auto small = [](double speed) { return [=] { return next_to_nothing(speed); }; };
  const auto copy = [](double scale, mpm::Precision p) { return [=] { return scaled(scale, p); }; };
  return {
      {"float against double", "200 m/s", "holds", "positions and densities in seven digits", 4e7,
       [] { return in_single_precision(200, 1e-4); }},
      {"float against double", "1120 m/s", "holds", "the cavity closes: small errors grow", 6e7,
       [] { return in_single_precision(1120, 1e-2); }},
      {"threads", "two", "holds", "sums in a fixed order", 5e7, on_two_threads},
      {"scaled", "2^20, double", "holds", "no length or time of our own is hidden in it", 8e7,
       copy(0x1p20, twice)},
      {"scaled", "2^-20, double", "holds", "no length or time of our own is hidden in it", 8e7,
       copy(0x1p-20, twice)},
      {"scaled", "2^20, float", "holds", "numbers leave the range of single precision", 8e7,
       copy(0x1p20, single)},
      {"scaled", "2^-20, float", "holds", "numbers leave the range of single precision", 8e7,
       copy(0x1p-20, single)},
      {"next to nothing", "1e-30 m/s, double", "holds", "squares are 1e-60", 1e7, small(1e-30)},
      {"next to nothing", "1e-160 m/s, double", "holds", "squares are denormal", 1e7, small(1e-160)},
      {"next to nothing", "1e-30 m/s, float", "breaks",
       "squares are nothing in single precision: must be said", 1e7, [] { return below_single_precision(); }},
  };
}

}  // namespace stability
