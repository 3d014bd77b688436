#include "libmpm/verification/lagrangian/lagrangian_2d.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>

#include "libmpm/material/list.hpp"

namespace mpm::verification::lagrangian {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

/// The vector turned to the right by a quarter: of the way along a line, its area vector to the right.
Vec2 right_of(const Vec2& along) { return {along.y(), -along.x()}; }

/// A velocity without what the holds forbid. The floor stops what moves into it.
Vec2 allowed(Vec2 v, std::uint8_t hold, double height, double dt) {
  if (hold & held_x) v.x() = 0;
  if (hold & held_y) v.y() = 0;
  if (hold & on_floor) v.y() = std::max(v.y(), dt > 0 ? -height / dt : 0);
  return v;
}

/// The artificial viscosity of the models is not asked for: edges have their own.
constexpr ArtificialViscosity no_viscosity{0, 0, 0};

}  // namespace

/// Its four nodes x, and a_c = dA/dx_c.
struct Lagrangian2d::Corners {
  std::array<Vec2, 4> x, a;
  Vec2 middle;
  double area;

  Corners(const std::array<int, 4>& cell, const std::vector<Vec2>& nodes) {
    for (std::size_t c = 0; c < 4; ++c) x[c] = nodes[index(cell[c])];
    for (std::size_t c = 0; c < 4; ++c) a[c] = 0.5 * right_of(x[(c + 1) % 4] - x[(c + 3) % 4]);
    middle = 0.25 * ((x[0] + x[2]) + (x[1] + x[3]));
    const Vec2 d = x[2] - x[0], e = x[3] - x[1];
    area = 0.5 * (d.x() * e.y() - e.x() * d.y());
  }
  double longest_edge() const {
    double square = 0;
    for (std::size_t c = 0; c < 4; ++c) square = std::max(square, (x[(c + 1) % 4] - x[c]).squaredNorm());
    return std::sqrt(square);
  }
};

Lagrangian2d::Lagrangian2d(const Material& material, QuadMesh mesh, std::vector<Vec2> velocities,
                           const Options& options)
    : material_(material),
      mesh_(std::move(mesh)),
      options_(options),
      velocity_(std::move(velocities)),
      node_mass_(mesh_.nodes.size(), 0) {
  if (velocity_.size() != mesh_.nodes.size() || mesh_.holds.size() != mesh_.nodes.size())
    throw std::invalid_argument("Lagrangian2d: a velocity and a hold for each node");
  for (std::size_t j = 0; j < velocity_.size(); ++j)
    velocity_[j] = allowed(velocity_[j], mesh_.holds[j], mesh_.nodes[j].y(), 0);
  const std::size_t count = mesh_.cells.size();
  with_model_type<double>(material_, [&]<class Model>(std::size_t) {
    own_count_ = static_cast<std::size_t>(numbers_in(Model::state, 2));
  });
  force_.resize(count), deviator_.resize(count, Deviator<double>{});
  own_.resize(count * own_count_, 0);
  for (auto* column : {&dilation_, &energy_, &pressure_}) column->resize(count, 0);
  sound_.resize(count, sound_speed_at_rest(material_));
  for (const auto& cell : mesh_.cells) {
    const Corners c(cell, mesh_.nodes);
    if (!(c.area > 0)) throw std::invalid_argument("Lagrangian2d: a cell without area");
    area_.push_back(c.area);
    mass_.push_back(material_.reference_density * c.area);
    for (const int node : cell) node_mass_[index(node)] += mass_.back() / 4;
  }
  first_area_ = area_;
  find_edges();
}

Lagrangian2d::~Lagrangian2d() = default;

/// Of the edges that meet in a node of four cells, the one beyond an edge shares no cell with it.
void Lagrangian2d::find_edges() {
  std::map<std::pair<int, int>, int> known;
  std::vector<std::vector<int>> cells_of;
  for (std::size_t i = 0; i < mesh_.cells.size(); ++i) {
    const auto& cell = mesh_.cells[i];
    std::array<int, 4> edges;
    for (std::size_t c = 0; c < 4; ++c) {
      const auto ends = std::minmax(cell[c], cell[(c + 1) % 4]);
      const auto [at, is_new] = known.try_emplace({ends.first, ends.second}, static_cast<int>(edges_.size()));
      if (is_new) edges_.push_back({ends.first, ends.second, -1, -1}), cells_of.emplace_back();
      edges[c] = at->second;
      cells_of[index(at->second)].push_back(static_cast<int>(i));
    }
    cell_edges_.push_back(edges);
  }
  std::vector<std::vector<int>> edges_of(mesh_.nodes.size());
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    edges_of[index(edges_[e].from)].push_back(static_cast<int>(e));
    edges_of[index(edges_[e].to)].push_back(static_cast<int>(e));
  }
  const auto beyond = [&](std::size_t e, int node) {
    int found = -1;
    for (const int other : edges_of[index(node)]) {
      const auto& ours = cells_of[e];
      const bool apart = std::ranges::none_of(
          cells_of[index(other)], [&](int cell) { return std::ranges::find(ours, cell) != ours.end(); });
      if (!apart) continue;
      if (found >= 0) return -1;  // more than four cells meet here
      found = other;
    }
    return found;
  };
  for (std::size_t e = 0; e < edges_.size(); ++e) {
    edges_[e].before = beyond(e, edges_[e].from);
    edges_[e].after = beyond(e, edges_[e].to);
  }
}

double Lagrangian2d::limiter(const Edge& edge) const {
  if (!options_.limiter) return 0;
  const auto way = [&](const Edge& e) -> Vec2 {
    return mesh_.nodes[index(e.to)] - mesh_.nodes[index(e.from)];
  };
  const auto change = [&](const Edge& e) -> Vec2 {
    return velocity_[index(e.to)] - velocity_[index(e.from)];
  };
  const Vec2 dx = way(edge), dv = change(edge);
  const double square = dv.squaredNorm();
  if (!(square > 0)) return 0;
  const auto ratio = [&](int next) {
    if (next < 0) return 1.0;
    const Edge& e = edges_[index(next)];
    const double along = way(e).dot(dx);  // both differences change sign with the direction of the edge
    return along == 0 ? 0.0 : change(e).dot(dv) / along * dx.squaredNorm() / square;
  };
  const double r = ratio(edge.before), s = ratio(edge.after);
  return std::max(0.0, std::min({1.0, 0.5 * (r + s), 2 * r, 2 * s}));
}

double Lagrangian2d::stable_step() const {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < area_.size(); ++i) {
    const auto& cell = mesh_.cells[i];
    const Corners c(cell, mesh_.nodes);
    double change = 0;
    for (std::size_t k = 0; k < 4; ++k)
      change =
          std::max(change, (velocity_[index(cell[(k + 1) % 4])] - velocity_[index(cell[k])]).squaredNorm());
    const double viscous =
        options_.linear_viscosity * sound_[i] + options_.quadratic_viscosity * std::sqrt(change);
    least = std::min(
        least, c.area / c.longest_edge() / (viscous + std::sqrt(viscous * viscous + sound_[i] * sound_[i])));
  }
  return options_.cfl * least;
}

void Lagrangian2d::find_forces() {
  std::vector<double> sharpness(edges_.size());  // 1 - psi
  for (std::size_t e = 0; e < edges_.size(); ++e) sharpness[e] = 1 - limiter(edges_[e]);
  for (std::size_t i = 0; i < mesh_.cells.size(); ++i) {
    const auto& cell = mesh_.cells[i];
    const Corners c(cell, mesh_.nodes);
    const Deviator<double>& s = deviator_[i];
    const double density = mass_[i] / c.area, impedance = density * sound_[i];
    auto& force = force_[i];
    for (std::size_t k = 0; k < 4; ++k)
      force[k] = {-((s.xx - pressure_[i]) * c.a[k].x() + s.xy * c.a[k].y()),
                  -(s.xy * c.a[k].x() + (s.yy - pressure_[i]) * c.a[k].y())};

    for (std::size_t k = 0; k < 4; ++k) {
      const std::size_t next = (k + 1) % 4;
      const Vec2 change = velocity_[index(cell[next])] - velocity_[index(cell[k])];
      const Vec2 across = right_of(c.middle - 0.5 * (c.x[k] + c.x[next]));
      const double closing = across.dot(change);
      if (!(closing < 0)) continue;
      const double speed = change.norm();
      const double q = sharpness[index(cell_edges_[i][k])] * (options_.linear_viscosity * impedance +
                                                              options_.quadratic_viscosity * density * speed);
      const Vec2 pull = (q * -closing / speed) * change;
      force[k] += pull;
      force[next] -= pull;
    }

    // gamma_c = h_c - sum_b h_b x_b . a_c / A
    const Vec2 twist = (c.x[0] + c.x[2]) - (c.x[1] + c.x[3]);
    std::array<double, 4> gamma;
    Vec2 mode = Vec2::Zero();
    for (std::size_t k = 0; k < 4; ++k) {
      gamma[k] = (k % 2 == 0 ? 1 : -1) - twist.dot(c.a[k]) / c.area;
      mode += gamma[k] * velocity_[index(cell[k])];
    }
    const double damping = options_.hourglass * impedance * std::sqrt(c.area);
    for (std::size_t k = 0; k < 4; ++k) force[k] -= (damping * gamma[k]) * mode;
  }
}

void Lagrangian2d::accelerate(double dt) {
  std::vector<Vec2> sum(mesh_.nodes.size(), Vec2::Zero());
  for (std::size_t i = 0; i < force_.size(); ++i)
    for (std::size_t k = 0; k < 4; ++k) sum[index(mesh_.cells[i][k])] += force_[i][k];
  std::vector<Vec2> mean(mesh_.nodes.size());
  for (std::size_t j = 0; j < sum.size(); ++j) {
    const Vec2 before = velocity_[j], free = before + (dt / node_mass_[j]) * sum[j];
    velocity_[j] = allowed(free, mesh_.holds[j], mesh_.nodes[j].y(), dt);
    mean[j] = 0.5 * (before + velocity_[j]);
    if (mesh_.holds[j] & on_floor) floor_work_ += node_mass_[j] * (velocity_[j].y() - free.y()) * mean[j].y();
  }
  for (std::size_t i = 0; i < force_.size(); ++i) {
    double work = 0;
    for (std::size_t k = 0; k < 4; ++k) work += force_[i][k].dot(mean[index(mesh_.cells[i][k])]);
    energy_[i] -= dt * work / mass_[i];
  }
}

void Lagrangian2d::deform(double dt) {
  std::vector<Mat2> gradient(mesh_.cells.size());
  for (std::size_t i = 0; i < gradient.size(); ++i) {
    const Corners c(mesh_.cells[i], mesh_.nodes);
    gradient[i].setZero();
    for (std::size_t k = 0; k < 4; ++k)
      gradient[i] += (velocity_[index(mesh_.cells[i][k])] * c.a[k].transpose()) / c.area;
  }
  for (std::size_t j = 0; j < velocity_.size(); ++j) mesh_.nodes[j] += dt * velocity_[j];
  time_ += dt;
  with_model<double>({material_, no_viscosity}, [&](const auto& model, std::size_t) {
    for (std::size_t i = 0; i < gradient.size(); ++i) {
      area_[i] = Corners(mesh_.cells[i], mesh_.nodes).area;
      tangled_ = tangled_ || !(area_[i] > 0);
      const Mat2 l = dt * gradient[i];
      auto strain = strain_over<double, space::PlaneStrain>(
          dilation_[i], Gradient<double>{l(0, 0), l(0, 1), l(1, 0), l(1, 1)}, model);
      // The area is that of the nodes: the gradient does not know of the hourglass motion's part of it.
      dilation_[i] = area_[i] / first_area_[i] - 1;
      strain.compression = -dilation_[i] / (1 + dilation_[i]);
      strain.divisor = 1 / (1 + model.implicit(dilation_[i], trace(strain.rate)));
      double no_viscous_pressure = 0;
      const Point<double> point{dilation_[i], energy_[i],          deviator_[i],
                                pressure_[i], no_viscous_pressure, &own_[i * own_count_]};
      model.shear(point, strain, 1 / dt);
      sound_[i] = std::sqrt(model.bulk(point, strain, 1 / dt).longitudinal_square);
    }
  });
}

bool Lagrangian2d::advance(double longest) {
  if (tangled_) return false;
  const double dt = std::min({stable_step(), longest, last_step_ > 0 ? 1.1 * last_step_ : longest});
  find_forces();
  accelerate(0.5 * (last_step_ + dt));
  deform(dt);
  last_step_ = dt;
  ++steps_;
  return !tangled_;
}

double Lagrangian2d::energy() const {
  double sum = -floor_work_;
  for (std::size_t j = 0; j < velocity_.size(); ++j) sum += 0.5 * node_mass_[j] * velocity_[j].squaredNorm();
  for (std::size_t i = 0; i < mass_.size(); ++i) sum += mass_[i] * energy_[i];
  return sum;
}

}  // namespace mpm::verification::lagrangian
