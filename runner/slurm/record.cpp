#include "runner/slurm/record.hpp"

#include <pwd.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <system_error>

#include "runner/catalog/output_file.hpp"

namespace mpmstudy {
namespace {

namespace fs = std::filesystem;

constexpr const char* file_name = "submitted.json";
constexpr const char* closed_name = "merged";  // the merge's script makes it, too

}  // namespace

void write_record(const fs::path& folder, const SubmissionRecord& record) {
  OutputFile file(folder / file_name);
  file.stream() << nlohmann::ordered_json({{"study", record.study},
                                           {"name", record.name},
                                           {"array", record.array_id},
                                           {"merge", record.merge_id},
                                           {"shards", record.shards},
                                           {"clusters", record.clusters},
                                           {"cluster", record.cluster},
                                           {"user", record.user},
                                           {"asked_at", record.asked_at}})
                       .dump(2)
                << "\n";
  file.commit();
}

std::optional<SubmissionRecord> read_record(const fs::path& folder) {
  const fs::path path = folder / file_name;
  std::error_code error;
  if (!fs::exists(path, error)) {
    if (error && error != std::errc::not_a_directory)
      throw std::runtime_error(path.string() + ": cannot be read: " + error.message());
    return {};
  }
  std::ifstream file(path);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  if (!file.is_open()) throw std::runtime_error(path.string() + ": cannot be read");
  try {
    const auto json = nlohmann::json::parse(text);
    SubmissionRecord record;
    record.study = json.at("study").get<std::string>();
    record.array_id = json.value("array", "");
    record.merge_id = json.value("merge", "");
    record.shards = json.at("shards").get<std::size_t>();
    record.name = json.value("name", "mpmstudy-" + record.study);  // as all jobs of a study were once called
    record.clusters = json.value("clusters", "");
    record.cluster = json.value("cluster", "");
    record.user = json.value("user", "");
    record.asked_at = json.value("asked_at", std::int64_t{0});
    return record;
  } catch (const nlohmann::json::exception&) {
    throw std::runtime_error(path.string() + ": is not what `mpmstudy run --engine slurm` writes");
  }
}

bool is_closed(const fs::path& folder) {
  std::error_code none;
  return fs::exists(folder / closed_name, none);
}

void close_submission(const fs::path& folder) {
  std::ofstream file(folder / closed_name);
  file.close();
  if (!file) throw std::runtime_error((folder / closed_name).string() + ": cannot be written");
}

std::string user_name() {
  std::array<char, 4096> text;
  passwd entry, *found = nullptr;
  if (getpwuid_r(geteuid(), &entry, text.data(), text.size(), &found) == 0 && found != nullptr)
    return found->pw_name;
  return std::to_string(geteuid());
}

}  // namespace mpmstudy
