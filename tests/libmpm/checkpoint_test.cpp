// A run that goes on from a checkpoint ends with the bits of one that was never disturbed: for every scene,
// stepper and physics, wherever it was cut, through a file.
#include "libmpm/io/checkpoint.hpp"

#include <gmock/gmock.h>

#include <bit>
#include <filesystem>
#include <functional>

#include "tests/libmpm/scenes.hpp"

namespace {

/// Every number of a result, bit for bit, and what it says.
std::vector<std::uint64_t> bits_of(const mpm::RunResult& r) {
  std::vector<std::uint64_t> bits;
  const auto add = [&](double v) { bits.push_back(std::bit_cast<std::uint64_t>(v)); };
  for (const auto& v :
       {r.initial_area, r.final_area, r.final_area_error, r.collapsibility, r.collapsibility_error})
    add(v.value_or(-1));
  add(static_cast<double>(r.steps)), add(static_cast<double>(r.particles)), add(r.energy_error);
  for (const auto& a : r.area_history) add(a.time), add(a.area), add(a.void_area);
  for (const auto& h : r.histories)
    for (std::size_t k = 0; k < h.times.size(); ++k) add(h.times[k]), add(h.values[k]);
  for (const auto& m : r.metrics) add(m.value), add(m.error.value_or(-1));
  for (const char c : r.outcome + r.reason) bits.push_back(static_cast<unsigned char>(c));
  return bits;
}

std::vector<std::uint64_t> bits_of(const std::vector<mpm::Snapshot>& snapshots) {
  std::vector<std::uint64_t> bits;
  for (const auto& s : snapshots)
    for (const auto* column :
         {&s.x, &s.z, &s.velocity_y, &s.stress_yz, &s.density, &s.pressure, &s.stress_xy, &s.temperature})
      for (const double v : *column) bits.push_back(std::bit_cast<std::uint64_t>(v));
  return bits;
}

struct Watcher : mpm::Observer {
  void on_snapshot(const mpm::Snapshot& s) override { snapshots.push_back(s); }
  std::vector<mpm::Snapshot> snapshots;
};

/// Takes a checkpoint after a step and stops there.
struct Cut : Watcher {
  explicit Cut(std::int64_t step) : at(step) {}
  bool wants_checkpoint() override { return ++steps == at; }
  void on_checkpoint(const mpm::Record& r) override { record = r; }
  bool on_step(const mpm::Progress&) override { return steps < at; }
  std::int64_t at, steps = 0;
  mpm::Record record;
};

struct Resumed : Watcher {
  mpm::Record* resume_from() override { return &record; }
  mpm::Record record;
};

class Checkpoint : public testing::Test {
 protected:
  ~Checkpoint() override { std::filesystem::remove(path); }

  /// With both kernels, where a scheme has both.
  void expect_same_bits(mpm::Scene scene) {
    for (const auto kernel : {mpm::Kernel::fast, mpm::Kernel::reference}) {
      scene.numerics.kernel = kernel;
      if (mpm::find_problems(scene).empty()) expect_same_bits_of(scene);
    }
  }

  /// Cut after a tenth, a half and nearly all of its steps.
  void expect_same_bits_of(const mpm::Scene& scene) {
    SCOPED_TRACE(scene.numerics.kernel == mpm::Kernel::fast ? "fast" : "reference");
    ++checked;
    Watcher undisturbed;
    const mpm::RunResult whole = mpm::run(scene, undisturbed);
    ASSERT_EQ(whole.status, mpm::RunStatus::done) << whole.reason;
    for (const std::int64_t step : {whole.steps / 10, whole.steps / 2, whole.steps - 1}) {
      Cut cut(step);
      ASSERT_EQ(mpm::run(scene, cut).status, mpm::RunStatus::stopped);
      mpm::write_checkpoint(path, cut.record);
      Resumed resumed;
      resumed.record = mpm::read_checkpoint(path);
      EXPECT_EQ(resumed.record.numbers, cut.record.numbers);
      EXPECT_EQ(resumed.record.integers, cut.record.integers);
      resumed.snapshots = cut.snapshots;
      const mpm::RunResult result = mpm::run(scene, resumed);
      EXPECT_EQ(bits_of(result), bits_of(whole)) << "cut after step " << step;
      EXPECT_EQ(bits_of(resumed.snapshots), bits_of(undisturbed.snapshots)) << "cut after step " << step;
    }
  }

  int checked = 0;
  const std::filesystem::path path =
      std::filesystem::temp_directory_path() / ("mpm-checkpoint-" + std::to_string(getpid()) + ".h5");
};

mpm::Scene collapse() {
  mpm::Scene s = scenes::cavity(0.3e-6);
  s.end_time = 3e-9;
  s.measures.snapshots = {0.5e-9, 2e-9};
  s.measures.gauges = {{.name = "push", .of = "force", .target = mpm::GaugeTarget::wall},
                       {.name = "energy", .of = "internal_energy", .target = mpm::GaugeTarget::body}};
  return s;
}

TEST_F(Checkpoint, of_a_cavity) {
  expect_same_bits(collapse());
  EXPECT_EQ(checked, 2) << "fast and reference";
}

TEST_F(Checkpoint, of_the_gaps_at_an_impact_wall) {
  mpm::Scene s = collapse();
  s.numerics.wall_gap = mpm::WallGap::tracked;
  expect_same_bits(s);
  EXPECT_EQ(checked, 2);
}

TEST_F(Checkpoint, of_a_run_that_a_gauge_ends) {
  mpm::Scene s = collapse();
  s.measures.gauges[1].stops = {{false, 3e-4, 0}};  // J/m, of 1.1e-3 that the block has
  expect_same_bits(s);
  EXPECT_EQ(checked, 2);
  EXPECT_TRUE(mpm::run(s).find("energy.stop"));
}

TEST_F(Checkpoint, of_a_sphere) {
  mpm::Scene s = collapse();
  s.space = mpm::Space::axisymmetric;
  expect_same_bits(s);
  s.numerics.scheme = mpm::ShapeFunction::gimp;
  expect_same_bits(s);
  EXPECT_EQ(checked, 4) << "fast and reference";
}

TEST_F(Checkpoint, of_three_axes) {
  mpm::Scene s = collapse();
  s.space = mpm::Space::three_d;
  s.block_width = 5e-6;
  s.end_time = 1e-9;
  s.measures.snapshots = {0.5e-9};
  s.material.kinematic_fraction = 0.5;
  s.numerics = mpm::default_numerics(s.kind, s.space);
  s.numerics.cell_size = 0.5e-6;
  expect_same_bits(s);
  s.numerics.transfer = mpm::Transfer::apic;
  s.numerics.particles_per_cell = 1;
  s.numerics.scheme = mpm::ShapeFunction::gimp;
  expect_same_bits(s);
  expect_same_bits(scenes::in_space(mpm::Space::three_d, scenes::shell(300, 0.35e-6)));
  EXPECT_EQ(checked, 5) << "of a cavity with FLIP and of a shell both kernels";
}

TEST_F(Checkpoint, of_a_cavity_in_full_width) {
  mpm::Scene s = collapse();
  s.numerics.symmetry = mpm::Symmetry::full;
  expect_same_bits(s);
}

TEST_F(Checkpoint, of_every_scheme) {
  for (const auto scheme :
       {mpm::ShapeFunction::gimp, mpm::ShapeFunction::bspline2, mpm::ShapeFunction::bspline3,
        mpm::ShapeFunction::cpdi, mpm::ShapeFunction::linear}) {
    SCOPED_TRACE(static_cast<int>(scheme));
    mpm::Scene s = collapse();
    s.end_time = 1e-9;
    s.measures.snapshots = {0.5e-9};
    s.numerics.scheme = scheme;
    expect_same_bits(s);
  }
}

TEST_F(Checkpoint, of_a_transfer_with_a_share_of_pic) {
  mpm::Scene s = collapse();
  s.end_time = 1e-9;
  s.measures.snapshots = {};
  s.numerics.pic_fraction = 0.1;
  expect_same_bits(s);
}

TEST_F(Checkpoint, of_an_affine_transfer) {
  mpm::Scene s = collapse();
  s.end_time = 1e-9;
  s.measures.snapshots = {};
  s.numerics.transfer = mpm::Transfer::apic;
  expect_same_bits(s);
}

TEST_F(Checkpoint, of_kinematic_hardening) {
  mpm::Scene s = collapse();
  s.material.kinematic_fraction = 0.5;
  expect_same_bits(s);
}

TEST_F(Checkpoint, of_an_ejection_that_ends_when_decided) {
  mpm::Scene s = collapse();
  s.impact_speed = 1500;
  s.end_time = 12e-9;
  s.measures.snapshots = {};
  s.measures.decides = mpm::Decides::ejection;
  s.measures.detached_for = 0.5e-9;
  s.measures.stop = mpm::Stop::decided;
  expect_same_bits(s);
}

TEST_F(Checkpoint, of_a_planar_impact) { expect_same_bits(scenes::planar(200, 5e-6, 0.1e-6, 1.5e-9)); }

TEST_F(Checkpoint, of_an_imploding_shell) { expect_same_bits(scenes::shell(800, 0.2e-6)); }

TEST_F(Checkpoint, of_two_bodies) {
  mpm::Scene s = collapse();
  s.kind = mpm::SceneKind::two_body_impact;
  s.end_time = 1e-9;
  s.measures.snapshots = {};
  expect_same_bits(s);
}

TEST_F(Checkpoint, of_another_scene_is_refused) {
  Cut cut(5);
  mpm::run(scenes::planar(200, 5e-6, 0.1e-6, 1.5e-9), cut);
  Resumed other;
  other.record = cut.record;
  EXPECT_THROW(mpm::run(collapse(), other), mpm::InputError);
}

TEST_F(Checkpoint, that_is_cut_short_is_not_read) {
  Cut cut(5);
  mpm::run(collapse(), cut);
  mpm::write_checkpoint(path, cut.record);
  std::filesystem::resize_file(path, std::filesystem::file_size(path) / 2);
  EXPECT_THROW(mpm::read_checkpoint(path), std::runtime_error);
}

}  // namespace
