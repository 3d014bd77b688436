#pragma once
#include <string>

namespace mpmstudy {

/// The commit that this program was built from, "-dirty" behind it if the sources had changed; "unknown"
/// outside a repository.
std::string git_revision();

}  // namespace mpmstudy
