#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/runner/study/study_text.hpp"

namespace mpmstudy {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

Study with(std::string key, std::string value, const std::string& text = study_text()) {
  ReadOptions options;
  options.set.emplace_back(std::move(key), std::move(value));
  return read_text(text, options);
}

std::string wrong(std::string key, std::string value) {
  ReadOptions options;
  options.set.emplace_back(std::move(key), std::move(value));
  return problems_of(study_text(), options);
}

TEST(Overrides, ReplaceWhatTheFileSays) {
  EXPECT_EQ(with("impact_speed", "\"300 m/s\"").scenes[0].impact_speed, 300);
  EXPECT_EQ(with("impact_speed", "300 m/s").scenes[0].impact_speed, 300);  // quotes that the shell took
  EXPECT_EQ(with("cell_size", "0.2 um").scenes[0].numerics.cell_size, 0.2e-6);
  EXPECT_EQ(with("particles_per_cell", "9").scenes[0].numerics.particles_per_cell, 9);
  EXPECT_EQ(with("scheme", "bspline2").scenes[0].numerics.scheme, mpm::ShapeFunction::bspline2);
  EXPECT_EQ(with("name", "other").name, "other");
  EXPECT_EQ(with("title", "Another title").title, "Another title");
  EXPECT_EQ(with("name", "2026").name, "2026");  // a string even where the shell's text looks like a number
}

TEST(Overrides, AddWhatTheFileLeavesOut) {
  EXPECT_EQ(with("hardening_modulus", "0 MPa").scenes[0].material.hardening_modulus, 0);
  EXPECT_EQ(with("material.hardening_modulus", "0 MPa").scenes[0].material.hardening_modulus, 0);
  EXPECT_EQ(with("snapshots", "[\"1 ns\"]").scenes[0].measures.snapshots, std::vector<double>{1e-9});
}

/// Two tables have a tolerance: meant is the one that the file has.
TEST(Overrides, FindTheTableThatTheFileHas) {
  const std::string sampled = study_text({{"impact_speed", "{ from = 100, to = 400, unit = \"m/s\" }"}},
                                         "[sweep]\nmode = \"sobol\"\nsamples = 4\nseed = 1\n");
  const std::string surface = "[surface]\nof = \"collapsibility\"\ntolerance = \"2 %\"\nbudget = 9\n";
  for (const char* key : {"tolerance", "surface.tolerance"})
    EXPECT_EQ(with(key, "5 %", sampled + surface).surface->tolerance, 0.05) << key;
  const std::string search =
      "[search]\ncritical = \"yield_stress\"\noutcome = \"collapsed\"\nbetween = [\"10 MPa\", \"90 MPa\"]\n"
      "tolerance = \"1 MPa\"\n";
  EXPECT_EQ(with("tolerance", "5 MPa", study_text({}, search)).search->tolerance, 5e6);
}

TEST(Overrides, MaySweep) {
  EXPECT_EQ(with("cavity_radius", "[\"1 um\", \"2 um\"]").scenes.size(), 2u);
  EXPECT_EQ(with("impact_speed", "{ from = 100, to = 200, count = 5, unit = \"m/s\" }").scenes.size(), 5u);
}

// The reference step where the fast one lacks the scheme or the transfer, unless the study names a kernel.
TEST(Overrides, KernelFollowsTheScheme) {
  const auto kernel = [](const Study& study) { return study.scenes[0].numerics.kernel; };
  EXPECT_EQ(kernel(with("scheme", "bspline2")), mpm::Kernel::fast);
  EXPECT_EQ(kernel(with("scheme", "cpdi")), mpm::Kernel::reference);
  EXPECT_EQ(kernel(with("pic_fraction", "0.02")), mpm::Kernel::reference);
  ReadOptions named;
  named.set = {{"scheme", "bspline3"}, {"kernel", "fast"}};
  EXPECT_THAT(problems_of(study_text(), named), HasSubstr("allowed: \"reference\": the fast step has"));
}

TEST(Overrides, TakeThePlaceOfAnAlternative) {
  const Study study = with("wall_thickness", "1 um");
  EXPECT_DOUBLE_EQ(study.scenes[0].cavity_center_height, 3.5e-6);
}

TEST(Overrides, AFitMayLoseItsSweep) {
  const std::string text =
      study_text({{"cavity_radius", "[\"1 um\", \"2 um\"]"}},
                 "[[fit]]\nx = \"cavity_radius\"\ny = \"collapsibility\"\nmodel = \"linear\"\n");
  EXPECT_EQ(with("cavity_radius", "1 um", text).fits.size(), 1u);
}

TEST(Overrides, ErrorsNameThem) {
  EXPECT_THAT(wrong("impact_speed", "200 kg"), StartsWith("--set: impact_speed = \"200 kg\": 'kg' is not"));
  EXPECT_THAT(wrong("impact_sped", "1 m/s"), HasSubstr("did you mean impact_speed?"));
  EXPECT_THAT(wrong("numerics.impact_speed", "1 m/s"), HasSubstr("unknown key"));
  EXPECT_THAT(wrong("when", "rear > 1 m/s"), HasSubstr("is a key of [[stop]]"));
  EXPECT_THAT(wrong("figure.log", "x"), HasSubstr("is a key of [[figure]]"));
  EXPECT_THAT(wrong("cavity_radius", "[1, 2"), StartsWith("--set: cavity_radius = [1, 2: not TOML"));
  EXPECT_THAT(wrong("cell_size", "1 um\nscheme = \"gimp\""), StartsWith("--set: "));
}

}  // namespace
}  // namespace mpmstudy
