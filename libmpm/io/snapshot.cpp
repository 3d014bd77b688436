#include "libmpm/io/snapshot.hpp"

#include "libmpm/io/fields.hpp"

namespace mpm {

Snapshot snapshot_of(const State& state, const Temperature& temperature) {
  const std::size_t n = state.particles.size();
  Snapshot s;
  s.time = state.time;
  s.step = state.step;
  for (const Vec2& x : state.particles.position) s.x.push_back(x.x()), s.y.push_back(x.y());
  for (const Field& field : fields()) {
    std::vector<double>& values = s.*field.values;
    values.reserve(n);
    for (std::size_t p = 0; p < n; ++p) values.push_back(field.of(state, p, temperature));
  }
  return s;
}

}  // namespace mpm
