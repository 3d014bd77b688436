#pragma once
/// The constants of all models, in the order of the table of parameters.
#include <array>
#include <cstddef>

#include "libmpm/material/eos/mie_grueneisen.hpp"
#include "libmpm/material/eos/stiffened_gas.hpp"
#include "libmpm/material/eos/tait.hpp"
#include "libmpm/material/eos/temperature.hpp"
#include "libmpm/material/row.hpp"
#include "libmpm/material/strength/failing.hpp"
#include "libmpm/material/strength/j2.hpp"
#include "libmpm/material/strength/johnson_cook.hpp"
#include "libmpm/material/strength/steinberg_guinan.hpp"

namespace mpm {
namespace detail {

inline constexpr auto eos_words = words<EquationOfState>({{EquationOfState::mie_grueneisen, "mie-grueneisen"},
                                                          {EquationOfState::stiffened_gas, "stiffened-gas"},
                                                          {EquationOfState::tait, "tait"}});
inline constexpr auto strength_words =
    words<StrengthModel>({{StrengthModel::von_mises, "von-mises"},
                          {StrengthModel::johnson_cook, "johnson-cook"},
                          {StrengthModel::steinberg_guinan, "steinberg-guinan"},
                          {StrengthModel::none, "none"}});
inline constexpr auto law_words =
    words<MaterialLaw>({{MaterialLaw::solid, "solid"}, {MaterialLaw::neo_hookean, "neo-hookean"}});

inline constexpr MaterialRow rows_of_all[] = {
    {"reference_density", "kg/m3", "reference_density_kg_m3", "density at rest", Range::positive,
     &Material::reference_density},
};
inline constexpr MaterialChoice choices_of_all[] = {
    {"law",
     "an equation of state and a deviator of its own, or a neo-Hookean solid, elastic at any strain",
     law_words,
     [](const Material& m) { return static_cast<std::size_t>(m.law); },
     [](Material& m, std::size_t i) { m.law = static_cast<MaterialLaw>(i); },
     {},
     "solid"},
    {"eos", "equation of state", eos_words, [](const Material& m) { return static_cast<std::size_t>(m.eos); },
     [](Material& m, std::size_t i) { m.eos = static_cast<EquationOfState>(i); }, law_is_solid,
     "mie-grueneisen"},
    {"strength", "what the deviator follows from; none: a fluid", strength_words,
     [](const Material& m) { return static_cast<std::size_t>(m.strength); },
     [](Material& m, std::size_t i) { m.strength = static_cast<StrengthModel>(i); }, law_is_solid,
     "von-mises"},
};

template <class Row, std::size_t... sizes>
constexpr auto joined(const Row (&... lists)[sizes]) {
  std::array<Row, (sizes + ...)> all{};
  auto* to = all.data();
  const auto add = [&](const auto& list) {
    for (const Row& row : list) *to++ = row;
  };
  (add(lists), ...);
  return all;
}

}  // namespace detail

/// A list more for a model with constants of its own.
inline constexpr auto material_rows =
    detail::joined(detail::rows_of_all, j2_rows, mie_grueneisen_rows, temperature_rows, tension_rows,
                   failure_rows, johnson_cook_rows, stiffened_gas_rows, tait_rows, steinberg_guinan_rows);
inline constexpr auto material_choices = detail::joined(tension_choices, j2_choices, detail::choices_of_all);

}  // namespace mpm
