// Compositions drawn at random: bodies of any shape and material that meet, fly apart, spin, implode or begin
// hot.
#include <algorithm>
#include <string>

#include "libmpm/scene/parameters.hpp"
#include "runner/plan/plan.hpp"
#include "tests/stability/case.hpp"
#include "tests/stability/dice.hpp"

namespace stability {
namespace {

using mpm::Shape;
using mpm::Triple;

/// A shape in the box from low to high, on the axis where there is one.
Shape draw_shape(Dice& d, mpm::Space space, const Triple& low, const Triple& high) {
  const bool axial = space == mpm::Space::axisymmetric;
  Triple center{}, half{};
  for (std::size_t k = 0; k < 3; ++k) center[k] = (low[k] + high[k]) / 2, half[k] = (high[k] - low[k]) / 2;
  if (axial) center[0] = 0, half[0] = high[0];
  const double radius = std::min({half[0], half[1], space == mpm::Space::three_d ? half[2] : half[1]});
  const auto ball = [&](double part) {
    return Shape{Shape::Form::ball, {center[0], center[1], center[2], part * radius}, {}};
  };
  switch (d.one_of(5)) {
    case 0:
      return ball(d.between(0.6, 1));
    case 1:
      return {Shape::Form::ellipsoid,
              {center[0], center[1], center[2], half[0] * d.between(0.5, 1), half[1] * d.between(0.5, 1),
               half[2] > 0 ? half[2] * d.between(0.5, 1) : 1},
              {}};
    case 2:
      return {Shape::Form::difference, {}, {ball(d.between(0.8, 1)), ball(d.between(0.1, 0.5))}};
    case 3:
      return {Shape::Form::difference,
              {},
              {{Shape::Form::block, {low[0], low[1], low[2], high[0], high[1], high[2]}, {}},
               ball(d.between(0.2, 0.9))}};
    default:
      return {Shape::Form::block, {low[0], low[1], low[2], high[0], high[1], high[2]}, {}};
  }
}

/// Bodies in slabs that lie one above the other.
mpm::Scene draw(Dice& d) {
  mpm::Scene s;
  s.kind = mpm::SceneKind::bodies;
  const mpm::Space spaces[] = {mpm::Space::plane_strain, mpm::Space::axisymmetric, mpm::Space::three_d};
  s.space = spaces[d.chance(0.1) ? 2 : d.one_of(2)];
  const bool solid = s.space == mpm::Space::three_d;
  s.numerics = mpm::default_numerics(s.kind, s.space);
  s.numerics.scheme = d.chance(0.3) ? mpm::ShapeFunction::gimp : mpm::ShapeFunction::bspline2;
  s.numerics.cfl = d.log_between(0.05, 0.5);
  s.numerics.linear_viscosity = d.between(0, 1.5);
  s.numerics.quadratic_viscosity = d.between(0, 2.5);
  if (d.chance(0.2)) s.numerics.kernel = mpm::Kernel::reference;

  const double scale = d.log_between(1e-9, 1e3);
  mpm::Composition& all = s.composition;
  all.high = {scale * d.between(1, 2), scale * d.between(1, 2), solid ? scale * d.between(1, 2) : 0};
  for (mpm::Face& face : all.faces) face = d.chance(0.5) ? mpm::Face::mirror : mpm::Face::open;
  if (s.space == mpm::Space::axisymmetric) all.faces[0] = mpm::Face::mirror;
  if (d.chance(0.4)) all.faces[static_cast<std::size_t>(mpm::Side::bottom)] = mpm::Face::wall;
  if (s.numerics.kernel == mpm::Kernel::fast)
    all.faces[static_cast<std::size_t>(mpm::Side::top)] = mpm::Face::open;
  s.numerics.cell_size = scale / (solid ? d.between(8, 12) : d.between(12, 40));

  const std::size_t count = 1 + d.one_of(3);
  double sound = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const auto names = mpm::material_names();
    const mpm::Material material = mpm::named_material(names[d.one_of(names.size())]);
    sound = std::max(sound, mpm::sound_speed_at_rest(material));
    if (k == 0)
      s.material = material;
    else
      s.other_materials.push_back(material);
    const double margin = d.chance(0.5) ? 0 : 0.05;  // some touch the faces and each other
    Triple low{}, high = all.high;
    for (std::size_t axis = 0; axis < 3; ++axis) low[axis] = margin * high[axis], high[axis] *= 1 - margin;
    const double from = (static_cast<double>(k) + margin) / static_cast<double>(count);
    low[1] = from * all.high[1];
    high[1] = (static_cast<double>(k) + 1 - margin) / static_cast<double>(count) * all.high[1];
    mpm::ComposedBody body{
        .name = "body " + std::to_string(k), .shape = draw_shape(d, s.space, low, high), .material = k};
    const double speed = d.log_between(1, 3000);
    for (std::size_t axis = 0; axis < (solid ? 3u : 2u); ++axis)
      body.velocity[axis] = speed * d.between(-1, 1);
    if (s.space == mpm::Space::axisymmetric) body.velocity[0] = 0;
    Triple center{};
    for (std::size_t axis = 0; axis < 3; ++axis) center[axis] = (low[axis] + high[axis]) / 2;
    if (s.space == mpm::Space::axisymmetric) center[0] = 0;
    if (s.space != mpm::Space::axisymmetric && d.chance(0.2))
      body.spin = d.between(-1, 1) * speed / scale, body.about = center;
    if (d.chance(0.2)) body.radial = {d.between(-1, 1) * speed, scale, d.between(-2, 2), center};
    if (d.chance(0.2)) body.energy = 0.5 * speed * speed;
    all.bodies.push_back(std::move(body));
  }
  s.end_time = d.log_between(0.1, 5) * scale / sound;
  s.measures.area_every = s.end_time / 20;
  return s;
}

}  // namespace

std::vector<Case> random_body_cases(int count, std::uint64_t seed) {
  return drawn_cases("random bodies", count, seed, draw,
                     [](const mpm::Scene& s) { return mpmstudy::canonical_text(s); });
}

}  // namespace stability
