// Which parameters have an effect: what effect.hpp calls inert changes no bit of any result, and everything
// else does.
#include "libmpm/scene/effect.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <sstream>

#include "libmpm/scene/parameters.hpp"
#include "libmpm/simulation.hpp"

namespace mpm {
namespace {

/// A coarse, strong impact: shock, plastic flow, tension and pressures beyond a low limit within 1 ns.
Scene small_scene() {
  Scene s;
  s.kind = SceneKind::cavity_impact;
  s.material = named_material("aluminium");
  s.material.pressure_limit = 5.5e9;  // nine tenths of it are passed, and that ends a run
  s.impact_speed = 300;
  s.block_width = 8e-6, s.block_height = 4e-6;
  s.cavity_radius = 1e-6, s.cavity_center_height = 2e-6;
  s.end_time = 1e-9;
  s.numerics = default_numerics(s.kind);
  s.numerics.cell_size = 0.5e-6;
  s.measures.area_every = 0.25e-9;
  s.measures.detached_for = default_detached_for(s);
  s.measures.snapshots = {0.9e-9};
  return s;
}

/// Fields of the snapshots and every number of the result, bit by bit.
std::string everything_of(const Scene& scene) {
  struct Fields : Observer {
    std::ostringstream text;
    void on_snapshot(const Snapshot& s) override {
      for (const auto* column :
           {&s.x, &s.y, &s.velocity_x, &s.velocity_y, &s.pressure, &s.stress_xx, &s.stress_xy,
            &s.specific_internal_energy, &s.temperature, &s.equivalent_plastic_strain})
        for (const double value : *column) text << value << ' ';
    }
  } fields;
  fields.text << std::hexfloat;
  const RunResult r = run(scene, fields);
  fields.text << static_cast<int>(r.status) << ' ' << r.outcome << ' ' << r.particles << ' ' << r.steps
              << '\n';
  for (const AreaSample& a : r.area_history)
    fields.text << a.time << ' ' << a.area << ' ' << a.void_area << '\n';
  for (const Metric& m : r.metrics) fields.text << m.name << ' ' << m.value << '\n';
  return fields.text.str();
}

void set(Scene& scene, std::string_view name, double value) {
  if (const Quantity* row = find_quantity(name))
    row->set(scene, value);
  else
    find_choice(name)->set(scene, static_cast<std::size_t>(value));
}

TEST(Effect, WhatIsInertChangesNoBit) {
  const double infinite = std::numeric_limits<double>::infinity();
  const struct {
    const char* name;
    double yield_stress, hardening_modulus, value;
  } cases[] = {
      {"spall_strength", 120e6, 384e6, 1e6}, {"hardening_modulus", infinite, 384e6, 1e9},
      {"hardening_measure", 120e6, 0, 2},    {"hardening_measure", infinite, 384e6, 1},
      {"kinematic_fraction", 120e6, 0, 0.5}, {"kinematic_fraction", infinite, 384e6, 0.5},
      {"detached_for", 120e6, 384e6, 1e-10}, {"stop", 120e6, 384e6, 1},
  };
  for (const Kernel kernel : {Kernel::fast, Kernel::reference})
    for (const auto& one : cases) {
      Scene scene = small_scene();
      scene.numerics.kernel = kernel;
      scene.material.yield_stress = one.yield_stress;
      scene.material.hardening_modulus = one.hardening_modulus;
      const Condition* condition = condition_of(one.name);
      ASSERT_TRUE(condition) << one.name;
      ASSERT_FALSE(condition->holds(scene)) << one.name;
      Scene changed = scene;
      set(scene, one.name, condition->inert(scene));
      set(changed, one.name, one.value);
      ASSERT_EQ(find_problems(changed).size(), 0u) << one.name;
      EXPECT_TRUE(everything_of(scene) == everything_of(changed)) << one.name;
    }
}

/// Scenes that have every constant of some model between them.
std::vector<Scene> scenes_of_models() {
  std::vector<Scene> all{small_scene()};
  for (const char* name : {"copper-johnson-cook", "water", "copper-steinberg-guinan", "water-tait"}) {
    all.push_back(small_scene());
    all.back().material = named_material(name);
    Scene& scene = all.back();
    if (scene.material.strength ==
        StrengthModel::steinberg_guinan)  // so fast that it hardens to the end and melts
      scene.impact_speed = 1000, scene.material.melting_temperature = 450,
      scene.material.yield_limit = 1.2 * scene.material.yield_stress;
  }
  return all;
}

TEST(Effect, EverythingElseChangesSomething) {
  const std::vector<Scene> all = scenes_of_models();
  for (const Scene& scene : all) {
    const RunResult plain = run(scene);
    ASSERT_EQ(plain.status, RunStatus::done) << plain.reason;
    const std::string before = everything_of(scene);
    for (const Quantity& row : quantities()) {
      const Condition* condition = condition_of(row.name);
      if (row.derived || !row.belongs_to(scene.kind) || (condition && !condition->holds(scene))) continue;
      const bool was_seen = &scene != &all.front() && (!condition || condition->holds(all.front()));
      if (was_seen) continue;
      Scene changed = scene;
      const double value = row.get(scene);
      if (row.name == "particles_per_cell")
        row.set(changed, 9);
      else
        row.set(changed, std::isinf(value) ? 1e-3 : value == 0 ? 0.1 : 0.9 * value);
      if (!fast_step_has(changed)) changed.numerics.kernel = Kernel::reference;
      ASSERT_EQ(find_problems(changed).size(), 0u) << row.name;
      EXPECT_TRUE(everything_of(changed) != before) << scene.material.name << " " << row.name;
    }
    if (&scene != &all.front()) continue;
    for (const Choice& row : choices()) {
      const Condition* condition = condition_of(row.name);
      if (!row.belongs_to(scene.kind) || (condition && !condition->holds(scene))) continue;
      Scene changed = scene;
      std::string unchanged = before;
      if (row.name == "wall_gap") {  // a block that leaves the wall and is held back by its cavity
        changed.impact_speed = 200;
        changed.block_height = 5e-6, changed.cavity_center_height = 1.9e-6, changed.cavity_radius = 1.5e-6;
        changed.end_time = 4e-9;
        unchanged = everything_of(changed);
      }
      row.set(changed, 1 - std::min<std::size_t>(row.get(scene), 1));
      if (!fast_step_has(changed)) changed.numerics.kernel = Kernel::reference;
      if (!find_problems(changed).empty()) continue;  // not every strength goes with every equation of state
      EXPECT_TRUE(everything_of(changed) != unchanged) << scene.material.name << " " << row.name;
    }
  }
}

TEST(Effect, NamesRowsOfTheTable) {
  for (const Condition& condition : conditions())
    EXPECT_TRUE(find_quantity(condition.parameter) || find_choice(condition.parameter))
        << condition.parameter;
}

}  // namespace
}  // namespace mpm
