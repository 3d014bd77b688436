#pragma once
/// Whether a surface through the runs of a study is as good as its [surface] wants. Pure.
#include <Eigen/Core>
#include <optional>
#include <string>
#include <vector>

#include "analysis/gaussian_process.hpp"
#include "runner/study/study.hpp"

namespace mpmstudy {

/// A run of the design, or one that was added.
struct SurfaceRun {
  const mpm::Scene* scene = nullptr;
  std::optional<double> value;  ///< of the result, SI; empty: it has failed, or its number has no meaning
  double error = 0;             ///< half width of its interval
};

/// The quantities that a study sweeps of each scene [SI], a row each.
Eigen::MatrixXd places_of(const Study&, const std::vector<const mpm::Scene*>&);

/// A tolerance holds when, at nine of ten of the places where runs may be, one would be within it of the
/// surface. That share is what the surface says itself: the mean, over the places, of the probability that a
/// run there is within the tolerance, by its deviation and the scatter of runs. Where runs that are left out
/// in turn show the surface too sure of itself, its deviations count as much larger as nine of ten of them
/// ask for. Of fewer than ten runs for each quantity it is not believed: so few do not show how much runs
/// scatter.
struct SurfaceState {
  std::size_t runs = 0, shown = 0;  ///< ... of them with the result
  double tolerance = 0;             ///< SI
  double share = 0;                 ///< of the places at which it holds
  std::size_t least = 0;            ///< runs from which on that is believed
  std::string failure;              ///< why there is no surface; else ""
  std::optional<analysis::GaussianProcess> process;

  bool holds() const;
};
SurfaceState surface_state(const Study&, const std::vector<SurfaceRun>&);

/// "a run would be within 0.0148 of it at 83 % of the places, wanted are 90 %".
std::string readable_state(const Study&, const SurfaceState&);

}  // namespace mpmstudy
