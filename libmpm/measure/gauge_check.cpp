// What is wrong with the gauges of a scene.
#include <algorithm>
#include <functional>
#include <limits>
#include <set>
#include <string>

#include "libmpm/contact/contacts.hpp"
#include "libmpm/measure/gauges.hpp"
#include "libmpm/scene/kinds/kind.hpp"
#include "libmpm/scene/region_of.hpp"

namespace mpm {
namespace {

template <int axes>
std::string text_of_place(const std::vector<double>& place) {
  std::string text;
  for (const double x : place) text += (text.empty() ? "(" : ", ") + text_of(x);
  return text + ") m";
}

/// One gauge, whose mistakes are told under its name.
template <int axes>
class GaugeCheck {
 public:
  GaugeCheck(const Gauge& gauge, const Scene& scene, Report& report)
      : gauge_(gauge), scene_(scene), report_(report) {}

  void name(bool is_first) {
    if (!is_gauge_name(gauge_.name))
      add("name", gauge_.name, "up to 60 letters, digits, '-' and '_'");
    else if (!is_first)
      add("name", gauge_.name, "of one gauge only");
  }
  void quantity() {
    const GaugeQuantity* known = find_gauge_quantity(gauge_.target, gauge_.of);
    if (known && known->is_in(scene_.space)) return;
    std::string allowed;
    for (const GaugeQuantity& one : gauge_quantities(gauge_.target))
      if (one.is_in(scene_.space)) allowed += (allowed.empty() ? "" : ", ") + std::string(one.name);
    add("of", gauge_.of, allowed);
  }
  void place(const Vec<axes>& low, const Vec<axes>& high,
             const std::function<bool(const Vec<axes>&)>& inside) {
    const std::string key(to_string(gauge_.target)), value = text_of_place<axes>(gauge_.place);
    if (gauge_.place.size() != axes)
      return add(key, value, axes == 2 ? "two coordinates, x and y" : "three coordinates, x, y and z");
    const Vec<axes> x = gauge_vector<axes>(gauge_.place);
    if (!x.allFinite()) return add(key, value, "made of finite numbers");
    if (gauge_.target == GaugeTarget::point) {
      if (!inside(x)) add(key, value, "inside a body at time 0");
      return;
    }
    static constexpr const char* sides[3][2] = {
        {"the left side", "the right side"}, {"the floor", ""}, {"the front", "the back"}};
    for (int k = 0; k < axes; ++k)
      if (!(x[k] >= low[k] && x[k] <= high[k]))
        return add(
            key, value,
            "in what is modelled: " + std::string(1, static_cast<char>('x' + k)) + " from " + sides[k][0] +
                " (" + text_of(low[k]) + " m)" +
                (k == 1 ? " on" : std::string(" to ") + sides[k][1] + " (" + text_of(high[k]) + " m)"));
  }
  void direction() {
    if (const int axis = beam_direction(gauge_.direction).axis; axis >= 0 && axis < axes) return;
    std::string allowed;
    for (const std::string_view word : beam_directions(axes))
      allowed += (allowed.empty() ? "" : ", ") + std::string(word);
    add("direction", gauge_.direction, allowed);
  }
  void body() {
    if (gauge_.body == all_bodies) return;
    std::string allowed(all_bodies);
    for (const ComposedBody& one : scene_.composition.bodies) {
      if (one.rigid) continue;  // there are no particles
      if (one.name == gauge_.body) return;
      allowed += ", " + one.name;
    }
    add("body", gauge_.body, allowed);
  }
  void contact() {
    const Composition& all = scene_.composition;
    bool known = true;
    for (const std::string& name : {gauge_.first, gauge_.second}) {
      if (all.index_of(name) < all.bodies.size()) continue;
      add("contact", name, "names of two bodies");
      known = false;
    }
    if (!known) return;
    const Contacts contacts(scene_);
    if (contacts.field_of(all.index_of(gauge_.first)) == contacts.field_of(all.index_of(gauge_.second)))
      add("contact", gauge_.first + ", " + gauge_.second, "two bodies that are not welded to each other");
  }
  /// The impulse of a step is of the floor, and of a mirror above.
  void wall(Floor floor, bool has_ceiling) {
    if (gauge_.wall != "bottom")
      add("wall", gauge_.wall, "bottom");
    else if (floor == Floor::open)
      add("wall", gauge_.wall, "a wall that is there: the bottom is open");
    else if (has_ceiling)
      add("wall", gauge_.wall, "of a scene that is open above: its force is not told from that of the top");
  }
  void reductions() {
    std::set<std::string_view> names;
    for (const Reduction& one : gauge_.reductions) {
      const std::string key = "reduce." + one.name;
      const std::string times = text_of(one.from) + " s to " + text_of(one.to) + " s";
      if (!is_gauge_name(one.name))
        add(key, one.name, "up to 60 letters, digits, '-' and '_'");
      else if (is_kept_name(one.name) || !names.insert(one.name).second)
        add(key, one.name, "a name of its own, and not max, min, end or stop");
      if (!(one.from >= 0 && one.from <= one.to))
        add(key, times, "from 0 s on, the first time not after the second");
      else if (!(one.to <= scene_.end_time))
        add(key, times, "up to end_time (" + text_of(scene_.end_time) + " s)");
    }
  }

  void stops() {
    for (const Threshold& one : gauge_.stops) {
      if (!std::isfinite(one.value)) add("stop", text_of(one.value), "a finite number");
      if (!(one.after >= 0 && one.after < scene_.end_time))
        add("after", text_of(one.after) + " s",
            "from 0 s on and before end_time (" + text_of(scene_.end_time) + " s)");
    }
  }

 private:
  void add(const std::string& key, std::string value, std::string allowed) {
    report_.add_other("gauge." + gauge_.name + "." + key, std::move(value), std::move(allowed));
  }
  const Gauge& gauge_;
  const Scene& scene_;
  Report& report_;
};

struct Walls {
  Floor floor;
  bool has_ceiling;
};

template <int axes>
void check_all(const Scene& scene, const Walls& walls, const Vec<axes>& low, const Vec<axes>& high,
               const std::function<bool(const Vec<axes>&)>& inside, Report& report) {
  std::set<std::string_view> names;
  for (const Gauge& gauge : scene.measures.gauges) {
    GaugeCheck<axes> check(gauge, scene, report);
    check.name(names.insert(gauge.name).second);
    check.quantity();
    check.reductions();
    check.stops();
    switch (gauge.target) {
      case GaugeTarget::body:
        check.body();
        break;
      case GaugeTarget::contact:
        check.contact();
        break;
      case GaugeTarget::wall:
        check.wall(walls.floor, walls.has_ceiling);
        break;
      case GaugeTarget::beam:
        check.direction();
        [[fallthrough]];
      case GaugeTarget::point:
      case GaugeTarget::place:
        check.place(low, high, inside);
    }
  }
}

LineAt<2> line_through(const Vec2& x) { return x.x(); }
LineAt<3> line_through(const Vec3& x) { return {x.x(), x.z()}; }

template <int axes>
bool contains(const BasicRegion<axes>& region, const Vec<axes>& x, double slack) {
  std::vector<Interval> filled;
  region.cut(line_through(x), filled);
  return std::ranges::any_of(filled, [&](const Interval& interval) {
    return x.y() >= interval.low - slack && x.y() <= interval.high + slack;
  });
}

template <int axes>
void check_of_kind(const Scene& scene, Report& report) {
  const KindIn<axes>& kind = kind_of(scene).in<axes>();
  const BasicLattice<axes> l = kind.lattice(scene);
  Vec<axes> high = l.origin;
  high.x() += l.columns * l.cell.x();
  high.y() = std::numeric_limits<double>::infinity();
  if constexpr (axes == 3) high.z() += l.slices * l.cell.z();
  const double bottom = l.origin.y() + l.empty_rows * l.cell.y(), top = l.origin.y() + l.rows * l.cell.y();
  // a place on a side is inside, however it was rounded
  const double slack = 1e-6 * l.cell.minCoeff();
  std::vector<BasicBody<axes>> bodies;
  if (kind.body) bodies.push_back(kind.body(scene, l));
  const Composition& all = scene.composition;
  const Vec<axes> margin = Vec<axes>::Constant(slack);
  const BasicRegion<axes> box =
      block<axes>(vector(all.low).head<axes>() - margin, vector(all.high).head<axes>() + margin);
  for (const ComposedBody& one : all.bodies)
    if (!one.rigid) bodies.push_back({region_of<axes>(one.shape) & box, {}});
  const auto inside = [&](const Vec<axes>& x) {
    for (int k = 0; k < axes; ++k)
      if (k != 1 && !(x[k] >= l.origin[k] - slack && x[k] <= high[k] + slack)) return false;
    if (!(x.y() >= bottom - slack && x.y() <= top + slack)) return false;
    return std::ranges::any_of(bodies, [&](const BasicBody<axes>& body) {
      return contains<axes>(body.region, x - body.place, slack);
    });
  };
  const Walls walls{kind_of(scene).floor(scene), all.face(Side::top) == Face::mirror};
  check_all<axes>(scene, walls, l.origin, high, inside, report);
}

}  // namespace

void check_gauges(const Scene& scene, Report& report) {
  if (scene.measures.gauges.empty()) return;
  axes_of(scene.space) == 2 ? check_of_kind<2>(scene, report) : check_of_kind<3>(scene, report);
}

/// A body that was made by hand is where its particles are.
template <int axes>
void check_gauges(const Scene& scene, const BasicState<axes>& body, Report& report) {
  if (scene.measures.gauges.empty()) return;
  const auto& grid = body.grid;
  const Vec<axes> low = grid.origin();
  Vec<axes> high = low;
  high.x() += grid.columns() * grid.cell().x();
  high.y() = std::numeric_limits<double>::infinity();
  if constexpr (axes == 3) high.z() += grid.slices() * grid.cell().z();
  check_all<axes>(
      scene, {body.floor, body.ceiling.has_value()}, low, high,
      [&](const Vec<axes>& x) {
        return std::ranges::any_of(body.particles.position, [&](const Vec<axes>& p) {
          return (p - x).cwiseAbs().cwiseQuotient(grid.cell()).maxCoeff() <= 1;
        });
      },
      report);
}

template void check_gauges(const Scene&, const State&, Report&);
template void check_gauges(const Scene&, const BasicState<3>&, Report&);

}  // namespace mpm
