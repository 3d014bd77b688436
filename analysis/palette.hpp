#pragma once
#include <string_view>

namespace analysis {

/// Of matplotlib's viridis (CC0), every eighth of the way; for `set palette defined`.
inline constexpr std::string_view viridis =
    "(0 '#440154', 1 '#472d7b', 2 '#3b528b', 3 '#2c728e', 4 '#21918c', 5 '#28ae80', 6 '#5ec962', 7 "
    "'#addc30', "
    "8 '#fde725')";

}  // namespace analysis
