#include "runner/exec/git_revision.hpp"

#include "git_revision_text.h"  // made by cmake/git_revision.cmake

namespace mpmstudy {
std::string git_revision() { return MPMSTUDY_GIT_REVISION; }
}  // namespace mpmstudy
