#pragma once
/// The one list of everything that a scene can be told. Study files, job keys, catalog columns and messages
/// are all made from it. Rows that every kind of scene has stand in parameters.cpp, those of a kind in the
/// file of the kind (kinds/), the constants of materials with their models (material/rows.hpp): a new
/// parameter is a member of Scene or of Material, and one row.
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "libmpm/core/input_row.hpp"
#include "libmpm/scene/scene.hpp"

namespace mpm {

/// Kinds of scene that have a row; all of them, where nothing is said.
struct KindSet {
  unsigned bits = ~0u;
  constexpr bool operator()(SceneKind kind) const { return (bits >> static_cast<unsigned>(kind)) & 1u; }
};

/// A number with a unit.
struct Quantity {
  std::string_view name;     ///< in study files and messages: "impact_speed"
  std::string_view unit;     ///< SI; "1" for a pure number
  std::string_view symbol;   ///< for figures, or ""
  std::string_view column;   ///< of the catalog: "impact_speed_m_s"
  std::string_view meaning;  ///< one line, for people
  Section section;
  Range range;
  bool required;                 ///< no default: a study must say it (or its alternative)
  std::string_view alternative;  ///< another name for the same degree of freedom, or ""
  double (*get)(const Scene&);
  void (*set)(Scene&, double);  ///< order matters: rows are applied from the top
  KindSet belongs_to = {};
  bool derived = false;  ///< made of other rows: no freedom of its own, no part of a job's key
  /// The value that says what every scene did before there was the row; the default of the member of Scene.
  /// It is left out of the identity of a scene, so that what was computed then is still found.
  std::optional<double> implied = {};
  std::string_view title = "";  ///< in figures, where it is not the name in words
};

/// A choice among words.
struct Choice {
  std::string_view name;
  std::string_view column;
  std::string_view meaning;
  Section section;
  std::span<const std::string_view> allowed;
  std::size_t (*get)(const Scene&);  ///< index into allowed
  void (*set)(Scene&, std::size_t);
  /// The word that says what every scene did before there was the choice. It is left out of the identity of a
  /// scene, so that what was computed then is still found.
  std::string_view implied = "";
  KindSet belongs_to = {};
};

std::span<const Quantity> quantities();
std::span<const Choice> choices();
const Quantity* find_quantity(std::string_view name);  ///< null if there is none
const Choice* find_choice(std::string_view name);
/// Whether a row is a constant of a material, of which a scene may have several.
bool is_of_material(const Quantity&);
/// The named material, as a choice: find_choice("material"). It is no row of choices(): keys, catalog and
/// messages have its constants, and its name is no part of what a job is.
const Choice& material_choice();

/// Names of kinds of scene as study files write them: "cavity-impact".
std::span<const std::string_view> scene_kind_names();
std::string_view to_string(SceneKind);
std::optional<SceneKind> scene_kind_from(std::string_view name);

}  // namespace mpm
