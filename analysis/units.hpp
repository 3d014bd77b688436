#pragma once
#include <string>
#include <string_view>

namespace analysis {

/// A quantity as people read it. Numbers are SI everywhere else.
struct Quantity {
  std::string name;    ///< "Cavity radius"
  std::string symbol;  ///< "R"; may be empty
  std::string unit;    ///< SI, as catalog and library write it: "m", "m^2", "Pa", "1", ...
};

/// The quantity that a study or the catalog calls by this name ("cavity_radius", "collapsibility",
/// "pressure", ...). A name that is not known becomes words, with the unit that the caller gives ("1": a pure
/// number).
Quantity named_quantity(std::string_view name, std::string_view unit_if_unknown = "1");

/// Shown number = SI number * factor.
struct DisplayUnit {
  double factor = 1;
  std::string text;  ///< "µm", "MPa", "µm²"; empty for a pure number
};

/// The unit in which numbers up to this size are short: 16e-9 s as ns, 3e9 Pa as GPa. A unit that is not in
/// the table stays as it is.
DisplayUnit display_unit(std::string_view si_unit, double largest);

/// The unit in which the paper draws a field: stress in MPa, work in mJ (here per volume); others as
/// display_unit().
DisplayUnit paper_unit(std::string_view si_unit, double largest);

/// "Cavity radius R (µm)", "Collapsibility Φ".
std::string axis_label(const Quantity&, const DisplayUnit&);

/// "R = 1.5 µm", for legends; four digits.
std::string value_label(const Quantity&, double in_si);

}  // namespace analysis
