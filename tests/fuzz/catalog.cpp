// Any bytes as results/catalog.db: opened, or refused with a CatalogError, to read and to write.
//
// Input that begins with '~' changes a good catalog instead, four bytes per change: three for the place, one
// for the new byte. A fuzzer that has to make whole databases hardly gets beyond their first page.
#include <fstream>
#include <iterator>
#include <vector>

#include "runner/catalog/catalog_error.hpp"
#include "runner/catalog/connection.hpp"
#include "runner/catalog/query.hpp"
#include "runner/catalog/reader.hpp"
#include "runner/catalog/stored_jobs.hpp"
#include "runner/catalog/writer.hpp"
#include "tests/fuzz/scratch.hpp"
#include "tests/runner/fakes.hpp"

namespace {

using Bytes = std::vector<std::uint8_t>;

/// A catalog with jobs that are done, failed and planned.
Bytes good_catalog(const std::filesystem::path& results) {
  {
    mpmstudy::CatalogWriter writer(results);
    writer.register_study("s", "S",
                          {mpmstudy::fakes::job(1), mpmstudy::fakes::job(2), mpmstudy::fakes::job(3)}, false,
                          {"s.toml", {"cell_size=1 um"}, 2});
    for (const int n : {1, 2}) {
      mpmstudy::FinishedJob job;
      job.key = mpmstudy::fakes::key(n);
      writer.reserve(job.key);
      job.status = n == 1 ? mpmstudy::JobStatus::done : mpmstudy::JobStatus::failed;
      job.result = mpmstudy::fakes::result_of(mpmstudy::fakes::scene(1e-6));
      if (n == 1) job.snapshots = {{1e-9, 3, "fields/a", 3, "00"}};
      writer.complete(job);
    }
    writer.flush();
  }
  std::ifstream file(mpmstudy::catalog_path(results), std::ios::binary);
  return Bytes((std::istreambuf_iterator<char>(file)), {});
}

Bytes changed(Bytes bytes, const std::uint8_t* data, std::size_t size) {
  for (std::size_t i = 0; i + 4 <= size; i += 4) {
    const std::size_t place = data[i] << 16 | data[i + 1] << 8 | data[i + 2];
    bytes[place % bytes.size()] = data[i + 3];
  }
  return bytes;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const mpmstudy::fuzz::Scratch scratch;
  static const Bytes good = good_catalog(scratch.path() / "good");
  const auto results = scratch.path() / "results";
  std::filesystem::remove_all(results);
  std::filesystem::create_directories(results);
  const auto path = mpmstudy::catalog_path(results);
  if (size > 0 && data[0] == '~') {
    const Bytes bytes = changed(good, data + 1, size - 1);
    mpmstudy::fuzz::write(path, bytes.data(), bytes.size());
  } else {
    mpmstudy::fuzz::write(path, data, size);
  }
  const auto attempt = [](auto&& call) {
    try {
      call();
    } catch (const mpmstudy::CatalogError&) {
    }
  };
  attempt([&] { mpmstudy::read_state(results); });
  attempt([&] { mpmstudy::read_jobs(results); });
  attempt([&] { mpmstudy::read_studies(results); });
  attempt([&] { mpmstudy::measured_costs(results); });
  attempt([&] { mpmstudy::query(results, "SELECT * FROM jobs LEFT JOIN metrics USING (key)"); });
  attempt([&] {
    mpmstudy::CatalogWriter writer(results);
    writer.register_study("s", "S", {mpmstudy::fakes::job(2), mpmstudy::fakes::job(4)}, true);
    writer.reserve(mpmstudy::fakes::key(2));
  });
  return 0;
}
