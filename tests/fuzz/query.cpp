// Any bytes as SQL for `query`: rows, or refused with a CatalogError; the catalog stays as it is, whatever
// was asked.
#include "runner/catalog/query.hpp"

#include <cstdlib>
#include <fstream>
#include <sstream>

#include "runner/catalog/catalog_error.hpp"
#include "runner/catalog/connection.hpp"
#include "runner/catalog/writer.hpp"
#include "tests/fuzz/scratch.hpp"

namespace {

std::string bytes_of(const std::filesystem::path& path) {
  std::stringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

/// Statements that go on and on are stopped: the fuzzer looks for damage, not for slow statements.
constexpr double most_seconds = 0.1;

struct FewRows : mpmstudy::RowSink {
  void columns(std::span<const std::string>) override {}
  void row(std::span<const mpmstudy::SqlValue>) override {
    if (++count > 1000) throw mpmstudy::CatalogError("enough");
  }
  int count = 0;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const mpmstudy::fuzz::Scratch scratch;
  static const std::string before = [] {
    { mpmstudy::CatalogWriter(scratch.path()).register_study("s", "S", {}, false); }
    return bytes_of(mpmstudy::catalog_path(scratch.path()));
  }();
  try {
    FewRows rows;
    mpmstudy::query(scratch.path(), std::string(reinterpret_cast<const char*>(data), size), rows, {},
                    most_seconds);
  } catch (const mpmstudy::CatalogError&) {
  }
  if (bytes_of(mpmstudy::catalog_path(scratch.path())) != before) std::abort();
  return 0;
}
