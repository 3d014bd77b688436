// Any bytes as results/catalog.db: opened, or refused with a CatalogError, to read and to write.
#include "runner/catalog/catalog_error.hpp"
#include "runner/catalog/connection.hpp"
#include "runner/catalog/query.hpp"
#include "runner/catalog/reader.hpp"
#include "runner/catalog/writer.hpp"
#include "tests/fuzz/scratch.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const mpmstudy::fuzz::Scratch scratch;
  const auto results = scratch.path() / "results";
  std::filesystem::remove_all(results);
  std::filesystem::create_directories(results);
  mpmstudy::fuzz::write(mpmstudy::catalog_path(results), data, size);
  const auto attempt = [](auto&& call) {
    try {
      call();
    } catch (const mpmstudy::CatalogError&) {
    }
  };
  attempt([&] { mpmstudy::read_state(results); });
  attempt([&] { mpmstudy::query(results, "SELECT * FROM jobs"); });
  attempt([&] { mpmstudy::CatalogWriter(results).register_study("s", "S", {}, false); });
  return 0;
}
