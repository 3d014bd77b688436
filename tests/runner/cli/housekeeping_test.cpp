// forget, gc, and the disk use that status tells: what goes, and what stays.
#include <SQLiteCpp/SQLiteCpp.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "runner/catalog/connection.hpp"
#include "runner/catalog/query.hpp"
#include "tests/runner/cli/program.hpp"

namespace mpmstudy {
namespace {

namespace fs = std::filesystem;
using testing::ContainsRegex;
using testing::HasSubstr;

/// Studies `kill` of 16 jobs, and `half`, whose 8 jobs are among them.
class HouseKeeping : public Program {
 protected:
  HouseKeeping() {
    EXPECT_EQ(verb({"run", study, "-q"}), 0) << output;
    EXPECT_EQ(verb({"run", study, "-q", "--set", "name=half", "--set", "impact_speed=200 m/s"}), 0) << output;
    EXPECT_THAT(output, HasSubstr("0 done, 0 failed, 8 reused"));
  }
  int verb(Arguments arguments) {
    arguments.insert(arguments.end(), {"--results", results});
    return run(arguments);
  }
  std::int64_t count(const std::string& sql) {
    return std::get<std::int64_t>(query(results, "SELECT count(*) FROM " + sql).rows.at(0).at(0));
  }
  std::int64_t folders() const {
    return std::distance(fs::directory_iterator(fs::path(results) / "fields"), fs::directory_iterator());
  }
  void write(const std::string& sql) { open_for_writing(results)->exec(sql); }
  void leave_file(const std::string& key, const std::string& name) {
    fs::create_directories(fs::path(results) / "fields" / key);
    std::ofstream(fs::path(results) / "fields" / key / name) << "1234567";
  }

  std::string study = SOURCE_DIR "/tests/faults/kill.toml";
};

TEST_F(HouseKeeping, ForgetTakesTheStudyAndLeavesItsJobs) {
  ASSERT_GT(count("fits WHERE study = 'kill'"), 0);
  ASSERT_EQ(verb({"forget", study}), 0) << output;  // by its file
  EXPECT_THAT(output, HasSubstr("kill forgotten: 8 of its 16 jobs no other study has\n"));
  for (const char* view : {"fits", "decisions", "jobs", "ladders", "parameters"})
    EXPECT_EQ(count(std::string(view) + " WHERE study = 'kill'"), 0) << view;
  EXPECT_EQ(count("studies"), 1);
  EXPECT_EQ(count("jobs WHERE study IS NULL AND status = 'done'"), 8);
  EXPECT_EQ(folders(), 16);
  ASSERT_EQ(verb({"run", study, "-q"}), 0) << output;
  EXPECT_THAT(output, HasSubstr("0 done, 0 failed, 16 reused, 0 left"));
  EXPECT_EQ(verb({"forget", "kill", "nobody"}), 2);
  EXPECT_THAT(output, HasSubstr("there is no study 'nobody'; known: half, kill"));
  EXPECT_EQ(count("studies"), 2) << "one is wrong: none is forgotten";
}

TEST_F(HouseKeeping, ForgetLeavesAStudyAloneThatIsBeingRun) {
  // as if this process ran a job of it
  write("UPDATE job SET status = 'running', runner_id = (SELECT max(id) FROM runner) WHERE id = 1");
  std::ifstream stat("/proc/self/stat");
  std::string word;
  for (int i = 0; i < 22; ++i) stat >> word;  // its start, in clock ticks after boot
  write("UPDATE runner SET ended_at = NULL, pid = " + std::to_string(getpid()) + ", process_start = " + word +
        " WHERE id = (SELECT max(id) FROM runner)");
  EXPECT_EQ(verb({"forget", "kill"}), 2);
  EXPECT_THAT(output, ContainsRegex("kill: .*:[0-9]+ runs its jobs; stop that run first"));
  EXPECT_EQ(count("studies"), 2);
  ASSERT_EQ(verb({"gc"}), 0) << output;
  EXPECT_EQ(count("jobs WHERE study = 'kill'"), 16);
}

TEST_F(HouseKeeping, GcRemovesWhatNoStudyHas) {
  ASSERT_EQ(verb({"forget", "kill"}), 0) << output;
  leave_file("0123456789abcdef0123456789abcdef", "checkpoint.h5");  // of a job that nobody knows
  const auto kept =
      std::get<std::string>(query(results, "SELECT key FROM jobs WHERE study = 'half'").rows[0][0]);
  leave_file(kept, "checkpoint.h5");
  ASSERT_EQ(verb({"gc", "--dry-run"}), 0) << output;
  EXPECT_THAT(output, HasSubstr("fields/0123456789abcdef0123456789abcdef\n"));
  EXPECT_THAT(output,
              HasSubstr("would be removed: 8 jobs that no study has; 9 folders of fields with 25 files, "));
  EXPECT_EQ(folders(), 17);
  EXPECT_EQ(count("(SELECT DISTINCT key FROM jobs)"), 16);
  ASSERT_EQ(verb({"gc"}), 0) << output;
  EXPECT_THAT(output, HasSubstr("removed: 8 jobs that no study has; 9 folders of fields with 25 files, "));
  EXPECT_EQ(folders(), 8);
  EXPECT_TRUE(fs::exists(fs::path(results) / "fields" / kept / "checkpoint.h5"));
  for (const char* view : {"metrics", "area_history", "snapshots", "events"})
    EXPECT_EQ(count(std::string("(SELECT DISTINCT key FROM ") + view + ")"), 8) << view;
  EXPECT_EQ(open_for_writing(results)->execAndGet("PRAGMA integrity_check").getString(), "ok");
  ASSERT_EQ(verb({"gc"}), 0);
  EXPECT_THAT(output, HasSubstr("removed: 0 jobs that no study has; 0 folders"));
  // what is wanted again is run again
  ASSERT_EQ(verb({"run", study, "-q"}), 0) << output;
  EXPECT_THAT(output, HasSubstr("8 done, 0 failed, 8 reused, 0 left"));
}

TEST_F(HouseKeeping, StatusSaysWhatTheDiskHolds) {
  const auto fields = [&](const std::string& where) {
    return std::get<std::int64_t>(query(results, "SELECT sum(bytes) FROM snapshots " + where).rows[0][0]);
  };
  using Json = nlohmann::json;
  Json json = Json::parse(out("status --json"));
  EXPECT_EQ(json["disk"]["fields_bytes"], fields(""));
  EXPECT_EQ(json["disk"]["no_study_bytes"], 0);
  EXPECT_EQ(json["studies"][1]["fields_bytes"], fields(""));
  EXPECT_EQ(json["studies"][0]["fields_bytes"],
            fields("WHERE key IN (SELECT key FROM jobs WHERE study = 'half')"));
  EXPECT_GT(json["disk"]["catalog_bytes"], 100'000);
  ASSERT_EQ(verb({"forget", "kill"}), 0);
  json = Json::parse(out("status --json"));
  EXPECT_EQ(json["disk"]["fields_bytes"], fields(""));
  EXPECT_EQ(json["disk"]["no_study_bytes"],
            fields("WHERE key NOT IN (SELECT key FROM jobs WHERE study = 'half')"));
  EXPECT_EQ(verb({"status"}), 0);
  EXPECT_THAT(output, HasSubstr(" of them are of jobs that no study has (`mpmstudy gc` frees them)\n"));
}

TEST_F(HouseKeeping, TheVersionNamesTheCommit) {
  EXPECT_EQ(run({"--version"}), 0);
  EXPECT_THAT(output,
              ContainsRegex("^mpmstudy [0-9.]+, commit [0-9a-f]+(-dirty)?, physics version [0-9]+\n$"));
}

}  // namespace
}  // namespace mpmstudy
