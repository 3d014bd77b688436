#include "libmpm/verification/exact/lagrangian_1d.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "libmpm/verification/exact/powers.hpp"

namespace mpm::verification::exact {

Lagrangian1d::Lagrangian1d(const ElasticPlasticSolid& solid, Geometry geometry, std::vector<double> positions,
                           std::vector<double> velocities, const Options& options)
    : solid_(solid),
      geometry_(geometry),
      options_(options),
      position_(std::move(positions)),
      velocity_(std::move(velocities)),
      node_mass_(position_.size(), 0),
      wall_position_(position_.at(0)) {
  if (position_.size() < 2 || velocity_.size() != position_.size())
    throw std::invalid_argument("lagrangian_1d: at least two nodes, and a velocity for each");
  for (std::size_t k = 0; k + 1 < position_.size(); ++k) {
    const double volume = area(k) * length(k);
    if (!(volume > 0)) throw std::invalid_argument("lagrangian_1d: positions must rise, radii be positive");
    cells_.push_back({.mass = solid_.fluid.density * volume, .volume = volume, .strain_rate = 0});
    cells_[k].pressure = options.pressure;
    if (options.pressure != 0)
      cells_[k].energy = options.pressure / (solid_.fluid.gamma * solid_.fluid.density);
    node_mass_[k] += cells_[k].mass / 2;
    node_mass_[k + 1] += cells_[k].mass / 2;
  }
}

double Lagrangian1d::area(std::size_t k) const {
  return hoops() == 0 ? 1 : hoops() == 1 ? middle(k) : square(middle(k));
}

double Lagrangian1d::normal_stress(std::size_t cell) const {
  return cells_.at(cell).pressure - cells_.at(cell).s1;
}

double Lagrangian1d::energy() const {
  double sum = 0;
  for (std::size_t j = 0; j < position_.size(); ++j) sum += node_mass_[j] * square(velocity_[j]) / 2;
  for (const Cell& c : cells_) sum += c.mass * c.energy;
  return sum;
}

double Lagrangian1d::stable_step() const {
  double least = std::numeric_limits<double>::infinity();
  const MieGruneisenFluid& fluid = solid_.fluid;
  for (std::size_t k = 0; k < cells_.size(); ++k) {
    const Cell& c = cells_[k];
    const double rho = c.mass / c.volume;
    const double bulk = -(fluid.pressure_slope(rho) - c.pressure * fluid.gamma * fluid.density) / square(rho);
    const double sound = std::sqrt(std::max(bulk, 0.0) + 4 * solid_.shear_modulus / (3 * rho));
    const double squeeze = std::max(-c.strain_rate, 0.0) * length(k);
    const double viscous =
        options_.linear_viscosity * fluid.sound_speed + options_.quadratic_viscosity * squeeze;
    least = std::min(least, length(k) / (viscous + std::sqrt(square(viscous) + square(sound)) + squeeze));
  }
  return options_.cfl * least;
}

void Lagrangian1d::accelerate(double dt) {
  std::vector<double> force(position_.size(), 0);
  for (std::size_t k = 0; k < cells_.size(); ++k) {
    const Cell& c = cells_[k];
    const double mean = -(c.pressure + c.viscous);
    const double along = area(k) * (c.s1 + mean);
    // a node moves ln r_mid by 1 / (2 r_mid)
    const double hoop = hoops() * area(k) * length(k) * (c.s2 + mean) / (2 * middle(k));
    force[k] += along - hoop;
    force[k + 1] -= along + hoop;
  }
  for (std::size_t j = 0; j < force.size(); ++j) velocity_[j] += dt * force[j] / node_mass_[j];
  if (options_.wall) velocity_[0] = std::max(velocity_[0], (wall_position_ - position_[0]) / dt);
}

void Lagrangian1d::deform(Cell& c, double d_eps_1, double d_eps_2, double volume, double length,
                          double dt) const {
  const double d_eps_3 = hoops() == 2 ? d_eps_2 : 0;
  const double g2 = 2 * solid_.shear_modulus, growth = d_eps_1 + d_eps_2 + d_eps_3, mean = growth / 3;
  const double old1 = c.s1, old2 = c.s2, old3 = c.s3;
  c.s1 += g2 * (d_eps_1 - mean);
  c.s2 += g2 * (d_eps_2 - mean);
  c.s3 += g2 * (d_eps_3 - mean);
  const double trial = std::sqrt(1.5 * (square(c.s1) + square(c.s2) + square(c.s3)));
  const double yield = solid_.yield_stress + solid_.hardening * c.plastic_strain;
  if (trial > yield) {
    const double plastic = (trial - yield) / (3 * solid_.shear_modulus + solid_.hardening);
    const double kept = (yield + solid_.hardening * plastic) / trial;
    c.s1 *= kept, c.s2 *= kept, c.s3 *= kept;
    c.plastic_strain += plastic;
  }
  c.strain_rate = growth / dt;
  const double squeeze = std::max(-c.strain_rate, 0.0) * length;
  c.viscous = c.mass / volume * squeeze *
              (options_.linear_viscosity * solid_.fluid.sound_speed + options_.quadratic_viscosity * squeeze);

  // e' = e - ((P + P')/2 + q) dv + v s : d_eps with P' = cold + gamma0 rho0 e': solved for P'.
  const double v = volume / c.mass, dv = v - c.volume / c.mass;
  const double work =
      (v - dv / 2) * ((old1 + c.s1) * d_eps_1 + (old2 + c.s2) * d_eps_2 + (old3 + c.s3) * d_eps_3) / 2;
  const double thermal = solid_.fluid.gamma * solid_.fluid.density;
  const double without = c.energy - (c.pressure / 2 + c.viscous) * dv + work;
  const double next = (solid_.fluid.pressure(1 / v, 0) + thermal * without) / (1 + thermal * dv / 2);
  const double held = std::max(next, -options_.spall_strength);
  c.energy = without - held * dv / 2;
  c.pressure = held;
  c.volume = volume;
}

void Lagrangian1d::advance(double longest) {
  const double dt = std::min(stable_step(), longest);
  accelerate(dt);
  std::vector<double> before(cells_.size()), before_middle(cells_.size());
  for (std::size_t k = 0; k < cells_.size(); ++k) before[k] = length(k), before_middle[k] = middle(k);
  for (std::size_t j = 0; j < position_.size(); ++j) position_[j] += dt * velocity_[j];
  for (std::size_t k = 0; k < cells_.size(); ++k)
    deform(cells_[k], std::log(length(k) / before[k]),
           hoops() == 0 ? 0 : std::log(middle(k) / before_middle[k]), area(k) * length(k), length(k), dt);
  time_ += dt;
}

std::vector<ImpactSample> impact_history(const ElasticPlasticSolid& solid, double impact_speed, double height,
                                         int cells, const std::vector<double>& times,
                                         Lagrangian1d::Options options) {
  std::vector<double> x;
  for (int j = 0; j <= cells; ++j) x.push_back(height * j / cells);
  options.wall = true;
  Lagrangian1d code(solid, Lagrangian1d::Geometry::planar, x, std::vector<double>(x.size(), -impact_speed),
                    options);
  std::vector<ImpactSample> samples;
  for (const double t : times) {
    while (code.time() < t) code.advance(t - code.time());
    samples.push_back({t, code.velocities().back() + impact_speed, code.normal_stress(0)});
  }
  return samples;
}

ShellStop compressible_shell_stop(const ElasticPlasticSolid& solid, double inner_radius, double outer_radius,
                                  double inner_speed, int cells, bool spherical) {
  std::vector<double> r, v;
  for (int j = 0; j <= cells; ++j) {
    r.push_back(inner_radius + (outer_radius - inner_radius) * j / cells);
    const double ratio = inner_radius / r.back();
    v.push_back(-inner_speed * (spherical ? square(ratio) : ratio));
  }
  using Geometry = Lagrangian1d::Geometry;
  Lagrangian1d code(solid, spherical ? Geometry::spherical : Geometry::cylindrical, r, v, {});
  ShellStop stop{false, inner_radius, 0};
  const double scale = inner_radius / inner_speed;
  while (stop.time == 0 || code.time() < 1.3 * stop.time) {
    code.advance(scale);
    const double a = code.positions()[0];
    if (a < inner_radius / 1000) return {true, a, code.time()};
    if (a < stop.radius) stop = {false, a, code.time()};
  }
  return stop;
}

double CavityHistory::time_at(double value) const {
  for (std::size_t k = 1; k < radius.size(); ++k)
    if (radius[k] <= value)
      return time[k - 1] + (time[k] - time[k - 1]) * (radius[k - 1] - value) / (radius[k - 1] - radius[k]);
  return std::numeric_limits<double>::quiet_NaN();
}
double CavityHistory::least() const { return *std::ranges::min_element(radius); }

CavityHistory compressible_cavity(const ElasticPlasticSolid& solid, double radius, double far_pressure,
                                  double end_time, int cells) {
  const MieGruneisenFluid& fluid = solid.fluid;
  const double sound = std::sqrt(square(fluid.sound_speed) + 4 * solid.shear_modulus / (3 * fluid.density));
  std::vector<double> r{radius};
  while (r.back() < radius + sound * end_time)  // nothing comes back from there; cells as in proportion to r
    r.push_back(r.back() * (1 + 1.0 / cells));
  Lagrangian1d::Options options;
  options.pressure = far_pressure;
  Lagrangian1d code(solid, Lagrangian1d::Geometry::spherical, r, std::vector<double>(r.size(), 0), options);
  CavityHistory history{{0}, {radius}};
  while (code.time() < end_time && history.radius.back() > radius / 20) {
    code.advance(end_time - code.time());
    history.time.push_back(code.time()), history.radius.push_back(code.positions()[0]);
  }
  return history;
}

}  // namespace mpm::verification::exact
