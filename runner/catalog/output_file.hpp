#pragma once
#include <filesystem>
#include <fstream>

namespace mpmstudy {

/// A text file that appears under its name when it is whole: written under a name of its own (unique_name),
/// synced, renamed by commit(). Without commit() nothing stays. Throws CatalogError naming path and cause.
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

/// "STEM.0123456789abcdef.tmp": random, since process numbers are the same on two machines or in two
/// namespaces that share the folder.
std::filesystem::path unique_name(const std::filesystem::path& stem);

/// Makes sure that a file or a folder's list of names is on disk. Throws std::system_error.
void sync_to_disk(const std::filesystem::path&);

}  // namespace mpmstudy
