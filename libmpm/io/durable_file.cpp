#include "libmpm/io/durable_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <random>
#include <stdexcept>
#include <string>
#include <system_error>

namespace mpm {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, const char* step) {
  throw std::runtime_error(path.string() + ": " + step + ": " + std::generic_category().message(errno));
}

/// An open file that closes itself. close() is called by hand where its error matters.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  int number() const { return number_; }
  int close() {
    const int number = number_;
    number_ = -1;
    return ::close(number);
  }

 private:
  int number_;
};

void write_all(const std::filesystem::path& path, int file, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(file, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) fail(path, "cannot write");
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
}

void write_and_sync(const std::filesystem::path& path, std::span<const std::byte> bytes) {
  Descriptor file(::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
  if (file.number() < 0) fail(path, "cannot create");
  write_all(path, file.number(), bytes);
  if (::fsync(file.number()) != 0) fail(path, "cannot sync");
  if (file.close() != 0) fail(path, "cannot close");
}

void sync_folder(std::filesystem::path folder) {
  if (folder.empty()) folder = ".";
  const Descriptor file(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (file.number() < 0) fail(folder, "cannot open the folder");
  if (::fsync(file.number()) != 0 && errno != EINVAL) fail(folder, "cannot sync the folder");
}

/// "PATH.0123456789abcdef.tmp": random, since process numbers are the same on two machines.
std::filesystem::path temporary_name(const std::filesystem::path& path) {
  std::random_device random;
  char text[17];
  std::snprintf(text, sizeof text, "%08x%08x", random(), random());
  return path.string() + "." + text + ".tmp";
}

}  // namespace

void write_durably(const std::filesystem::path& path, std::span<const std::byte> bytes) {
  const std::filesystem::path temporary = temporary_name(path);
  try {
    write_and_sync(temporary, bytes);
    if (::rename(temporary.c_str(), path.c_str()) != 0) fail(path, "cannot rename the .tmp to it");
  } catch (...) {
    ::unlink(temporary.c_str());
    throw;
  }
  sync_folder(path.parent_path());
}

}  // namespace mpm
