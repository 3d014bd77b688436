// What is printed for people, with a clock that the test sets.
#include <gmock/gmock.h>

#include <sstream>

#include "runner/status/eta.hpp"
#include "runner/status/label.hpp"
#include "runner/status/plain_status.hpp"
#include "runner/status/terminal_status.hpp"
#include "runner/study/characters.hpp"
#include "tests/runner/fakes.hpp"

namespace mpmstudy {
namespace {

using testing::HasSubstr;
using testing::Not;

mpm::Progress at(double fraction, std::int64_t step = 10) {
  return {step, 16e-9 * fraction, 16e-9, 1e-12, 1000};
}

TEST(Label, numbers_that_people_read) {
  const std::string swept[] = {"cavity_radius", "scheme", "unknown"};
  EXPECT_EQ(label_of(fakes::scene(1.5e-6), swept), "cavity_radius = 1.5 um, scheme = gimp");
  EXPECT_EQ(readable_duration(3.21), "3.2 s");
  EXPECT_EQ(readable_duration(125), "2 min 05 s");
  EXPECT_EQ(readable_duration(3720), "1 h 02 min");
  EXPECT_EQ(readable_duration(9.97), "10 s");
}

TEST(EtaTest, follows_the_work_that_is_done) {
  Eta eta(100, 1);
  EXPECT_FALSE(eta.remaining(1));
  eta.progress("a", 40, 0.5);
  EXPECT_NEAR(eta.remaining(10).value(), 40, 1e-9);  // 20 of 100 in 10 s
  eta.finished("a", 40);
  EXPECT_NEAR(eta.remaining(10).value(), 15, 1e-9);
  EXPECT_NEAR(eta.fraction(), 0.4, 1e-12);
}

TEST(EtaTest, is_no_sooner_than_the_longest_job) {
  Eta eta(100, 4);
  eta.finished("small", 20);
  eta.progress("long", 80, 0.0);
  eta.progress("long", 80, 0.25);  // 40 of 100 in 10 s, by one worker
  EXPECT_NEAR(eta.remaining(10).value(), 15, 1e-9);
}

TEST(PlainStatusTest, a_line_for_each_start_and_end) {
  std::ostringstream out;
  double now = 0;
  const auto status = make_plain_status(out, {30, {"cavity_radius"}, false}, [&] { return now; });
  const auto job = fakes::job(1);
  status->run_started({2, 3, 1, 0, 12, 2});
  status->job_started(job);
  status->job_progress(job, at(0.1));
  now = 31;
  status->job_progress(job, at(0.5));
  status->job_progress(job, at(0.6));
  status->job_finished(job, {JobStatus::done, "", 1000, 500, 3.2, 0.1});
  status->job_finished(fakes::job(2), {JobStatus::failed, "step 3: broke", 0, 0, 1, 1});
  status->run_finished({1, 1, 3, 0, 32, 5e6, ""});
  EXPECT_THAT(out.str(), HasSubstr("2 jobs to run on 2 workers"));
  EXPECT_THAT(out.str(), HasSubstr("3 jobs done already"));
  EXPECT_THAT(out.str(), HasSubstr("started: 1001 particles"));
  EXPECT_THAT(out.str(), Not(HasSubstr(" 10 %")));
  EXPECT_THAT(out.str(), HasSubstr(" 50 %"));
  EXPECT_THAT(out.str(), Not(HasSubstr(" 60 %")));
  EXPECT_THAT(out.str(),
              HasSubstr("[1/2] 000000000000 done in 3.2 s (1000 particles, 500 steps, 5.00 M/s updates)"));
  EXPECT_THAT(out.str(), HasSubstr("FAILED: step 3: broke"));
  EXPECT_THAT(out.str(), HasSubstr("1 done, 1 failed, 3 reused, 0 left"));
  EXPECT_THAT(out.str(), Not(HasSubstr("\x1b")));
}

TEST(PlainStatusTest, a_stopped_job_is_not_counted) {
  std::ostringstream plain, terminal;
  const auto clock = [] { return 0.0; };
  TerminalOptions options;
  options.width = [] { return std::size_t{200}; };
  const std::pair<std::ostringstream*, std::unique_ptr<Status>> both[] = {
      {&plain, make_plain_status(plain, {}, clock)},
      {&terminal, make_terminal_status(terminal, options, clock)}};
  for (const auto& [out, status] : both) {
    status->run_started({2, 0, 0, 0, 12, 1});
    status->job_finished(fakes::job(1), {JobStatus::done, "", 1000, 500, 3.2, 0.1});
    status->job_finished(fakes::job(2), {JobStatus::planned, "", 0, 0, 0, 0});
    EXPECT_THAT(out->str(),
                HasSubstr("[1/2] " + short_key(fakes::job(2).key) + " stopped, will be run again\n"));
    EXPECT_THAT(out->str(), Not(HasSubstr("[2/2]")));
  }
}

TEST(PlainStatusTest, one_is_not_many) {
  EXPECT_THAT(start_text({1, 1, 1, 1, 12, 1}), HasSubstr("1 job to run on 1 worker,"));
  EXPECT_THAT(start_text({1, 1, 1, 1, 12, 1}), Not(HasSubstr("1 jobs")));
}

TEST(PlainStatusTest, quiet_says_failures_and_the_summary) {
  std::ostringstream out;
  const auto status = make_plain_status(out, {30, {}, true}, [] { return 0.0; });
  status->run_started({2, 0, 0, 0, 12, 2});
  status->job_started(fakes::job(1));
  status->job_finished(fakes::job(1), {});
  EXPECT_EQ(out.str(), "");
  status->job_finished(fakes::job(2), {JobStatus::failed, "broke", 0, 0, 1, 1});
  EXPECT_THAT(out.str(), HasSubstr("broke"));
}

TEST(PlainStatusTest, a_second_run_counts_from_one) {
  std::ostringstream plain, terminal;
  const auto clock = [] { return 0.0; };
  TerminalOptions options;
  options.width = [] { return std::size_t{200}; };
  const std::pair<std::ostringstream*, std::unique_ptr<Status>> both[] = {
      {&plain, make_plain_status(plain, {}, clock)},
      {&terminal, make_terminal_status(terminal, options, clock)}};
  for (const auto& [out, status] : both) {
    for (int run = 0; run < 2; ++run) {
      status->run_started({2, 0, 0, 0, 12, 1});
      for (int n = 1; n <= 2; ++n) status->job_finished(fakes::job(n), {});
      status->run_finished({});
    }
    EXPECT_THAT(out->str(), HasSubstr("[2/2]"));
    EXPECT_THAT(out->str(), Not(HasSubstr("[3/2]")));
    EXPECT_THAT(out->str(), Not(HasSubstr("3/2 jobs")));
  }
}

TEST(PlainStatusTest, no_line_is_longer_than_120_columns_nor_than_one_line) {
  JobEnd end;
  end.status = JobStatus::failed;
  end.reason = std::string(300, 'r') + "\nsecond";
  const std::string label = "cavity_radius = 1 um, " + std::string(300, 'l');
  for (const auto status : {JobStatus::failed, JobStatus::planned, JobStatus::done}) {
    end.status = status;
    const auto line = end_line(1, 2, fakes::job(1), end, label);
    EXPECT_EQ(characters_in(line), line_columns);
    EXPECT_THAT(line, HasSubstr("cavity_radius = 1 um, "));
    EXPECT_THAT(line, Not(HasSubstr("\n")));
  }
  // Short ones are whole.
  end.status = JobStatus::failed;
  end.reason = "broke";
  EXPECT_THAT(end_line(1, 2, fakes::job(1), end, "a = 1"), testing::EndsWith(" FAILED: broke  a = 1"));
}

TEST(CutText, counts_code_points) {
  EXPECT_EQ(cut_text("µµµµµ", 5), "µµµµµ");
  EXPECT_EQ(cut_text("µµµµµµ", 5), "µµ...");
  EXPECT_EQ(cut_text("abc", 2), "..");
  EXPECT_EQ(first_line("a\nb"), "a");
}

TEST(TerminalStatusTest, redraws_seldom_and_never_wraps) {
  std::ostringstream out;
  double now = 0;
  std::size_t width = 40;
  TerminalOptions options;
  options.width = [&] { return width; };
  options.swept = {"cavity_radius"};
  const auto status = make_terminal_status(out, options, [&] { return now; });
  status->run_started({20, 0, 0, 0, 210, 20});
  for (int n = 1; n <= 20; ++n) status->job_started(fakes::job(n));
  const auto before = out.str().size();
  for (int i = 0; i < 100; ++i) status->job_progress(fakes::job(1), at(0.3));
  EXPECT_EQ(out.str().size(), before);  // no time has passed
  for (const std::size_t w : {1u, 5u, 40u, 200u}) {
    width = w;
    now += 1;
    out.str("");
    status->job_progress(fakes::job(1), at(0.3, 77));
    std::istringstream lines(out.str());
    std::size_t count = 0;
    for (std::string line; std::getline(lines, line); ++count) {
      if (const auto end = line.rfind("\x1b[J"); end != std::string::npos) line = line.substr(end + 3);
      EXPECT_LT(line.size(), std::max<std::size_t>(w, 1)) << line;
    }
    EXPECT_EQ(count, 13u);  // twelve jobs and the run
  }
  EXPECT_THAT(out.str(), HasSubstr("[###.......]  30 %  step     77      4.800 ns  cavity_radius = 1 um"));
  EXPECT_THAT(out.str(), HasSubstr("0/20 jobs"));
  EXPECT_THAT(out.str(), HasSubstr("20 running"));
}

}  // namespace
}  // namespace mpmstudy
