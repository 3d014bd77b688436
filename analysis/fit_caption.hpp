#pragma once
#include <string>

#include "analysis/fit.hpp"
#include "analysis/units.hpp"

namespace analysis {

/// "Φ = (0.98 ± 0.02) − (0.11 ± 0.01) R;  R in µm;  r² = 0.998;  χ²/ν = 0.4" in the units of the axes. χ²/ν,
/// per degree of freedom, only where the errors of the points are its weights; above 1 it says "lack of fit".
std::string fit_caption(const Fit&, const QuantityLabel& x, const DisplayUnit&, const QuantityLabel& y,
                        const DisplayUnit&);

}  // namespace analysis
