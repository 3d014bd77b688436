#pragma once
/// What a kind of scene is. One file of this folder says all of it, and list.cpp names it. A kind is added by
/// its file, its enumerator in SceneKind and its line in list.cpp: see README.md.
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "libmpm/body/fill.hpp"
#include "libmpm/measure/measurement.hpp"
#include "libmpm/scene/build.hpp"
#include "libmpm/scene/parameters.hpp"
#include "libmpm/scene/report.hpp"
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

/// A rectangle that holds the bodies [m].
struct Extent {
  double width, height;
};

using Measurements = std::vector<std::unique_ptr<Measurement>>;

/// Functions of a scene of that kind. Lengths in m, speeds in m/s.
struct Kind {
  SceneKind kind;
  std::string_view name;  ///< in study files: "cavity-impact"
  /// Its rows of the table of parameters, beside those that every scene has. Kinds share a row by naming it.
  std::span<const Quantity> quantities;
  std::span<const Choice> choices;
  /// The result that an accuracy is asked of where a study does not say which.
  std::string_view headline;

  void (*set_default_numerics)(Numerics&);
  /// Of numbers that are each in their range.
  void (*check)(const Scene&, Report&);
  Extent (*extent)(const Scene&);  ///< of all of the scene, modelled or not
  Lattice (*lattice)(const Scene&);
  Floor (*floor)(const Scene&);
  Body (*body)(const Scene&, const Lattice&);
  double (*area)(const Scene&, const Lattice&);  ///< of the modelled part of the body [m^2]
  double (*fastest)(const Scene&);               ///< speed of the fastest part of the body
  double (*coarsest_cell)(const Scene&);         ///< that still shows the body
  /// Beside the balance, the health and the hot spots of a run.
  Measurements (*measurements)(const Scene&, const State&);
};

std::span<const Kind* const> kinds();  ///< in the order of SceneKind
const Kind& kind_of(SceneKind);
inline const Kind& kind_of(const Scene& s) { return kind_of(s.kind); }

}  // namespace mpm
