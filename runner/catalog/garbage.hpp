#pragma once
/// What a results folder holds that no study wants: rows of jobs, and folders of fields and checkpoints.
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace mpmstudy {

struct Garbage {
  std::int64_t jobs = 0;                       ///< rows of jobs that no study has and nobody runs
  std::vector<std::filesystem::path> folders;  ///< of fields/, of these jobs or of none that is known
  std::int64_t files = 0;                      ///< in these folders
  std::int64_t bytes = 0;                      ///< of these files
};

/// Looks only. A checkpoint of a job that a study has is no garbage: the job goes on from it. Throws
/// CatalogError: there is no catalog.
Garbage find_garbage(const std::filesystem::path& results);

/// What the files of a study take, and all of them.
struct DiskUse {
  struct OfStudy {
    std::string study;       ///< "": of jobs that no study has
    std::int64_t bytes = 0;  ///< of its jobs' fields; a job of two studies counts for both
  };
  std::int64_t catalog = 0;  ///< [bytes], its log included
  std::int64_t fields = 0;   ///< [bytes] of finished jobs, each once
  std::vector<OfStudy> studies;
};

/// As the catalog has it, without a look at each file. Throws CatalogError.
DiskUse disk_use(const std::filesystem::path& results);

}  // namespace mpmstudy
