#pragma once
#include <vector>

#include "libmpm/scene/parameters.hpp"
#include "runner/study/study.hpp"

namespace mpmstudy {

/// The quantity that a study's [search] looks for.
class Searched {
 public:
  explicit Searched(const Study&);

  const mpm::Quantity& quantity() const { return *quantity_; }
  /// Gives it another value. What the file gives by a derived row stays what the file says: with a
  /// wall_thickness, the cavity's centre moves as its radius does.
  void set(mpm::Scene&, double value) const;

 private:
  const mpm::Quantity* quantity_;
  std::vector<const mpm::Quantity*> kept_;
};

}  // namespace mpmstudy
