#pragma once
#include <limits>
#include <vector>

#include "libmpm/verification/exact/elastic_plastic_impact.hpp"
#include "libmpm/verification/exact/verney.hpp"

namespace mpm::verification::exact {

/// A one-dimensional Lagrangian code: what the exact jumps and the incompressible shell leave out
/// (reflections, elastic waves, compressibility), at as many cells as it takes. Shares no code with step/.
///
/// Nodes j carry position and velocity, cells between them stress and energy (von Neumann & Richtmyer 1950,
/// J. Appl. Phys. 21, 232; Wilkins 1964). With A = 1 (planar), r_mid (cylindrical, per radian, plane strain)
/// or r_mid^2 (spherical, per steradian):
///   V = A dr;   d_eps_1 = ln(dr'/dr),   d_eps_2 = ln(r_mid'/r_mid) along 0, 1 or 2 hoops
///   m_j du_j/dt = sum over the two cells of -d(V eps : sigma)/d(eps of node j)   (virtual work)
///   s by radial return with linear isotropic hardening;   de = -(P + q) dv + v s : d_eps
///   q = rho dr |theta| (q1 c0 + q2 dr |theta|) in compression
/// Energy is exact up to second order in the time step. P is positive in compression, stresses in tension.
class Lagrangian1d {
 public:
  enum class Geometry { planar, cylindrical, spherical };  ///< by the number of hoops
  struct Options {
    double linear_viscosity = 0.5;     ///< q1 [1]
    double quadratic_viscosity = 1.5;  ///< q2 [1]
    double cfl = 0.25;                 ///< share of the stability limit [1]
    bool wall = false;                 ///< at the place of the first node; pushes and does not pull
    double spall_strength = std::numeric_limits<double>::infinity();  ///< P >= -spall_strength [Pa]
    double pressure = 0;  ///< at the start, by heat at the density of rest [Pa]
  };

  /// Positions rise; one more than cells. Cells are at rest density and free of stress, but for the pressure.
  Lagrangian1d(const ElasticPlasticSolid&, Geometry, std::vector<double> positions,
               std::vector<double> velocities, const Options&);

  /// One step, no longer than `longest` [s].
  void advance(double longest);

  double time() const { return time_; }
  const std::vector<double>& positions() const { return position_; }
  const std::vector<double>& velocities() const { return velocity_; }
  double normal_stress(std::size_t cell) const;  ///< compression positive, without q [Pa]
  double energy() const;                         ///< kinetic + internal, per area, radian or steradian

 private:
  struct Cell {
    double mass, volume, strain_rate;  ///< theta [1/s]
    double s1 = 0, s2 = 0, s3 = 0;     ///< deviator [Pa]
    double pressure = 0, viscous = 0, energy = 0, plastic_strain = 0;
  };
  double middle(std::size_t cell) const { return (position_[cell] + position_[cell + 1]) / 2; }
  double area(std::size_t cell) const;  ///< A
  int hoops() const { return static_cast<int>(geometry_); }
  double length(std::size_t cell) const { return position_[cell + 1] - position_[cell]; }
  double stable_step() const;
  void accelerate(double dt);
  void deform(Cell&, double d_eps_1, double d_eps_2, double volume, double length, double dt) const;

  ElasticPlasticSolid solid_;
  Geometry geometry_;
  Options options_;
  std::vector<double> position_, velocity_, node_mass_;
  std::vector<Cell> cells_;
  double wall_position_, time_ = 0;
};

/// A block of `height` that moves at -impact_speed onto a rigid wall, as seen from outside.
struct ImpactSample {
  double time;           ///< [s]
  double surface_speed;  ///< of the free surface against the moving body [m/s]
  double wall_stress;    ///< compression positive [Pa]
};
/// Samples at the given times (ascending). The wall can be left, as in Lagrangian1d::Options::wall.
std::vector<ImpactSample> impact_history(const ElasticPlasticSolid&, double impact_speed, double height,
                                         int cells, const std::vector<double>& times,
                                         Lagrangian1d::Options options = {});

/// The imploding shell of verney.hpp, but compressible and with elastic strains: where and when its inner
/// radius is smallest. `solid` gives density, yield stress and hardening. Cylinder or sphere.
ShellStop compressible_shell_stop(const ElasticPlasticSolid& solid, double inner_radius, double outer_radius,
                                  double inner_speed, int cells, bool spherical = false);

/// The cavity of pressed_cavity.hpp, but in a compressible solid that is under the pressure from the start:
/// its radius step by step, up to `end_time` or a twentieth of the first radius. `cells` to the first radius.
struct CavityHistory {
  std::vector<double> time, radius;

  /// When the radius falls to that value; NaN where it does not [s].
  double time_at(double value) const;
  double least() const;  ///< [m]
};
CavityHistory compressible_cavity(const ElasticPlasticSolid& solid, double radius, double far_pressure,
                                  double end_time, int cells);

}  // namespace mpm::verification::exact
