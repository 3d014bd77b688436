#include "runner/bench/kernel_bench.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>

#include "libmpm/core/thread_clock.hpp"
#include "libmpm/mpm.hpp"
#include "libmpm/scene/build.hpp"

namespace mpmstudy {
namespace {

mpm::Scene strong_cavity(mpm::Space space, std::int64_t particles) {
  mpm::Scene s;
  s.space = space;
  s.kind = mpm::SceneKind::cavity_impact;
  s.material = mpm::named_material("aluminium");
  s.impact_speed = 1120;
  s.block_width = 10e-6;
  s.block_height = 11e-6;
  s.cavity_radius = 1.5e-6;
  s.cavity_center_height = 6.5e-6;
  s.end_time = 12e-9;
  s.numerics = mpm::default_numerics(s.kind, space);
  const double radius = 1.5e-6, per_cell = s.numerics.particles_per_cell / static_cast<double>(particles);
  // half of the area is modelled, or a quarter of the volume
  const double area = 5e-6 * 11e-6 - 0.5 * std::numbers::pi * radius * radius;
  const double volume = 5e-6 * 11e-6 * 5e-6 - std::numbers::pi / 3 * radius * radius * radius;
  s.numerics.cell_size =
      space == mpm::Space::three_d ? std::cbrt(volume * per_cell) : std::sqrt(area * per_cell);
  s.measures.area_every = s.end_time / 320;
  return s;
}

/// Floating-point operations of a particle update (a fused multiply-add is two), of aluminium with isotropic
/// hardening: counted in the instructions that a run of 15000 particles executes. See PERFORMANCE.md.
double operations(const mpm::Scene& s) {
  const bool gimp = s.numerics.scheme == mpm::ShapeFunction::gimp;
  switch (s.space) {
    case mpm::Space::plane_strain:
      return gimp ? 712 : 658;
    case mpm::Space::axisymmetric:
      return gimp ? 839 : 798;
    case mpm::Space::three_d:
      return gimp ? 2630 : 2564;
  }
  return 0;
}

/// A run that is taken further piece by piece, and measures nothing.
template <int axes>
class Walk {
 public:
  explicit Walk(const mpm::Scene& scene)
      : reference_(scene.numerics.kernel == mpm::Kernel::reference),
        simulation_(scene, mpm::build_state<axes>(scene)),
        particles_(simulation_.state().particles.size()) {
    rate(0);  // the first step puts the particles in order
  }
  std::size_t particles() const { return particles_; }

  /// Million particle updates per second over at least this many seconds, or over as many steps as are
  /// wanted: of processor time, or with more than one thread of time that passes.
  double rate(double seconds, int threads = 1, std::int64_t wanted = 0) {
    const auto now = [=] {
      return threads == 1
                 ? mpm::thread_cpu_seconds()
                 : std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
    };
    simulation_.stepper().use_threads(threads);
    const double start = now();
    std::int64_t steps = 0;
    do {
      for (int k = 0; k < 4; ++k, ++steps) step();
    } while (wanted > 0 ? steps < wanted : now() - start < seconds);
    return 1e-6 * static_cast<double>(steps) * static_cast<double>(particles_) / (now() - start);
  }

  /// The same up to this time of the run [s].
  double rate_until(double time) {
    const double start = mpm::thread_cpu_seconds();
    std::int64_t steps = 0;
    for (; simulation_.time() < time && std::isfinite(simulation_.time_step()); ++steps) step();
    if (!(simulation_.time() >= time)) return 0;
    return 1e-6 * static_cast<double>(steps) * static_cast<double>(particles_) /
           (mpm::thread_cpu_seconds() - start);
  }

  mpm::StepTimes times() { return simulation_.stepper().times(); }

  double bytes_per_particle() {
    const mpm::BasicState<axes>& state = simulation_.state();
    const mpm::BasicParticles<axes>& p = state.particles;
    const std::size_t each = sizeof(p.position[0]) + sizeof(p.velocity[0]) + sizeof(p.half_size[0]) +
                             sizeof(p.deviator[0]) + 8 * sizeof(double) + sizeof(mpm::Mat<axes>);
    const double beside = reference_
                              ? static_cast<double>(each * particles_ +
                                                    state.grid.nodes().size() * sizeof(mpm::BasicNode<axes>))
                              : static_cast<double>(simulation_.stepper().memory());
    return beside / static_cast<double>(particles_);
  }

 private:
  void step() { simulation_.step(simulation_.time_step()); }

  bool reference_;
  mpm::BasicSimulation<axes> simulation_;
  std::size_t particles_;
};

double median(std::vector<double> values) {
  std::ranges::sort(values);
  return values[values.size() / 2];
}

/// Rows of one scene: the fast step in both precisions with every number of threads, and the reference.
template <int axes>
void add_rows(mpm::Scene scene, KernelBenchRow blank, const KernelBenchOptions& options, KernelBench& bench) {
  const mpm::Choice& precisions = *mpm::find_choice("precision");
  std::vector<Walk<axes>> fast;
  for (std::size_t precision = 0; precision < precisions.allowed.size(); ++precision) {
    precisions.set(scene, precision);
    fast.emplace_back(scene);
  }
  scene.numerics.precision = mpm::Precision::double_precision;
  scene.numerics.kernel = mpm::Kernel::reference;
  Walk<axes> reference(scene);
  // a pair of lists of rates for each precision and number of threads
  struct Rates {
    std::size_t precision;
    int threads;
    std::vector<double> fast, to_reference;
  };
  std::vector<Rates> measured;
  for (std::size_t p = 0; p < fast.size(); ++p)
    for (const int threads : options.threads) measured.push_back({p, threads, {}, {}});
  std::vector<double> reference_rates;
  for (int k = 0; k < options.repetitions; ++k) {
    reference_rates.push_back(reference.rate(options.seconds, 1, options.steps));
    for (Rates& r : measured) {
      r.fast.push_back(fast[r.precision].rate(options.seconds, r.threads, options.steps));
      r.to_reference.push_back(r.fast.back() / reference_rates.back());
    }
  }
  const auto row = [&](const char* kernel, std::size_t precision, Walk<axes>& walk, double rate) {
    KernelBenchRow r = blank;
    r.kernel = kernel;
    r.precision = precisions.allowed[precision];
    r.particles = static_cast<std::int64_t>(walk.particles());
    r.million_particle_updates_per_s = rate;
    r.ratio_to_reference = 1;
    r.bytes_per_particle = walk.bytes_per_particle();
    return r;
  };
  for (const Rates& m : measured) {
    KernelBenchRow r = row("fast", m.precision, fast[m.precision], median(m.fast));
    r.threads = m.threads;
    r.ratio_to_reference = median(m.to_reference);
    // everything that a step keeps is read and written once
    const KernelWork work{operations(scene), 2 * r.bytes_per_particle};
    const bool single = precisions.allowed[m.precision] == "float";
    if (m.threads == 1)
      r.roofline_share = 1e6 * r.million_particle_updates_per_s / roofline_rate(bench.roofline, work, single);
    const mpm::StepTimes t = fast[m.precision].times();
    const double all = t.sort + t.grid + t.particles;
    r.sort_share = t.sort / all, r.grid_share = t.grid / all;
    bench.rows.push_back(std::move(r));
  }
  bench.rows.push_back(row("reference", 0, reference, median(reference_rates)));
}

/// Calls use(scene, row) for every space, scheme and size, with what a row says of it.
template <class Use>
void each_scene(const KernelBenchOptions& options, Use use) {
  const mpm::Choice& schemes = *mpm::find_choice("scheme");
  const mpm::Choice& spaces = *mpm::find_choice("space");
  for (const mpm::Space space : options.spaces)
    for (std::size_t scheme = 0; scheme < schemes.allowed.size(); ++scheme)
      for (const std::int64_t wanted : options.particles) {
        mpm::Scene scene = strong_cavity(space, wanted);
        schemes.set(scene, scheme);
        if (!mpm::fast_step_has(scene)) continue;
        KernelBenchRow row;
        row.space = spaces.allowed[spaces.get(scene)];
        row.scheme = schemes.allowed[scheme];
        use(scene, row);
      }
}

template <int axes>
void add_whole_run(const mpm::Scene& scene, WholeRunRow row, std::vector<WholeRunRow>& rows) {
  Walk<axes> walk(scene);
  row.particles = static_cast<std::int64_t>(walk.particles());
  for (int tenth = 0; tenth < 10; ++tenth)
    row.million_particle_updates_per_s[static_cast<std::size_t>(tenth)] =
        walk.rate_until(0.1 * (tenth + 1) * scene.end_time);
  rows.push_back(std::move(row));
}

}  // namespace

KernelBench bench_kernel(const KernelBenchOptions& options) {
  KernelBench bench;
  bench.roofline = measure_roofline(options.repetitions, options.seconds);
  each_scene(options, [&](mpm::Scene& scene, const KernelBenchRow& row) {
    if (options.elastic) scene.material.yield_stress = std::numeric_limits<double>::infinity();
    scene.material.kinematic_fraction = options.kinematic ? 0.5 : 0;
    if (scene.space == mpm::Space::three_d)
      add_rows<3>(scene, row, options, bench);
    else
      add_rows<2>(scene, row, options, bench);
  });
  return bench;
}

std::vector<WholeRunRow> bench_whole_run(const KernelBenchOptions& options) {
  std::vector<WholeRunRow> rows;
  const mpm::Choice& precisions = *mpm::find_choice("precision");
  each_scene(options, [&](mpm::Scene& scene, const KernelBenchRow& row) {
    for (std::size_t precision = 0; precision < precisions.allowed.size(); ++precision) {
      precisions.set(scene, precision);
      const WholeRunRow blank{row.space, row.scheme, std::string(precisions.allowed[precision]), 0, {}};
      if (scene.space == mpm::Space::three_d)
        add_whole_run<3>(scene, blank, rows);
      else
        add_whole_run<2>(scene, blank, rows);
    }
  });
  return rows;
}

}  // namespace mpmstudy
