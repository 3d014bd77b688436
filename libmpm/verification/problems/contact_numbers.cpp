// Bodies in contact, against what is known of them: BENCHMARKS.md says more of each.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "libmpm/measure/gauges.hpp"
#include "libmpm/verification/exact/hertz.hpp"
#include "libmpm/verification/exact/rolling.hpp"
#include "libmpm/verification/problems/contact_scenes.hpp"
#include "libmpm/verification/problems/problems.hpp"
#include "libmpm/verification/problems/scenes.hpp"
#include "libmpm/verification/problems/with_options.hpp"

namespace mpm::verification {
namespace {

using namespace contact_scenes;

/// Of a whole run: what contact must not lose.
void add_balance(ExactNumbers& numbers, const RunResult& r) {
  numbers.push_back({"energy error", "1", 0, r.energy_error, 1e-12, Judged::absolute});
  numbers.push_back({"momentum error", "1", 0, metric(r, "momentum_error"), 1e-12, Judged::absolute});
}

/// Slope of the straight line through a history from a time on, of the sum of `parts` of histories.
double slope(const RunResult& r, double from, std::initializer_list<std::pair<const char*, double>> parts) {
  double n = 0, t = 0, v = 0, tt = 0, tv = 0;
  const std::vector<double>& times = r.history(parts.begin()->first)->times;
  for (std::size_t k = 0; k < times.size(); ++k) {
    if (times[k] < from) continue;
    double value = 0;
    for (const auto& [name, part] : parts) value += part * r.history(name)->values[k];
    n += 1, t += times[k], v += value, tt += times[k] * times[k], tv += times[k] * value;
  }
  return (n * tv - t * v) / (n * tt - t * t);
}

}  // namespace

/// A cylinder of radius 0.5 m on a rigid plane, 16 cells per radius, E = 1 MPa. Gravity rises over 0.4 s, two
/// periods of the bouncing cylinder; accelerations are slopes over the second half of a second.
ExactNumbers rolling_numbers(double degrees, double friction, bool turned, const ExactOptions& options) {
  constexpr double radius = 0.5, g = 9.81, end = 1;
  const double angle = degrees * std::numbers::pi / 180, h = radius / 16 * options.cells;
  const double c = std::cos(angle), s = std::sin(angle), way = 0.5 * g * s * end * end, room = radius + 4 * h;
  Scene scene = turned ? box(Space::plane_strain, h, {-room, -room - way * s, 0}, {room + way * c, room, 0})
                       : box(Space::plane_strain, h, {-room, -room, 0}, {room + way, room, 0});
  scene.material = elastic(1e6);
  ComposedBody plane = rigid_plane(turned ? angle : 0);
  plane.shape.shift = {-radius * (turned ? s : 0), -radius * (turned ? c : 1), 0};
  scene.composition.bodies = {{.name = "cylinder", .shape = ball({0, 0, 0}, radius)}, plane};
  scene.composition.contacts = {friction > 0 ? coulomb(friction) : frictionless()};
  scene.composition.gravity = turned ? Triple{0, -g, 0} : Triple{g * s, -g * c, 0};
  scene.composition.gravity_rise = 0.4;
  scene.end_time = end;
  scene.measures.area_every = end / 400;
  for (const char* of : {"velocity_x", "velocity_y", "spin"}) add_gauge(scene, of, of, "cylinder");
  const RunResult r = run(with_options(scene, options));
  const exact::Rolling rolls(angle, friction, g, 0.5);
  const double down = turned ? c : 1, across = turned ? -s : 0;
  const double ours = slope(r, 0.5, {{"velocity_x", down}, {"velocity_y", across}});
  const double rim = -radius * slope(r, 0.5, {{"spin", 1}});
  ExactNumbers numbers = {
      {"acceleration", "m/s2", rolls.acceleration, ours, rolls.sticks && friction > 0 ? 0.025 : 0.002}};
  if (friction > 0)
    numbers.push_back(
        {"acceleration of the rim", "m/s2", rolls.rim_acceleration, rim, rolls.sticks ? 0.03 : 0.06});
  else
    numbers.push_back({"acceleration of the rim", "m/s2", 0, rim, 0.05, Judged::absolute});
  add_balance(numbers, r);
  return with_trouble(std::move(numbers), r);
}

/// Two spheres of radius 10 mm, E = 1 GPa, nu = 0.3, 1000 kg/m^3, two cells apart on the axis; 20 cells per
/// radius. The force is the change of momentum of one; Hertz's answer is that of small strain.
ExactNumbers spheres_numbers(double speed, const ExactOptions& options) {
  constexpr double radius = 10e-3;
  const double h = radius / 20 * options.cells, gap = 2 * h;
  const exact::Hertz hertz(radius, 1e9, 0.3, 1000, speed);
  Scene scene = box(Space::axisymmetric, h, {0, 0, 0}, {1.2 * radius, 4.6 * radius, 0});
  scene.composition.bodies = {
      {.name = "low", .shape = ball({0, 1.2 * radius, 0}, radius), .velocity = {0, speed / 2, 0}},
      {.name = "high", .shape = ball({0, 3.2 * radius + gap, 0}, radius), .velocity = {0, -speed / 2, 0}}};
  scene.composition.contacts = {frictionless()};
  scene.end_time = gap / speed + 1.4 * hertz.time;
  scene.measures.area_every = scene.end_time / 300;
  add_gauge(scene, "low", "center_y", "low"), add_gauge(scene, "high", "center_y", "high");
  add_gauge(scene, "speed", "velocity_y", "high");
  add_contact_gauge(scene, "force", "force_y", "high", "low");
  const RunResult r = run(with_options(scene, options));
  const History &force = *r.history("force"), &low = *r.history("low"), &high = *r.history("high");
  double largest = 0, approach = 0;
  for (const double f : force.values) largest = std::max(largest, f);
  for (std::size_t k = 0; k < low.values.size(); ++k)
    approach = std::max(approach, 2 * radius - (high.values[k] - low.values[k]));
  // a mean over the period before its time
  const auto pushes = [&](double f) { return f > 1e-3 * largest; };
  const auto first = std::ranges::find_if(force.values, pushes) - force.values.begin();
  const auto last =
      force.values.rend() - std::find_if(force.values.rbegin(), force.values.rend(), pushes) - 1;
  const auto time = [&](std::ptrdiff_t k) { return force.times.at(static_cast<std::size_t>(k)); };
  const double period = scene.measures.area_every, begin = time(first) - period;
  ExactNumbers numbers = {
      {"time in contact", "s", hertz.time, time(last) - begin, speed < 10 ? 0.05 : 0.08},
      {"largest force", "N", hertz.force, 2 * std::numbers::pi * largest, speed < 10 ? 0.05 : 0.1},
      {"largest approach", "m", hertz.approach, approach, 0.05},
      {"restitution", "1", 0.97, 2 * metric(r, "speed.end") / speed, 0, Judged::shortfall},
      {"gap at the first force, in cells", "1", 0, (gap - speed * begin) / h, 0.2, Judged::absolute}};
  add_balance(numbers, r);
  return with_trouble(std::move(numbers), r);
}

/// The copper bar of studies/benchmarks/taylor.toml, 8 cells per radius. Length and foot: to where the
/// particles' domains end.
ExactNumbers taylor_numbers(const ExactOptions& options) {
  constexpr double radius = 3.2e-3, length = 32.4e-3;
  const double h = radius / 8 * options.cells;
  const auto scene_on = [&](bool plane) {
    Scene scene = box(Space::axisymmetric, h, {0, plane ? -4 * h : 0, 0}, {3 * radius, length + 4 * h, 0});
    scene.material = named_material("copper");
    Material& m = scene.material;
    m.youngs_modulus = 117e9, m.poissons_ratio = 0.35, m.bulk_sound_speed = 3815.5;
    m.yield_stress = 400e6, m.hardening_modulus = 100e6, m.hardening_measure = HardeningMeasure::equivalent;
    scene.composition.bodies = {
        {.name = "bar", .shape = block({0, 0, 0}, {radius, length, 0}), .velocity = {0, -227, 0}}};
    if (plane) {
      scene.composition.bodies.push_back(rigid_plane(0));
      scene.composition.contacts = {frictionless()};
    } else {
      face(scene, Side::bottom) = Face::wall;
    }
    scene.end_time = 80e-6;
    scene.measures.area_every = 1e-6;
    add_gauge(scene, "top", "highest_y", "bar"), add_gauge(scene, "foot", "highest_x", "bar");
    return with_options(scene, options);
  };
  const RunResult r = run(scene_on(true)), wall = run(scene_on(false));
  ExactNumbers numbers = {
      {"length", "m", 21.42e-3, metric(r, "top.end"), 0.2e-3, Judged::absolute},
      {"radius of the foot", "m", 7.23e-3, metric(r, "foot.end"), 0.2e-3, Judged::absolute},
      {"length, against the wall of a box", "m", metric(wall, "top.end"), metric(r, "top.end"), 0.1e-3,
       Judged::absolute},
      {"foot, against the wall of a box", "m", metric(wall, "foot.end"), metric(r, "foot.end"), 0.15e-3,
       Judged::absolute}};
  add_balance(numbers, r);
  return with_trouble(std::move(numbers), r);
}

/// Four elastic spheres that come together at the centre of a square, in three dimensions, 6 cells per
/// radius; the upper half is modelled, all four of it. The rims of bodies are cut into strips along y
/// (body/fill.cpp): the four are mirror images of each other, but not images in the diagonal.
ExactNumbers four_spheres_numbers(const ExactOptions& options) {
  constexpr double radius = 10e-3, speed = 10;
  const double h = radius / 6 * options.cells, at = radius + 0.5 * h, along = speed / std::sqrt(2.0);
  const double edge = h * std::ceil((2 * at + 2 * h) / h);
  Scene scene = box(Space::three_d, h, {-edge, -edge, 0}, {edge, edge, radius + 2 * h});
  face(scene, Side::front) = Face::mirror;
  scene.composition.contacts = {frictionless()};
  const char* names[] = {"a", "b", "c", "d"};
  for (int k = 0; k < 4; ++k) {
    const double x = k == 0 || k == 3 ? 1 : -1, y = k < 2 ? 1 : -1;
    scene.composition.bodies.push_back({.name = names[k],
                                        .shape = ball({x * at, y * at, 0}, radius),
                                        .velocity = {-x * along, -y * along, 0}});
    for (const char* of : {"velocity_x", "velocity_y"})
      add_gauge(scene, (std::string(names[k]) + of).c_str(), of, names[k]);
  }
  scene.end_time = h / (2 * along) + 1.3 * exact::Hertz(radius, 1e9, 0.3, 1000, 2 * along).time;
  scene.measures.area_every = scene.end_time / 40;
  const RunResult r = run(with_options(scene, options));
  double asymmetry = 0, off_diagonal = 0;
  const double ax = metric(r, "avelocity_x.end"), ay = metric(r, "avelocity_y.end");
  for (int k = 0; k < 4; ++k) {
    const double x = k == 0 || k == 3 ? 1 : -1, y = k < 2 ? 1 : -1;
    const double vx = x * metric(r, std::string(names[k]) + "velocity_x.end");
    const double vy = y * metric(r, std::string(names[k]) + "velocity_y.end");
    asymmetry = std::max({asymmetry, std::abs(vx / ax - 1), std::abs(vy / ay - 1)});
    off_diagonal = std::max(off_diagonal, std::abs(vx - vy) / along);
  }
  ExactNumbers numbers = {
      {"speed of leaving over that of coming", "1", 0.85, ax / along, 0, Judged::shortfall},
      {"difference between the four", "1", 0, asymmetry, 1e-10, Judged::absolute},
      {"speed across the diagonal", "1", 0, off_diagonal, 0.005, Judged::absolute}};
  add_balance(numbers, r);
  return with_trouble(std::move(numbers), r);
}

/// A copper flyer at 2 m/s on aluminium, both elastic, so slow that the match of acoustic impedances Z = rho
/// c is exact to 0.05 %: between the two waves the velocity is Zc / (Za + Zc) of the flyer's, the stress Za
/// times that.
ExactNumbers contact_shock_numbers(const ExactOptions& options) {
  constexpr double speed = 2;
  const double h = 0.05e-6 * options.cells, width = 4 * h;
  Scene scene = box(Space::plane_strain, h, {0, 0, 0}, {width, 12e-6, 0});
  face(scene, Side::left) = face(scene, Side::right) = Face::mirror;
  scene.material = named_material("aluminium"), scene.other_materials = {named_material("copper")};
  const double za = scene.material.reference_density * sound_speed_at_rest(scene.material);
  const Material& copper = scene.other_materials[0];
  const double zc = copper.reference_density * sound_speed_at_rest(copper), common = -speed * zc / (za + zc);
  for (Material* m : {&scene.material, &scene.other_materials[0]})
    m->yield_stress = std::numeric_limits<double>::infinity();
  scene.composition.bodies = {{.name = "target", .shape = block({0, 1e-6, 0}, {width, 6e-6, 0})},
                              {.name = "flyer",
                               .shape = block({0, 6e-6, 0}, {width, 11e-6, 0}),
                               .material = 1,
                               .velocity = {0, -speed, 0}}};
  scene.end_time = 0.75e-9;
  scene.measures.area_every = 0.01e-9;
  const auto look = [&](const char* name, const char* of, double y) {
    scene.measures.gauges.push_back({.name = name,
                                     .of = of,
                                     .place = {width / 2, y},
                                     .reductions = {{"mean", Window::mean, 0.55e-9, 0.7e-9}}});
  };
  look("below", "velocity_y", 5e-6), look("above", "velocity_y", 7e-6);
  look("stress", "stress_yy", 5e-6);
  scene.composition.contacts = {frictionless()};
  const RunResult r = run(with_options(scene, options));
  ExactNumbers numbers = {{"velocity below", "m/s", common, metric(r, "below.mean"), 0.005},
                          {"velocity above", "m/s", common, metric(r, "above.mean"), 0.005},
                          {"stress", "Pa", za * common, metric(r, "stress.mean"), 0.005}};
  add_balance(numbers, r);
  return with_trouble(std::move(numbers), r);
}

}  // namespace mpm::verification
