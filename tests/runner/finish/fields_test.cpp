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
  EXPECT_THAT(drawn.x, ElementsAre(2, 3));
  EXPECT_THAT(drawn.y, ElementsAre(5, 6));
  EXPECT_THAT(drawn.size, ElementsAre(2, 2));
  EXPECT_THAT(drawn.value, ElementsAre(11, 12));
}

}  // namespace
