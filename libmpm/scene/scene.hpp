#pragma once
#include <algorithm>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "libmpm/material/material.hpp"
#include "libmpm/scene/composition.hpp"
#include "libmpm/scene/gauge.hpp"
#include "libmpm/scene/kinds/list.hpp"
#include "libmpm/space/space.hpp"

namespace mpm {

/// What is simulated: the names of kinds/list.hpp. x = 0 is a mirror axis of the configuration, in
/// axisymmetry its axis: circles are spheres, and blocks are cylinders whose diameter is their width. Of
/// three axes z = 0 is a mirror, too: circles are spheres, and blocks are as deep as they are wide. Nothing
/// outside kinds/ asks a scene for its kind: what is special about one stands in its Kind (kinds/kind.hpp).
enum class SceneKind {
#define MPM_ENUMERATOR(name) name,
  MPM_SCENE_KINDS(MPM_ENUMERATOR)
#undef MPM_ENUMERATOR
};

enum class ShapeFunction {
  gimp,      ///< generalised interpolation, particle domains that follow the stretch
  bspline2,  ///< quadratic B-spline
  cpdi,      ///< parallelograms that follow the whole deformation
  bspline3,  ///< cubic B-spline
  linear,    ///< piecewise linear, of three axes the eight-node trilinear functions of the paper
};

/// How particles and grid exchange velocities.
enum class Transfer {
  flip,  ///< particles take the grid's acceleration (step/flip.hpp), with a share of PIC (step/flip_pic.hpp)
  apic,  ///< particles take the grid's velocity and its gradient (step/apic.hpp)
};

/// How much of the configuration is modelled.
enum class Symmetry {
  half,  ///< x >= 0; of a shell, which has a second mirror at y = 0, the quarter x, y >= 0. Of three axes
         ///< what of these lies at z >= 0: the quarter of a block, the octant of a shell
  full,  ///< all of it
};

/// Which code takes the steps. Results agree to rounding.
enum class Kernel {
  fast,       ///< step/fast/
  reference,  ///< step/step.hpp: plain, slow, the oracle
};

/// What the fast step counts in.
enum class Precision {
  double_precision,
  single_precision,  ///< half the memory, about twice the speed; areas to about four digits
};

/// When an impact wall pushes a body that has left it and comes back.
enum class WallGap {
  unseen,   ///< from a distance of about a cell on
  tracked,  ///< once the gap that has opened since is closed: boundary/impact_wall.hpp
};

/// How a scene is computed. Make one with default_numerics(), which knows what suits a kind of scene.
struct Numerics {
  double cell_size = 0;        ///< h [m]
  int particles_per_cell = 0;  ///< 1, 4, 9 or 16, on a square lattice; of three axes 1, 8 or 27
  ShapeFunction scheme = ShapeFunction::bspline2;
  Transfer transfer = Transfer::flip;
  Symmetry symmetry = Symmetry::half;
  Kernel kernel = Kernel::fast;
  Precision precision = Precision::double_precision;
  WallGap wall_gap = WallGap::unseen;
  double pic_fraction = 0;         ///< share of PIC in the FLIP transfer, a step [1]; see step/flip_pic.hpp
  double cfl = 0;                  ///< share of h / (signal speed) that a step takes [1]
  double linear_viscosity = 0;     ///< q1 [1]; see material/artificial_viscosity.hpp
  double quadratic_viscosity = 0;  ///< q2 [1]
};

/// What the outcome of a run with a cavity says.
enum class Decides {
  collapse,  ///< is the cavity gone? collapsed, partial
  ejection,  ///< does the downstream wall throw out material? See measure/ejection.hpp
};

/// When a run ends.
enum class Stop {
  end_time,
  decided,  ///< as soon as its outcome is known (ejection), or at end_time
};

struct Measures {
  double area_every = 0;    ///< period of the area history, and of all that is sampled [s]
  double detached_for = 0;  ///< how long a part must have been off the body to count as ejected [s]
  Decides decides = Decides::collapse;
  Stop stop = Stop::end_time;
  std::vector<double> snapshots;  ///< times at which fields are handed to the observer [s], ascending
  std::vector<Gauge> gauges;      ///< read every area_every
};

/// A number that a study has a name for.
struct Label {
  std::string name;
  double value = 0;  ///< SI
  std::string unit;
  std::string written = {};  ///< as its study file would write it: "30 deg"; empty: with the unit above
};

/// One fully resolved run: plain data in SI units. A length or a speed that a kind of scene does not have is
/// 0.
struct Scene {
  SceneKind kind = SceneKind::cavity_impact;
  Material material;
  /// Materials 1, 2, ... beside `material`, which is number 0 (BasicParticles::material_ends): of the kind
  /// "bodies", and of bodies of one's own (fill() and Simulation(scene, body)).
  std::vector<Material> other_materials;
  double impact_speed = 0;          ///< u [m/s], > 0
  double block_width = 0;           ///< W [m], the full width also when half of it is modelled
  double block_height = 0;          ///< H [m]
  double cavity_radius = 0;         ///< R [m]
  double cavity_center_height = 0;  ///< y_c above the impact face [m]
  double inner_radius = 0;          ///< a0 of the shell [m]
  double outer_radius = 0;          ///< b0 of the shell [m]
  double inner_speed = 0;           ///< u0, inwards, at the inner radius [m/s], > 0
  double end_time = 0;              ///< [s]
  Space space = Space::plane_strain;
  Composition composition;  ///< of the kind "bodies"
  Numerics numerics;
  Measures measures;
  std::vector<Label> labels;  ///< for people: nothing of the run reads them, and they are no part of its key
};

inline std::size_t material_count(const Scene& s) { return 1 + s.other_materials.size(); }
/// Material number `index` of a scene. Throws InputError where there are fewer.
const Material& material_of(const Scene&, std::size_t index);
/// The largest value(material) of its materials.
template <class Value>
double largest_of(const Scene& s, const Value& value) {
  double largest = value(s.material);
  for (const Material& m : s.other_materials) largest = std::max(largest, value(m));
  return largest;
}

/// Whether the fast step knows the space, the scheme, the transfer and all that acts on the bodies; if not,
/// the kernel must be the reference.
bool fast_step_has(const Scene&);

/// The numerics that a kind of scene uses where a study says nothing (cell_size stays 0: it must be said).
Numerics default_numerics(SceneKind, Space = Space::plane_strain);

/// One thing that is wrong with a scene, in words that a user can act on.
struct Problem {
  std::string parameter;  ///< name of the parameter, as in parameters.hpp
  std::string value;      ///< what it is, with its unit
  std::string allowed;    ///< what it may be
};

/// Everything that is wrong with the scene; empty if it can be run.
std::vector<Problem> find_problems(const Scene&);

/// What a run will need, before it starts.
struct Estimate {
  std::int64_t particles = 0;
  std::int64_t steps = 0;
  double update_cost = 1;  ///< see below
};
/// What one particle costs in one step, in what it costs in the fast step.
double update_cost(Space, Kernel);
Estimate estimate(const Scene&);

}  // namespace mpm
