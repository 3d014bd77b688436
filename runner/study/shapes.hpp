#pragma once
/// The shapes of bodies, as study files write them.
#include "libmpm/scene/composition.hpp"
#include "libmpm/space/space.hpp"
#include "runner/study/quantity_reader.hpp"

namespace mpmstudy {

/// What reading a part of a body needs, for one job.
struct BodyContext {
  mpm::Space space;
  const ValueOf& value;
  QuantityReader& quantities;
  Mistakes& mistakes;

  int axes() const { return mpm::axes_of(space); }
  /// A list of as many lengths (or speeds, numbers, ...) as the space has axes; what is beyond is 0. Empty
  /// after adding mistakes.
  std::optional<mpm::Triple> vector(std::string_view key, const Value&, std::string_view unit) const;
  std::optional<double> number(std::string_view key, const Value&, const Expected&) const;
};

/// { block = { low = [...], high = [...] } } and the like. Empty after adding mistakes.
std::optional<mpm::Shape> read_shape(const Entry&, const BodyContext&);

}  // namespace mpmstudy
