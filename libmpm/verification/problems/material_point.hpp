#pragma once
/// The material of a scene alone, taken along a path by the library's stress update.
#include "libmpm/material/material.hpp"
#include "libmpm/step/state.hpp"
#include "libmpm/verification/exact/elastic_plastic_impact.hpp"

namespace mpm::verification {

/// One point in uniaxial strain, without artificial viscosity. Compression positive.
class MaterialPoint {
 public:
  explicit MaterialPoint(const mpm::Material&);
  /// Behind a shock; hardening is isotropic.
  MaterialPoint(const mpm::Material&, const exact::ImpactState&);

  /// Goes to ln(rho/rho0) = strain in equal steps.
  void strain_to(double strain, int steps);

  double strain() const { return strain_; }            ///< ln(rho/rho0) [1]
  double density() const;                              ///< [kg/m^3]
  double normal_stress() const;                        ///< [Pa]
  double von_mises() const;                            ///< 3/2 of the deviator's normal part, signed [Pa]
  double plastic_strain() const;                       ///< [1]
  double specific_energy() const;                      ///< [J/kg]
  double wave_speed_change() const { return speed_; }  ///< sum of sqrt(dsigma dV) so far [m/s]

 private:
  void step(double change);

  mpm::State state_;
  mpm::MaterialModel model_;
  double strain_ = 0, speed_ = 0;
};

/// The state behind a steady shock into material at rest, from the library's equation of state and the jump
/// conditions alone.
struct MaterialHugoniot {
  double pressure, shock_speed, density, temperature;  ///< [Pa], [m/s], [kg/m^3], [K]
};
MaterialHugoniot material_hugoniot(const mpm::Material&, double particle_speed);

}  // namespace mpm::verification
