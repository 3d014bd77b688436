#pragma once
#include <cmath>
#include <numbers>

namespace mpm::verification::exact {

/// Two equal elastic spheres that meet head on at the relative speed v: with 1/E* = 2 (1 - nu^2) / E,
/// R* = R / 2, m* = m / 2,
///   F = 4/3 E* sqrt(R*) d^(3/2),   d_max = (15 m* v^2 / (16 E* sqrt(R*)))^(2/5),
///   time in contact (4/5) sqrt(pi) Gamma(2/5) / Gamma(9/10) d_max / v = 2.94328 d_max / v.
/// Source: H. Hertz 1882, J. reine angew. Math. 92, 156; K. L. Johnson 1985, Contact Mechanics, section 11.4.
/// Valid while the radius of contact sqrt(R* d) is small against R.
struct Hertz {
  double approach, force, time;  ///< largest [m], [N], in contact [s]

  Hertz(double radius, double youngs_modulus, double poissons_ratio, double density, double speed) {
    const double mass = 4.0 / 3 * std::numbers::pi * std::pow(radius, 3) * density / 2;
    const double modulus = youngs_modulus / (2 * (1 - poissons_ratio * poissons_ratio));
    const double root = std::sqrt(radius / 2);
    approach = std::pow(15 * mass * speed * speed / (16 * modulus * root), 0.4);
    force = 4.0 / 3 * modulus * root * std::pow(approach, 1.5);
    time = 0.8 * std::sqrt(std::numbers::pi) * std::tgamma(0.4) / std::tgamma(0.9) * approach / speed;
  }
};

}  // namespace mpm::verification::exact
