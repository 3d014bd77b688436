#pragma once
/// The stress update of stress_update.cpp for blocks of particles, by the same text of a material model.
#include "libmpm/material/model.hpp"
#include "libmpm/step/fast/kernels.hpp"
#include "libmpm/step/fast/lanes.hpp"

namespace mpm::fast::MPM_ISA {

template <class Real, class Model, class Space>
struct UpdateStress {
  using P = Pack<Real>;
  static constexpr int axes = Space::axes;
  using C = Columns<axes>;
  using Deviator = typename Space::template Deviator<P>;
  static_assert(MaterialModelOver<Model, P, Space>);

  /// Extremes as packs.
  struct ExtremePacks {
    P signal, low_dilation, high_dilation, high_pressure, finite;
  };

  static MPM_INLINE Point<P, Deviator> point(P* f, int own, Deviator& stress) {
    return {f[C::dilation], f[C::energy], stress, f[C::pressure], f[C::viscous_pressure], f + own};
  }

  /// The fastest signal against the grid is speed + viscous + sqrt(root); the root is taken only where it may
  /// raise the largest so far.
  static MPM_INLINE void record(const P* f, const Signal<P>& signal, ExtremePacks& extremes) {
    const P dilation = f[C::dilation], pressure = f[C::pressure];
    P speed = magnitude(f[C::velocity]);
    each<axes, 1>([&]<int a>() __attribute__((always_inline)) {
      speed = larger(speed, magnitude(f[C::velocity + a]));
    });
    const P root = signal.viscous * signal.viscous + signal.longitudinal_square;
    const P rest = extremes.signal - (speed + signal.viscous);
    // lanes without a particle do not count
    const auto faster = ((root > rest * rest) | (rest < 0)) & (f[C::initial_volume] > 0);
    if (__builtin_expect(any(faster), 0))
      extremes.signal = faster ? speed + signal.viscous + square_root(root) : extremes.signal;
    extremes.finite += Real(0) * root + Real(0) * speed + Real(0) * pressure;
    extremes.high_pressure = larger(extremes.high_pressure, pressure);
    extremes.low_dilation = smaller(extremes.low_dilation, dilation);
    extremes.high_dilation = larger(extremes.high_dilation, dilation);
  }

  /// In three loops over the blocks: a pack's chain of operations is some 80 cycles long in each, and the
  /// processor finds room for several packs at once, which it does not when all three are one loop.
  static void update(const void* any_model, Real* blocks, int count, int columns, int own,
                     const Gradients<Real, axes>& gradients, Real inverse_dt, Extremes<Real>& sums) {
    const Model model = *static_cast<const Model*>(any_model);
    auto* const first = reinterpret_cast<P*>(blocks);
    const auto each_block = [&](auto&& work) __attribute__((always_inline)) {
      P* f = first;
      for (int b = 0; b < count; ++b, f += columns) work(f, b);
    };
    StrainFor<P, Space, Model> strain[chunk_blocks];
    each_block([&](P * f, int b) __attribute__((always_inline)) {
      const auto* const l = reinterpret_cast<const P*>(gradients.of_block[b]);
      [[maybe_unused]] const auto* const hoop = reinterpret_cast<const P*>(gradients.hoop[b]);
      if constexpr (axes == 3)
        strain[b] = strain_over<P, Space>(
            f[C::dilation], FullGradient<P>{l[0], l[1], l[2], l[3], l[4], l[5], l[6], l[7], l[8]}, model);
      else if constexpr (Space::has_hoop)
        strain[b] = strain_over<P, Space>(f[C::dilation], Gradient<P>{l[0], l[1], l[2], l[3]}, model, *hoop);
      else
        strain[b] = strain_over<P, Space>(f[C::dilation], Gradient<P>{l[0], l[1], l[2], l[3]}, model);
    });
    each_block([&](P * f, int b) __attribute__((always_inline)) {
      Deviator stress;
      load(f + C::deviator, stress);
      model.shear(point(f, own, stress), strain[b], inverse_dt);
      store(stress, f + C::deviator);
    });
    const auto pack = [](Real * lanes) __attribute__((always_inline))->P& {
      return *reinterpret_cast<P*>(lanes);
    };
    ExtremePacks extremes{pack(sums.signal), pack(sums.low_dilation), pack(sums.high_dilation),
                          pack(sums.high_pressure), pack(sums.finite)};
    each_block([&](P * f, int b) __attribute__((always_inline)) {
      Deviator stress;
      load(f + C::deviator, stress);
      record(f, model.bulk(point(f, own, stress), strain[b], inverse_dt), extremes);
    });
    pack(sums.signal) = extremes.signal, pack(sums.finite) = extremes.finite;
    pack(sums.low_dilation) = extremes.low_dilation, pack(sums.high_dilation) = extremes.high_dilation;
    pack(sums.high_pressure) = extremes.high_pressure;
  }

  /// The mass beyond the model's validity. Most steps have none, so that it has a pass of its own.
  static void add_what_is_beyond(const Band<Real>& band, const Validity<Real>& valid, SweepReport& report) {
    const auto* f = reinterpret_cast<const P*>(band.blocks);
    for (std::size_t b = 0; b < band.count; ++b, f += band.columns)
      for (int l = 0; l < Lanes<Real>::width; ++l) {
        const Real dilation = f[C::dilation][l];
        if (f[C::pressure][l] > valid.pressure_limit) report.overpressed += f[C::initial_volume][l];
        if (dilation < valid.least_dilation || dilation >= valid.most_dilation)
          report.overstrained += f[C::initial_volume][l];
      }
  }

  static void report(const void* any_model, const Band<Real>& band, const Extremes<Real>& extremes,
                     SweepReport& report) {
    const Validity<Real> valid = static_cast<const Model*>(any_model)->validity();
    bool beyond = false;
    for (int l = 0; l < Lanes<Real>::width; ++l) {
      const auto raise = [](double& most, double v) { most = v > most ? v : most; };
      raise(report.largest_signal, extremes.signal[l]);
      raise(report.largest_dilation, extremes.high_dilation[l]);
      const double low = extremes.low_dilation[l];
      report.smallest_dilation = low < report.smallest_dilation ? low : report.smallest_dilation;
      report.broken |= extremes.finite[l] != 0;
      beyond |= extremes.high_pressure[l] > valid.pressure_limit ||
                extremes.low_dilation[l] < valid.least_dilation ||
                extremes.high_dilation[l] >= valid.most_dilation;
    }
    if (beyond) add_what_is_beyond(band, valid, report);
  }
};

}  // namespace mpm::fast::MPM_ISA
