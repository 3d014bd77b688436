// Claims follow the numbers of the catalog: the same study with other results is judged otherwise.
#include "runner/finish/claims.hpp"

#include <gmock/gmock.h>

#include "runner/catalog/writer.hpp"
#include "tests/runner/fakes.hpp"

namespace mpmstudy {
namespace {

class Claims : public testing::Test {
 protected:
  /// A done job of a study.
  void put(CatalogWriter& writer, const std::string& study, std::vector<Job> jobs,
           std::vector<mpm::RunResult> results) {
    writer.register_study(study, study, jobs, false);
    for (std::size_t i = 0; i < jobs.size(); ++i) {
      writer.claim(jobs[i].key);
      FinishedJob done;
      done.key = jobs[i].key;
      done.result = results[i];
      writer.finish(done);
    }
    writer.flush();
  }
  Claim judged(const std::string& name) {
    for (Claim& c : judge_claims(folder.path()))
      if (c.name == name) return c;
    ADD_FAILURE() << "no claim " << name;
    return {};
  }
  static mpm::RunResult with(double collapsibility, std::vector<mpm::Metric> metrics = {},
                             std::string outcome = "partial") {
    mpm::RunResult r;
    r.collapsibility = collapsibility;
    r.collapsibility_error = 0.01;
    r.metrics = std::move(metrics);
    r.outcome = std::move(outcome);
    return r;
  }
  fakes::TemporaryFolder folder;
};

TEST_F(Claims, AreNotRunWithoutTheirStudies) {
  CatalogWriter writer(folder.path());
  for (const Claim& c : judge_claims(folder.path())) {
    EXPECT_EQ(c.verdict, "not run") << c.name;
    EXPECT_FALSE(c.sentence.empty());
    EXPECT_FALSE(c.study.empty());
  }
}

TEST_F(Claims, FollowTheOrderOfTheNumbers) {
  CatalogWriter writer(folder.path());
  // job n has the radius 1/n um
  put(writer, "collapsibility-radius", {fakes::job(1), fakes::job(2), fakes::job(3)},
      {with(0.5), with(0.7), with(0.9)});
  EXPECT_EQ(judged("collapsibility-falls-with-radius").verdict, "holds");
  put(writer, "collapsibility-radius", {fakes::job(4), fakes::job(5)}, {with(0.9), with(0.7)});
  EXPECT_EQ(judged("collapsibility-falls-with-radius").verdict, "does not");
}

TEST_F(Claims, FollowOutcomesAndMetrics) {
  CatalogWriter writer(folder.path());
  put(writer, "strong-collapse", {fakes::job(1)},
      {with(
          1,
          {{"new_cavities", 4, "1", {}}, {"cavities_at_end", 1, "1", {}}, {"decision_margin", 0.2, "1", {}}},
          "ejected")});
  EXPECT_EQ(judged("wall-broken").verdict, "holds");
  EXPECT_EQ(judged("new-cavities").verdict, "holds");
  EXPECT_EQ(judged("coalescence").verdict, "holds");
  put(writer, "strong-collapse", {fakes::job(2)},
      {with(1, {{"new_cavities", 0, "1", {}}, {"cavities_at_end", 0, "1", {}}}, "arrested")});
  EXPECT_EQ(judged("wall-broken").verdict, "does not");
  EXPECT_EQ(judged("new-cavities").verdict, "does not");
  EXPECT_EQ(judged("coalescence").verdict, "does not");

  put(writer, "weak-collapse", {fakes::job(3)}, {with(0.8, {{"aspect_ratio", 0.7, "1", {}}})});
  EXPECT_EQ(judged("incomplete-collapse").verdict, "holds");
  EXPECT_EQ(judged("less-collapse-along-shock").verdict, "holds");
  put(writer, "weak-collapse", {fakes::job(4)}, {with(0.995, {{"aspect_ratio", 1.3, "1", {}}})});
  EXPECT_EQ(judged("incomplete-collapse").verdict, "does not");
  EXPECT_EQ(judged("less-collapse-along-shock").verdict, "does not");

  put(writer, "scale-invariance", {fakes::job(5), fakes::job(6)}, {with(0.8), with(0.8)});
  EXPECT_EQ(judged("scale-invariance").verdict, "holds");
  put(writer, "scale-invariance", {fakes::job(7), fakes::job(8)}, {with(0.8), with(0.8000000001)});
  EXPECT_EQ(judged("scale-invariance").verdict, "does not");
}

TEST_F(Claims, FollowTheFitOfTheCriticalSpeed) {
  CatalogWriter writer(folder.path());
  writer.register_study("critical-speed", "", {fakes::job(1)}, false);
  const auto fit = [&](double r2) {
    writer.replace_fits(
        "critical-speed",
        {{"critical_speed_extrapolated", "wall_thickness", "quadratic", "c0", 100, 1.0, r2, "m/s"},
         {"critical_speed_extrapolated", "wall_thickness", "quadratic", "c2", 3e13, 1e12, r2, "m/s/m^2"}});
  };
  writer.replace_critical_speeds("critical-speed", {{1e-6, 400, 410, "a", "b", 1e-7, 390, 20, "", 5, 0},
                                                    {2e-6, 600, 610, "a", "b", 1e-7, 590, 20, "", 5, 1}});
  fit(0.999);
  EXPECT_EQ(judged("critical-speed-parabola").verdict, "holds");
  EXPECT_THAT(judged("critical-speed-parabola").measured, testing::HasSubstr("30.0 ± 1.0"));
  EXPECT_EQ(judged("critical-speed-values").verdict, "not comparable");
  fit(0.6);
  EXPECT_EQ(judged("critical-speed-parabola").verdict, "does not");
}

}  // namespace
}  // namespace mpmstudy
