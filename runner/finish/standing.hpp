#pragma once
#include <filesystem>
#include <string>

#include "runner/study/study.hpp"

namespace mpmstudy {

/// What the catalog has of a study against what its file says.
enum class Standing {
  whole,     ///< its jobs are those of the file, and all of them are done (of a search: all points bracketed)
  other,     ///< nothing, not all of it yet, or under its name something else than the file says
  undecided  ///< all that can run has run, but some jobs failed or some points were not found
};
struct StudyStanding {
  Standing standing = Standing::whole;
  std::string
      why;  ///< one clause for people, empty where whole: "the catalog has it at impact_speed = 150 m/s"
};

/// `study`: as its file says. Throws CatalogError if there is no catalog.
StudyStanding standing_of(const Study& study, const std::filesystem::path& results);

}  // namespace mpmstudy
