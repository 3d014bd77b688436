#pragma once
#include <array>
#include <string>
#include <string_view>

namespace mpmstudy {

/// Powers of the base units m, kg, s, K, A, mol, cd; angles are pure numbers.
struct Dimension {
  static constexpr std::array<std::string_view, 7> units = {"m", "kg", "s", "K", "A", "mol", "cd"};
  std::array<int, units.size()> powers{};
  bool operator==(const Dimension&) const = default;
  /// "kg m-1 s-2"; "1" for a pure number. Units of UDUNITS.
  std::string text() const;
};

}  // namespace mpmstudy
