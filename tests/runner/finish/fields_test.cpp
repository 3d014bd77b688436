// What a figure of fields draws of a snapshot.
#include "runner/finish/fields.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <stdexcept>

namespace {

using testing::ElementsAre;

/// Three particles of edge 2 along z.
mpm::Snapshot particles(bool with_depth) {
  mpm::Snapshot s;
  s.x = {1, 2, 3}, s.y = {4, 5, 6};
  s.density = {2, 2, 2};
  s.mass = with_depth ? std::vector<double>{16, 16, 16} : std::vector<double>{8, 8, 8};
  s.pressure = {7, 8, 9};
  if (with_depth) s.z = {3, 1, -1.5}, s.velocity_z = {10, 11, 12};
  return s;
}

TEST(FieldFigures, ShowAllParticlesOfTwoAxes) {
  const auto drawn = mpmstudy::particles_of(particles(false), "pressure");
  EXPECT_THAT(drawn.x, ElementsAre(1, 2, 3));
  EXPECT_THAT(drawn.size, ElementsAre(2, 2, 2));
  EXPECT_THAT(drawn.value, ElementsAre(7, 8, 9));
  EXPECT_THROW(mpmstudy::particles_of(particles(false), "velocity_z"), std::runtime_error);
}

TEST(FieldFigures, ShowTheSectionOfThreeAxes) {
  const auto drawn = mpmstudy::particles_of(particles(true), "velocity_z");
  EXPECT_THAT(drawn.x, ElementsAre(1, 2, 3));
  EXPECT_THAT(drawn.y, ElementsAre(4, 5, 6));
  EXPECT_THAT(drawn.size, ElementsAre(2, 2, 2));
  EXPECT_THAT(drawn.value, ElementsAre(10, 11, 12));
  EXPECT_THAT(drawn.depth, ElementsAre(3, 1, 1.5));
}

TEST(FieldFigures, ShowASliceAnywhere) {
  const auto at_z = mpmstudy::particles_of(particles(true), "velocity_z", {}, {.axis = 2, .at = 6});
  EXPECT_THAT(at_z.value, ElementsAre(10));
  const auto at_x = mpmstudy::particles_of(particles(true), "velocity_z", {}, {.axis = 0, .at = 6});
  EXPECT_THAT(at_x.x, ElementsAre(-1.5));  // z, y
  EXPECT_THAT(at_x.y, ElementsAre(6));
  const auto at_y = mpmstudy::particles_of(particles(true), "velocity_z", {}, {.axis = 1, .at = 1});
  EXPECT_THAT(at_y.x, ElementsAre(1));  // x, z
  EXPECT_THAT(at_y.y, ElementsAre(3));
  EXPECT_THAT(at_y.depth, ElementsAre(3));
}

TEST(FieldFigures, ShowWhatIsSeenAlongAnAxis) {
  using mpmstudy::FieldView;
  mpm::Snapshot s = particles(true);
  s.x = {1, 1.5, 3}, s.y = {4.5, 5.5, 5};  // two of them in one column along z
  s.mass = {16, 48, 16}, s.density = {2, 6, 2};
  const auto largest = mpmstudy::particles_of(s, "velocity_z", {}, {.of = FieldView::Of::largest, .axis = 2});
  EXPECT_THAT(largest.x, ElementsAre(1, 3));
  EXPECT_THAT(largest.y, ElementsAre(5, 5));
  EXPECT_THAT(largest.size, ElementsAre(2, 2));
  EXPECT_THAT(largest.value, ElementsAre(11, 12));
  const auto mean = mpmstudy::particles_of(s, "velocity_z", {}, {.of = FieldView::Of::mean, .axis = 2});
  EXPECT_THAT(mean.value, ElementsAre(10.5, 12));  // by volume
}

TEST(FieldFigures, SayTheirViewAndAreMirroredWhereItsAxisIs) {
  using mpmstudy::FieldView;
  mpm::Scene scene;
  scene.kind = mpm::SceneKind::bodies, scene.space = mpm::Space::three_d;
  scene.composition.low = {0, 0, -1};
  scene.composition.faces[static_cast<std::size_t>(mpm::Side::left)] = mpm::Face::mirror;
  mpmstudy::FigureRequest request;
  request.title = "Pressure";
  auto picture = picture_of(request, scene, "200 m/s");
  EXPECT_EQ(picture.title, "Pressure, 200 m/s");
  EXPECT_TRUE(picture.mirrored);
  request.view = {.axis = 0, .at = 1e-6};
  picture = picture_of(request, scene);
  EXPECT_THAT(picture.title, testing::StartsWith("Pressure, x = 1"));
  EXPECT_EQ(picture.across + picture.up, "zy");
  EXPECT_FALSE(picture.mirrored);  // z = 0 is no mirror
  scene.composition.low = {-1, 0, 0};
  scene.composition.faces[static_cast<std::size_t>(mpm::Side::front)] = mpm::Face::mirror;
  EXPECT_TRUE(picture_of(request, scene).mirrored);
  request.title = "", request.view = {.of = FieldView::Of::mean, .axis = 1};
  picture = picture_of(request, scene);
  EXPECT_EQ(picture.title, "mean along y");
  EXPECT_EQ(picture.across + picture.up, "xz");
  EXPECT_FALSE(picture.mirrored);
}

}  // namespace
