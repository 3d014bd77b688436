#include "tests/stability/bodies.hpp"

#include <sstream>
#include <utility>

#include "libmpm/mpm.hpp"

namespace stability {

mpm::Scene frame(double speed, double cell, double end_time) {
  mpm::Scene s;
  s.kind = mpm::SceneKind::cavity_impact;
  s.material = mpm::named_material("aluminium");
  s.impact_speed = speed;
  s.numerics = mpm::default_numerics(s.kind);
  s.numerics.cell_size = cell;
  s.end_time = end_time;
  s.measures.area_every = end_time / 50;
  return s;
}

mpm::State nothing(mpm::Vec2 low, mpm::Vec2 cell, int columns) {
  return mpm::empty_state(low, cell, columns);
}

mpm::RunResult go(const mpm::Scene& scene, mpm::State& state) {
  mpm::Simulation simulation(scene, std::move(state));
  const mpm::RunResult result = simulation.run();
  state = simulation.state();
  return result;
}

Outcome also(Outcome o, bool fine, const std::string& note) {
  o.as_expected &= fine;
  o.note = o.note.empty() ? note : o.note + "; " + note;
  return o;
}

std::string text(const std::string& what, double value) {
  std::ostringstream t;
  t << what << " " << value;
  return t.str();
}

}  // namespace stability
