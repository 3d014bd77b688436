#pragma once
/// The places to which a [surface] may add runs.
#include "runner/study/mistakes.hpp"
#include "runner/study/study.hpp"
#include "runner/study/sweep_request.hpp"

namespace mpmstudy {

/// Adds a mistake where the rest of the study does not go with its [surface].
void check_surface(const SweepRequest&, const Entry& section, const Study&, Mistakes&);

/// The design with more samples: of sobol, halton and random those that follow it; of a latin hypercube,
/// which nothing follows, a Sobol sequence of its seed.
SweepRequest candidates_of(const SweepRequest& design, const SurfaceRequest&);

}  // namespace mpmstudy
