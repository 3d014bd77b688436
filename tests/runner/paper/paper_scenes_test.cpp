// Claims of the paper are judged on its scenes only: a file that bears the name of one and says something
// else is told apart, and every study of the project is known.
#include "runner/paper/paper_scenes.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runner/paper/claims.hpp"

namespace mpmstudy {
namespace {

using testing::HasSubstr;

Study read(const std::string& name, std::vector<std::pair<std::string, std::string>> set = {}) {
  ReadOptions options;
  options.set = std::move(set);
  return read_study(std::string(SOURCE_DIR) + "/studies/paper/" + name + ".toml", options);
}

TEST(PaperScenes, TheStudiesOfTheProjectAreThePapers) {
  for (const std::string& name : studies_of_claims()) EXPECT_EQ(unlike_the_paper(read(name)), "") << name;
}

TEST(PaperScenes, EveryStudyThatClaimsRestOnIsKnown) {
  for (const std::string& name : studies_of_claims())
    EXPECT_THAT(unlike_the_paper(read(name, {{"specific_heat", "900 J/kg/K"}})),
                HasSubstr("specific_heat = 900 J/kg/K in place of 880 J/kg/K"))
        << name;
}

TEST(PaperScenes, WhatIsOfAnotherSpeedOrMaterialIsSaid) {
  EXPECT_THAT(unlike_the_paper(read("weak-collapse", {{"impact_speed", "150 m/s"}})),
              HasSubstr("impact_speed = 150 m/s in place of 200 m/s"));
  EXPECT_THAT(unlike_the_paper(read("planar-impact", {{"reference_density", "8930 kg/m3"}})),
              HasSubstr("reference_density"));
  EXPECT_THAT(unlike_the_paper(read("collapsibility-yield", {{"yield_stress", "[\"60 MPa\", \"61 MPa\"]"}})),
              HasSubstr("yield_stress"));
}

TEST(PaperScenes, NumericsAndOtherNamesAreFree) {
  EXPECT_EQ(unlike_the_paper(read("weak-collapse", {{"cell_size", "0.3 um"}, {"precision", "double"}})), "");
  EXPECT_EQ(unlike_the_paper(read("weak-collapse", {{"impact_speed", "150 m/s"}, {"name", "weak-150"}})), "");
}

}  // namespace
}  // namespace mpmstudy
