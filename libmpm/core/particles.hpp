#pragma once
#include <cstddef>
#include <vector>

#include "libmpm/core/archive.hpp"
#include "libmpm/core/state_column.hpp"
#include "libmpm/core/tensor.hpp"

namespace mpm {

/// The material points, one column a quantity. Columns have the same length, apart from those of physics that
/// a scene lacks, which are empty.
template <int axes>
struct BasicParticles {
  using Vector = Vec<axes>;

  std::vector<Vector> position;  ///< [m]
  std::vector<Vector> velocity;  ///< [m/s]
  std::vector<double> mass;  ///< in plane strain per depth [kg/m], in axisymmetry per radian [kg]; constant
  std::vector<double> initial_volume;  ///< at the reference density: mass / density; constant
  std::vector<double> dilation;  ///< J - 1 = rho0/rho - 1 [1], at most most_dilation (material/model.hpp);
                                 ///< small strains keep their digits
  std::vector<double> energy;    ///< specific internal energy, carried at half steps (see step.hpp) [J/kg]
  std::vector<double> pressure;  ///< of the equation of state [Pa]
  std::vector<double> viscous_pressure;  ///< q >= 0 [Pa]
  std::vector<Tensor<axes>> deviator;    ///< s [Pa]
  std::vector<Vector> half_size;         ///< of the particle's domain [m]
  /// Half edges of the particle's parallelogram, as columns [m]; empty with schemes that have none (Cpdi).
  std::vector<Mat<axes>> domain;
  std::vector<MaterialColumn> own;  ///< what the material models keep beside these; see keep()
  /// Where the particles of each material end: those of material m are next to each other and begin where
  /// those of m - 1 end. Empty: all are of material 0.
  std::vector<std::size_t> material_ends;
  /// Where the particles of each body of a composed scene end, likewise. Empty: all are of one body.
  std::vector<std::size_t> body_ends;
  /// Velocity gradient that the particle carries [1/s], and the kinetic energy of that motion [J/kg]; empty
  /// with transfers that carry none (Apic).
  std::vector<Mat<axes>> affine;
  std::vector<double> affine_energy;

  std::size_t size() const { return position.size(); }
  double density(std::size_t p) const { return mass[p] / volume(p); }  ///< [kg/m^3]
  double volume(std::size_t p) const {
    return initial_volume[p] * (1 + dilation[p]);
  }  ///< [m^2], per radian or of three axes [m^3]

  /// Kinetic energy of a particle [J/m], of three axes [J].
  double kinetic_energy(std::size_t p) const {
    const double inside = affine_energy.empty() ? 0 : mass[p] * affine_energy[p];
    return 0.5 * mass[p] * velocity[p].squaredNorm() + inside;
  }
  /// Total Cauchy stress, artificial viscosity included [Pa].
  Tensor<axes> stress(std::size_t p) const {
    return plus_mean(deviator[p], -(pressure[p] + viscous_pressure[p]));
  }

  /// The values of a column of the material; empty where the model has none of that name.
  std::span<const double> own_values(std::string_view name) const;
  std::span<double> own_values(std::string_view name);
  /// Gives the particles the columns of a model, as far as they lack them. Throws std::logic_error where a
  /// column of that name is of another form or length.
  void keep(std::span<const StateColumn> columns);
  struct Range {
    std::size_t first, last;  ///< [first, last)
  };
  Range range_of(std::size_t material) const;
  std::size_t material_of(std::size_t p) const;
  Range range_of_body(std::size_t body) const;
  std::size_t body_of(std::size_t p) const;

  void reserve(std::size_t n);
  /// Adds a particle at rest, without stress.
  void add(Vector x, Vector v, double m, double v0, Vector half);
};
using Particles = BasicParticles<2>;

/// The columns of a model among those of the particles, which must have them (keep()) and must outlive it.
class OwnNumbers {
 public:
  template <int axes>
  OwnNumbers(BasicParticles<axes>&, std::span<const StateColumn>);
  /// All numbers of a particle, one column after the other.
  void read(std::size_t p, double* to) const;
  void write(std::size_t p, const double* from) const;

 private:
  std::vector<MaterialColumn*> columns_;
};

template <int axes>
void carry_particles(BasicParticles<axes>&, Archive&);

}  // namespace mpm
