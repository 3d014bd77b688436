#include "libmpm/io/snapshot.hpp"

#include "libmpm/io/fields.hpp"

namespace mpm {

template <int axes>
Snapshot snapshot_of(const BasicState<axes>& state, std::span<const Temperature> temperatures) {
  const std::size_t n = state.particles.size();
  Snapshot s;
  s.time = state.time;
  s.step = state.step;
  for (const Vec<axes>& x : state.particles.position) {
    s.x.push_back(x.x()), s.y.push_back(x.y());
    if constexpr (axes == 3) s.z.push_back(x.z());
  }
  for (const Field& field : fields()) {
    if (axes == 2 && field.only_of_three_axes()) continue;
    std::vector<double>& values = s.*field.values;
    values.reserve(n);
    for (std::size_t p = 0; p < n; ++p)
      values.push_back(field.of(state, p, temperatures[state.particles.material_of(p)]));
  }
  return s;
}

template Snapshot snapshot_of(const State&, std::span<const Temperature>);
template Snapshot snapshot_of(const BasicState<3>&, std::span<const Temperature>);

}  // namespace mpm
