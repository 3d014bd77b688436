#include "runner/status/eta.hpp"

#include <algorithm>

namespace mpmstudy {

Eta::Eta(double predicted, unsigned workers) : total_(predicted), workers_(std::max(workers, 1u)) {}

void Eta::progress(const std::string& key, double predicted, double fraction) {
  running_[key] = {predicted, std::clamp(fraction, 0.0, 1.0)};
}

void Eta::finished(const std::string& key, double predicted) {
  running_.erase(key);
  finished_ += predicted;
}

void Eta::stopped(const std::string& key) { running_.erase(key); }

double Eta::fraction() const {
  double done = finished_;
  for (const auto& [key, job] : running_) done += job.predicted * job.fraction;
  return total_ > 0 ? std::min(done / total_, 1.0) : 0;
}

std::optional<double> Eta::remaining(double elapsed) const {
  const double share = fraction();
  if (elapsed <= 0 || share < 0.002) return std::nullopt;
  // The whole at the speed so far; but no sooner than the longest running job alone, whose speed is one
  // worker's share.
  const double speed = share * total_ / elapsed;
  double left = (1 - share) * total_ / speed;
  for (const auto& [key, job] : running_)
    left =
        std::max(left, (1 - job.fraction) * job.predicted /
                           (speed / static_cast<double>(std::min<std::size_t>(workers_, running_.size()))));
  return left;
}

}  // namespace mpmstudy
