#include "runner/catalog/output_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <random>
#include <system_error>

#include "runner/catalog/catalog_error.hpp"

namespace mpmstudy {

namespace {

namespace fs = std::filesystem;

/// What a link leads to is replaced, not the link; `-o /dev/stdout` is one, too.
fs::path behind_links(fs::path path) {
  std::error_code error;
  if (!fs::is_symlink(path, error)) return path;
  const fs::path target = fs::canonical(path, error);
  return error ? path : target;
}

/// A device or a pipe is written to: a file that takes its place would be a device no longer.
bool is_written_in_place(const fs::path& path) {
  std::error_code error;
  const auto status = fs::status(path, error);
  return fs::exists(status) && !fs::is_regular_file(status) && !fs::is_directory(status);
}

}  // namespace

OutputFile::OutputFile(std::filesystem::path path)
    : path_(behind_links(std::move(path))),
      partial_(is_written_in_place(path_) ? path_ : unique_name(path_)) {
  std::error_code error;
  if (fs::is_directory(path_, error))
    throw CatalogError(path_.string() + ": cannot be written: it is a folder");
  if (path_.has_parent_path()) std::filesystem::create_directories(path_.parent_path(), error);
  stream_.open(partial_, std::ios::binary | std::ios::trunc);
  if (!stream_)
    throw CatalogError(path_.string() + ": cannot be written (" +
                       std::error_code(errno, std::generic_category()).message() + ")");
}

OutputFile::~OutputFile() {
  if (committed_ || partial_ == path_) return;
  stream_.close();
  std::error_code ignored;
  std::filesystem::remove(partial_, ignored);
}

void OutputFile::commit() {
  stream_.close();
  if (!stream_) throw CatalogError(path_.string() + ": cannot be written; is the disk full?");
  if (partial_ == path_) return;
  try {
    sync_to_disk(partial_);
    std::filesystem::rename(partial_, path_);
  } catch (const std::system_error& error) {
    throw CatalogError(path_.string() + ": cannot be written (" + error.code().message() + ")");
  }
  committed_ = true;
}

std::filesystem::path unique_name(const std::filesystem::path& stem) {
  std::random_device random;
  const std::uint64_t high = random(), low = random();
  return stem.string() + fmt::format(".{:016x}.tmp", high << 32 | low);
}

void sync_to_disk(const std::filesystem::path& path) {
  const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  const bool failed = file < 0 || fsync(file) != 0;
  const int code = errno;
  if (file >= 0) close(file);
  if (failed) throw std::system_error(code, std::generic_category(), path.string());
}

}  // namespace mpmstudy
