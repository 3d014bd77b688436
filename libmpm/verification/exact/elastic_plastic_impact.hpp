#pragma once
#include "libmpm/verification/exact/hugoniot.hpp"

namespace mpm::verification::exact {

/// MieGruneisenFluid with a hypoelastic deviator (logarithmic strain) and J2 yield with linear isotropic
/// hardening.
struct ElasticPlasticSolid {
  MieGruneisenFluid fluid;
  double shear_modulus;  ///< G [Pa], > 0
  double yield_stress;   ///< Y0 [Pa], > 0
  double hardening;      ///< H per unit of equivalent plastic strain [Pa], >= 0
};

enum class WaveStructure {
  elastic,    ///< one elastic shock: slower than the speed at the elastic limit
  two_waves,  ///< elastic precursor, plastic shock behind it
  overdriven  ///< one plastic shock that outruns any precursor
};

/// The steady state behind the wave (or both waves) of a planar impact, in uniaxial strain.
///
/// Stresses are compressive and positive: sigma = P + 2 q / 3 is the normal stress, q the von Mises stress.
/// Speeds are Lagrangian (against undeformed material ahead), so a wave reaches the initial height h at h /
/// speed.
struct ImpactState {
  WaveStructure structure;
  double elastic_wave_speed;         ///< first wave [m/s]; the plastic shock's where overdriven
  double plastic_wave_speed;         ///< [m/s]; the elastic wave's where elastic
  double elastic_limit_stress;       ///< HEL: sigma at first yield [Pa]
  double elastic_limit_speed;        ///< particle speed behind the precursor [m/s]
  double normal_stress;              ///< sigma [Pa]
  double pressure;                   ///< P [Pa]
  double von_mises;                  ///< q [Pa]
  double equivalent_plastic_strain;  ///< [1]
  double density;                    ///< [kg/m^3]
  double specific_energy;            ///< [J/kg]
  double particle_speed;             ///< that of the impact [m/s]

  /// Where a body moves at -up against a rigid wall at x = 0: speed of its last front from the wall [m/s].
  double front_speed_from_wall(const ElasticPlasticSolid&) const;
  /// ... and of its precursor; equal to the former where there is one wave.
  double precursor_speed_from_wall(const ElasticPlasticSolid&) const;
};

/// Impact of a rigid wall at particle speed up > 0 [m/s].
///
/// Uniaxial strain, eps = ln(rho/rho0): q = 2 G eps up to eps1 = Y0/2G, then
///   q = Y0 + H p,  p = (2 G eps - Y0) / (3 G + H).
/// Each wave is a jump (1: ahead, 2: behind) that obeys
///   (u2 - u1)^2 = (sigma2 - sigma1)(V1 - V2),  e2 - e1 = (sigma1 + sigma2)(V1 - V2) / 2,
///   Lagrangian speed (u2 - u1) / (rho0 (V1 - V2)).
/// A plastic shock faster than the precursor swallows it: one jump from rest. Valid while gamma0 eta < 2.
/// Structure as in the elastic-plastic piston of ExactPack (which has no hardening and another EOS).
/// Throws std::invalid_argument where up or a modulus is not positive.
ImpactState elastic_plastic_impact(const ElasticPlasticSolid&, double particle_speed);

/// What the free surface does when the final state reaches it and unloads to sigma = 0 in one simple wave.
struct SimpleRelease {
  double surface_speed;              ///< up + integral of sqrt(-dsigma dV) [m/s]
  double density;                    ///< [kg/m^3]
  double equivalent_plastic_strain;  ///< [1]
};

/// Elastic until the deviator has turned round (q = -q_max), then plastic in reverse with isotropic
/// hardening; de = -sigma dV. The precursor's own reflection is left out.
SimpleRelease simple_release(const ElasticPlasticSolid&, const ImpactState&);

}  // namespace mpm::verification::exact
