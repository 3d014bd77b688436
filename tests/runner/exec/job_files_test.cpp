// Names of snapshots, and the file that makes one series of them.
#include "runner/exec/job_files.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "tests/runner/fakes.hpp"

namespace mpmstudy {
namespace {

TEST(JobFiles, NamesTellTimesApart) {
  EXPECT_EQ(snapshot_name(0, 0), "000_0.000ns.vtkhdf");
  EXPECT_EQ(snapshot_name(3, 2.2e-9), "003_2.200ns.vtkhdf");
  EXPECT_EQ(snapshot_name(3, 1.62e-9), "003_1.620ns.vtkhdf");
  EXPECT_EQ(snapshot_name(1, 1.0001e-9), "001_1.0001ns.vtkhdf");
  EXPECT_NE(snapshot_name(0, 1.00001e-9), snapshot_name(0, 1.00002e-9));
}

TEST(JobFiles, ASeriesNamesEveryFileWithItsTime) {
  const fakes::TemporaryFolder folder;
  const auto write = [](const std::filesystem::path& path, const mpm::Snapshot&) {
    std::ofstream(path) << "x";
  };
  JobFiles files(folder.path(), "0123", write);
  for (const double time : {1e-9, 1.62e-9}) {
    mpm::Snapshot snapshot;
    snapshot.time = time;
    files.add(snapshot);
  }
  EXPECT_EQ(files.close().size(), 2u);
  std::ifstream file(folder.path() / "fields" / "0123" / series_name);
  const auto series = nlohmann::json::parse(file);
  EXPECT_EQ(series["file-series-version"], "1.0");
  ASSERT_EQ(series["files"].size(), 2u);
  for (const auto& one : series["files"])
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "fields" / "0123" / one["name"].get<std::string>()));
  EXPECT_EQ(series["files"][1]["time"].get<double>(), 1.62e-9);
}

TEST(JobFiles, WithoutSnapshotsThereIsNoFolder) {
  const fakes::TemporaryFolder folder;
  JobFiles files(folder.path(), "0123", {});
  EXPECT_TRUE(files.close().empty());
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "fields" / "0123"));
}

}  // namespace
}  // namespace mpmstudy
