#include "runner/catalog/records.hpp"

#include "libmpm/core/enumerators.hpp"
#include "runner/catalog/catalog_error.hpp"

namespace mpmstudy {
namespace {
constexpr auto status_names = mpm::words<JobStatus>({{JobStatus::planned, "planned"},
                                                     {JobStatus::running, "running"},
                                                     {JobStatus::done, "done"},
                                                     {JobStatus::failed, "failed"},
                                                     {JobStatus::cancelled, "cancelled"}});
constexpr auto failure_names = mpm::words<FailureKind>({{FailureKind::breakdown, "breakdown"},
                                                        {FailureKind::timeout, "timeout"},
                                                        {FailureKind::memory, "memory"},
                                                        {FailureKind::crash, "crash"},
                                                        {FailureKind::error, "error"}});
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
