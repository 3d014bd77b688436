#include "libmpm/exact/elastic_plastic_impact.hpp"

#include <cmath>
#include <stdexcept>

#include "libmpm/exact/root.hpp"

namespace mpm::exact {
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

// -------------------------------------------------------------------------------------------- release

struct Unloading {
  double strain, energy, speed;  ///< ln(rho/rho0), e, u: the strain is the variable
};

/// Signed q on the way down, and dq/dstrain.
struct Path {
  double strain0, q0, plastic0, shear, hardening;

  double turned() const { return strain0 - q0 / shear; }  ///< strain where q = -q0
  bool plastic(double strain) const { return strain < turned(); }
  double reverse_strain(double strain) const {
    return plastic(strain) ? 2 * shear * (turned() - strain) / (3 * shear + hardening) : 0;
  }
  double q(double strain) const {
    return plastic(strain) ? -q0 - hardening * reverse_strain(strain) : q0 + 2 * shear * (strain - strain0);
  }
  /// On a smooth piece: which one is said by the caller, since the ends of a step touch both.
  double slope(bool on_plastic_piece) const {
    return on_plastic_piece ? 2 * shear * hardening / (3 * shear + hardening) : 2 * shear;
  }
};

double stress(const ElasticPlasticSolid& solid, const Path& path, const Unloading& at) {
  return solid.fluid.pressure(solid.fluid.density * std::exp(at.strain), at.energy) +
         2 * path.q(at.strain) / 3;
}

Unloading unload(const ElasticPlasticSolid& solid, const Path& path, const Unloading& at, double h,
                 bool plastic) {
  const MieGruneisenFluid& fluid = solid.fluid;
  struct Rate {
    double energy, speed;  ///< per unit of strain
  };
  const auto rate = [&](double strain, double energy) {
    const double rho = fluid.density * std::exp(strain);
    const double sigma = fluid.pressure(rho, energy) + 2 * path.q(strain) / 3;
    const double dv = -1 / rho;  // dV/dstrain
    const double dsigma =
        (fluid.pressure_slope(rho) - fluid.gamma * fluid.density * sigma) * dv + 2 * path.slope(plastic) / 3;
    return Rate{-sigma * dv, -std::sqrt(-dsigma * dv)};
  };
  const Rate k1 = rate(at.strain, at.energy);
  const Rate k2 = rate(at.strain + h / 2, at.energy + h / 2 * k1.energy);
  const Rate k3 = rate(at.strain + h / 2, at.energy + h / 2 * k2.energy);
  const Rate k4 = rate(at.strain + h, at.energy + h * k3.energy);
  return {at.strain + h, at.energy + h / 6 * (k1.energy + 2 * k2.energy + 2 * k3.energy + k4.energy),
          at.speed + h / 6 * (k1.speed + 2 * k2.speed + 2 * k3.speed + k4.speed)};
}

/// Goes down one piece in equal steps, at most `steps` of them. True where sigma = 0 was reached on it.
bool unload_piece(const ElasticPlasticSolid& solid, const Path& path, Unloading& at, double h, int steps,
                  bool plastic) {
  const auto tension = [&](const Unloading& u) { return -stress(solid, path, u); };
  for (int i = 0; i < steps; ++i) {
    const Unloading next = unload(solid, path, at, h, plastic);
    if (tension(next) >= 0) {
      const double part =
          bisect([&](double f) { return tension(unload(solid, path, at, f * h, plastic)); }, 0, 1);
      at = unload(solid, path, at, part * h, plastic);
      return true;
    }
    at = next;
  }
  return false;
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
  const double strain = std::log(loaded_state.density / solid.fluid.density);
  const Path path{strain, loaded_state.von_mises, loaded_state.equivalent_plastic_strain, solid.shear_modulus,
                  solid.hardening};
  Unloading at{strain, loaded_state.specific_energy, loaded_state.particle_speed};
  constexpr int steps = 1000;
  // In reverse plasticity no bound is known beforehand; a step of the compression's own size / steps is
  // small.
  if (!unload_piece(solid, path, at, (path.turned() - strain) / steps, steps, false))
    while (!unload_piece(solid, path, at, -strain / steps, steps, true)) {
    }
  return {at.speed, solid.fluid.density * std::exp(at.strain),
          loaded_state.equivalent_plastic_strain + path.reverse_strain(at.strain)};
}

}  // namespace mpm::exact
