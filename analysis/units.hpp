#pragma once
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace analysis {

/// A quantity as people read it. Numbers are SI everywhere else.
struct QuantityLabel {
  std::string name;    ///< "Cavity radius"
  std::string symbol;  ///< "R"; may be empty
  std::string unit;    ///< SI, as catalog and library write it: "m", "m^2", "Pa", "1", ...
};

/// The quantity that a study or the catalog calls by this name. Without a title its name is the words of the
/// name; a unit that the name ends in, as columns and metrics do ("centroid_shift_m"), is none of them.
QuantityLabel quantity_label(std::string_view name, std::string_view si_unit = "1",
                             std::string_view symbol = "", std::string_view title = "");

/// "m2" -> "m^2": the catalog writes powers without the mark.
std::string with_powers(std::string_view unit);

/// "final_void_area" of "final_void_area_m2" and "m2": for a table that has the unit in a line of its own.
std::string_view without_unit(std::string_view name, std::string_view unit);

/// Whether display_unit has scales for an SI unit. "m2" is "m^2".
bool is_known_unit(std::string_view si_unit);

/// Shown number = SI number * factor.
struct DisplayUnit {
  double factor = 1;
  std::string text;  ///< "µm", "MPa", "µm²"; empty for a pure number
};

/// The unit in which numbers up to this size are short: 16e-9 s as ns, 3e9 Pa as GPa. A unit that is not in
/// the table stays as it is.
DisplayUnit display_unit(std::string_view si_unit, double largest);

/// The unit of grey pictures, which are made for print: of stress (MPa) and of work per volume (mJ/mm³) one
/// whatever the numbers, so that pictures of several studies can be compared side by side; others as
/// display_unit().
DisplayUnit fixed_unit(std::string_view si_unit, double largest);

/// "Cavity radius R (µm)", "Collapsibility Φ".
std::string axis_label(const QuantityLabel&, const DisplayUnit&);

/// "R = 1.5 µm", for legends; four digits, or as many as are asked for.
std::string value_label(const QuantityLabel&, double in_si, int digits = 4);

/// value_label of each value, with as many digits, from four on, as it takes for different values to have
/// different labels. Equal values have equal ones.
std::vector<std::string> value_labels(const QuantityLabel&, std::span<const double> in_si);

}  // namespace analysis
