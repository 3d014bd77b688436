#include "runner/catalog/records.hpp"

#include <array>

#include "runner/catalog/catalog_error.hpp"

namespace mpmstudy {
namespace {
constexpr std::array<std::string_view, 5> status_names = {"planned", "running", "done", "failed",
                                                          "cancelled"};
constexpr std::array<std::string_view, 5> failure_names = {"breakdown", "timeout", "memory", "crash",
                                                           "error"};
}  // namespace

std::string_view to_string(JobStatus status) { return status_names[static_cast<std::size_t>(status)]; }

JobStatus job_status_from(std::string_view word) {
  for (std::size_t i = 0; i < status_names.size(); ++i)
    if (status_names[i] == word) return static_cast<JobStatus>(i);
  throw CatalogError("catalog: '" + std::string(word) + "' is no job status");
}

std::string_view to_string(FailureKind kind) { return failure_names[static_cast<std::size_t>(kind)]; }

FailureKind failure_kind_from(std::string_view word) {
  for (std::size_t i = 0; i < failure_names.size(); ++i)
    if (failure_names[i] == word) return static_cast<FailureKind>(i);
  throw CatalogError("catalog: '" + std::string(word) + "' is no kind of failure");
}

}  // namespace mpmstudy
