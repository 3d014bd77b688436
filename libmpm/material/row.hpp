#pragma once
/// The constants of a material as rows of the table of parameters. A model lists those that it reads beside
/// its formulas; rows.hpp has the list of lists.
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

#include "libmpm/core/enumerators.hpp"
#include "libmpm/core/input_row.hpp"
#include "libmpm/material/material.hpp"

namespace mpm {

/// When a constant has an effect; an empty `when`: always.
struct MaterialUse {
  std::string_view when = "";  ///< for people: "tension = \"cutoff\""
  bool (*holds)(const Material&) = nullptr;
};

inline constexpr MaterialUse law_is_solid{"law = \"solid\"",
                                          [](const Material& m) { return m.law == MaterialLaw::solid; }};

struct MaterialRow {
  std::string_view name;     ///< in study files: "youngs_modulus"
  std::string_view unit;     ///< SI
  std::string_view column;   ///< of the catalog: "youngs_modulus_Pa"
  std::string_view meaning;  ///< one line
  Range range;
  double Material::*value;
  MaterialUse use{};
  std::string_view symbol = "";
  Section section = Section::material;
  std::optional<double> implied = {};  ///< see Quantity::implied
};

struct MaterialChoice {
  std::string_view name;  ///< also the column
  std::string_view meaning;
  std::span<const std::string_view> allowed;
  std::size_t (*get)(const Material&);  ///< index into allowed
  void (*set)(Material&, std::size_t);
  MaterialUse use{};
  std::string_view implied = "";  ///< see Choice::implied
};

}  // namespace mpm
