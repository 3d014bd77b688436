// Kinds of scene and the table of parameters that is made of them.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <regex>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "libmpm/core/enumerators.hpp"
#include "libmpm/measure/results.hpp"
#include "libmpm/scene/kinds/kind.hpp"
#include "tests/libmpm/scenes.hpp"

namespace {

/// Visits the members of one object under their names, but for those that hold others and those without a
/// row: the kind, the times of snapshots and the gauges stand in a job's key by themselves, and the name of a
/// material is no part of what it is.
template <class Visit, class... Members>
void visit_all(const Visit& visit, std::string_view names, Members&... members) {
  const auto one = [&](auto& member) {
    const std::size_t end = names.find(',');
    const std::string name(names.substr(0, end));
    names.remove_prefix(end == names.npos ? names.size() : end + 2);
    using Member = std::decay_t<decltype(member)>;
    constexpr bool is_number = std::is_arithmetic_v<Member> || std::is_enum_v<Member>;
    if constexpr (is_number && !std::is_same_v<Member, mpm::SceneKind>) visit(name, member);
  };
  (one(members), ...);
}
#define VISIT(object, ...)                       \
  {                                              \
    auto& [__VA_ARGS__] = object;                \
    visit_all(visit, #__VA_ARGS__, __VA_ARGS__); \
  }

/// Calls visit(name, member) for every member of a scene that a row of the table must stand for. A new member
/// does not compile here before it is named; and then it fails the test before it has a row.
template <class Visit>
void each_member(mpm::Scene& s, const Visit& visit) {
  VISIT(s, kind, material, other_materials, impact_speed, block_width, block_height, cavity_radius,
        cavity_center_height, inner_radius, outer_radius, inner_speed, end_time, space, composition, numerics,
        measures, labels)
  VISIT(s.material, name, law, eos, strength, reference_density, youngs_modulus, poissons_ratio, yield_stress,
        hardening_modulus, hardening_measure, kinematic_fraction, bulk_sound_speed, hugoniot_slope,
        gruneisen_gamma, specific_heat, initial_temperature, pressure_limit, tension, spall_strength,
        failure_strain, adiabatic_index, stiffening_pressure, strain_hardening, hardening_exponent,
        rate_hardening, reference_strain_rate, softening_exponent, melting_temperature, tait_pressure,
        tait_exponent, strain_factor, yield_limit, shear_per_pressure, shear_per_temperature,
        melting_gamma_fall)
  VISIT(s.numerics, cell_size, particles_per_cell, scheme, transfer, symmetry, kernel, precision, wall_gap,
        pic_fraction, cfl, linear_viscosity, quadratic_viscosity)
  VISIT(s.measures, area_every, detached_for, decides, stop, snapshots, gauges)
}
#undef VISIT

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
  each_member(scene, [&](const std::string& name, auto& member) {
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

TEST(Kinds, AreEachWhole) {
  for (const mpm::Kind* kind : mpm::kinds()) {
    const mpm::ResultRow* headline = mpm::find_result(kind->headline);
    ASSERT_TRUE(headline) << kind->name;
    EXPECT_TRUE(headline->belongs_to(kind->kind) && headline->has_interval) << kind->name;
    for (const auto function :
         {kind->of_two_axes.size != nullptr, kind->of_two_axes.is_there(),
          kind->of_two_axes.lattice != nullptr, kind->of_two_axes.measurements != nullptr,
          kind->of_three_axes.size != nullptr, kind->of_three_axes.is_there(),
          kind->of_three_axes.lattice != nullptr, kind->of_three_axes.measurements != nullptr,
          kind->check != nullptr, kind->coarsest_cell != nullptr, kind->extent != nullptr,
          kind->fastest != nullptr, kind->floor != nullptr, kind->parts != nullptr,
          kind->set_default_numerics != nullptr})
      EXPECT_TRUE(function) << kind->name;
  }
}

/// A new kind is one file and one line of the list: what is special about it is asked of its Kind. A scene is
/// made of some kind elsewhere, and rows are asked whether they belong to it.
TEST(Kinds, NothingElseAsksASceneForItsKind) {
  namespace fs = std::filesystem;
  const std::regex makes(R"((kind = |default_numerics\()(mpm::)?SceneKind::\w+)");
  const std::regex asks(R"(SceneKind::\w|using enum [\w:]*SceneKind|switch \([^)]*kind\)|)"
                        R"(to_string\([^)]*kind\) [=!]=|)"
                        R"(\bhas_cavity\b)");
  for (const char* folder : {"libmpm", "runner", "analysis"})
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(SOURCE_DIR) / folder)) {
      const std::string path = entry.path().string();
      if (!(path.ends_with(".cpp") || path.ends_with(".hpp")) || path.find("/scene/kinds/") != path.npos)
        continue;
      std::ifstream file(path);
      int number = 0;
      for (std::string line; std::getline(file, line);) {
        ++number;
        EXPECT_FALSE(std::regex_search(std::regex_replace(line, makes, ""), asks))
            << path << ":" << number << ": " << line
            << "\nmake it a member of Kind (libmpm/scene/kinds/kind.hpp)";
      }
    }
}

// What is added last has no word, and would be told as nothing.
TEST(Enumerators, AreCounted) {
  EXPECT_EQ(mpm::enumerators<mpm::Tension>(), 3u);
  EXPECT_EQ(mpm::enumerators<mpm::ShapeFunction>(), 5u);
  EXPECT_EQ(mpm::enumerators<mpm::Kernel>(), 2u);
}

}  // namespace
