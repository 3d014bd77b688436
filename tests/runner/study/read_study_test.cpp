#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "libmpm/scene/parameters.hpp"
#include "tests/runner/study/study_text.hpp"

namespace mpmstudy {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(ReadStudy, OneScene) {
  const Study study = read_text(study_text());
  EXPECT_EQ(study.name, "test");
  EXPECT_EQ(study.title, "test");
  ASSERT_EQ(study.scenes.size(), 1u);
  const mpm::Scene& scene = study.scenes[0];
  EXPECT_EQ(scene.material.name, "aluminium");
  EXPECT_EQ(scene.material.yield_stress, 120e6);
  EXPECT_EQ(scene.impact_speed, 200);
  EXPECT_EQ(scene.block_width, 1e-5);
  EXPECT_EQ(scene.numerics.cell_size, 1e-7);
  EXPECT_EQ(scene.numerics.cfl, mpm::default_numerics(scene.kind).cfl);
  EXPECT_EQ(scene.measures.area_every, scene.end_time / 320);
  EXPECT_TRUE(study.swept.empty());
  EXPECT_THAT(study.given, ElementsAre("material", "impact_speed", "block_width", "block_height",
                                       "cavity_radius", "cavity_center_height", "end_time", "cell_size"));
}

TEST(ReadStudy, MaterialsAreAnAxis) {
  const Study study =
      read_text(study_text({{"material", "[\"copper\", \"tungsten\"]"}, {"yield_stress", "\"60 MPa\""}}));
  ASSERT_EQ(study.scenes.size(), 2u);
  EXPECT_THAT(study.swept, ElementsAre("material"));
  EXPECT_EQ(study.scenes[0].material.name, "copper");
  EXPECT_EQ(study.scenes[1].material.reference_density, 19300);
  for (const mpm::Scene& scene : study.scenes) EXPECT_EQ(scene.material.yield_stress, 60e6);  // the file's
}

TEST(ReadStudy, MaterialFirstThenItsChanges) {
  const Study study = read_text(
      study_text({{"yield_stress", "\"60 MPa\""}},
                 "[material]\nhardening_modulus = \"0 MPa\"\nspecific_heat = \"0.9 kJ/kg/K\"\n"
                 "initial_temperature = \"26.85 degC\"\ntension = \"cutoff\"\nspall_strength = \"1 GPa\"\n"));
  const mpm::Material& material = study.scenes[0].material;
  EXPECT_EQ(material.yield_stress, 60e6);
  EXPECT_EQ(material.hardening_modulus, 0);
  EXPECT_EQ(material.specific_heat, 900);
  EXPECT_DOUBLE_EQ(material.initial_temperature, 300);
  EXPECT_EQ(material.tension, mpm::Tension::cutoff);
  EXPECT_EQ(material.youngs_modulus, 69e9);
}

TEST(ReadStudy, WallThicknessPlacesTheCavity) {
  const Study study = read_text(study_text({{"cavity_center_height", ""}, {"wall_thickness", "\"1 um\""}}));
  EXPECT_DOUBLE_EQ(study.scenes[0].cavity_center_height, 3.5e-6);
}

TEST(ReadStudy, SnapshotsAreSortedAndUnique) {
  const Study study = read_text(study_text(
      {}, "[measure]\nsnapshots = [\"2 ns\", \"1 ns\", \"1000 ps\", \"16 ns\"]\narea_every = \"0.1 ns\"\n"));
  EXPECT_THAT(study.scenes[0].measures.snapshots, ElementsAre(1e-9, 2e-9, 16e-9));
  EXPECT_EQ(study.scenes[0].measures.area_every, 1e-10);
}

TEST(ReadStudy, FitsAndFigures) {
  const Study study = read_text(
      study_text({{"cavity_radius", "[\"1 um\", \"2 um\"]"}},
                 "[measure]\nsnapshots = [\"1 ns\"]\n"
                 "[[fit]]\nx = \"cavity_radius\"\ny = \"collapsibility\"\nmodel = \"quadratic\"\n"
                 "[[figure]]\nname = \"a\"\nkind = \"history\"\ntitle = \"A\"\n"
                 "[[figure]]\nname = \"b\"\nkind = \"xy\"\nx = \"cavity_radius\"\ny = \"final_area_m2\"\n"
                 "[[figure]]\nname = \"c\"\nkind = \"fields\"\ny = \"plastic_work\"\n"));
  ASSERT_EQ(study.fits.size(), 1u);
  EXPECT_EQ(study.fits[0].model, "quadratic");
  ASSERT_EQ(study.figures.size(), 3u);
  EXPECT_EQ(study.figures[0].title, "A");
  EXPECT_EQ(study.figures[1].x, "cavity_radius");
  EXPECT_EQ(study.figures[2].y, "plastic_work");
}

TEST(ReadStudy, Search) {
  const Study study = read_text(study_text({{"impact_speed", ""}},
                                           "[search]\ncritical = \"impact_speed\"\noutcome = \"ejected\"\n"
                                           "between = [\"200 m/s\", \"2 km/s\"]\ntolerance = \"10 m/s\"\n"));
  ASSERT_TRUE(study.search);
  EXPECT_EQ(study.search->critical, "impact_speed");
  EXPECT_EQ(study.search->lower, 200);
  EXPECT_EQ(study.search->upper, 2000);
  EXPECT_EQ(study.search->tolerance, 10);
  EXPECT_EQ(study.scenes.at(0).impact_speed, 200);
  EXPECT_FALSE(read_text(study_text()).search);
}

TEST(ReadStudy, SaysEverythingAtOnce) {
  const std::string text = problems_of(study_text({{"impact_speed", "\"200 kg\""},
                                                   {"block_width", "\"-1 um\""},
                                                   {"end_tim", "\"1 ns\""},
                                                   {"end_time", ""}}));
  EXPECT_THAT(text, HasSubstr(".toml:6:16: impact_speed = \"200 kg\""));
  EXPECT_THAT(text, HasSubstr("block_width = \"-1 um\": negative"));
  EXPECT_THAT(text, HasSubstr("did you mean end_time?"));
  EXPECT_THAT(text, HasSubstr("end_time: missing"));
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 3);
}

/// Every study of the repository is valid.
TEST(ReadStudy, RepositoryStudies) {
  int studies = 0;
  for (const char* folder : {"paper", "examples"})
    for (const auto& file :
         std::filesystem::directory_iterator(std::string(SOURCE_DIR "/studies/") + folder)) {
      if (file.path().extension() != ".toml") continue;
      const Study study = read_study(file.path());
      EXPECT_EQ(study.name, file.path().stem());
      EXPECT_FALSE(study.scenes.empty());
      ++studies;
    }
  EXPECT_GE(studies, 16);
}

}  // namespace
}  // namespace mpmstudy
