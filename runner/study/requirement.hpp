#pragma once
/// [sweep] require = "...": which points of a sweep are wanted.
#include <string>
#include <vector>

#include "runner/study/quantity_reader.hpp"

namespace mpmstudy {

struct Requirement {
  Expression expression;  ///< 1 where it holds, 0 where it does not
  Place place;
  std::string written;
};

/// One text or a list of them. `searched`: what [search] looks for, which has no value; "": nothing.
std::vector<Requirement> read_requirements(const Table* sweep, const std::string& searched, const Units&,
                                           const KnownParameters&, Mistakes&);

/// The names in them, which a file may need for nothing else.
std::vector<std::string> names_in_requirements(const Table* sweep);

}  // namespace mpmstudy
