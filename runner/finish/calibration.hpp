#pragma once
#include <string>
#include <vector>

#include "analysis/calibration.hpp"
#include "runner/finish/study_results.hpp"

namespace mpmstudy {

/// How the intervals of a result hold: of every done job with more than first_cells cells, what its
/// first_cells coarsest ones give, against the extrapolated value of all; relative to accuracy_scale of that.
/// Jobs of which too few cells show the result are left out.
std::vector<analysis::CalibrationPoint> calibration_of(const Study&, const StudyResults&,
                                                       const std::string& quantity);

}  // namespace mpmstudy
