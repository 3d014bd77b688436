// What is read out of the answers of Slurm's commands, and how a command is run.
#include "runner/slurm/client.hpp"

#include <gmock/gmock.h>

#include <chrono>
#include <cstdlib>

#include "runner/slurm/command.hpp"

namespace mpmstudy {
namespace {

using testing::HasSubstr;

TEST(JobNumber, is_the_last_line_that_is_one) {
  const std::vector<std::pair<std::string, std::string>> cases = {
      {"4711\n", "4711"},
      {"4711", "4711"},
      {"4711;fast\n", "4711;fast"},
      {"Welcome\n2026\n4711\n", "4711"},
      {"4711\n\n17 of your jobs wait\n", "4711"},
      {"  4711\n", ""},
      {"Submitted batch job 4711\n", "4711"},
      {"Submitted batch job 4711 on cluster fast\n", "4711;fast"},
      {"sbatch: Submitted batch job 4711\n", ""},
      {"Submitted batch job 4711 too late\n", ""},
      {"Submitted batch job\n", ""},
      {"Submitted batch job 4711 on cluster \n", ""},
      {"4711 jobs\n", ""},
      {"4711;\n", ""},
      {"4711;a b\n", ""},
      {"4711\r\n", "4711"},
      {"", ""},
  };
  for (const auto& [printed, expected] : cases) {
    const auto number = parse_job_number(printed);
    const std::string found =
        number ? number->id + (number->cluster.empty() ? "" : ";" + number->cluster) : "";
    EXPECT_EQ(found, expected) << printed;
  }
}

TEST(Queue, is_an_answer_only_with_its_titles) {
  EXPECT_FALSE(parse_queue(""));
  EXPECT_FALSE(parse_queue("Connection refused\n"));
  EXPECT_FALSE(parse_queue("mpmstudy|4711|PD|n|None\n")) << "the begin is lost";
  EXPECT_FALSE(parse_queue("mpmstudy|JOBID|ST|NAME|REASON\nmpmstudy|4711|P")) << "the end is lost";
  EXPECT_TRUE(parse_queue("mpmstudy|JOBID|ST|NAME|REASON\n")->empty());
  const auto rows = parse_queue(
      "CLUSTER: far\nWelcome\nmpmstudy|JOBID|ST|NAME|REASON\nmpmstudy|4711_3|PD|n|launch failed requeued "
      "held\n"
      "mpmstudy|4711_4|CD|n|None\n");
  ASSERT_EQ(rows->size(), 2u);
  EXPECT_EQ(rows->at(0).id, "4711_3");
  EXPECT_EQ(rows->at(0).array_id(), "4711");
  EXPECT_EQ(rows->at(0).reason, "launch failed requeued held");
  EXPECT_FALSE(rows->at(0).ended());
  EXPECT_TRUE(rows->at(1).ended());
  EXPECT_FALSE((QueueRow{"1", "XY", "n", ""}.ended())) << "a state that nobody knows is no end";
}

TEST(Command, has_its_two_outputs_apart) {
  const auto answer = run_command({"sh", "-c", "echo out; echo err >&2; exit 3"}, 60);
  EXPECT_EQ(answer.out, "out\n");
  EXPECT_EQ(answer.err, "err\n");
  EXPECT_EQ(answer.code, 3);
  EXPECT_EQ(answer.words(), "err out (exit code 3)");
}

TEST(Command, passes_words_as_they_are) {
  const std::string word = "a  b'\"$(touch x)`\n%j\\";
  EXPECT_EQ(run_command({"printf", "%s", word}, 60).out, word);
}

TEST(Command, is_ended_with_all_that_it_started) {
  const auto start = std::chrono::steady_clock::now();
  const auto answer = run_command({"sh", "-c", "echo begun; sleep 50; echo never"}, 0.5);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(25));
  EXPECT_TRUE(answer.timed_out);
  EXPECT_EQ(answer.out, "begun\n");
  EXPECT_THAT(answer.words(), HasSubstr("no answer in time"));
}

TEST(Command, is_over_when_it_ends_and_not_when_what_it_left_behind_does) {
  const auto start = std::chrono::steady_clock::now();
  const auto answer = run_command({"sh", "-c", "sleep 50 & echo done"}, 100);
  EXPECT_LT(std::chrono::steady_clock::now() - start, std::chrono::seconds(25));
  EXPECT_EQ(answer.out, "done\n");
  EXPECT_FALSE(answer.timed_out);
}

TEST(Command, that_is_not_there_says_so) {
  const auto answer = run_command({"no-such-program-4711"}, 60);
  EXPECT_FALSE(answer.started);
  EXPECT_THAT(answer.words(), HasSubstr("no-such-program-4711 is not installed here"));
}

TEST(Command, does_not_get_the_variables_that_are_dropped) {
  setenv("SQUEUE_FORMAT", "x", 1);
  setenv("SLURM_CLUSTERS", "y", 1);
  setenv("SQUARE", "kept", 1);
  const auto answer = run_command({"sh", "-c", "echo $SQUEUE_FORMAT,$SLURM_CLUSTERS,$SQUARE"}, 60,
                                  {"SQUEUE_*", "SLURM_CLUSTERS"});
  EXPECT_EQ(answer.out, ",,kept\n");
  for (const char* name : {"SQUEUE_FORMAT", "SLURM_CLUSTERS", "SQUARE"}) unsetenv(name);
}

}  // namespace
}  // namespace mpmstudy
