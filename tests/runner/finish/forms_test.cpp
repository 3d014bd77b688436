// A study in another form than its file's: what is shown, what is replaced, what claims rest on, where
// figures go. The program itself, on studies of a second.
#include "tests/runner/finish/finish.hpp"

namespace mpmstudy {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;

/// T of the trials, with cells of 0.5 um.
std::string study_text(const std::string& name, const std::string& radii = R"(["1 um", "2 um"])") {
  return "schema = 1\nname = \"" + name + "\"\nscene = \"cavity-impact\"\n[parameters]\n" +
         R"(material = "aluminium"
impact_speed = "200 m/s"
block_width = "10 um"
block_height = "6 um"
cavity_center_height = "3 um"
cavity_radius = )" +
         radii + R"(
end_time = "1 ns"
[numerics]
cell_size = "0.5 um"
[[fit]]
x = "cavity_radius"
y = "collapsibility"
model = "linear"
[[figure]]
name = "f"
kind = "xy"
x = "cavity_radius"
y = "collapsibility"
[[figure]]
name = "area"
kind = "history"
)";
}

class Forms : public Finish {
 protected:
  std::string first(const std::string& sql) {
    const Rows rows = query(results(), sql);
    return rows.rows.empty() ? "" : std::get<std::string>(rows.rows[0][0]);
  }
  std::string page() const {
    std::ifstream in(results() / "report.html");
    return {std::istreambuf_iterator<char>(in), {}};
  }
  std::string printed;
};

TEST_F(Forms, TwoStudiesMayHaveAFigureOfOneName) {
  const std::string t = write("T.toml", study_text("t")).string(),
                    u = write("U.toml", study_text("u")).string();
  ASSERT_EQ(run("run -q " + t, printed), 0) << printed;
  ASSERT_EQ(run("run -q --set 'impact_speed=400 m/s' " + u, printed), 0) << printed;
  EXPECT_THAT(printed, HasSubstr("figures/u/f.png"));
  EXPECT_TRUE(fs::exists(results() / "figures/t/f.svg") && fs::exists(results() / "figures/u/f.svg"));
  // A name is still that of one study.
  const std::string copy = write("copy.toml", study_text("t")).string();
  EXPECT_EQ(run("figures " + t + " " + copy, printed), 2);
  EXPECT_THAT(printed, HasSubstr("is also the name of"));
}

TEST_F(Forms, FiguresAndReportTakeTheFormOfTheLastRun) {
  const std::string t = write("T.toml", study_text("t")).string();
  ASSERT_EQ(run("run -q --cells 1.4 " + t, printed), 0) << printed;
  EXPECT_EQ(run("figures " + t, printed), 0) << printed;
  EXPECT_THAT(printed, HasSubstr("t: as it was last run, with --cells 1.4"));
  EXPECT_EQ(run("figures", printed), 0) << printed;  // every study of the catalog
  EXPECT_THAT(printed, HasSubstr("figures/t/f.png"));
  EXPECT_EQ(run("report " + t, printed), 0) << printed;
  EXPECT_THAT(page(), Not(HasSubstr("Not complete")));
  EXPECT_THAT(page(), HasSubstr("As it was run with --cells 1.4"));
  // Told otherwise: the file as it is, of which nothing is done; and the fuller page is kept.
  EXPECT_EQ(run("report --cells 1 " + t, printed), 75);
  EXPECT_THAT(printed, HasSubstr("2 of 2 jobs are not done (the catalog has it at cell_size = 700 nm)"));
  EXPECT_THAT(printed, HasSubstr("had 2 pictures, the page that takes its place has 0"));
  EXPECT_TRUE(fs::exists(results() / "report-2-pictures.html"));
  EXPECT_THAT(page(), HasSubstr("Not complete: 2 of 2 are missing"));
  EXPECT_THAT(page(), Not(HasSubstr("<td>done</td>"))) << "no rows of the other form below that";
  // `plan` plans what `run` would run, and says that the catalog has something else.
  EXPECT_EQ(run("plan " + t, printed), 0);
  EXPECT_THAT(printed, HasSubstr("t: was last run with --cells 1.4; this is the plan of"));
  const std::string key = first("SELECT key FROM jobs LIMIT 1");
  EXPECT_EQ(run("explain " + key + " " + t, printed), 0);
  EXPECT_THAT(printed, HasSubstr("as it was last run, with --cells 1.4"));
}

TEST_F(Forms, ANameAloneShowsTheLastRunOfThatName) {
  const std::string t = write("T.toml", study_text("t")).string();
  ASSERT_EQ(run("run -q --set name=fast --set 'impact_speed=400 m/s' " + t, printed), 0) << printed;
  EXPECT_EQ(run("figures --set name=fast " + t, printed), 0) << printed;
  EXPECT_THAT(printed, HasSubstr("figures/fast/f.png"));
  EXPECT_EQ(run("figures " + t, printed), 75);
  EXPECT_THAT(printed, HasSubstr("the catalog does not have the study"));
}

TEST_F(Forms, RunSaysWhatItReplaces) {
  const std::string t = write("T.toml", study_text("t")).string();
  ASSERT_EQ(run("run -q " + t, printed), 0) << printed;
  EXPECT_THAT(printed, Not(HasSubstr("takes the place")));
  ASSERT_EQ(run("run -q " + t, printed), 0) << printed;
  EXPECT_THAT(printed, Not(HasSubstr("takes the place")));
  ASSERT_EQ(run("run -n --set 'impact_speed=300 m/s' " + t, printed), 0) << printed;
  EXPECT_THAT(printed,
              HasSubstr("t: would take the place of the study of this name that was run before as its "
                        "file is: 2 done jobs would leave it, and its fits and figures would be "
                        "replaced; "));
  ASSERT_EQ(run("run -q --set 'impact_speed=300 m/s' " + t, printed), 0) << printed;
  EXPECT_THAT(printed,
              HasSubstr("t: takes the place of the study of this name that was run before as its file "
                        "is: 2 done jobs leave it"));
  EXPECT_THAT(printed, HasSubstr("--set name=..."));
  ASSERT_EQ(run("run -q --set name=other --set 'impact_speed=350 m/s' " + t, printed), 0) << printed;
  EXPECT_THAT(printed, Not(HasSubstr("takes the place")));
}

TEST_F(Forms, AClaimIsNotJudgedOnAnotherSpeed) {
  // The paper's own study, coarse and short.
  const std::string weak = std::string("run -q ") + SOURCE_DIR +
                           "/studies/paper/weak-collapse.toml --cells 3 --set end_time='1 ns' --set "
                           "'snapshots=[\"1 ns\"]' ";
  ASSERT_EQ(run(weak + "--set impact_speed='150 m/s'", printed), 0) << printed;
  run("report", printed);
  const auto verdict = [&] {
    return first("SELECT verdict || ': ' || measured FROM claims WHERE name = 'incomplete-collapse'");
  };
  EXPECT_THAT(verdict(), HasSubstr("not run: the catalog has it at impact_speed = 150 m/s; end_time = 1 ns"));
  EXPECT_THAT(printed, HasSubstr("not run"));
}

TEST_F(Forms, AClaimIsNotJudgedOnAFileThatOnlyBearsTheName) {
  const std::string mine = write("weak-collapse.toml", std::string(study_text("weak-collapse"))).string();
  ASSERT_EQ(run("run -q " + mine, printed), 0) << printed;
  run("report " + mine, printed);
  EXPECT_THAT(first("SELECT verdict || ': ' || measured FROM claims WHERE name = 'incomplete-collapse'"),
              testing::ContainsRegex("^not run: .*weak-collapse.toml has .* in place of "));
}

TEST_F(Forms, AReportHasTheClaimsOfItsStudiesOnly) {
  const std::string mine = write("T.toml", study_text("t")).string();
  const std::string planar = std::string(SOURCE_DIR) + "/studies/paper/planar-impact.toml";
  ASSERT_EQ(run("run -q " + mine, printed), 0) << printed;
  for (const std::string files : {"", mine.c_str()}) {
    EXPECT_EQ(run("report " + files, printed), 0) << printed;
    EXPECT_THAT(printed, Not(HasSubstr("not run")));
    EXPECT_THAT(printed, HasSubstr("the paper claims nothing of t\n"));
  }
  ASSERT_EQ(run("run -q --cells 2 " + planar, printed), 0) << printed;
  EXPECT_EQ(run("report " + mine + " " + planar, printed), 0) << printed;
  EXPECT_THAT(printed, HasSubstr("(planar-impact)"));
  EXPECT_THAT(printed, Not(HasSubstr("weak-collapse")));
  EXPECT_THAT(printed, HasSubstr("the paper claims nothing of t\n"));
  EXPECT_EQ(run("report " + mine, printed), 0) << printed;
  EXPECT_THAT(printed, Not(HasSubstr("planar-impact")));
  EXPECT_EQ(first("SELECT count(*) || '' FROM claims"), "18");  // all, whatever is shown
}

TEST_F(Forms, AClaimIsJudgedOnOtherCells) {
  const std::string study = std::string(SOURCE_DIR) + "/studies/paper/planar-impact.toml";
  ASSERT_EQ(run("run -q --cells 2 " + study, printed), 0) << printed;
  run("report " + study, printed);
  EXPECT_THAT(first("SELECT verdict || ': ' || measured FROM claims WHERE name = 'initial-pressure'"),
              testing::ContainsRegex("^(holds|not decided at these cells): .* GPa"));
}

// A catalog records where a file was. One that was moved into a folder below is still the study's.
TEST_F(Forms, AFileThatWasMovedIntoAFolderIsFound) {
  const fs::path t = write("T.toml", study_text("t")), below = t.parent_path() / "below";
  ASSERT_EQ(run("run -q --cells 1.4 " + t.string(), printed), 0) << printed;
  const std::string key = first("SELECT key FROM jobs LIMIT 1"), moved = (below / "T.toml").string();
  fs::create_directories(t.parent_path() / "another");
  write("another/T.toml", study_text("another"));  // has the file's name, and is another study
  fs::remove(t);
  EXPECT_EQ(run("report", printed), 1);
  EXPECT_THAT(printed, HasSubstr("t: left out; " + t.string() + ": is not there any longer"));
  EXPECT_EQ(run("explain " + key, printed), 0) << "what the catalog has is enough";
  EXPECT_EQ(run("status t", printed), 0) << printed;

  fs::create_directories(below);
  std::ofstream(moved) << study_text("t");
  for (const std::string verb : {"report", "figures"}) {
    EXPECT_EQ(run(verb, printed), 0) << printed;
    EXPECT_THAT(printed, HasSubstr("t: " + t.string() + " is not there any longer; " + moved +
                                   " is taken in its place"));
  }
  EXPECT_THAT(page(), HasSubstr("As it was run with --cells 1.4"));
  EXPECT_EQ(run("explain " + key, printed), 0);
  EXPECT_THAT(printed, HasSubstr("cavity_radius"));
  EXPECT_THAT(printed, HasSubstr(moved + ":10:17"));
  // Running it from there is no other study's run.
  EXPECT_EQ(run("run -q --cells 1.4 " + moved, printed), 0) << printed;
  EXPECT_THAT(printed, Not(HasSubstr("takes the place")));
  EXPECT_EQ(first("SELECT path FROM studies WHERE name = 't'"), moved);
}

TEST_F(Forms, FitsOfAnotherFormAreForgotten) {
  const std::string t = write("T.toml", study_text("t")).string();
  ASSERT_EQ(run("run -q " + t, printed), 0) << printed;
  ASSERT_EQ(query(results(), "SELECT * FROM fits").rows.size(), 2u);
  CatalogWriter writer(results());
  writer.register_study("t", "", {}, false, {t, {}, 1});
  EXPECT_EQ(query(results(), "SELECT * FROM fits").rows.size(), 2u);
  writer.register_study("t", "", {}, false, {t, {"impact_speed=300 m/s"}, 1});
  EXPECT_EQ(query(results(), "SELECT * FROM fits").rows.size(), 0u);
}

TEST_F(Forms, AFailedJobIsNoWorkForRun) {
  const std::string t = write("T.toml", study_text("t")).string();
  EXPECT_EQ(run("run -q --timeout '1 ms' --set end_time='400 ns' " + t, printed), 1) << printed;
  EXPECT_EQ(run("figures " + t, printed), 1);
  EXPECT_THAT(printed, HasSubstr("2 of 2 jobs failed"));
  EXPECT_THAT(printed, HasSubstr("mpmstudy retry --study t"));
  EXPECT_THAT(printed, Not(HasSubstr("runs them")));
}

TEST_F(Forms, ATitleThatNoFontHasIsSaid) {
  std::string text = study_text("t");
  text.insert(text.find("kind = \"xy\""), "title = \"能 against \U000F0000\"\n");
  const std::string t = write("T.toml", text).string();
  ASSERT_EQ(run("run -q " + t, printed), 0) << printed;
  EXPECT_THAT(printed, HasSubstr("title of figure f: no font of this machine has "));
  EXPECT_THAT(printed, HasSubstr("\U000F0000"));
}

TEST_F(Forms, FiguresOfAStudyThatWouldBeOneFileAreRefused) {
  std::string text = study_text("t");
  text.insert(text.find("[[fit]]"), "[measure]\nsnapshots = [\"1 ns\"]\n");
  const std::string t =
      write("T.toml", text +
                          "[[figure]]\nname = \"area-2\"\nkind = \"history\"\n[[figure]]\nname = "
                          "\"p\"\nkind = \"fields\"\ny = \"pressure\"\n[[figure]]\nname = "
                          "\"p-1\"\nkind = \"history\"\n")
          .string();
  EXPECT_EQ(run("run -q " + t, printed), 2);  // before any job
  EXPECT_THAT(printed, HasSubstr("name = \"p-1\": p-1.png is also a file of figure \"p\""));
}

}  // namespace
}  // namespace mpmstudy
