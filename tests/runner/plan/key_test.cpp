#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

#include "libmpm/scene/effect.hpp"
#include "libmpm/scene/parameters.hpp"
#include "runner/plan/plan.hpp"
#include "tests/runner/study/study_text.hpp"

namespace mpmstudy {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string key_of(const std::string& text) { return job_key(read_text(text).scenes.at(0)); }

/// A scene whose numbers depend on no default, in which every parameter has an effect.
mpm::Scene fixed_scene(mpm::SceneKind kind = mpm::SceneKind::cavity_impact) {
  mpm::Scene scene;
  scene.kind = kind;
  double value = 1;
  for (const mpm::Quantity& row : mpm::quantities())  // a row with an implied value came later
    if (!row.derived && !row.implied) row.set(scene, value++);
  for (const mpm::Choice& row : mpm::choices()) row.set(scene, 0);
  scene.material.tension = mpm::Tension::cutoff;
  scene.measures.decides = mpm::Decides::ejection;
  scene.measures.snapshots = {1, 2};
  return scene;
}

/// Changes only when results change: a new parameter or a new physics version. Results of older catalogs are
/// then computed anew; be sure that this is meant.
TEST(JobKey, Golden) {
  mpm::Scene scene = fixed_scene();
  scene.material.tension = mpm::Tension::polynomial;
  scene.measures.decides = mpm::Decides::collapse;
  EXPECT_EQ(former_key(scene), "1b63c0b8931349fe9b0af1b1f89e64e0") << scene_text(scene);
  EXPECT_NE(job_key(scene), former_key(scene));
  scene.material.spall_strength = 0;
  scene.measures.detached_for = scene.end_time / 16;
  EXPECT_EQ(job_key(scene), former_key(scene));
}

/// No key of a study that names nothing without an effect has changed.
TEST(JobKey, IsTheFormerOneWhereEveryValueHasAnEffect) {
  EXPECT_EQ(former_key(fixed_scene()), job_key(fixed_scene()));
  for (const char* rest :
       {"", "[measure]\ndecides = \"ejection\"\nstop = \"decided\"\ndetached_for = \"2 ns\"\n",
        "[material]\ntension = \"cutoff\"\nspall_strength = \"1 GPa\"\n",
        "[material]\nkinematic_fraction = 0.5\nhardening_measure = \"tangent\"\n"}) {
    const mpm::Scene scene = read_text(study_text({}, rest)).scenes.at(0);
    EXPECT_EQ(former_key(scene), job_key(scene)) << rest;
  }
}

TEST(JobKey, LeavesOutWhatHasNoEffect) {
  const std::string key = key_of(study_text());
  for (const char* rest : {"[material]\nspall_strength = \"1 GPa\"\n",
                           "[material]\nstrain_hardening = \"1 GPa\"\nadiabatic_index = 3\n",
                           "[measure]\nstop = \"decided\"\ndetached_for = \"2 ns\"\n"}) {
    EXPECT_EQ(key_of(study_text({}, rest)), key) << rest;
    EXPECT_NE(former_key(read_text(study_text({}, rest)).scenes.at(0)), key) << rest;
  }
  EXPECT_EQ(key_of(study_text({}, "[material]\nhardening_modulus = \"0 Pa\"\nkinematic_fraction = 0.5\n")),
            key_of(study_text({}, "[material]\nhardening_modulus = \"0 Pa\"\n")));
}

/// Physics version 6 changed the bits of the plain step alone: jobs of the fast one keep their keys.
TEST(JobKey, EachKernelHasAPhysicsVersion) {
  mpm::Scene scene = fixed_scene();
  EXPECT_THAT(canonical_text(scene), testing::StartsWith("physics_version=5\n"));
  scene.numerics.kernel = mpm::Kernel::reference;
  EXPECT_THAT(canonical_text(scene), testing::StartsWith("physics_version=6\n"));
}

TEST(JobKey, Is32HexadecimalDigits) {
  const std::string key = job_key(fixed_scene());
  EXPECT_EQ(key.size(), 32u);
  EXPECT_EQ(key.find_first_not_of("0123456789abcdef"), std::string::npos);
}

TEST(JobKey, DoesNotDependOnSpelling) {
  const std::string key = key_of(study_text());
  EXPECT_EQ(key_of(study_text({{"block_width", "\"0.01 mm\""},
                               {"block_height", "\"6e-6 m\""},
                               {"impact_speed", "\"0.2 km/s\""},
                               {"end_time", "\"0.016 us\""},
                               {"cavity_radius", "{ values = [1500], unit = \"nm\" }"}})),
            key);
  EXPECT_EQ(key_of(study_text({}, "[material]\nyoungs_modulus = \"69000 MPa\"\n")), key);  // said or default
  std::string renamed = study_text();
  renamed.replace(renamed.find("\"test\""), 6, "\"another\"\ntitle = \"Another\"");
  EXPECT_EQ(key_of(renamed), key);
}

TEST(JobKey, DependsOnEveryQuantityAndChoice) {
  for (const std::string_view name : mpm::scene_kind_names()) {
    const mpm::Scene scene = fixed_scene(*mpm::scene_kind_from(name));
    std::set<std::string> keys = {job_key(scene)};
    std::size_t changes = 1;
    for (const mpm::Quantity& row : mpm::quantities()) {
      mpm::Scene changed = scene;
      row.set(changed, std::isinf(row.get(scene)) ? 1 : row.get(scene) + 1);
      if (row.derived) continue;
      const mpm::Condition* condition = mpm::condition_of(row.name);
      if (row.belongs_to(scene.kind) && (!condition || condition->holds(scene))) {
        EXPECT_TRUE(keys.insert(job_key(changed)).second) << row.name;
        ++changes;
      } else {
        EXPECT_EQ(job_key(changed), job_key(scene)) << row.name;
      }
    }
    for (const mpm::Choice& row : mpm::choices()) {
      // a material may take away what a choice acts on; a scene that has no wall has no gap
      const mpm::Condition* condition = row.name == "wall_gap" ? mpm::condition_of(row.name) : nullptr;
      const bool counts = row.belongs_to(scene.kind) && (!condition || condition->holds(scene));
      for (std::size_t i = 0; i < row.allowed.size(); ++i) {
        if (i == row.get(scene)) continue;
        mpm::Scene changed = scene;
        row.set(changed, i);
        EXPECT_EQ(keys.insert(job_key(changed)).second, counts) << row.name;
        changes += counts;
      }
    }
    mpm::Scene changed = scene;
    changed.measures.snapshots.pop_back();
    EXPECT_TRUE(keys.insert(job_key(changed)).second);
    EXPECT_EQ(keys.size(), changes + 1);
  }
  EXPECT_NE(job_key(fixed_scene(mpm::SceneKind::cavity_impact)),
            job_key(fixed_scene(mpm::SceneKind::planar_impact)));
}

TEST(JobKey, LastBitCounts) {
  mpm::Scene scene = fixed_scene(), other = scene;
  other.end_time = std::nextafter(other.end_time, 1e9);
  EXPECT_NE(job_key(scene), job_key(other));
}

// A row that is added leaves the keys of what was computed before it alone, and new values have keys of their
// own.
TEST(CanonicalText, LeavesOutWhatARowImplies) {
  mpm::Scene scene = fixed_scene();
  scene.numerics.pic_fraction = 0;
  std::vector<mpm::Quantity> rows(mpm::quantities().begin(), mpm::quantities().end());
  std::vector<mpm::Quantity> before;
  for (mpm::Quantity& row : rows)
    if (row.name == "pic_fraction")
      row.implied = 0;
    else
      before.push_back(row);
  EXPECT_EQ(canonical_text(scene, rows), canonical_text(scene, before));
  scene.numerics.pic_fraction = 0.5;
  EXPECT_NE(canonical_text(scene, rows), canonical_text(scene, before));
  EXPECT_EQ(canonical_text(scene, rows), canonical_text(scene));
}

TEST(CanonicalText, LeavesOutWhatIsDerived) {
  EXPECT_THAT(canonical_text(fixed_scene()), HasSubstr("\ncavity_center_height="));
  EXPECT_THAT(canonical_text(fixed_scene()), Not(HasSubstr("wall_thickness")));
}

}  // namespace
}  // namespace mpmstudy
