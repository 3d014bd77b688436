// Slurm's commands misbehave, each in every way that users have met: what the program says, its exit code,
// and what Slurm and the results folder hold afterwards. Whatever happened, the next run with a Slurm that
// answers leaves each job in the queue once.
#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <map>
#include <regex>

#include "tests/runner/cli/program.hpp"

namespace mpmstudy {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

class FakeSlurm : public Program {
 protected:
  void SetUp() override {
    fs::create_directories(slurm);
    fs::create_directories(tools);
    for (const char* tool : {"sbatch", "squeue", "scontrol", "scancel"})
      fs::create_symlink(SOURCE_DIR "/tests/runner/slurm/fake_slurm.sh", tools / tool);
    path = std::getenv("PATH");
    setenv("PATH", (tools.string() + ":" + path).c_str(), 1);
    setenv("FAKE_SLURM", slurm.c_str(), 1);
    setenv("SQUEUE_PARTITION", "other", 1);  // a user's setting that must not reach squeue
    unsetenv("MPMSTUDY_SLURM_TIMEOUT");
  }
  void TearDown() override {
    setenv("PATH", path.c_str(), 1);
    for (const char* name : {"FAKE_SLURM", "SQUEUE_PARTITION", "MPMSTUDY_SLURM_TIMEOUT"}) unsetenv(name);
  }
  void misbehave(const std::string& tool, const std::string& how) {
    if (how.empty())
      fs::remove(slurm / tool);
    else
      std::ofstream(slurm / tool) << how << "\n";
    if (how.ends_with("hangs")) setenv("MPMSTUDY_SLURM_TIMEOUT", "3", 1);
  }
  void behave() {
    for (const char* tool : {"sbatch", "squeue", "scontrol", "scancel"}) misbehave(tool, "");
    unsetenv("MPMSTUDY_SLURM_TIMEOUT");
  }
  static std::string text_of(const fs::path& file) {
    std::ifstream in(file);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  /// How many arrays and merges Slurm has.
  std::pair<int, int> taken() const {
    std::pair<int, int> counts;
    std::ifstream jobs(slurm / "jobs");
    for (std::string line; std::getline(jobs, line);)
      ++(line.find("-merge ") == std::string::npos ? counts.first : counts.second);
    return counts;
  }
  std::vector<fs::path> folders() const {
    std::vector<fs::path> all;
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(results + "/slurm", none))
      if (entry.is_directory()) all.push_back(entry.path());
    std::ranges::sort(all);
    return all;
  }
  void edit(const fs::path& file, const std::string& pattern, const std::string& by) {
    const std::string text = std::regex_replace(text_of(file), std::regex(pattern), by);
    std::ofstream(file) << text;
  }
  /// As if sbatch had been asked long ago.
  void wait_for_slurm() {
    edit(folders().back() / "submitted.json", "\"asked_at\": [0-9]+", "\"asked_at\": 1");
  }
  int submit(Arguments more = {}) {
    Arguments arguments = {"run", smoke, "--engine", "slurm", "--results", results};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }
  int status() { return run({"status", "--results", results}); }

  fs::path slurm = folder.path() / "slurm", tools = folder.path() / "tools";
  std::string path;
};

/// The elements of an array read the copy of the study, and the points beside it.
TEST_F(FakeSlurm, PointsAreBesideTheCopyOfTheStudy) {
  const fs::path study = fs::path(SOURCE_DIR) / "studies/examples/design.toml";
  ASSERT_EQ(run({"run", study.string(), "--engine", "slurm", "--results", results}), 0) << output;
  ASSERT_EQ(folders().size(), 1u);
  EXPECT_EQ(text_of(folders()[0] / "design.csv"), text_of(study.parent_path() / "design.csv"));
  EXPECT_EQ(run({"check", (folders()[0] / "study.toml").string()}), 0) << output;
}

using Taken = std::pair<int, int>;  // arrays, merges
constexpr Taken none{0, 0}, array_only{1, 0}, both{1, 1};

/// A first submission while a tool misbehaves.
struct SubmitCase {
  std::string name, sbatch, squeue, scontrol;
  int code;           ///< of the run
  Taken taken;        ///< by Slurm
  bool folder;        ///< one is left
  std::string says;   ///< a part of the output
  int status;         ///< 0: `status` knows what became of it, with a Slurm that answers
  int again;          ///< of the next run, with a Slurm that answers
  Taken taken_again;  ///< after it
};

void PrintTo(const SubmitCase& c, std::ostream* out) { *out << c.name; }

class Submitting : public FakeSlurm, public testing::WithParamInterface<SubmitCase> {};

TEST_P(Submitting, never_loses_or_doubles_a_job) {
  const SubmitCase& c = GetParam();
  misbehave("sbatch", c.sbatch);
  misbehave("squeue", c.squeue);
  misbehave("scontrol", c.scontrol);
  EXPECT_EQ(submit(), c.code) << output;
  EXPECT_THAT(output, HasSubstr(c.says));
  EXPECT_EQ(taken(), c.taken) << output;
  EXPECT_EQ(folders().size(), c.folder ? 1u : 0u) << output;
  behave();
  EXPECT_EQ(status(), 75) << output;  // work is left, whether it is known to be in the queue or not
  if (c.status == 0) {
    EXPECT_THAT(output, Not(HasSubstr("not known whether"))) << output;
  }
  EXPECT_EQ(submit(), c.again) << output;
  EXPECT_EQ(taken(), c.taken_again) << output;
  if (c.again == 75) {  // Slurm might still have taken it; now it cannot
    wait_for_slurm();
    EXPECT_EQ(submit(), 0) << output;
  }
  EXPECT_EQ(taken(), both) << output;
  EXPECT_EQ(submit(), 0) << output;
  EXPECT_THAT(output, HasSubstr("2 jobs in the queue already"));
  EXPECT_EQ(taken(), both) << output;
  EXPECT_THAT(text_of(slurm / "calls"), Not(HasSubstr("scancel"))) << "what Slurm has taken is left to it";
}

const std::vector<SubmitCase> submit_cases = {
    // sbatch
    {"answers", "", "", "", 0, both, true, "submitted: array 4711, merge 4712", 0, 0, both},
    {"notice", "notice", "", "", 0, both, true, "sbatch: NOTICE: maintenance", 0, 0, both},
    {"names_a_cluster", "cluster", "", "", 0, both, true, "submitted: array 4711, merge 4712", 0, 0, both},
    // squeue cannot help here: the words are understood
    {"wordy", "wordy", "unreachable", "", 0, both, true, "submitted: array 4711, merge 4712", 0, 0, both},
    {"refuses", "refuses", "", "", 75, none, false, "Invalid partition name", 0, 0, both},
    {"fails", "fails", "", "", 75, none, true, "exit code 1", 75, 75, none},
    {"dies", "dies", "", "", 75, none, true, "exit code 137", 75, 75, none},
    {"hangs", "hangs", "", "", 75, none, true, "no answer in time", 75, 75, none},
    {"timeout", "timeout", "", "", 75, none, true, "Socket timed out", 75, 75, none},
    {"taken_timeout", "taken-timeout", "", "", 0, both, true, "but squeue has the job as 4711", 0, 0, both},
    {"taken_refuses", "taken-refuses", "", "", 0, both, true, "but squeue has the job as 4711", 0, 0, both},
    {"taken_fails", "taken-fails", "", "", 0, both, true, "but squeue has the merge as 4712", 0, 0, both},
    {"taken_hangs", "taken-hangs", "", "", 0, both, true, "no answer in time", 0, 0, both},
    {"taken_mute", "taken-mute", "", "", 0, both, true, "but squeue has the job as 4711", 0, 0, both},
    {"taken_garbage", "taken-garbage", "", "", 0, both, true, "502 Bad Gateway", 0, 0, both},
    {"kills_caller", "kills-caller", "", "", 1000 + 9, array_only, true, "", 0, 0, both},
    {"merge_refused", "merge-refused", "", "", 75, array_only, true, "QOSMaxSubmitJobPerUserLimit", 0, 0,
     both},
    {"merge_taken_fails", "merge-taken-fails", "", "", 0, both, true, "squeue has the merge as 4712", 0, 0,
     both},
    // both: what sbatch leaves open squeue does not answer
    {"taken_and_unreachable", "taken-fails", "unreachable", "", 75, array_only, true, "Unable to contact", 0,
     0, both},
    {"refuses_and_unreachable", "refuses", "unreachable", "", 75, none, true, "Unable to contact", 0, 0,
     both},
    // scontrol is only asked for the cluster's name, and may be silent
    {"scontrol_unreachable", "", "", "unreachable", 0, both, true, "submitted: array 4711", 0, 0, both},
};

const auto case_name = [](const auto& info) { return info.param.name; };
INSTANTIATE_TEST_SUITE_P(Slurm, Submitting, testing::ValuesIn(submit_cases), case_name);

/// A run, and `status`, while what was submitted before cannot be asked for.
struct AskCase {
  std::string name, squeue, scontrol;
  bool in_queue;  ///< the jobs are still in the queue; else Slurm has forgotten them
  int code;       ///< of the run and of `status`
  std::string says;
  Taken taken;  ///< afterwards, with the first submission
};

void PrintTo(const AskCase& c, std::ostream* out) { *out << c.name; }

class Asking : public FakeSlurm, public testing::WithParamInterface<AskCase> {};

TEST_P(Asking, takes_no_silence_for_an_empty_queue) {
  const AskCase& c = GetParam();
  ASSERT_EQ(submit(), 0) << output;
  if (!c.in_queue) fs::remove(slurm / "jobs");
  misbehave("squeue", c.squeue);
  misbehave("scontrol", c.scontrol);
  EXPECT_EQ(status(), 75) << output;  // work is left
  if (c.code == 75) {
    EXPECT_THAT(output, HasSubstr("not known whether it is in the queue: "));
    EXPECT_THAT(output, HasSubstr(c.says));
  }
  EXPECT_EQ(run({"status", "--json", "--results", results}), 75);
  EXPECT_EQ(submit({"--dry-run"}), c.code) << output;
  EXPECT_EQ(submit(), c.code) << output;
  EXPECT_THAT(output, HasSubstr(c.says));
  EXPECT_EQ(taken(), c.taken) << output;
}

const std::vector<AskCase> ask_cases = {
    {"answers", "", "", true, 0, "2 jobs in the queue already", both},
    {"notice", "notice", "", true, 0, "2 jobs in the queue already", both},
    {"unreachable", "unreachable", "", true, 75, "Unable to contact slurm controller", both},
    {"fails", "fails", "", true, 75, "squeue: exit code 1", both},
    {"hangs", "hangs", "", true, 75, "squeue: no answer in time", both},
    {"mute", "mute", "", true, 75, "squeue: exit code 0", both},
    {"garbage", "garbage", "", true, 75, "502 Bad Gateway", both},
    {"late_failure", "late-failure", "", true, 75, "exit code 1", both},
    // The jobs are gone: only a Slurm that says so, of the same cluster, has them submitted again.
    {"forgotten", "", "", false, 0, "0 of 1 shards are whole", both},
    {"purged", "purged", "", false, 0, "0 of 1 shards are whole", both},
    {"forgotten_elsewhere", "", "elsewhere", false, 75, "submitted to the cluster 'fake'", none},
    {"forgotten_and_cluster_unknown", "", "unreachable", false, 75, "scontrol does not say", none},
};
INSTANTIATE_TEST_SUITE_P(Slurm, Asking, testing::ValuesIn(ask_cases), case_name);

TEST_F(FakeSlurm, shows_users_their_own_jobs_only) {
  ASSERT_EQ(submit(), 0) << output;
  fs::remove(slurm / "jobs");
  misbehave("scontrol", "private");
  EXPECT_EQ(status(), 75) << output << "one's own jobs are shown";
  edit(folders().at(0) / "submitted.json", "\"user\": \"[^\"]*\"", "\"user\": \"somebody\"");
  EXPECT_EQ(submit(), 75);
  EXPECT_THAT(output, HasSubstr("submitted by somebody"));
}

TEST_F(FakeSlurm, does_not_take_a_reused_number_for_its_job) {
  ASSERT_EQ(submit(), 0) << output;
  std::ofstream(slurm / "jobs") << "4711 of-another R None\n";
  EXPECT_EQ(submit(), 75) << output;
  EXPECT_THAT(output, HasSubstr("job 4711 is called 'of-another'"));
  std::ofstream(slurm / "jobs") << "4711 of-another CD None\n";
  EXPECT_EQ(submit(), 0) << output;
}

TEST_F(FakeSlurm, has_no_commands_here) {
  ASSERT_EQ(submit(), 0) << output;
  fs::remove(tools / "sbatch");
  fs::remove(tools / "squeue");
  setenv("PATH", tools.c_str(), 1);
  EXPECT_EQ(status(), 75) << output;
  EXPECT_THAT(output, HasSubstr("squeue is not installed here"));
  fs::remove_all(results + "/slurm");
  EXPECT_EQ(submit(), 75) << output;
  EXPECT_THAT(output, HasSubstr("sbatch is not installed here"));
  EXPECT_TRUE(folders().empty()) << "nothing can have been submitted";
}

TEST_F(FakeSlurm, releases_what_is_held_and_says_when_it_may_not) {
  ASSERT_EQ(submit(), 0) << output;
  edit(slurm / "jobs", "^(4711 \\S+ PD) None", "$1 launch failed requeued held");
  misbehave("scontrol", "refuses");
  EXPECT_EQ(submit(), 75) << output;
  EXPECT_THAT(output, HasSubstr("does not release it: 4711: scontrol: error: Access/permission denied"));
  behave();
  EXPECT_EQ(submit(), 0) << output;
  EXPECT_THAT(output, HasSubstr("element 4711 and held it; it is released"));
}

TEST_F(FakeSlurm, is_asked_about_submissions_whose_record_is_damaged) {
  ASSERT_EQ(submit(), 0) << output;
  std::ofstream(folders().at(0) / "submitted.json") << "{\"study\": ";
  EXPECT_EQ(status(), 75) << output;
  EXPECT_EQ(submit(), 75) << output;
  EXPECT_THAT(output, HasSubstr("submitted.json: is not what"));
  EXPECT_EQ(taken(), both);
}

// As earlier versions left it: no name, all jobs of a study are called alike.
TEST_F(FakeSlurm, has_jobs_of_an_older_record) {
  ASSERT_EQ(submit(), 0) << output;
  std::ofstream(folders().at(0) / "submitted.json")
      << R"({"study": "smoke", "array": "4711", "merge": "4712", "shards": 1})";
  edit(slurm / "jobs", "mpmstudy-smoke-[^ ]*-merge", "mpmstudy-smoke-merge");
  edit(slurm / "jobs", "mpmstudy-smoke-[0-9][^ ]*", "mpmstudy-smoke");
  EXPECT_EQ(submit(), 0) << output;
  EXPECT_THAT(output, HasSubstr("2 jobs in the queue already"));
  EXPECT_EQ(taken(), both);
}

// The merge's job is lost after the elements have ended: what they made is not made again.
TEST_F(FakeSlurm, loses_the_merge) {
  ASSERT_EQ(submit(), 0) << output;
  const auto first = folders().at(0);
  const std::string element =
      "SLURM_ARRAY_TASK_ID=0 SLURM_JOB_ID=1 bash '" + (first / "array.sh").string() + "' > /dev/null 2>&1";
  ASSERT_EQ(std::system(element.c_str()), 0);
  fs::remove(slurm / "jobs");
  EXPECT_EQ(status(), 75);  // until what is whole has been taken over
  EXPECT_THAT(output, HasSubstr("1 of 1 shards whole"));
  EXPECT_THAT(output, HasSubstr("merge is lost: `mpmstudy run --engine slurm` takes over what is whole"));
  EXPECT_EQ(submit(), 0) << output;
  EXPECT_THAT(output, HasSubstr("2 jobs merged"));
  EXPECT_THAT(output, HasSubstr("2 done, 0 failed, none left"));
  EXPECT_EQ(taken(), none);
  EXPECT_TRUE(fs::exists(results + "/figures/smoke-area.png") ||
              fs::exists(results + "/figures/smoke/smoke-area.png"));
  EXPECT_EQ(submit({"--dry-run"}), 0);
  EXPECT_THAT(output, HasSubstr("nothing is left to submit: every job is decided"));
  EXPECT_THAT(output, Not(HasSubstr("in the queue")));
}

// What an element made cannot be taken over now, as with a full disk: it is kept, and not run again.
TEST_F(FakeSlurm, keeps_a_shard_that_cannot_be_taken_over_now) {
  ASSERT_EQ(submit(), 0) << output;
  const auto first = folders().at(0);
  const std::string element =
      "SLURM_ARRAY_TASK_ID=0 SLURM_JOB_ID=1 bash '" + (first / "array.sh").string() + "' > /dev/null 2>&1";
  ASSERT_EQ(std::system(element.c_str()), 0);
  fs::remove(slurm / "jobs");
  fs::remove_all(results + "/fields");
  std::ofstream(results + "/fields") << "in the way\n";
  EXPECT_EQ(std::system(("bash '" + (first / "merge.sh").string() + "' > /dev/null 2>&1").c_str()) >> 8, 75);
  EXPECT_FALSE(fs::exists(first / "merged")) << "the merge's script has taken no for an answer";
  EXPECT_EQ(submit(), 75) << output;
  EXPECT_THAT(output, HasSubstr("2 jobs not submitted: they are in shards that could not be merged now"));
  EXPECT_FALSE(fs::exists(first / "merged"));
  EXPECT_EQ(taken(), none);
  fs::remove(results + "/fields");
  EXPECT_EQ(submit(), 0) << output;
  EXPECT_THAT(output, HasSubstr("2 jobs merged"));
  EXPECT_EQ(taken(), none);
}

// As a run on threads: what to know of the study, and what has come of it.
TEST_F(FakeSlurm, has_warnings_and_a_table_of_results) {
  const auto file = folder.path() / "prefix.toml";
  fs::copy_file(smoke, file);
  edit(file, "\\[parameters\\]", "[parameters]\nyield_stress = \"120 mPa\"");
  const Arguments slurm_run = {"run", file.string(), "--engine", "slurm", "--results", results};
  ASSERT_EQ(run(slurm_run), 0) << output;
  EXPECT_THAT(output, HasSubstr("yield_stress: 120 mPa is unusual"));
  fs::remove(slurm / "jobs");
  run({"run", file.string(), "--results", results});
  ASSERT_EQ(run(slurm_run), 0) << output;
  EXPECT_THAT(output, HasSubstr("yield_stress: 120 mPa is unusual"));
  EXPECT_THAT(output, HasSubstr("none left"));
  EXPECT_THAT(output, testing::ContainsRegex("  job +[a-z_]+ +collapsibility"));
  Arguments only = slurm_run;
  std::ofstream(folder.path() / "keys") << "x\n";
  only.insert(only.end(), {"--only", (folder.path() / "keys").string()});
  EXPECT_EQ(run(only), 2);
  EXPECT_THAT(output, HasSubstr("does not go with --engine slurm"));
}

// All is decided, but what an element made cannot be read: that is no success.
TEST_F(FakeSlurm, leaves_a_shard_that_cannot_be_taken_over) {
  ASSERT_EQ(submit(), 0) << output;
  ASSERT_EQ(run({"run", smoke, "--results", results}), 0) << output;
  const auto shard = folders().at(0) / "shard-0";
  fs::create_directories(shard);
  std::ofstream(shard / "catalog.db") << "this is no database\n";
  fs::remove(slurm / "jobs");
  EXPECT_EQ(submit(), 1) << output;
  EXPECT_THAT(output, HasSubstr("2 done, 0 failed, none left"));
  EXPECT_THAT(output, HasSubstr(shard.string()));
}

TEST_F(FakeSlurm, is_given_no_option_that_breaks_the_scripts) {
  for (const std::string option :
       {"--array=0-3", "--wait", "-W", "--job-name=mine", "partition=long", "--a=\nb"}) {
    EXPECT_EQ(submit({"--slurm=" + option}), 2) << option;
    EXPECT_THAT(output, HasSubstr("--slurm="));
  }
  EXPECT_EQ(run({"run", smoke, "--engine", "slurm", "--results", results + "\nx"}), 2);
  EXPECT_EQ(run({"run", smoke, "--engine", "slurm", "--results", results + "\\x"}), 2);
  EXPECT_EQ(taken(), none);
}

TEST_F(FakeSlurm, is_asked_on_the_cluster_that_the_options_name) {
  ASSERT_EQ(submit({"--slurm=--clusters=far"}), 0) << output;
  EXPECT_EQ(status(), 75);
  EXPECT_THAT(text_of(slurm / "calls"), testing::ContainsRegex("squeue .*--clusters=far"));
}

}  // namespace
}  // namespace mpmstudy
