#include "runner/bench/kernel_bench.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "libmpm/mpm.hpp"
#include "libmpm/scene/build.hpp"
#include "libmpm/scene/dispatch.hpp"
#include "runner/exec/thread_clock.hpp"

namespace mpmstudy {
namespace {

mpm::Scene strong_cavity(std::int64_t particles) {
  mpm::Scene s;
  s.kind = mpm::SceneKind::cavity_impact;
  s.material = mpm::named_material("aluminium");
  s.impact_speed = 1120;
  s.block_width = 10e-6;
  s.block_height = 11e-6;
  s.cavity_radius = 1.5e-6;
  s.cavity_center_height = 6.5e-6;
  s.end_time = 12e-9;
  s.numerics = mpm::default_numerics(s.kind);
  const double area = 5e-6 * 11e-6 - 0.5 * std::numbers::pi * 1.5e-6 * 1.5e-6;  // half of it is modelled
  s.numerics.cell_size = std::sqrt(area * s.numerics.particles_per_cell / static_cast<double>(particles));
  s.measures.area_every = s.end_time / 320;
  return s;
}

/// A run that can be taken further, piece by piece.
class Walk {
 public:
  explicit Walk(const mpm::Scene& scene)
      : scene_(scene),
        state_(mpm::build_state(scene)),
        stepper_(mpm::stepper_for(scene)),
        particles_(state_.particles.size()) {
    const double sound = 1.25 * scene.material.bulk_sound_speed;
    signal_ = 3 * (sound + scene.impact_speed);
  }
  std::size_t particles() const { return particles_; }

  /// Million particle updates a second over at least this many seconds of processor time.
  double rate(double seconds) {
    const double start = thread_cpu_seconds();
    std::int64_t steps = 0;
    do {
      for (int k = 0; k < 4; ++k, ++steps)
        signal_ = stepper_->step(state_, scene_.numerics.cfl * state_.grid.cell().minCoeff() / signal_)
                      .largest_signal;
    } while (thread_cpu_seconds() - start < seconds);
    return 1e-6 * static_cast<double>(steps) * static_cast<double>(particles_) /
           (thread_cpu_seconds() - start);
  }

  double bytes_per_particle() const {
    const mpm::Particles& p = state_.particles;
    const std::size_t each = sizeof(p.position[0]) + sizeof(p.velocity[0]) + sizeof(p.half_size[0]) +
                             sizeof(p.deviator[0]) + 8 * sizeof(double) + sizeof(mpm::Mat2);
    const double beside =
        scene_.numerics.kernel == mpm::Kernel::reference
            ? static_cast<double>(each * particles_ + state_.grid.nodes().size() * sizeof(mpm::Node))
            : static_cast<double>(stepper_->memory());
    return beside / static_cast<double>(particles_);
  }

 private:
  mpm::Scene scene_;
  mpm::State state_;
  std::unique_ptr<mpm::Stepper> stepper_;
  std::size_t particles_;
  double signal_;
};

double median(std::vector<double> values) {
  std::ranges::sort(values);
  return values[values.size() / 2];
}

}  // namespace

std::vector<KernelBenchRow> bench_kernel(const KernelBenchOptions& options) {
  std::vector<KernelBenchRow> rows;
  const mpm::Choice& schemes = *mpm::find_choice("scheme");
  for (std::size_t scheme = 0; scheme < schemes.allowed.size(); ++scheme)
    for (const std::int64_t wanted : options.particles) {
      mpm::Scene scene = strong_cavity(wanted);
      schemes.set(scene, scheme);
      if (!mpm::fast_step_has(scene.numerics)) continue;
      scene.numerics.kernel = mpm::Kernel::fast;
      Walk fast(scene);
      scene.numerics.kernel = mpm::Kernel::reference;
      Walk reference(scene);
      std::vector<double> fast_rates, reference_rates, ratios;
      for (int k = 0; k < options.repetitions; ++k) {
        fast_rates.push_back(fast.rate(options.seconds));
        reference_rates.push_back(reference.rate(options.seconds));
        ratios.push_back(fast_rates.back() / reference_rates.back());
      }
      const auto row = [&](const char* kernel, const Walk& walk, double rate, double ratio) {
        rows.push_back({std::string(schemes.allowed[scheme]), kernel, "double", 1,
                        static_cast<std::int64_t>(walk.particles()), rate, ratio, walk.bytes_per_particle()});
      };
      row("fast", fast, median(fast_rates), median(ratios));
      row("reference", reference, median(reference_rates), 1);
    }
  return rows;
}

}  // namespace mpmstudy
