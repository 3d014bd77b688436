#pragma once
#include <string>
#include <vector>

#include "analysis/calibration.hpp"
#include "runner/finish/study_results.hpp"

namespace mpmstudy {

/// How the intervals of a result hold: of every done job with five cells or more, what all cells but the two
/// finest give, against the extrapolated value of all cells; relative to accuracy_scale of that. Jobs of
/// which fewer than five cells show the result are left out.
std::vector<analysis::CalibrationPoint> calibration_of(const Study&, const StudyResults&,
                                                       const std::string& quantity);

}  // namespace mpmstudy
