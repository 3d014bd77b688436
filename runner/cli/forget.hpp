#pragma once
/// `mpmstudy forget STUDY...`: the catalog no longer has these studies; their jobs stay until `gc`.
#include <string>
#include <vector>

#include "runner/cli/cli.hpp"

namespace mpmstudy {

struct ForgetOptions {
  std::vector<std::string> studies;  ///< names, or study files
  std::string results;
};

void setup_forget(CLI::App&);
/// All of them or, if one is unknown or being run, none. Throws CatalogError.
int run_forget(const ForgetOptions&);

}  // namespace mpmstudy
