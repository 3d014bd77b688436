#pragma once
/// Where more runs would tell a surface most.
#include <Eigen/Core>
#include <vector>

#include "analysis/gaussian_process.hpp"

namespace analysis {

/// Rows of `candidates`, at most `count`, best first: each is the one after which the variance of the surface
/// is least, summed over all candidates [Seo et al. 2000; Cohn 1996], as if those chosen before had been run.
/// The sum counts a place more where runs nearby, left out, are off by more than the surface says: near a
/// jump or a bend. `seen`: places that runs have been asked for and that say nothing, a row each: nobody goes
/// there again. What is chosen follows from the arguments alone; of equals the first one is taken.
std::vector<Eigen::Index> next_places(const GaussianProcess&, const Eigen::MatrixXd& candidates,
                                      const Eigen::MatrixXd& seen, std::size_t count);

}  // namespace analysis
