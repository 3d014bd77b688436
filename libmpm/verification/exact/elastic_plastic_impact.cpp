#include "libmpm/verification/exact/elastic_plastic_impact.hpp"

#include <cmath>
#include <stdexcept>

#include "libmpm/verification/exact/root.hpp"
#include "libmpm/verification/exact/uniaxial_strain.hpp"

namespace mpm::verification::exact {
namespace {

/// Deviator of uniaxial compression to the strain ln(rho/rho0), along the loading path.
struct Deviator {
  double von_mises;       ///< q [Pa]
  double plastic_strain;  ///< p [1]
};

Deviator loaded(const ElasticPlasticSolid& solid, double strain) {
  const double trial = 2 * solid.shear_modulus * strain;
  if (trial <= solid.yield_stress) return {trial, 0};
  const double plastic = (trial - solid.yield_stress) / (3 * solid.shear_modulus + solid.hardening);
  return {solid.yield_stress + solid.hardening * plastic, plastic};
}

/// Ahead of a wave, or behind it.
struct State {
  double volume, stress, energy, speed;  ///< V = 1/rho [m^3/kg], sigma [Pa], e [J/kg], u [m/s]
};

/// sigma behind a jump to volume v: sigma = P(rho, e) + 2q/3 with the Hugoniot's e, which is linear in sigma.
double stress_behind(const ElasticPlasticSolid& solid, const State& ahead, double v) {
  const MieGruneisenFluid& fluid = solid.fluid;
  const double half_jump = (ahead.volume - v) / 2;
  const double q = loaded(solid, -std::log(fluid.density * v)).von_mises;
  const double cold = fluid.pressure(1 / v, ahead.energy + ahead.stress * half_jump) + 2 * q / 3;
  return cold / (1 - fluid.gamma * fluid.density * half_jump);
}

State behind(const ElasticPlasticSolid& solid, const State& ahead, double v) {
  const double stress = stress_behind(solid, ahead, v);
  const double energy = ahead.energy + (ahead.stress + stress) * (ahead.volume - v) / 2;
  return {v, stress, energy, ahead.speed + std::sqrt((stress - ahead.stress) * (ahead.volume - v))};
}

/// The jump from `ahead` to the particle speed u; between the volumes where the EOS is valid.
State jump(const ElasticPlasticSolid& solid, const State& ahead, double u) {
  const double du = u - ahead.speed;
  const auto excess = [&](double compressed) {
    const double v = ahead.volume - compressed;
    return (stress_behind(solid, ahead, v) - ahead.stress) * compressed - du * du;
  };
  return behind(solid, ahead, ahead.volume - bisect(excess, 0, ahead.volume));
}

double wave_speed(const ElasticPlasticSolid& solid, const State& ahead, const State& after) {
  return (after.speed - ahead.speed) / (solid.fluid.density * (ahead.volume - after.volume));
}

}  // namespace

double ImpactState::front_speed_from_wall(const ElasticPlasticSolid& solid) const {
  return plastic_wave_speed * solid.fluid.density / density;
}

double ImpactState::precursor_speed_from_wall(const ElasticPlasticSolid& solid) const {
  if (structure != WaveStructure::two_waves) return front_speed_from_wall(solid);
  return elastic_wave_speed - particle_speed;
}

ImpactState elastic_plastic_impact(const ElasticPlasticSolid& solid, double particle_speed) {
  if (!(particle_speed > 0))
    throw std::invalid_argument("elastic_plastic_impact: particle speed must be positive");
  if (!(solid.yield_stress > 0 && solid.shear_modulus > 0 && solid.hardening >= 0))
    throw std::invalid_argument("elastic_plastic_impact: Y0 and G must be positive, H not negative");
  const State rest{1 / solid.fluid.density, 0, 0, 0};
  const double yield_strain = solid.yield_stress / (2 * solid.shear_modulus);
  const State limit = behind(solid, rest, rest.volume * std::exp(-yield_strain));

  ImpactState result{};
  result.elastic_limit_stress = limit.stress;
  result.elastic_limit_speed = limit.speed;
  result.elastic_wave_speed = wave_speed(solid, rest, limit);
  State final = limit;
  if (particle_speed <= limit.speed) {
    result.structure = WaveStructure::elastic;
    final = jump(solid, rest, particle_speed);
    result.elastic_wave_speed = result.plastic_wave_speed = wave_speed(solid, rest, final);
  } else {
    result.structure = WaveStructure::two_waves;
    final = jump(solid, limit, particle_speed);
    result.plastic_wave_speed = wave_speed(solid, limit, final);
    if (result.plastic_wave_speed > result.elastic_wave_speed) {
      result.structure = WaveStructure::overdriven;
      final = jump(solid, rest, particle_speed);
      result.elastic_wave_speed = result.plastic_wave_speed = wave_speed(solid, rest, final);
    }
  }
  const Deviator deviator = loaded(solid, -std::log(solid.fluid.density * final.volume));
  result.normal_stress = final.stress;
  result.von_mises = deviator.von_mises;
  result.pressure = final.stress - 2 * deviator.von_mises / 3;
  result.equivalent_plastic_strain = deviator.plastic_strain;
  result.density = 1 / final.volume;
  result.specific_energy = final.energy;
  result.particle_speed = particle_speed;
  return result;
}

SimpleRelease simple_release(const ElasticPlasticSolid& solid, const ImpactState& loaded_state) {
  UniaxialStrain at(solid, loaded_state);
  // No bound of the released strain is known beforehand; a thousandth of the compression is a small step.
  const double step = at.strain() / 1000;
  const auto after = [&](double part) {
    UniaxialStrain next = at;
    next.strain_to(at.strain() - part * step);
    return next;
  };
  while (after(1).normal_stress() > 0) at = after(1);
  at = after(bisect([&](double part) { return -after(part).normal_stress(); }, 0, 1));
  return {loaded_state.particle_speed + at.wave_speed_change(), at.density(), at.plastic_strain()};
}

}  // namespace mpm::verification::exact
