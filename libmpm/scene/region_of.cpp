#include "libmpm/scene/region_of.hpp"

#include <functional>
#include <limits>

namespace mpm {
namespace {

Mat3 rotation_of(const Shape& shape) {
  return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(shape.rotation.data());
}

/// Reads the numbers of a shape one after the other, where the shape puts them.
template <int axes>
class Numbers {
 public:
  explicit Numbers(const Shape& shape) : shape_(shape), next_(shape.numbers.begin()) {}
  double number() { return *next_++; }
  bool left() const { return next_ != shape_.numbers.end(); }
  /// Not moved.
  Vec3 triple() {
    const double x = number(), y = number(), z = number();
    return {x, y, z};
  }
  Vec<axes> point() { return in_axes(rotation_of(shape_) * triple() + vector(shape_.shift)); }
  Vec<axes> direction() { return in_axes(rotation_of(shape_) * triple()); }
  Vec<axes> lengths() { return in_axes(triple()); }
  static Vec<axes> in_axes(const Vec3& x) { return x.head<axes>(); }

 private:
  const Shape& shape_;
  std::vector<double>::const_iterator next_;
};

/// A block that is turned lies between pairs of planes.
template <int axes>
BasicRegion<axes> turned_block(const Vec3& low, const Vec3& high, const Shape& shape) {
  const auto move = [&](const Vec3& x) {
    return Numbers<axes>::in_axes(rotation_of(shape) * x + vector(shape.shift));
  };
  BasicRegion<axes> region = everywhere<axes>();
  for (int k = 0; k < axes; ++k) {
    const Vec<axes> outwards = Numbers<axes>::in_axes(rotation_of(shape) * Vec3::Unit(k));
    region = region & half_space<axes>(move(high), outwards) & half_space<axes>(move(low), -outwards);
  }
  region.low = Vec<axes>::Constant(std::numeric_limits<double>::infinity());
  region.high = -region.low;
  for (int corner = 0; corner < 8; ++corner) {
    Vec3 x = low;
    for (int k = 0; k < 3; ++k)
      if (corner >> k & 1) x[k] = high[k];
    region.low = region.low.cwiseMin(move(x)), region.high = region.high.cwiseMax(move(x));
  }
  return region;
}

template <int axes>
BasicRegion<axes> primitive(const Shape& shape) {
  Numbers<axes> of(shape);
  switch (shape.form) {
    case Shape::Form::block: {
      const Vec3 low = of.triple(), high = of.triple();
      if (shape.rotation != Shape::no_rotation) return turned_block<axes>(low, high, shape);
      return block<axes>(of.in_axes(low + vector(shape.shift)), of.in_axes(high + vector(shape.shift)));
    }
    case Shape::Form::ball: {
      const Vec<axes> center = of.point();
      return ball<axes>(center, of.number());
    }
    case Shape::Form::ellipsoid: {
      const Vec<axes> center = of.point(), half_axes = of.lengths();
      return ellipsoid<axes>(center, half_axes, rotation_of(shape).topLeftCorner<axes, axes>());
    }
    case Shape::Form::polygon: {
      std::vector<Vec2> corners;
      while (of.left()) {
        const double x = of.number(), y = of.number();
        corners.push_back((rotation_of(shape) * Vec3(x, y, 0) + vector(shape.shift)).head<2>());
      }
      return polygon<axes>(corners);
    }
    case Shape::Form::half_space: {
      const Vec<axes> point = of.point(), outwards = of.direction();
      return half_space<axes>(point, outwards);
    }
    case Shape::Form::cylinder:
      if constexpr (axes == 3) {
        const Vec3 from = of.point(), to = of.point();
        return cylinder(from, to, of.number());
      }
      [[fallthrough]];  // refused by the checks of the scene
    default:
      return everywhere<axes>();
  }
}

/// The shape moved by what its whole is moved by.
Shape moved(Shape part, const Shape& whole) {
  const Vec3 shift = rotation_of(whole) * vector(part.shift) + vector(whole.shift);
  const Mat3 rotation = rotation_of(whole) * rotation_of(part);
  for (int i = 0; i < 3; ++i) {
    part.shift[static_cast<std::size_t>(i)] = shift[i];
    for (int k = 0; k < 3; ++k) part.rotation[static_cast<std::size_t>(3 * i + k)] = rotation(i, k);
  }
  return part;
}

/// Parts [first, last), halved again and again: of many parts no chain of calls gets long.
template <int axes>
BasicRegion<axes> united(const Shape& whole, std::size_t first, std::size_t last) {
  if (last - first == 1) return region_of<axes>(moved(whole.parts[first], whole));
  const std::size_t middle = (first + last) / 2;
  return united<axes>(whole, first, middle) | united<axes>(whole, middle, last);
}

}  // namespace

template <int axes>
BasicRegion<axes> region_of(const Shape& shape) {
  if (shape.parts.empty()) return primitive<axes>(shape);
  if (shape.form == Shape::Form::together) return united<axes>(shape, 0, shape.parts.size());
  BasicRegion<axes> region = region_of<axes>(moved(shape.parts.front(), shape));
  for (std::size_t k = 1; k < shape.parts.size(); ++k) {
    BasicRegion<axes> part = region_of<axes>(moved(shape.parts[k], shape));
    if (shape.form == Shape::Form::difference)
      region = std::move(region) - std::move(part);
    else
      region = std::move(region) & std::move(part);
  }
  return region;
}

template BasicRegion<2> region_of(const Shape&);
template BasicRegion<3> region_of(const Shape&);

}  // namespace mpm
