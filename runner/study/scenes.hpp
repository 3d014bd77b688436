#pragma once
/// From what a study says to scenes that can be run.
#include <string>
#include <vector>

#include "libmpm/scene/scene.hpp"
#include "runner/study/axis.hpp"
#include "runner/study/bodies.hpp"
#include "runner/study/combine.hpp"
#include "runner/study/gauges.hpp"
#include "runner/study/ladder_request.hpp"
#include "runner/study/mistakes.hpp"
#include "runner/study/requirement.hpp"
#include "runner/study/study.hpp"

namespace mpmstudy {

/// Everything that a study says about its scenes.
struct SceneRequest {
  mpm::SceneKind kind{};
  std::vector<Axis> axes;              ///< in the order of the file
  std::vector<JobQuantity> snapshots;  ///< [s]
  std::vector<GaugeRequest> gauges;
  bool seeks_ejection =
      false;           ///< of a [search]: runs decide ejection and end then, unless the file says more
  WrittenUnits units;  ///< of what the file gives, for messages
  double cells = 1;    ///< --cells: cell_size of the axes is that of the file times this
  LadderRequest ladder;
  Place ladder_place;              ///< of its key
  Place place;                     ///< of `scene`, for mistakes with values that the file does not name
  BodiesReader* bodies = nullptr;  ///< of scenes of bodies
  std::vector<Requirement> requirements;
  bool skips_invalid = false;  ///< points without a scene are no mistakes
  Place invalid_place;         ///< of its key
};

struct SweptScenes {
  std::vector<mpm::Scene> scenes;  ///< one per job
  std::vector<SkippedPoints> skipped;
};

/// The swept ones of the request's axes, in the order of the file.
std::vector<const Axis*> swept_axes(const SceneRequest&);

/// What mpm::find_problems has to say is added at the place of the value it is about, unless such points are
/// skipped.
SweptScenes build_scenes(const SceneRequest&, const Combinations&, Mistakes&);

}  // namespace mpmstudy
