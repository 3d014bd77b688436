// Scenes of bodies, as study files write them, and parameters of a study's own.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>

#include "libmpm/scene/build.hpp"
#include "libmpm/scene/parameters.hpp"
#include "runner/plan/composition_text.hpp"
#include "runner/plan/plan.hpp"
#include "runner/study/parameter_value.hpp"
#include "runner/study/study.hpp"
#include "tests/temporary_folder.hpp"

namespace mpmstudy {
namespace {

Study study_of(const std::string& text, const ReadOptions& options = {}) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "study.toml") << text;
  return read_study(folder.path() / "study.toml", options);
}

constexpr const char* two_bodies = R"(
schema = 1
name = "two"
scene = "bodies"
[parameters]
speed = ["300 m/s", "600 m/s"]
wall = "0.5 um"
radius = "block / 2 - wall"
block = "4 um"
end_time = "radius / 1000 m/s"
[materials.soft]
base = "copper"
yield_stress = "speed / 1 m/s * 1 MPa"
[box]
low = ["0 um", "0 um"]
high = ["block", "block"]
[faces]
left = "mirror"
bottom = "wall"
[[body]]
name = "ring"
material = "tungsten"
shape = { ring = { center = ["block / 2", "block / 2"], inner_radius = "radius / 2", outer_radius = "radius" } }
velocity = ["0 m/s", "-speed"]
[[body]]
name = "core"
material = "soft"
shape = { disc = { center = ["block / 2", "block / 2"], radius = "radius / 2" } }
[numerics]
cell_size = "0.1 um"
)";

TEST(Bodies, AreWhatTheirExpressionsComeTo) {
  const Study study = study_of(two_bodies);
  ASSERT_EQ(study.scenes.size(), 2u);
  EXPECT_THAT(study.swept, testing::ElementsAre("speed"));
  const mpm::Scene& s = study.scenes[1];
  ASSERT_EQ(s.composition.bodies.size(), 2u);
  EXPECT_EQ(s.composition.bodies[0].velocity, (mpm::Triple{0, -600, 0}));
  EXPECT_NEAR(s.composition.bodies[1].shape.numbers[3], 0.75e-6, 1e-18);
  EXPECT_NEAR(s.end_time, 1.5e-9, 1e-21);
  EXPECT_EQ(s.material.name, "tungsten");
  ASSERT_EQ(s.other_materials.size(), 1u);
  EXPECT_EQ(s.other_materials[0].yield_stress, 600e6);
  EXPECT_EQ(s.other_materials[0].reference_density, mpm::named_material("copper").reference_density);
  EXPECT_EQ(s.composition.face(mpm::Side::left), mpm::Face::mirror);
  EXPECT_EQ(s.composition.face(mpm::Side::right), mpm::Face::open);
  ASSERT_EQ(s.labels.size(), 4u);
  EXPECT_EQ(s.labels[0].name, "speed");
  EXPECT_EQ(s.labels[0].value, 600);
  EXPECT_EQ(s.labels[0].unit, "m/s");
  EXPECT_EQ(s.labels[2].name, "radius");
  EXPECT_NEAR(s.labels[2].value, 1.5e-6, 1e-18);
}

// The mass of a disc is exact though its rim cuts the cells.
TEST(Bodies, HaveTheirArea) {
  const mpm::Scene s = study_of(two_bodies).scenes[0];
  const mpm::State state = mpm::build_state(s);
  ASSERT_EQ(state.particles.body_ends.size(), 2u);
  double area[2] = {0, 0};
  for (std::size_t p = 0; p < state.particles.size(); ++p)
    area[p < state.particles.body_ends[0] ? 0 : 1] += state.particles.initial_volume[p];
  const double whole = M_PI * 1.5e-6 * 1.5e-6;
  EXPECT_NEAR(area[0] / (0.75 * whole), 1, 2e-3);
  EXPECT_NEAR(area[1] / (0.25 * whole), 1, 2e-3);
}

TEST(Bodies, AreTheSameJobInOtherWords) {
  std::string other = two_bodies;
  const auto replace = [&](const std::string& a, const std::string& b) {
    other.replace(other.find(a), a.size(), b);
  };
  replace("radius = \"block / 2 - wall\"", "radius = \"1.5 um\"");
  replace("wall = \"0.5 um\"\n", "");
  replace("[\"0 m/s\", \"-speed\"]", "[\"0 m/s\", \"-1 * speed\"]");
  EXPECT_EQ(job_key(study_of(other).scenes[0]), job_key(study_of(two_bodies).scenes[0]));
  replace("\"1.5 um\"", "\"1.6 um\"");
  EXPECT_NE(job_key(study_of(other).scenes[0]), job_key(study_of(two_bodies).scenes[0]));
}

// The catalog and the messages between processes keep a scene as this text.
TEST(Bodies, AreKeptAsText) {
  const mpm::Scene s = study_of(two_bodies).scenes[0];
  mpm::Scene other = s;
  other.composition = {};
  other.other_materials.clear();
  set_composition(other, composition_text(s));
  EXPECT_EQ(composition_text(other), composition_text(s));
  EXPECT_EQ(job_key(other), job_key(s));
  EXPECT_EQ(other.other_materials[0].name, "soft");
  EXPECT_THROW(set_composition(other, "{}"), std::invalid_argument);
}

std::string with_core(const std::string& more) {
  std::string text = two_bodies;
  const std::string shape = "radius = \"radius / 2\" } }\n";
  text.insert(text.find(shape) + shape.size(), more);
  return text;
}

// What a body has not is not in its key: keys of catalogs go on being found.
TEST(Bodies, MoveRadiallyAndBeginHot) {
  const mpm::Scene plain = study_of(two_bodies).scenes[0];
  EXPECT_THAT(composition_text(plain), testing::Not(testing::HasSubstr("radial")));
  EXPECT_THAT(composition_text(plain), testing::Not(testing::HasSubstr("energy")));
  const mpm::Scene s = study_of(with_core("radial_velocity = { speed = \"-speed\", at = \"radius\", exponent "
                                          "= 1, about = [\"block / 2\", \"block / 2\"] }\n"
                                          "pressure = \"1 GPa\"\n"))
                           .scenes[0];
  const mpm::ComposedBody& core = s.composition.bodies[1];
  EXPECT_EQ(core.radial, (mpm::RadialVelocity{-300, 1.5e-6, 1, {2e-6, 2e-6, 0}}));
  const mpm::Material& soft = s.other_materials[0];
  EXPECT_NEAR(core.energy * soft.gruneisen_gamma * soft.reference_density, 1e9, 1e-3);
  EXPECT_NE(job_key(s), job_key(plain));
  mpm::Scene other = s;
  other.composition = {};
  set_composition(other, composition_text(s));
  EXPECT_EQ(other.composition.bodies[1].radial, core.radial);
  EXPECT_EQ(other.composition.bodies[1].energy, core.energy);
  EXPECT_EQ(job_key(other), job_key(s));
  other.composition.bodies[1].radial.exponent = 2;
  EXPECT_NE(job_key(other), job_key(s));
  const mpm::Scene hot = study_of(with_core("specific_internal_energy = \"2 kJ/kg\"\n")).scenes[0];
  EXPECT_EQ(hot.composition.bodies[1].energy, 2000);
}

TEST(Bodies, SayInWhichPartsTheyDiffer) {
  const Study study = study_of(two_bodies);
  EXPECT_EQ(own_parts(study.scenes[0], study.scenes[0]), "none");
  EXPECT_EQ(own_parts(study.scenes[0], study.scenes[1]), "ring, material soft");
  mpm::Scene other = study.scenes[0];
  other.composition.high[0] *= 2;
  EXPECT_EQ(own_parts(study.scenes[0], other), "box");
}

TEST(Bodies, OfAChangedDensityAreWarnedOf) {
  std::string text = two_bodies;
  text.replace(text.find("yield_stress"), 0, "reference_density = \"8000 kg/m3\"\n");
  EXPECT_THAT(study_of(text).warnings,
              testing::Contains(testing::HasSubstr("soft has another reference_density than its base, whose "
                                                   "specific_heat it keeps")));
}

// A person reads the unit of the file; the catalog has SI.
TEST(OwnParameters, AreShownInTheUnitOfTheFile) {
  std::string text = two_bodies;
  text.replace(text.find("wall = "), 0, "angle = { values = [0, 30], unit = \"deg\" }\n");
  const std::string shape = "outer_radius = \"radius\" }";
  text.insert(text.find(shape) + shape.size(),
              ", rotate = { angle = \"angle\", about = [\"2 um\", \"2 um\"] }");
  text.replace(text.find("[\"300 m/s\", \"600 m/s\"]"), 22, "\"0.3 km/s\"");
  const Study study = study_of(text);
  ASSERT_EQ(study.scenes.size(), 2u);
  EXPECT_EQ(readable_parameter(study.scenes[1], "angle"), "30 deg");
  EXPECT_NEAR(*quantity_value(study.scenes[1], "angle"), 0.5235987755982988, 1e-15);
  EXPECT_EQ(readable_parameter(study.scenes[1], "speed"), "0.3 km/s");
  EXPECT_EQ(readable_parameter(study.scenes[1], "radius"), "1.5 um");  // of an expression
}

TEST(OwnParameters, PlaceGauges) {
  const Study study =
      study_of(std::string(two_bodies) +
               "[[gauge]]\nname = \"top\"\nof = \"velocity_y\"\nbeam = [\"block / 2\", \"block + "
               "1 um\"]\n");
  const mpm::Gauge& gauge = study.scenes[0].measures.gauges.at(0);
  EXPECT_NEAR(gauge.place[0], 2e-6, 1e-18);
  EXPECT_NEAR(gauge.place[1], 5e-6, 1e-18);
}

TEST(OwnParameters, AreSetOnTheCommandLine) {
  ReadOptions options;
  options.set = {{"speed", "100 m/s"}, {"block", "6 um"}};
  const Study study = study_of(two_bodies, options);
  ASSERT_EQ(study.scenes.size(), 1u);
  EXPECT_EQ(study.scenes[0].composition.bodies[0].velocity[1], -100);
  EXPECT_NEAR(study.scenes[0].end_time, 2.5e-9, 1e-21);
  options.set = {{"spede", "100 m/s"}};
  EXPECT_THROW(study_of(two_bodies, options), StudyError);
}

TEST(OwnParameters, ServeEveryKindOfScene) {
  const std::string text = R"(
schema = 1
name = "own"
scene = "cavity-impact"
[parameters]
material = "aluminium"
impact_speed = "200 m/s"
block_width = "10 um"
block_height = "cavity_radius + wall + 2 um"
wall = { values = [1, 2], unit = "um" }
cavity_radius = "1.5 um"
cavity_center_height = "block_height - wall - cavity_radius"
end_time = "1 ns"
[numerics]
cell_size = "0.2 um"
)";
  const Study study = study_of(text);
  ASSERT_EQ(study.scenes.size(), 2u);
  EXPECT_NEAR(study.scenes[1].block_height, 5.5e-6, 1e-18);
  EXPECT_NEAR(study.scenes[1].cavity_center_height, 2e-6, 1e-18);
  EXPECT_NEAR(mpm::find_quantity("wall_thickness")->get(study.scenes[1]), 2e-6, 1e-18);
  ASSERT_EQ(study.own.size(), 1u);
  EXPECT_EQ(study.own[0].name, "wall");
  EXPECT_EQ(study.own[0].unit, "m");
}

}  // namespace
}  // namespace mpmstudy
