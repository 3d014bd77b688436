#include "libmpm/contact/surface_table.hpp"

#include <algorithm>

namespace mpm {

void SurfaceTable::add(double centroid, double surface) {
  if (!centroids_.empty() && !(centroid > centroids_.back())) return;
  centroids_.push_back(centroid);
  surfaces_.push_back(surface);
}

double SurfaceTable::surface(double centroid) const {
  // a sliver at the edge of what the node sees is where its particles are
  if (centroid <= centroids_.front()) return surfaces_.front() + (centroid - centroids_.front());
  if (centroid >= centroids_.back()) return surfaces_.back();
  const auto next =
      static_cast<std::size_t>(std::ranges::upper_bound(centroids_, centroid) - centroids_.begin());
  const double part = (centroid - centroids_[next - 1]) / (centroids_[next] - centroids_[next - 1]);
  return surfaces_[next - 1] + part * (surfaces_[next] - surfaces_[next - 1]);
}

}  // namespace mpm
