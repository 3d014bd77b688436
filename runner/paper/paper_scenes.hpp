#pragma once
#include <string>

#include "runner/study/study.hpp"

namespace mpmstudy {

/// In what a study that bears the name of one of the paper's studies differs from it: "impact_speed = 150 m/s
/// in place of 200 m/s". Empty where it does not differ, and of other studies. Cells and other numerics may
/// differ: they decide how far a number can be trusted, not what it is of.
std::string unlike_the_paper(const Study&);

}  // namespace mpmstudy
