#pragma once
/// What a scene of the kind "bodies" is made of, as plain data in SI units.
#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "libmpm/core/enumerators.hpp"

namespace mpm {

using Triple = std::array<double, 3>;  ///< x, y, z

/// A region (body/region.hpp, made by region_of.hpp) as data. Of two axes z is 0 and means nothing, but for a
/// prism.
struct Shape {
  enum class Form {
    block,         ///< low corner, high corner
    ball,          ///< centre, radius; of two axes a disc
    ellipsoid,     ///< centre, half axes
    cylinder,      ///< centre of one end, of the other, radius; of three axes
    polygon,       ///< corners (x, y) in turn; of three axes the prism along z
    half_space,    ///< a point of the plane, and the direction that points away from the half space
    together,      ///< what is in one of the parts
    difference,    ///< what is in the first part and in no other
    intersection,  ///< what is in all parts
  };
  Form form = Form::block;
  std::vector<double> numbers;  ///< in the order above, points as (x, y, z) [m]
  std::vector<Shape> parts;
  /// Of the shape, after it is made: x -> rotation x + shift [m].
  std::array<double, 9> rotation = no_rotation;  ///< row by row
  Triple shift{};

  static constexpr std::array<double, 9> no_rotation = {1, 0, 0, 0, 1, 0, 0, 0, 1};
};
inline constexpr auto shape_forms = words<Shape::Form>({{Shape::Form::block, "block"},
                                                        {Shape::Form::ball, "ball"},
                                                        {Shape::Form::ellipsoid, "ellipsoid"},
                                                        {Shape::Form::cylinder, "cylinder"},
                                                        {Shape::Form::polygon, "polygon"},
                                                        {Shape::Form::half_space, "half-space"},
                                                        {Shape::Form::together, "union"},
                                                        {Shape::Form::difference, "minus"},
                                                        {Shape::Form::intersection, "intersection"}});

/// What two bodies do where they touch.
enum class ContactLaw {
  welded,        ///< they share the grid: neither slides nor parts, except as the grid lets it
  frictionless,  ///< contact/frictionless.hpp
  coulomb,       ///< contact/coulomb.hpp
};
inline constexpr auto contact_laws = words<ContactLaw>({{ContactLaw::welded, "welded"},
                                                        {ContactLaw::frictionless, "frictionless"},
                                                        {ContactLaw::coulomb, "coulomb"}});

/// Of a pair of bodies; without names of all pairs that no other rule names.
struct ContactRule {
  std::string first, second;
  ContactLaw law = ContactLaw::welded;
  double friction = 0;  ///< mu, of Coulomb [1]; may be infinite
};

/// Towards a point or away from it, at the distance r from it with the speed
///   speed (r / at)^exponent                                          [m/s]
/// An incompressible cylinder has the exponent -1, a sphere -2; 1: all parts keep their proportions; 0: one
/// speed.
struct RadialVelocity {
  double speed = 0;     ///< positive outwards [m/s]
  double at = 1;        ///< where it is that speed, > 0 [m]; of no effect when the exponent is 0
  double exponent = 0;  ///< [1]
  Triple about{};       ///< [m]

  bool operator==(const RadialVelocity&) const = default;
};

/// A region, its material, and how it moves at time 0.
struct ComposedBody {
  std::string name;
  Shape shape;
  std::size_t material = 0;  ///< number in the scene, see material_of()
  Triple velocity{};         ///< [m/s]
  double spin = 0;           ///< angular velocity about the line along z through `about` [rad/s]
  Triple about{};            ///< [m]
  RadialVelocity radial{};   ///< beside the others
  /// Specific internal energy at time 0, above that of the material at rest [J/kg]: a body at the density of
  /// rest, heated there. Its pressure follows (pressure_per_energy()).
  double energy = 0;
  /// Nothing deforms or stops it: it keeps velocity and spin, has no material and no particles, and acts on
  /// others by contact alone (contact/rigid_body.hpp). `about` moves with it.
  bool rigid = false;
};

/// What is at a side of the box.
enum class Face {
  open,    ///< nothing; a run ends where a body reaches it, but above
  mirror,  ///< rigid, frictionless, holds what touches it; what lies behind is the image
  wall,    ///< below only: rigid, frictionless, lets go
};
inline constexpr auto face_words =
    words<Face>({{Face::open, "open"}, {Face::mirror, "mirror"}, {Face::wall, "wall"}});

enum class Side { left, right, bottom, top, front, back };
inline constexpr auto side_words = words<Side>({{Side::left, "left"},
                                                {Side::right, "right"},
                                                {Side::bottom, "bottom"},
                                                {Side::top, "top"},
                                                {Side::front, "front"},
                                                {Side::back, "back"}});

struct Composition {
  Triple low{}, high{};               ///< corners of the box that the bodies lie in [m]
  std::array<Face, 6> faces{};        ///< in the order of Side; front and back of three axes
  std::vector<ComposedBody> bodies;   ///< in the order of their materials
  std::vector<ContactRule> contacts;  ///< pairs that none is of are welded
  Triple gravity{};                   ///< acceleration of all that is in the box [m/s^2]

  double gravity_rise = 0;  ///< over which gravity grows from nothing, evenly [s]
  bool has_gravity() const { return gravity != Triple{}; }
  /// Of the body of that name; as many as there are bodies where there is none.
  std::size_t index_of(std::string_view name) const {
    const auto has_name = [&](const ComposedBody& b) { return b.name == name; };
    return static_cast<std::size_t>(std::find_if(bodies.begin(), bodies.end(), has_name) - bodies.begin());
  }
  Face face(Side side) const { return faces[static_cast<std::size_t>(side)]; }
};

}  // namespace mpm
