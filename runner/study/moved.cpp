#include "runner/study/moved.hpp"

#include <algorithm>
#include <system_error>

namespace mpmstudy {
namespace {

namespace fs = std::filesystem;

/// What is in a folder; empty where it cannot be read.
std::vector<fs::path> entries_of(const fs::path& folder) {
  std::vector<fs::path> entries;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
    entries.push_back(folder / entry->path().filename());
  return entries;
}

bool is_study_file(const fs::path& path) {
  std::error_code error;
  return path.extension() == ".toml" && fs::is_regular_file(path, error);
}

}  // namespace

std::vector<fs::path> same_name_below(const fs::path& path) {
  const fs::path name = path.filename();
  if (name.empty()) return {};
  const fs::path above = path.parent_path();
  std::vector<fs::path> found;
  for (const fs::path& entry : entries_of(above.empty() ? "." : above)) {
    std::error_code error;
    if (!fs::is_directory(entry, error)) continue;
    const bool has = name == "*.toml" ? std::ranges::any_of(entries_of(entry), is_study_file)
                                      : fs::is_regular_file(entry / name, error);
    if (has) found.push_back(above / entry.filename() / name);
  }
  std::ranges::sort(found);
  return found;
}

}  // namespace mpmstudy
