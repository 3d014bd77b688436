#pragma once
#include <map>
#include <string>

namespace mpmstudy {

/// What the fine cells of `./reproduce.sh --full` say of a claim: results/reference/claims.csv, as it was
/// when the program was built.
struct ReferenceClaim {
  std::string verdict, measured;
};
/// By the claim's name.
const std::map<std::string, ReferenceClaim>& reference_claims();

}  // namespace mpmstudy
