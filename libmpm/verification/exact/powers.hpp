#pragma once

namespace mpm::verification::exact {

inline double square(double x) { return x * x; }
inline double cube(double x) { return x * x * x; }

}  // namespace mpm::verification::exact
