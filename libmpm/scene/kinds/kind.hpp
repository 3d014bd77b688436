#pragma once
/// What a kind of scene is. One file of this folder says all of it, and list.hpp names it: a kind is added by
/// its file and its line there. See README.md.
#include <limits>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "libmpm/body/fill.hpp"
#include "libmpm/measure/measurement.hpp"
#include "libmpm/measure/results.hpp"
#include "libmpm/scene/build.hpp"
#include "libmpm/scene/parameters.hpp"
#include "libmpm/scene/report.hpp"
#include "libmpm/scene/resolution.hpp"
#include "libmpm/scene/scene.hpp"

namespace mpm {

/// For rows of numbers that are members of Scene.
template <double Scene::*member>
double get(const Scene& s) {
  return s.*member;
}
template <double Scene::*member>
void set(Scene& s, double value) {
  s.*member = value;
}

/// A box that holds the bodies [m].
struct Extent {
  double width, height;
  double depth = 0;  ///< of three axes
};

/// What a kind is in spaces of so many axes; nothing where it has none of these.
template <int axes>
struct KindIn {
  BasicLattice<axes> (*lattice)(const Scene&) = nullptr;
  BasicBody<axes> (*body)(const Scene&, const BasicLattice<axes>&) = nullptr;
  /// Of the modelled part of the body [m^2], of three axes [m^3].
  double (*size)(const Scene&, const BasicLattice<axes>&) = nullptr;
  /// Beside the balance, the health and the hot spots of a run.
  BasicMeasurements<axes> (*measurements)(const Scene&, const BasicState<axes>&) = nullptr;
  /// In place of `body`, where a scene is more than one body: all of it at time 0.
  BasicState<axes> (*state)(const Scene&) = nullptr;

  bool is_there() const { return body || state; }
};

/// The pressure of a scene that has no planar shock.
inline double no_shock(const Scene&) { return 0; }
/// The time of a scene whose bodies need not part.
inline double never(const Scene&) { return std::numeric_limits<double>::infinity(); }

inline bool is_half_by_choice(const Scene& s) { return s.numerics.symmetry == Symmetry::half; }

/// Functions of a scene of that kind. Lengths in m, speeds in m/s. What has no default must be said.
struct Kind {
  SceneKind kind;
  std::string_view name;  ///< in study files: "cavity-impact"
  /// Its rows of the table of parameters, beside those that every scene has. Kinds share a row by naming it.
  std::span<const Quantity> quantities;
  std::span<const Choice> choices = {};
  /// Rows of the table of results: what `measurements` come to, one entry for each of them.
  std::span<const Results> results = {};
  /// The result that an accuracy is asked of where a study does not say which.
  std::string_view headline;
  /// What RunResult::outcome can say, beside "undecided". None: the kind decides nothing.
  std::span<const std::string_view> outcomes = {};
  bool is_composed = false;       ///< whether its scenes have a Composition, of bodies
  bool has_area_history = false;  ///< whether its runs hand the area of a cavity to the observer

  void (*set_default_numerics)(Numerics&);
  /// Of numbers that are each in their range.
  void (*check)(const Scene&, Report&);
  Extent (*extent)(const Scene&);  ///< of all of the scene, modelled or not
  Floor (*floor)(const Scene&);
  double (*fastest)(const Scene&);           ///< speed of the fastest part of the body
  double (*coarsest_cell)(const Scene&);     ///< that still shows the body
  std::vector<Part> (*parts)(const Scene&);  ///< walls and holes that a grid may be too coarse for
  /// Of the planar shock that impact_speed makes, which has to be within the equation of state [Pa].
  double (*shock_pressure)(const Scene&) = no_shock;
  /// When real bodies, once they have met, would part again: those of the scene hold together [s].
  double (*parting_time)(const Scene&) = never;
  /// Whether what lies at x < 0 is the image of what is modelled.
  bool (*is_half)(const Scene&) = is_half_by_choice;
  bool (*is_half_along_z)(const Scene&) = is_half_by_choice;  ///< the same at z < 0; of three axes
  KindIn<2> of_two_axes;
  KindIn<3> of_three_axes = {};

  template <int axes>
  const KindIn<axes>& in() const {
    if constexpr (axes == 2)
      return of_two_axes;
    else
      return of_three_axes;
  }
};

std::span<const Kind* const> kinds();  ///< in the order of SceneKind
const Kind& kind_of(SceneKind);
inline const Kind& kind_of(const Scene& s) { return kind_of(s.kind); }

}  // namespace mpm
