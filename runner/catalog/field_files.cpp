// Field files against what the catalog says of them.
#include "runner/catalog/field_files.hpp"

#include <fmt/format.h>
#include <sys/stat.h>
#include <xxhash.h>

#include <chrono>
#include <fstream>
#include <unordered_set>

#include "runner/catalog/store_impl.hpp"

namespace mpmstudy {
namespace fs = std::filesystem;

std::string checksum_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  const std::unique_ptr<XXH3_state_t, decltype(&XXH3_freeState)> state(XXH3_createState(), XXH3_freeState);
  XXH3_128bits_reset(state.get());
  std::vector<char> block(1 << 16);
  while (file) {
    file.read(block.data(), static_cast<std::streamsize>(block.size()));
    XXH3_128bits_update(state.get(), block.data(), static_cast<std::size_t>(file.gcount()));
  }
  if (!file.eof()) throw CatalogError(path.string() + ": cannot be read");
  const XXH128_hash_t hash = XXH3_128bits_digest(state.get());
  return fmt::format("{:016x}{:016x}", hash.high64, hash.low64);
}

std::string what_is_wrong(const fs::path& path, std::int64_t bytes, const std::string& checksum) {
  std::error_code error;
  const auto size = fs::file_size(path, error);
  if (error) return fmt::format("{}: {}", path.string(), error.message());
  if (size != static_cast<std::uintmax_t>(bytes))
    return fmt::format("{}: has {} bytes, was written with {}", path.string(), size, bytes);
  if (checksum.empty() || checksum_of(path) == checksum) return {};
  return fmt::format("{}: its checksum is not the one it was written with", path.string());
}

std::int64_t modified_ns(const fs::path& path) {
  struct stat s {};
  if (stat(path.c_str(), &s) != 0) return 0;
  return std::int64_t{s.st_mtim.tv_sec} * 1'000'000'000 + s.st_mtim.tv_nsec;
}

/// A checksum costs reading the file, so it is taken where the file has another time than it was written
/// with. Only equality says something: file server and runners have clocks of their own. Rows of an older
/// catalog have no such time; there the file must not be newer than the end of its job.
std::map<std::int64_t, std::string> Store::Impl::damaged_jobs(std::int64_t study) {
  std::map<std::int64_t, std::string> damaged;
  SQLite::Statement rows(
      *db,
      "SELECT j.id, f.path, f.bytes, f.checksum, j.finished_at, f.modified_ns FROM study_job m "
      "JOIN job j ON j.id = m.job_id JOIN snapshot f ON f.job_id = j.id "
      "WHERE m.study_id = ? AND j.status = 'done'");
  rows.bind(1, study);
  while (rows.executeStep()) {
    const auto id = rows.getColumn(0).getInt64();
    if (damaged.contains(id)) continue;
    const fs::path path = results / rows.getColumn(1).getString();
    std::error_code ignored;
    const auto written = fs::last_write_time(path, ignored);
    const auto touched = utc_timestamp(std::chrono::time_point_cast<std::chrono::system_clock::duration>(
        std::chrono::file_clock::to_sys(written)));
    const std::int64_t then = rows.getColumn(5).getInt64();
    const bool read =
        then != 0 ? modified_ns(path) != then : !ignored && touched > rows.getColumn(4).getString();
    const auto wrong =
        what_is_wrong(path, rows.getColumn(2).getInt64(), read ? rows.getColumn(3).getString() : "");
    if (!wrong.empty()) damaged[id] = wrong;
  }
  return damaged;
}

std::int64_t Store::sweep_files() {
  std::unordered_set<std::string> kept, planned;
  SQLite::Statement rows(*impl_->db, "SELECT key, status = 'planned' FROM job WHERE status <> 'cancelled'");
  while (rows.executeStep())
    (rows.getColumn(1).getInt() == 1 ? planned : kept).insert(rows.getColumn(0).getString());
  // Files of a job whose key has changed stay where they are.
  SQLite::Statement former(*impl_->db,
                           "SELECT former_key FROM job WHERE former_key IS NOT NULL AND status = 'done'");
  while (former.executeStep()) kept.insert(former.getColumn(0).getString());
  std::int64_t swept = 0;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(impl_->results / "fields", error)) {
    const std::string key = entry.path().filename().string();
    if (kept.contains(key)) continue;
    std::error_code ignored;  // what stays is swept by a later start, or by the job's next attempt
    if (planned.contains(key) && fs::exists(entry.path() / checkpoint_name, ignored)) continue;
    fs::remove_all(entry.path(), ignored);
    ++swept;
  }
  return swept;
}

}  // namespace mpmstudy
