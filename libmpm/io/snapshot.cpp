#include "libmpm/io/snapshot.hpp"

namespace mpm {

Snapshot snapshot_of(const State& state, const Temperature& temperature) {
  const Particles& ps = state.particles;
  Snapshot s;
  s.time = state.time;
  s.step = state.step;
  for (std::size_t p = 0; p < ps.size(); ++p) {
    const PlaneTensor& dev = ps.deviator[p];
    s.x.push_back(ps.position[p].x());
    s.y.push_back(ps.position[p].y());
    s.velocity_x.push_back(ps.velocity[p].x());
    s.velocity_y.push_back(ps.velocity[p].y());
    s.mass.push_back(ps.mass[p]);
    s.density.push_back(ps.density(p));
    s.pressure.push_back(ps.pressure[p]);
    s.stress_xx.push_back(dev.xx - ps.pressure[p]);
    s.stress_yy.push_back(dev.yy - ps.pressure[p]);
    s.stress_zz.push_back(dev.zz - ps.pressure[p]);
    s.stress_xy.push_back(dev.xy);
    s.von_mises.push_back(J2::von_mises(dev));
    s.equivalent_plastic_strain.push_back(ps.plastic_strain[p]);
    s.plastic_work.push_back(ps.plastic_work[p] * ps.density(p));
    s.specific_internal_energy.push_back(ps.energy[p]);
    s.temperature.push_back(temperature(ps.dilation[p], ps.energy[p]));
  }
  return s;
}

}  // namespace mpm
