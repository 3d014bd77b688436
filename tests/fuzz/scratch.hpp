#pragma once
#include <unistd.h>

#include <cstdint>
#include <filesystem>
#include <fstream>
#include <string>

/// UDUNITS-2 loses a few bytes with every unit that it refuses.
extern "C" [[gnu::used]] inline const char* __lsan_default_suppressions() { return "leak:utlex\n"; }

namespace mpmstudy::fuzz {

/// A folder in memory where there is one, gone with the process.
class Scratch {
 public:
  Scratch() {
    namespace fs = std::filesystem;
    const fs::path memory = "/dev/shm";
    path_ = (fs::is_directory(memory) ? memory : fs::temp_directory_path()) /
            ("mpmstudy-fuzz-" + std::to_string(getpid()));
    fs::create_directories(path_);
  }
  ~Scratch() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

inline void write(const std::filesystem::path& path, const std::uint8_t* data, std::size_t size) {
  std::ofstream(path, std::ios::binary)
      .write(reinterpret_cast<const char*>(data), static_cast<std::streamsize>(size));
}

}  // namespace mpmstudy::fuzz
