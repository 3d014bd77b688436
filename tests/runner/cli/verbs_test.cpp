// explain, retry, verify, merge, watch: as a user calls them, on a small study.
#include <SQLiteCpp/SQLiteCpp.h>

#include "runner/catalog/connection.hpp"
#include "runner/catalog/query.hpp"
#include "tests/runner/cli/program.hpp"
#include "tests/runner/rows_of.hpp"

namespace mpmstudy {
namespace {

namespace fs = std::filesystem;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

class Verbs : public Program {
 protected:
  Verbs() { EXPECT_EQ(run({"run", study, "--results", results, "-q"}), 0) << output; }
  int verb(Arguments arguments) {
    arguments.insert(arguments.end(), {"--results", results});
    return run(arguments);
  }
  std::string text(const std::string& sql) {
    return std::get<std::string>(query(results, sql).rows.at(0).at(0));
  }
  void write(const std::string& sql) { open_for_writing(results)->exec(sql); }

  std::string study = SOURCE_DIR "/tests/faults/kill.toml";
};

TEST_F(Verbs, explain_says_which_parameter_is_new_and_where_it_is_said) {
  ASSERT_EQ(verb({"run", study, "-q", "--set", "yield_stress=150 MPa", "--set", "name=harder"}), 0) << output;
  const auto key = text("SELECT key FROM jobs WHERE study = 'harder' AND cavity_radius_m = 1e-6 LIMIT 1");
  ASSERT_EQ(verb({"explain", key.substr(0, 12)}), 0) << output;
  EXPECT_THAT(output, HasSubstr("of harder: a point of the sweep\ndone"));
  EXPECT_THAT(output, HasSubstr("  yield_stress = 150 MPa (there 120 MPa)  --set\n"));
  EXPECT_THAT(output, HasSubstr("planned -> running by "));
  EXPECT_THAT(output, Not(HasSubstr("cavity_radius =  ")));
  // A job that is not there yet, of a file that is named.
  ASSERT_EQ(verb({"plan", study, "--json", "--set", "impact_speed=250 m/s"}), 0);
  const auto at = output.find("\"key\": \"");
  const auto planned = output.substr(at + 8, 32);
  ASSERT_EQ(verb({"explain", planned, study, "--set", "impact_speed=250 m/s"}), 0) << output;
  EXPECT_THAT(output, HasSubstr("will run: the catalog does not have it"));
  EXPECT_THAT(output, ContainsRegex("impact_speed = 250 m/s \\(there [23]00 m/s\\)  --set"));
  // What the file itself says has its line.
  const auto other = text("SELECT key FROM jobs WHERE study = 'kill' ORDER BY position DESC LIMIT 1");
  ASSERT_EQ(verb({"explain", other}), 0);
  EXPECT_THAT(output, ContainsRegex("impact_speed = 300 m/s .*kill.toml:8:"));
}

TEST_F(Verbs, explain_says_where_snapshots_and_materials_are_said) {
  ASSERT_EQ(verb({"run", study, "-q", "--set", "snapshots=[\"0.5 ns\"]", "--set", "name=one"}), 0) << output;
  const auto key = text("SELECT key FROM jobs WHERE study = 'one' ORDER BY position LIMIT 1");
  ASSERT_EQ(verb({"explain", key}), 0) << output;
  EXPECT_THAT(output, ContainsRegex("  snapshots = 1 time \\(there 2 times\\)  --set\n"));
  // What no key says is the named material's.
  write(
      "UPDATE job SET specific_heat_J_kg_K = 1 WHERE key NOT IN (SELECT key FROM jobs WHERE study = 'one')");
  ASSERT_EQ(verb({"explain", key}), 0) << output;
  EXPECT_THAT(output, ContainsRegex("  specific_heat = .*kill.toml:7:[0-9]+, of the material\n"));
}

TEST_F(Verbs, explain_knows_what_scaled_the_cells) {
  ASSERT_EQ(verb({"run", study, "-q", "--cells", "1.5", "--set", "name=coarse"}), 0) << output;
  EXPECT_EQ(
      std::get<double>(query(results, "SELECT cells FROM studies WHERE name = 'coarse'").rows.at(0).at(0)),
      1.5);
  ASSERT_EQ(verb({"explain", text("SELECT key FROM jobs WHERE study = 'coarse' LIMIT 1")}), 0) << output;
  EXPECT_THAT(output, ContainsRegex("cell_size = 600 nm .*kill.toml:[0-9]+:[0-9]+, times --cells"));
}

TEST_F(Verbs, explain_of_a_search_names_the_section_that_its_speeds_come_from) {
  const std::string search = SOURCE_DIR "/tests/slurm/search.toml";
  const std::string round = ".*search.toml:20:[0-9]+, a round of the search";
  ASSERT_EQ(verb({"run", search, "-q", "--audit", "100 %"}), 0) << output;
  const auto key =
      text("SELECT key FROM jobs WHERE study = 'slurm-search' ORDER BY impact_speed_m_s DESC LIMIT 1");
  ASSERT_EQ(verb({"explain", key}), 0) << output;
  EXPECT_THAT(output, ContainsRegex("  cavity_radius = [12.5]* um  .*search.toml:11:"));
  EXPECT_THAT(output, ContainsRegex("  impact_speed = [0-9]* m/s  " + round));
  EXPECT_THAT(output, ContainsRegex("impact_speed = [0-9]* m/s .there [0-9]* m/s.  " + round));
  const auto audited = text("SELECT key FROM jobs WHERE study = 'slurm-search-audit' LIMIT 1");
  ASSERT_EQ(verb({"explain", audited}), 0) << output;
  EXPECT_THAT(output, HasSubstr("stop = end-time (there decided)  --audit"));
}

TEST_F(Verbs, explain_says_why_a_job_failed_and_retry_plans_it_again) {
  const auto key = text("SELECT key FROM jobs LIMIT 1");
  write(
      "UPDATE job SET status = 'failed', failure_kind = 'breakdown', reason = 'density left its range', "
      "steps = 7 WHERE key = '" +
      key + "'");
  ASSERT_EQ(verb({"explain", key}), 0);
  EXPECT_THAT(output, HasSubstr("failed (breakdown) at step 7: density left its range"));
  EXPECT_EQ(verb({"run", study, "-q"}), 1);  // left so
  EXPECT_EQ(verb({"retry", "--kind", "timeout"}), 0);
  EXPECT_THAT(output, HasSubstr("0 jobs planned again"));
  EXPECT_EQ(verb({"retry", "--study", "nobody"}), 2);
  EXPECT_THAT(output, HasSubstr("there is no study 'nobody'"));
  EXPECT_EQ(verb({"retry", "--kind", "timeout", key}), 1);  // it failed in another way
  EXPECT_EQ(verb({"retry", key.substr(0, 12)}), 0);
  EXPECT_THAT(output, HasSubstr("1 job planned again"));
  EXPECT_EQ(verb({"retry", key}), 1);
  EXPECT_EQ(verb({"run", study, "-q"}), 0);
  EXPECT_THAT(output, HasSubstr("1 done, 0 failed, 15 reused, 0 left"));
  EXPECT_EQ(verb({"explain", "zzz"}), 2);
  EXPECT_EQ(verb({"explain", ""}), 2);  // several jobs begin so
}

TEST_F(Verbs, what_goes_through_a_queue_keeps_its_options) {
  ASSERT_EQ(verb({"run", study, "--set", "impact_speed=250 m/s", "--cells", "1.5", "--timeout", "1 h",
                  "--engine", "slurm", "--dry-run"}),
            0)
      << output;
  const std::string options = "--set 'impact_speed=250 m/s' --cells 1.5 --timeout '1 h' ";
  const auto array = output.find(options);
  ASSERT_NE(array, std::string::npos) << output;
  EXPECT_NE(output.find(options, array + 1), std::string::npos) << "and of the merge";
}

TEST_F(Verbs, verify_finds_a_result_that_does_not_come_out_again) {
  ASSERT_EQ(verb({"verify", "3", "--seed", "5", "--files"}), 0) << output;
  EXPECT_THAT(output, HasSubstr("3 of 3 jobs come out the same to the last bit"));
  EXPECT_THAT(output, HasSubstr("32 of 32 files are as they were written"));
  const auto key = text("SELECT key FROM jobs LIMIT 1");
  write("UPDATE job SET final_area_m2 = final_area_m2 * (1 + 1e-15) WHERE key = '" + key + "'");
  std::ofstream(fs::path(results) / text("SELECT path FROM snapshots LIMIT 1"), std::ios::app) << "x";
  EXPECT_EQ(verb({"verify", "16", "--files"}), 1);
  EXPECT_THAT(output, HasSubstr(key + ": final_area_m2: "));
  EXPECT_THAT(output, HasSubstr("15 of 16 jobs come out the same"));
  EXPECT_THAT(output, HasSubstr("31 of 32 files are as they were written"));
  for (const auto& entry : fs::directory_iterator(results)) EXPECT_NE(entry.path().extension(), ".tmp");
}

TEST_F(Verbs, damaged_files_are_made_again) {
  const auto rows = rows_of(results);
  fs::remove(fs::path(results) / text("SELECT path FROM snapshots LIMIT 1"));
  ASSERT_EQ(verb({"run", study}), 0);
  EXPECT_THAT(output, HasSubstr("1 job to run again: a file of fields is missing or damaged"));
  EXPECT_EQ(rows_of(results), rows);
  EXPECT_EQ(verb({"verify", "0", "--files"}), 0) << output;
}

// A disk that changes a bit changes neither size nor time: no run sees it, verify does, and the next run
// then makes the file again.
TEST_F(Verbs, a_file_that_rotted_is_made_again_after_verify) {
  const auto rows = rows_of(results);
  const auto path = fs::path(results) / text("SELECT path FROM snapshots LIMIT 1");
  const auto written = fs::last_write_time(path);
  std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
  const char first = static_cast<char>(file.get());
  file.seekp(0);
  file.put(static_cast<char>(first ^ 1));
  file.close();
  fs::last_write_time(path, written);
  EXPECT_EQ(verb({"verify", "0", "--files"}), 1);
  ASSERT_EQ(verb({"run", study}), 0);
  EXPECT_THAT(output, HasSubstr("1 job to run again: a file of fields is missing or damaged"));
  EXPECT_EQ(rows_of(results), rows);
  EXPECT_EQ(verb({"verify", "0", "--files"}), 0) << output;
}

TEST_F(Verbs, merge_takes_over_another_folder_once) {
  const auto other = (folder.path() / "other").string();
  ASSERT_EQ(run({"merge", results, "--results", other}), 0) << output;
  EXPECT_THAT(output, HasSubstr("16 jobs merged, 0 known already"));
  EXPECT_EQ(run({"merge", results, results, "--results", other}), 0);
  EXPECT_THAT(output, HasSubstr("0 jobs merged, 32 known already"));
  ASSERT_EQ(run({"run", study, "-q", "--results", other}), 0) << output;
  EXPECT_THAT(output, HasSubstr("0 done, 0 failed, 16 reused, 0 left"));
  EXPECT_EQ(rows_of(other), rows_of(results));
  write("UPDATE job SET steps = steps + 1 WHERE id = 1");
  EXPECT_EQ(run({"merge", results, (folder.path() / "none").string(), "--results", other}), 1);
  EXPECT_THAT(output, HasSubstr("two results under one key: steps: "));
  EXPECT_THAT(output, HasSubstr("there is no catalog"));
  EXPECT_EQ(run({"merge", results, "--results", results}), 1);
  EXPECT_THAT(output, HasSubstr("is the results folder itself"));
}

TEST_F(Verbs, watch_ends_when_all_is_decided) {
  EXPECT_EQ(verb({"watch", "--every", "0.1"}), 0);
  EXPECT_THAT(output, ContainsRegex("kill +0 +0 +16 +0 +0"));
  write("UPDATE job SET status = 'planned' WHERE id = 1");
  const pid_t child = start({"watch", "kill", "--every", "0.1", "--results", results});
  usleep(400'000);
  write("UPDATE job SET status = 'done' WHERE id = 1");
  EXPECT_EQ(wait_for(child), 0);
  EXPECT_THAT(output, ContainsRegex("kill +1 +0 +15 +0 +0"));
}

TEST_F(Verbs, stale_rows_are_seen_and_in_no_fit) {
  const auto fits = rows_of(results);
  ASSERT_GT(query(results, "SELECT * FROM fits").rows.size(), 0u);
  // As if an older program had done them all, and this one came to the catalog.
  write("UPDATE job SET physics_version = physics_version - 1, key = substr(key, 2) || 'g'");
  EXPECT_EQ(query(results, "SELECT DISTINCT key FROM jobs WHERE stale = 1").rows.size(), 16u);
  EXPECT_EQ(verb({"figures", study}), 75);
  EXPECT_THAT(output, HasSubstr("16 of 16 jobs are not done"));
  EXPECT_EQ(verb({"status"}), 0);
  EXPECT_THAT(output, HasSubstr("16 jobs are of an older physics version"));
  ASSERT_EQ(verb({"run", study, "-q"}), 0);
  EXPECT_THAT(output, HasSubstr("16 done, 0 failed, 0 reused, 0 left"));
  EXPECT_EQ(query(results, "SELECT * FROM jobs WHERE stale = 1 AND study IS NOT NULL").rows.size(), 0u);
  EXPECT_EQ(query(results, "SELECT DISTINCT key FROM jobs WHERE stale = 1").rows.size(), 16u);
}

}  // namespace
}  // namespace mpmstudy
