#include "runner/exec/job_checkpoint.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "libmpm/io/checkpoint.hpp"

namespace mpmstudy {
namespace {

namespace fs = std::filesystem;

constexpr const char* spent = "job/spent";
constexpr const char* program = "job/program";
constexpr const char* files = "job/files";

std::vector<std::int64_t> column_of(const std::string& text) { return {text.begin(), text.end()}; }
std::string text_of(const std::vector<std::int64_t>& column) {
  std::string text;
  for (const auto c : column) text += static_cast<char>(c);
  return text;
}

/// Identifies this program: only the same code gives the same bits.
std::string this_program() {
  std::error_code ignored;
  const fs::path path = fs::read_symlink("/proc/self/exe", ignored);
  return fmt::format("{} {} {}", path.string(), fs::file_size(path, ignored),
                     fs::last_write_time(path, ignored).time_since_epoch().count());
}

}  // namespace

void write_job_checkpoint(const fs::path& path, JobCheckpoint checkpoint) {
  nlohmann::json list = nlohmann::json::array();
  for (const auto& f : checkpoint.files)
    list.push_back({f.time, f.step, f.path, f.bytes, f.checksum, f.modified_ns});
  mpm::Record& record = checkpoint.run;
  record.numbers[spent] = {checkpoint.wall_s, checkpoint.cpu_s};
  record.integers[program] = column_of(this_program());
  record.integers[files] = column_of(list.dump());
  mpm::write_checkpoint(path, record);
}

std::optional<JobCheckpoint> read_job_checkpoint(const fs::path& path, const fs::path& results,
                                                 std::string& why_not) {
  std::error_code ignored;
  if (!fs::exists(path, ignored)) return std::nullopt;
  try {
    JobCheckpoint checkpoint;
    checkpoint.run = mpm::read_checkpoint(path);
    mpm::Record& record = checkpoint.run;
    if (text_of(record.integers.at(program)) != this_program()) {
      why_not = "its checkpoint is of another build of the program";
      return std::nullopt;
    }
    checkpoint.wall_s = record.numbers.at(spent).at(0);
    checkpoint.cpu_s = record.numbers.at(spent).at(1);
    for (const auto& f : nlohmann::json::parse(text_of(record.integers.at(files)))) {
      checkpoint.files.push_back({f.at(0), f.at(1), f.at(2), f.at(3), f.at(4), f.at(5)});
      const SnapshotFile& file = checkpoint.files.back();
      if (why_not = what_is_wrong(results / file.path, file.bytes, file.checksum); !why_not.empty())
        return std::nullopt;
    }
    return checkpoint;
  } catch (const std::exception& error) {
    why_not = std::string("its checkpoint cannot be read: ") + error.what();
    return std::nullopt;
  }
}

}  // namespace mpmstudy
