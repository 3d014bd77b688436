#pragma once
#include <filesystem>
#include <fstream>

namespace mpmstudy {

/// A text file that appears under its name when it is whole: written as NAME.tmp, synced, renamed by
/// commit(). Without commit() nothing stays. Throws CatalogError naming path and cause.
class OutputFile {
 public:
  explicit OutputFile(std::filesystem::path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  std::ostream& stream() { return stream_; }
  void commit();

 private:
  std::filesystem::path path_, partial_;
  std::ofstream stream_;
  bool committed_ = false;
};

/// Makes sure that a file or a folder's list of names is on disk. Throws std::system_error.
void sync_to_disk(const std::filesystem::path&);

}  // namespace mpmstudy
