// Taking over the jobs of another catalog: once, again, and what must not be mixed.
#include <gmock/gmock.h>

#include <fstream>

#include "runner/catalog/catalog_error.hpp"
#include "runner/catalog/field_files.hpp"
#include "runner/catalog/query.hpp"
#include "runner/catalog/results_of.hpp"
#include "runner/catalog/writer.hpp"
#include "tests/runner/fakes.hpp"
#include "tests/runner/rows_of.hpp"

namespace mpmstudy {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class Merge : public testing::Test {
 protected:
  /// Jobs first ... last of the plan, done in a results folder of their own, each with a file.
  fs::path make(const std::string& name, int first, int last, double factor = 1) {
    const auto here = folder.path() / name;
    CatalogWriter writer(here);
    const std::vector<Job> jobs(all.begin() + first, all.begin() + last + 1);
    writer.register_study("fake", "A fake", jobs, false);
    for (const auto& job : jobs) {
      EXPECT_TRUE(writer.reserve(job.key));
      FinishedJob finished;
      finished.key = job.key;
      finished.result = fakes::result_of(job.scene);
      finished.result.energy_error *= factor;
      const std::string file = "fields/" + job.key + "/000_1.000ns.vtkhdf";
      fs::create_directories((here / file).parent_path());
      std::ofstream(here / file) << job.key;
      finished.snapshots = {{1e-9, 3, file, 32, checksum_of(here / file)}};
      writer.complete(std::move(finished));
    }
    return here;
  }
  MergeReport merge(const fs::path& shard) { return Store(results, {}).merge(shard); }
  std::int64_t count(const std::string& what) {
    return std::get<std::int64_t>(query(results, "SELECT count(*) FROM " + what).rows[0][0]);
  }

  const std::vector<Job> all = fakes::plan(6).jobs;
  fakes::TemporaryFolder folder;
  const fs::path results = folder.path() / "results";
};

TEST_F(Merge, shards_become_the_catalog_of_one_run) {
  const auto one = make("whole", 0, 5);
  {
    CatalogWriter writer(results);
    writer.register_study("fake", "A fake", all, false);
  }
  EXPECT_EQ(merge(make("a", 0, 3)).merged, 4);
  const auto second = merge(make("b", 2, 5));  // two jobs twice: the same results
  EXPECT_EQ(second.merged, 2);
  EXPECT_EQ(second.same, 2);
  EXPECT_EQ(rows_of(results), rows_of(one));
  for (const auto& job : all)
    EXPECT_EQ(fs::file_size(results / "fields" / job.key / "000_1.000ns.vtkhdf"), 32u);
  EXPECT_EQ(count("events WHERE to_status = 'done' AND reason LIKE 'merged from %'"), 6);
}

TEST_F(Merge, again_changes_nothing) {
  const auto shard = make("a", 0, 5);
  EXPECT_EQ(merge(shard).merged, 6);  // a catalog that knew nothing has the study, too
  const auto rows = rows_of(results);
  EXPECT_EQ(rows, rows_of(shard));
  const auto again = merge(shard);
  EXPECT_EQ(again.merged, 0);
  EXPECT_EQ(again.same, 6);
  EXPECT_EQ(rows_of(results), rows);
  EXPECT_EQ(count("events WHERE to_status = 'done'"), 6);
}

TEST_F(Merge, two_results_under_one_key_are_an_error_and_ours_is_kept) {
  merge(make("a", 0, 2));
  const auto rows = rows_of(results);
  const auto report = merge(make("b", 2, 2, 1 + 1e-15));
  EXPECT_EQ(report.merged, 0);
  ASSERT_EQ(report.conflicts.size(), 1u);
  EXPECT_THAT(report.conflicts[0], HasSubstr(all[2].key + ": two results under one key: energy_error: "));
  EXPECT_EQ(rows_of(results), rows);
}

TEST_F(Merge, a_job_with_a_damaged_file_is_left_out) {
  const auto shard = make("a", 0, 2);
  std::ofstream(shard / "fields" / all[1].key / "000_1.000ns.vtkhdf") << std::string(32, 'x');
  const auto report = merge(shard);
  EXPECT_EQ(report.merged, 2);
  ASSERT_EQ(report.damaged.size(), 1u);
  EXPECT_THAT(report.damaged[0], HasSubstr("checksum"));
  EXPECT_EQ(count("jobs WHERE status = 'done'"), 2);
}

TEST_F(Merge, what_failed_here_and_is_done_there_is_done) {
  {
    CatalogWriter writer(results);
    writer.register_study("fake", "A fake", all, false);
    writer.reserve(all[0].key);
    FinishedJob failed;
    failed.key = all[0].key;
    failed.status = JobStatus::failed;
    failed.failure = FailureKind::timeout;
    failed.reason = "slow machine";
    writer.complete(failed);
  }
  EXPECT_EQ(merge(make("a", 0, 0)).merged, 1);
  EXPECT_EQ(count("jobs WHERE status = 'done' AND reason IS NULL AND failure_kind IS NULL AND attempt = 2"),
            1);
  EXPECT_EQ(count("jobs WHERE status = 'planned'"), 5);
}

TEST_F(Merge, a_folder_without_a_catalog_is_refused) {
  EXPECT_THROW(merge(folder.path() / "nothing"), CatalogError);
}

TEST_F(Merge, retry_plans_what_its_filter_names) {
  CatalogWriter writer(results);
  writer.register_study("fake", "A fake", all, false);
  for (int i = 0; i < 3; ++i) {
    writer.reserve(all[static_cast<std::size_t>(i)].key);
    FinishedJob failed;
    failed.key = all[static_cast<std::size_t>(i)].key;
    failed.status = JobStatus::failed;
    failed.failure = i == 0 ? FailureKind::timeout : FailureKind::breakdown;
    writer.complete(failed);
  }
  writer.flush();
  Store store(results, {});
  store.begin();
  EXPECT_EQ(store.retry({"", "nobody", ""}).size(), 0u);
  EXPECT_EQ(store.retry({all[1].key.substr(0, 31), "", "timeout"}).size(), 1u);
  EXPECT_EQ(store.retry({all[1].key, "fake", "breakdown"}), std::vector{all[1].key});
  store.commit();
  EXPECT_EQ(count("jobs WHERE status = 'failed'"), 1);
  EXPECT_EQ(count("events WHERE reason = 'retry asked for'"), 2);
}

}  // namespace
}  // namespace mpmstudy
