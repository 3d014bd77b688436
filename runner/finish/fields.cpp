#include "runner/finish/fields.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <stdexcept>
#include <utility>

#include "analysis/units.hpp"
#include "libmpm/io/fields.hpp"
#include "libmpm/scene/build.hpp"
#include "libmpm/scene/kinds/kind.hpp"

namespace mpmstudy {
namespace {

/// How far from a slice particles are taken, in their edges: material that is stretched across the slice to
/// four times its length still has particles there. Of those that cover a place the nearest one is shown.
constexpr double reach = 2;

/// Edge of a particle's section [m].
double edge_of(const mpm::Snapshot& s, std::size_t p) {
  const double volume = s.mass[p] / s.density[p];
  return s.has_depth() ? std::cbrt(volume) : std::sqrt(volume);
}

/// "z = 1 um", "largest along z"; "" of the slice at z = 0.
std::string text_of(const FieldView& view) {
  if (view == FieldView{}) return "";
  const std::string axis(1, "xyz"[view.axis]);
  if (view.of == FieldView::Of::slice) return analysis::value_label({"", axis, "m"}, view.at);
  return (view.of == FieldView::Of::largest ? "largest along " : "mean along ") + axis;
}

/// The columns across and up of a picture that looks along an axis.
struct Seen {
  const std::vector<double>&across, &up, &along;
};
Seen seen_along(const mpm::Snapshot& s, int axis) {
  if (axis == 0) return {s.z, s.y, s.x};
  if (axis == 1) return {s.x, s.z, s.y};
  return {s.x, s.y, s.z};
}

/// What lies along an axis, one value for each column of particles.
class Projection {
 public:
  Projection(const mpm::Snapshot& s, const FieldView& view)
      : s_(s), seen_(seen_along(s, view.axis)), of_(view.of) {
    for (std::size_t p = 0; p < s.x.size(); ++p) side_ += volume(p);
    side_ = std::cbrt(side_ / static_cast<double>(std::max<std::size_t>(1, s.x.size())));
  }

  analysis::ParticleSquares of(const std::vector<double>& values) const {
    struct Column {
      double largest = -std::numeric_limits<double>::infinity(), sum = 0, volume = 0;
    };
    std::map<std::pair<std::int64_t, std::int64_t>, Column> columns;
    for (std::size_t p = 0; p < values.size(); ++p) {
      Column& column = columns[{cell(seen_.across[p]), cell(seen_.up[p])}];
      column.largest = std::max(column.largest, values[p]);
      column.sum += values[p] * volume(p), column.volume += volume(p);
    }
    analysis::ParticleSquares squares;
    for (const auto& [at, column] : columns) {
      squares.x.push_back((static_cast<double>(at.first) + 0.5) * side_);
      squares.y.push_back((static_cast<double>(at.second) + 0.5) * side_);
      squares.size.push_back(side_);
      squares.value.push_back(of_ == FieldView::Of::largest ? column.largest : column.sum / column.volume);
    }
    return squares;
  }

 private:
  double volume(std::size_t p) const { return s_.mass[p] / s_.density[p]; }
  std::int64_t cell(double x) const { return static_cast<std::int64_t>(std::floor(x / side_)); }

  const mpm::Snapshot& s_;
  Seen seen_;
  FieldView::Of of_;
  double side_ = 0;  ///< of a particle, in the mean [m]
};

}  // namespace

analysis::ParticleSquares particles_of(const mpm::Snapshot& s, const std::string& field,
                                       const std::vector<int>& materials, const FieldView& view) {
  const mpm::Field* row = mpm::find_field(field);
  if (!row) throw std::runtime_error("a snapshot has no field " + field);
  const std::vector<double>& values = s.*row->values;
  if (values.size() != s.x.size()) throw std::runtime_error("a snapshot of two axes has no field " + field);
  if (s.has_depth() && view.of != FieldView::Of::slice) return Projection(s, view).of(values);
  const Seen seen = seen_along(s, s.has_depth() ? view.axis : 2);
  const bool several = materials.size() == s.x.size();
  analysis::ParticleSquares particles;
  for (std::size_t p = 0; p < s.x.size(); ++p) {
    const double edge = edge_of(s, p);
    const double depth = s.has_depth() ? std::abs(seen.along[p] - view.at) : 0;
    if (!(depth < reach * edge)) continue;
    if (s.has_depth()) particles.depth.push_back(depth);
    particles.x.push_back(seen.across[p]), particles.y.push_back(seen.up[p]);
    particles.size.push_back(edge), particles.value.push_back(values[p]);
    if (several) particles.material.push_back(materials[p]);
  }
  return particles;
}

FieldPicture picture_of(const FigureRequest& request, const mpm::Scene& scene, const std::string& label) {
  const mpm::Kind& kind = mpm::kind_of(scene);
  FieldPicture picture;
  picture.mirrored = request.view.axis == 0 ? kind.is_half_along_z(scene) : kind.is_half(scene);
  if (request.view.axis == 0) picture.across = "z";
  if (request.view.axis == 1) picture.up = "z";
  for (const std::string& part : {request.title, label, text_of(request.view)})
    if (!part.empty()) picture.title += (picture.title.empty() ? "" : ", ") + part;
  return picture;
}

std::vector<int> materials_of(const mpm::Scene& scene) {
  std::vector<int> numbers;
  if (mpm::material_count(scene) < 2) return numbers;
  const auto ends = mpm::axes_of(scene.space) == 2 ? mpm::build_state<2>(scene).particles.material_ends
                                                   : mpm::build_state<3>(scene).particles.material_ends;
  for (std::size_t m = 0; m < ends.size(); ++m) numbers.resize(ends[m], static_cast<int>(m));
  return numbers;
}

}  // namespace mpmstudy
