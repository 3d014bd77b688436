// Kinds of scene and the table of parameters that is made of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <functional>
#include <string>
#include <vector>

#include "libmpm/core/enumerators.hpp"
#include "libmpm/scene/kinds/kind.hpp"
#include "tests/libmpm/scenes.hpp"

namespace {

/// Calls visit(name, member) for every member of a scene that a row of the table must stand for. A new member
/// does not compile here before it is named; and then it fails the test before it has a row.
template <class Visit>
void each_member(mpm::Scene& s, const Visit& visit) {
  auto& [kind, material, impact_speed, block_width, block_height, cavity_radius, cavity_center_height,
         inner_radius, outer_radius, inner_speed, end_time, space, numerics, measures] = s;
  auto& [name, reference_density, youngs_modulus, poissons_ratio, yield_stress, hardening_modulus,
         hardening_measure, kinematic_fraction, bulk_sound_speed, hugoniot_slope, gruneisen_gamma,
         specific_heat, initial_temperature, pressure_limit, tension, spall_strength] = material;
  auto& [cell_size, particles_per_cell, scheme, transfer, symmetry, kernel, precision, pic_fraction, cfl,
         linear_viscosity, quadratic_viscosity] = numerics;
  auto& [area_every, detached_for, decides, stop, snapshots] = measures;
  // kind and snapshots stand in a job's key by themselves; the name of a material is no part of what it is
  static_cast<void>(kind), static_cast<void>(name), static_cast<void>(snapshots);
#define MEMBER(m) visit(#m, m)
  MEMBER(impact_speed), MEMBER(block_width), MEMBER(block_height), MEMBER(cavity_radius);
  MEMBER(cavity_center_height), MEMBER(inner_radius), MEMBER(outer_radius), MEMBER(inner_speed);
  MEMBER(end_time), MEMBER(space);
  MEMBER(reference_density), MEMBER(youngs_modulus), MEMBER(poissons_ratio), MEMBER(yield_stress);
  MEMBER(hardening_modulus), MEMBER(hardening_measure), MEMBER(kinematic_fraction);
  MEMBER(bulk_sound_speed), MEMBER(hugoniot_slope), MEMBER(gruneisen_gamma), MEMBER(specific_heat);
  MEMBER(initial_temperature), MEMBER(pressure_limit), MEMBER(tension), MEMBER(spall_strength);
  MEMBER(cell_size), MEMBER(particles_per_cell), MEMBER(scheme), MEMBER(transfer), MEMBER(symmetry);
  MEMBER(kernel), MEMBER(precision), MEMBER(pic_fraction), MEMBER(cfl), MEMBER(linear_viscosity);
  MEMBER(quadratic_viscosity), MEMBER(area_every), MEMBER(detached_for), MEMBER(decides), MEMBER(stop);
#undef MEMBER
}

/// What all rows that are not made of others say.
std::vector<double> said(const mpm::Scene& s) {
  std::vector<double> values;
  for (const mpm::Quantity& q : mpm::quantities())
    if (!q.derived) values.push_back(q.get(s));
  for (const mpm::Choice& c : mpm::choices()) values.push_back(static_cast<double>(c.get(s)));
  return values;
}

TEST(Parameters, EveryMemberOfASceneHasARow) {
  mpm::Scene scene = scenes::cavity(0.2e-6);
  const auto before = said(scene);
  std::size_t members = 0;
  each_member(scene, [&](const char* name, auto& member) {
    const auto old = member;
    member = static_cast<std::decay_t<decltype(member)>>(static_cast<int>(old) + 1);
    EXPECT_NE(said(scene), before) << name << " stands in no row: neither keys nor the catalog know it";
    member = old;
    ++members;
  });
  EXPECT_EQ(said(scene), before);
  EXPECT_EQ(members, before.size());
}

TEST(Parameters, RowsAreThoseOfTheirKinds) {
  using enum mpm::SceneKind;
  const auto has = [](const char* name, mpm::SceneKind kind) {
    return mpm::find_quantity(name)->belongs_to(kind);
  };
  EXPECT_TRUE(has("impact_speed", cavity_impact) && has("impact_speed", planar_impact) &&
              has("impact_speed", two_body_impact) && !has("impact_speed", imploding_shell));
  EXPECT_TRUE(has("cavity_radius", two_body_impact) && !has("cavity_radius", planar_impact));
  EXPECT_TRUE(has("inner_speed", imploding_shell) && !has("inner_speed", cavity_impact));
  for (const mpm::Kind* kind : mpm::kinds()) EXPECT_TRUE(has("cell_size", kind->kind)) << kind->name;
  EXPECT_FALSE(mpm::find_choice("stop")->belongs_to(planar_impact));
}

TEST(Kinds, AreInTheOrderOfTheirEnumAndFindTheirNames) {
  ASSERT_EQ(mpm::kinds().size(), mpm::enumerators<mpm::SceneKind>());
  for (std::size_t i = 0; i < mpm::kinds().size(); ++i) {
    const mpm::Kind& kind = *mpm::kinds()[i];
    EXPECT_EQ(kind.kind, static_cast<mpm::SceneKind>(i));
    EXPECT_EQ(mpm::scene_kind_from(kind.name), kind.kind);
    EXPECT_EQ(mpm::to_string(kind.kind), kind.name);
    EXPECT_EQ(mpm::scene_kind_names()[i], kind.name);
  }
}

// What is added last has no word, and would be told as nothing.
TEST(Enumerators, AreCounted) {
  EXPECT_EQ(mpm::enumerators<mpm::Tension>(), 3u);
  EXPECT_EQ(mpm::enumerators<mpm::ShapeFunction>(), 4u);
  EXPECT_EQ(mpm::enumerators<mpm::Kernel>(), 2u);
}

}  // namespace
