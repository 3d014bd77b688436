// Claims follow the numbers of the catalog: the same study with other results is judged otherwise.
#include "runner/paper/claims.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <map>

#include "libmpm/io/vtkhdf.hpp"
#include "runner/catalog/writer.hpp"
#include "runner/paper/reference_claims.hpp"
#include "tests/runner/fakes.hpp"

namespace mpmstudy {
namespace {

/// Job n has the radius 1/n um, and the key of its scene.
Job job(int n) {
  Job made = fakes::job(n);
  made.key = job_key(made.scene);
  return made;
}

class Claims : public testing::Test {
 protected:
  /// From now on the file of the study says these jobs.
  void say(const std::string& name, const std::vector<Job>& jobs) {
    Study study;
    study.name = study.title = name;
    study.kind = mpm::SceneKind::cavity_impact;
    for (const Job& one : jobs) study.scenes.push_back(one.scene);
    said[name] = study;
  }
  /// A done job of a study.
  void put(CatalogWriter& writer, const std::string& study, std::vector<Job> jobs,
           std::vector<mpm::RunResult> results) {
    say(study, jobs);
    writer.register_study(study, study, jobs, false);
    for (std::size_t i = 0; i < jobs.size(); ++i) {
      writer.reserve(jobs[i].key);
      FinishedJob done;
      done.key = jobs[i].key;
      done.result = results[i];
      writer.complete(done);
    }
    writer.flush();
  }
  Claim judged(const std::string& name) {
    std::vector<Study> studies;
    for (const auto& [study, file] : said) studies.push_back(file);
    for (Claim& c : judge_claims(folder.path(), studies))
      if (c.name == name) return c;
    ADD_FAILURE() << "no claim " << name;
    return {};
  }
  /// A done job with snapshots.
  void put(CatalogWriter& writer, const std::string& study, const Job& job, mpm::RunResult result,
           const std::vector<mpm::Snapshot>& snapshots) {
    say(study, {job});
    writer.register_study(study, study, {job}, false);
    writer.reserve(job.key);
    FinishedJob done;
    done.key = job.key;
    done.result = std::move(result);
    for (const mpm::Snapshot& s : snapshots) {
      const std::string path = job.key + std::to_string(done.snapshots.size()) + ".h5";
      mpm::write_vtkhdf(folder.path() / path, s);
      done.snapshots.push_back({s.time, 0, path, 0, {}});
    }
    writer.complete(done);
    writer.flush();
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
  std::map<std::string, Study> said;
  fakes::TemporaryFolder folder;
};

/// Half a block of 5 by 10 um at rest, cool and whole.
mpm::Snapshot block(double time_ns) {
  mpm::Snapshot s;
  s.time = time_ns * 1e-9;
  for (int j = 0; j < 100; ++j)
    for (int i = 0; i < 50; ++i) {
      s.x.push_back((i + 0.5) * 1e-7);
      s.y.push_back((j + 0.5) * 1e-7);
    }
  const std::size_t n = s.x.size();
  s.mass.assign(n, 2700e-14);
  s.density.assign(n, 2700);
  for (auto column :
       {&mpm::Snapshot::velocity_x, &mpm::Snapshot::velocity_y, &mpm::Snapshot::pressure,
        &mpm::Snapshot::stress_xx, &mpm::Snapshot::stress_yy, &mpm::Snapshot::stress_xy,
        &mpm::Snapshot::stress_zz, &mpm::Snapshot::von_mises, &mpm::Snapshot::equivalent_plastic_strain,
        &mpm::Snapshot::plastic_work, &mpm::Snapshot::specific_internal_energy, &mpm::Snapshot::temperature})
    (s.*column).assign(n, 0);
  return s;
}

/// With a hole: what was there is gone to a corner.
mpm::Snapshot with_hole(mpm::Snapshot s, double x, double radius) {
  for (std::size_t p = 0; p < s.x.size(); ++p)
    if (std::hypot(s.x[p] - x, s.y[p] - 5e-6) < radius) s.x[p] = s.y[p] = 1e-7;
  return s;
}

/// With a hot place that turns.
mpm::Snapshot with_vortex(mpm::Snapshot s, double x, double turns) {
  for (std::size_t p = 0; p < s.x.size(); ++p) {
    const double dx = s.x[p] - x, dy = s.y[p] - 5e-6;
    s.plastic_work[p] = std::exp(-(dx * dx + dy * dy) / 1e-12);
    s.velocity_x[p] = -turns * dy;
    s.velocity_y[p] = turns * dx;
  }
  return s;
}

TEST_F(Claims, AreNotRunWithoutTheirStudies) {
  CatalogWriter writer(folder.path());
  for (const Claim& c : judge_claims(folder.path(), {})) {
    EXPECT_EQ(c.verdict, "not run") << c.name;
    EXPECT_FALSE(c.sentence.empty());
    EXPECT_FALSE(c.study.empty());
  }
}

TEST_F(Claims, FollowTheOrderOfTheNumbers) {
  CatalogWriter writer(folder.path());
  // job n has the radius 1/n um
  put(writer, "collapsibility-radius", {job(1), job(2), job(3)}, {with(0.5), with(0.7), with(0.9)});
  EXPECT_EQ(judged("collapsibility-falls-with-radius").verdict, "holds");
  put(writer, "collapsibility-radius", {job(4), job(5)}, {with(0.9), with(0.7)});
  EXPECT_EQ(judged("collapsibility-falls-with-radius").verdict, "does not hold");
}

TEST_F(Claims, FollowOutcomesAndMetrics) {
  CatalogWriter writer(folder.path());
  put(writer, "strong-collapse", {job(1)}, {with(1, {{"decision_margin", 0.2, "1", {}}}, "ejected")});
  EXPECT_EQ(judged("wall-broken").verdict, "holds");
  // A wall that is whole on cells of 0.1 um may part on finer ones.
  put(writer, "strong-collapse", {job(2)}, {with(1, {}, "arrested")});
  EXPECT_EQ(judged("wall-broken").verdict, "not decided at these cells");
  EXPECT_THAT(judged("wall-broken").measured, testing::HasSubstr("whole on cells of 0.1 um"));
  Job fine = job(2);
  fine.scene.numerics.cell_size = 0.05e-6;
  fine.key = job_key(fine.scene);
  put(writer, "strong-collapse", {fine}, {with(1, {}, "arrested")});
  EXPECT_EQ(judged("wall-broken").verdict, "does not hold");
  put(writer, "strong-collapse", {job(9)},
      {with(1, {{"cavity_joined_outside_time_s", 9e-9, "s", {}}}, "arrested")});
  EXPECT_EQ(judged("wall-broken").verdict, "holds");

  put(writer, "weak-collapse", {job(3)}, {with(0.8, {{"aspect_ratio", 0.7, "1", {}}})});
  EXPECT_EQ(judged("incomplete-collapse").verdict, "holds");
  EXPECT_EQ(judged("less-collapse-along-shock").verdict, "holds");
  // An interval that reaches a whole collapse says neither; a cavity that closed does.
  put(writer, "weak-collapse", {job(10)}, {with(0.995)});
  EXPECT_EQ(judged("incomplete-collapse").verdict, "not decided at these cells");
  put(writer, "weak-collapse", {job(4)}, {with(0.995, {{"aspect_ratio", 1.3, "1", {}}}, "collapsed")});
  EXPECT_EQ(judged("incomplete-collapse").verdict, "does not hold");
  EXPECT_EQ(judged("less-collapse-along-shock").verdict, "does not hold");

  // Numbers that have a flag are no evidence, and that is said.
  mpm::RunResult torn = with(0.15);
  torn.final_area = 0.85e-12;
  torn.collapsibility_error = 5.9;
  put(writer, "weak-collapse", {job(11)}, {torn});
  EXPECT_EQ(judged("incomplete-collapse").verdict, "not decided");
  EXPECT_THAT(judged("incomplete-collapse").measured, testing::HasSubstr("interval as wide as"));

  put(writer, "scale-invariance", {job(5), job(6)}, {with(0.8), with(0.8)});
  EXPECT_EQ(judged("scale-invariance").verdict, "holds");
  put(writer, "scale-invariance", {job(7), job(8)}, {with(0.8), with(0.8000000001)});
  EXPECT_EQ(judged("scale-invariance").verdict, "does not hold");
}

TEST_F(Claims, FollowTheCavitiesOfTheSnapshots) {
  CatalogWriter writer(folder.path());
  const mpm::RunResult strong = with(1, {{"jet_impact_time_s", 1.5e-9, "s", {}}}, "arrested");
  // One off the axis is two in the whole block.
  const auto start = with_hole(block(1.2), 0, 1e-6), apart = with_hole(block(2.4), 2e-6, 0.5e-6);
  put(writer, "strong-collapse", job(1), strong, {start, block(1.6), apart, with_hole(block(4.4), 0, 2e-6)});
  EXPECT_EQ(judged("new-cavities").verdict, "holds");
  EXPECT_EQ(judged("coalescence").verdict, "holds");
  EXPECT_THAT(judged("coalescence").measured, testing::StartsWith("2 at 2.4 ns"));
  put(writer, "strong-collapse", job(2), strong, {start, block(1.6), apart});
  EXPECT_EQ(judged("new-cavities").verdict, "holds");
  EXPECT_EQ(judged("coalescence").verdict, "does not hold");
  put(writer, "strong-collapse", job(3), strong, {start, block(1.6), block(4.4)});
  EXPECT_EQ(judged("new-cavities").verdict, "does not hold");
  EXPECT_EQ(judged("coalescence").verdict, "does not hold");
}

TEST_F(Claims, FollowWhatTurnsAroundTheHotSpots) {
  CatalogWriter writer(folder.path());
  const mpm::RunResult jet = with(1, {{"jet_impact_time_s", 1.7e-9, "s", {}}});
  const auto run = [&](int n, double x, double turns) {
    put(writer, "two-body-jet", job(n), jet,
        {with_vortex(block(2), x, turns), with_vortex(block(3), x, turns)});
  };
  run(1, 1e-6, -2e9);
  EXPECT_EQ(judged("hot-spots-in-vortices").verdict, "holds");
  EXPECT_THAT(judged("hot-spots-in-vortices").measured, testing::HasSubstr("2.0 rad"));
  run(2, 1e-6, 0.1e9);  // hardly turns
  EXPECT_EQ(judged("hot-spots-in-vortices").verdict, "does not hold");
  run(3, 0.1e-6, -2e9);  // on the axis
  EXPECT_EQ(judged("hot-spots-in-vortices").verdict, "does not hold");
}

TEST_F(Claims, FollowTheFitOfTheCriticalSpeed) {
  CatalogWriter writer(folder.path());
  Job points[] = {job(1), job(2)}, uppers[] = {job(1), job(2)};
  for (int i = 0; i < 2; ++i) {
    uppers[i].scene.impact_speed = 410 + 200 * i;
    uppers[i].key = job_key(uppers[i].scene);
  }
  say("critical-speed", {points[0], points[1]});
  said["critical-speed"].search = SearchRequest{"impact_speed", "ejected", 200, 1000, 10, ""};
  writer.register_study("critical-speed", "", {uppers[0], uppers[1]}, false);
  const auto fit = [&](std::optional<double> r2, std::optional<double> chi2) {
    writer.replace_fits(
        "critical-speed",
        {{"critical_speed_extrapolated", "wall_thickness", "quadratic", "c0", 100, 1.0, r2, "m/s", {}, chi2},
         {"critical_speed_extrapolated",
          "wall_thickness",
          "quadratic",
          "c2",
          3e13,
          1e12,
          r2,
          "m/s/m^2",
          {},
          chi2}});
  };
  const auto bracket = [&](std::int64_t position, double lower, double extrapolated, double wall) {
    const auto i = static_cast<std::size_t>(position);
    mpm::Scene below = points[i].scene;
    below.impact_speed = lower;
    return BracketRow{"impact_speed", "m/s", lower, lower + 10, job_key(below), uppers[i].key, 1e-7,
                      extrapolated,   20.0,  "",    5,          position,       "{}",          wall};
  };
  writer.replace_brackets("critical-speed", {bracket(0, 400, 390, 1e-6), bracket(1, 600, 590, 2e-6)});
  fit(0.999, 0.5);
  EXPECT_EQ(judged("critical-speed-parabola").verdict, "holds");
  EXPECT_THAT(judged("critical-speed-parabola").measured, testing::HasSubstr("30.0, standard error 1.0"));
  EXPECT_EQ(judged("critical-speed-values").verdict, "not comparable");
  EXPECT_EQ(judged("critical-speed-values").measured,
            "390 ± 20 m/s at d = 1 um to 590 ± 20 m/s at 2 um; on the finest cell 405 to 605 m/s");
  // Scatter within the intervals says nothing against a parabola; beyond them it does.
  fit(0.6, 0.5);
  EXPECT_EQ(judged("critical-speed-parabola").verdict, "not decided at these cells");
  EXPECT_THAT(judged("critical-speed-parabola").measured, testing::HasSubstr("intervals of up to ± 20 m/s"));
  fit(0.6, 4);
  EXPECT_EQ(judged("critical-speed-parabola").verdict, "does not hold");
  // Through as many points as coefficients every parabola goes.
  fit({}, {});
  EXPECT_EQ(judged("critical-speed-parabola").verdict, "not decided at these cells");
  EXPECT_THAT(judged("critical-speed-parabola").measured, testing::HasSubstr("as many points as"));
  // A bracket whose value is not known is no evidence.
  auto doubtful = bracket(1, 600, 590, 2e-6);
  doubtful.flags = "flips back at 700 m/s";
  writer.replace_brackets("critical-speed", {bracket(0, 400, 390, 1e-6), doubtful});
  EXPECT_THAT(judged("critical-speed-values").measured, testing::HasSubstr("to 390 ± 20 m/s at 1 um"));
  // A curvature within its standard error is none.
  writer.replace_fits("critical-speed", {{"critical_speed_extrapolated",
                                          "wall_thickness",
                                          "quadratic",
                                          "c2",
                                          1e12,
                                          2e12,
                                          0.99,
                                          "m/s/m^2",
                                          {},
                                          0.5}});
  EXPECT_EQ(judged("critical-speed-parabola").verdict, "not decided at these cells");
}

TEST_F(Claims, RestOnTheJobsOfTheirStudiesFile) {
  CatalogWriter writer(folder.path());
  put(writer, "weak-collapse", {job(3)}, {with(0.8)});
  EXPECT_EQ(judged("incomplete-collapse").verdict, "holds");
  // `run --set impact_speed=...`: another job under the name.
  Job slow = job(3);
  slow.scene.impact_speed = 150;
  slow.key = job_key(slow.scene);
  put(writer, "weak-collapse", {slow}, {with(0.5)});
  say("weak-collapse", {job(3)});
  EXPECT_EQ(judged("incomplete-collapse").verdict, "not run");
  EXPECT_EQ(judged("incomplete-collapse").measured, "the catalog has it at impact_speed = 150 m/s");
  // Half of a study is no evidence for what is said of all of it, nor is more than it says.
  put(writer, "collapsibility-radius", {job(1), job(2)}, {with(0.5), with(0.7)});
  say("collapsibility-radius", {job(1), job(2), job(5)});
  EXPECT_EQ(judged("collapsibility-falls-with-radius").verdict, "not run");
  say("collapsibility-radius", {job(1)});
  EXPECT_EQ(judged("collapsibility-falls-with-radius").verdict, "not run");
  // The speed of the shock comes from another study.
  put(writer, "two-body-jet", {job(7)}, {with(1)});
  EXPECT_EQ(judged("jet-overtakes-shock").verdict, "not run");
  EXPECT_THAT(judged("jet-overtakes-shock").measured, testing::HasSubstr("planar-impact: its study file"));
}

TEST_F(Claims, AnOrderWithinTheIntervalsIsNotDecided) {
  CatalogWriter writer(folder.path());
  // Radii 1/3, 1/2, 1 um; intervals of 0.01 each.
  put(writer, "collapsibility-radius", {job(1), job(2), job(3)}, {with(0.5), with(0.505), with(0.9)});
  EXPECT_EQ(judged("collapsibility-falls-with-radius").verdict, "not decided at these cells");
}

TEST_F(Claims, HaveAReferenceWithFineCells) {
  CatalogWriter writer(folder.path());
  const auto& reference = reference_claims();
  for (const Claim& c : judge_claims(folder.path(), {}))
    EXPECT_TRUE(reference.contains(c.name) && !reference.at(c.name).verdict.empty()) << c.name;
  EXPECT_EQ(reference.at("critical-speed-parabola").verdict, "holds");
  EXPECT_EQ(reference.at("shock-outruns-wall").measured,
            "shock 7357 m/s, free surface 3014 m/s, both against the material ahead");
}

}  // namespace
}  // namespace mpmstudy
