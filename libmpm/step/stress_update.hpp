#pragma once
#include "libmpm/step/state.hpp"

namespace mpm {

/// New density, deviator, pressure and viscous pressure of every particle from its velocity gradient L:
///   J <- J det(1 + dt L);   D, W: parts of L (1 + dt L/2)^-1 (the middle of the step);
///   s by J2 with the rotation of W;   q by the artificial viscosity;
///   P = cold(J) + thermal (e + dt (s : D - (P + q) tr D) / (2 rho)), linear in P and solved for it.
/// Particles carry e at half steps, as FLIP carries v: the bracket takes it to the end of the step,
/// implicitly. Fills the report's signal, dilations, kinetic energy and the mass beyond the equation of
/// state.
void update_stress(State&, const MaterialModel&, double dt, StepReport&);

}  // namespace mpm
