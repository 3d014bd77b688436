#pragma once
/// The stress update of stress_update.cpp for a pack of particles, without branches, in three parts. Each is
/// a loop over a chunk: a pack's chain of operations is some 80 cycles long in each, and the processor finds
/// room for several packs at once, which it does not when all three are one loop.
#include "libmpm/step/fast/kernels.hpp"
#include "libmpm/step/fast/lanes.hpp"

namespace mpm::fast::MPM_ISA {

/// Extremes as packs.
template <class Real>
struct ExtremePacks {
  Pack<Real> signal, low_dilation, high_dilation, high_pressure, finite;
};

/// dt L of a pack: the gradient of the displacement over the step.
template <class Real>
struct Gradient {
  Pack<Real> xx, xy, yx, yy;
};

/// The motion of a pack over the step, seen from its middle.
template <class Real>
struct Strain {
  Pack<Real> rate_xx, rate_yy, rate_xy;  ///< dt D
  Pack<Real> cosine, sine;               ///< of the rotation
  Pack<Real> mu;                         ///< rho / rho0 - 1 at the end
  Pack<Real> divisor;  ///< 1 / (1 + thermal theta / (2 rho)): what makes the pressure implicit
};

template <class Real, Variant variant>
MPM_INLINE Strain<Real> strain_of(Pack<Real>* f, const Gradient<Real>& l, const Constants<Real>& k) {
  using P = Pack<Real>;
  const P growth = (l.xx + l.yy) + (l.xx * l.yy - l.xy * l.yx);
  // At most tenfold: see MieGrueneisen::expanded. The second of smaller() wins where it is not a number.
  const P dilation = smaller(all(k.most_dilation), f[Column::dilation] + (1 + f[Column::dilation]) * growth);
  f[Column::dilation] = dilation;
  const P ratio = 1 + dilation;

  // L (1 + dt L/2)^-1, with respect to positions in the middle of the step, times the determinant
  const P a = 1 + Real(0.5) * l.xx, b = Real(0.5) * l.xy, c = Real(0.5) * l.yx, d = 1 + Real(0.5) * l.yy;
  const P det = a * d - b * c;
  const P xx_det = l.xx * d - l.xy * c, xy_det = l.xy * a - l.xx * b;
  const P yx_det = l.yx * d - l.yy * c, yy_det = l.yy * a - l.yx * b;
  // the rotation of the spin w: tan(w/2) = turn / det; see Rotation::of_spin
  const P turn = Real(0.25) * (yx_det - xy_det);
  const P det_square = det * det, turn_square = turn * turn, norm = det_square + turn_square;
  // the pressure is divided by implicit / det
  const Real thermal = Real(0.5) * k.gamma0;  // gamma0 rho0 / (2 rho) at rho0
  P implicit = (xx_det + yy_det) * (thermal * ratio);
  if constexpr (variant.linear_tension) implicit = dilation > 0 ? P{} : implicit;
  implicit += det;

  // One division for four: divisions are slow, and these numbers are all near 1.
  const P ratio_det = ratio * det, norm_implicit = norm * implicit;
  const P inverse_all = 1 / (ratio_det * norm_implicit);
  const P inverse_first = inverse_all * norm_implicit, inverse_second = inverse_all * ratio_det;
  const P inverse_det = inverse_first * ratio, inverse_norm = inverse_second * implicit;
  return {xx_det * inverse_det,
          yy_det * inverse_det,
          Real(0.5) * (xy_det + yx_det) * inverse_det,
          (det_square - turn_square) * inverse_norm,
          (turn + turn) * det * inverse_norm,
          -dilation * (inverse_first * det),
          det * (inverse_second * norm)};
}

/// J2 plasticity: see material/strength/j2.hpp.
template <class Real, Variant variant>
MPM_INLINE void update_deviator(Pack<Real>* f, Pack<Real>* own, const Strain<Real>& e,
                                const Constants<Real>& k) {
  using P = Pack<Real>;
  Pack<Real>* const back_stress = own + 2;
  const P cc = e.cosine * e.cosine, ss = e.sine * e.sine, cs = e.cosine * e.sine, cs2 = cs + cs,
          double_cosine = cc - ss;
  const auto rotate = [&](P& xx, P& yy, P& xy_) {
    const P sum = xx + yy, turned = cc * xx + ss * yy - cs2 * xy_;
    xy_ = cs * (xx - yy) + double_cosine * xy_;
    xx = turned;
    yy = sum - turned;
  };

  // trial deviator, relative to the back stress
  P sxx = f[deviator_xx], syy = f[deviator_yy], sxy = f[deviator_xy];
  rotate(sxx, syy, sxy);
  const Real twice = 2 * k.shear_modulus;
  const P mean = (e.rate_xx + e.rate_yy) * Real(1.0 / 3.0);
  P rxx = sxx + twice * (e.rate_xx - mean), ryy = syy + twice * (e.rate_yy - mean),
    rxy = sxy + twice * e.rate_xy;
  P axx{}, ayy{}, axy{};
  if constexpr (variant.back_stress) {
    axx = back_stress[0], ayy = back_stress[1], axy = back_stress[2];
    rotate(axx, ayy, axy);
    rxx -= axx, ryy -= ayy, rxy -= axy;
  }
  if constexpr (!variant.plastic) {
    f[deviator_xx] = rxx, f[deviator_yy] = ryy, f[deviator_xy] = rxy;
    return;
  }
  // q^2 = 3/2 s:s with s_zz = -(s_xx + s_yy)
  const P mises = square_root(3 * (rxx * rxx + ryy * ryy + rxx * ryy + rxy * rxy));
  const P excess = larger(mises - (k.yield_stress + k.isotropic_modulus * own[0]), P{});
  const P dp = excess * k.inverse_return;
  const P flow = mises > 0 ? Real(1.5) * dp / mises : P{};
  const P kept = 1 - twice * flow;
  P work;  // mean stress of the return times the increment
  if constexpr (variant.back_stress) {
    const Real share = k.kinematic_modulus / Real(1.5);
    const P sxx_new = axx + kept * rxx, syy_new = ayy + kept * ryy, sxy_new = axy + kept * rxy;
    work =
        flow * (2 * (sxx_new * rxx + syy_new * ryy) + sxx_new * ryy + syy_new * rxx + 2 * (sxy_new * rxy)) -
        Real(0.5) * (k.isotropic_modulus + k.kinematic_modulus) * dp * dp;
    back_stress[0] = axx + share * flow * rxx;
    back_stress[1] = ayy + share * flow * ryy;
    back_stress[2] = axy + share * flow * rxy;
    sxx = sxx_new, syy = syy_new, sxy = sxy_new;
  } else {
    sxx = kept * rxx, syy = kept * ryy, sxy = kept * rxy;
    work = dp * (mises - (3 * k.shear_modulus + Real(0.5) * k.isotropic_modulus) * dp);
  }
  f[deviator_xx] = sxx, f[deviator_yy] = syy, f[deviator_xy] = sxy;
  own[0] += dp;
  own[1] += work * (k.inverse_rho0 * (1 + f[Column::dilation]));
}

/// Pressure, artificial viscosity and the fastest signal: see material/.
template <class Real, Variant variant>
MPM_INLINE void update_pressure(Pack<Real>* f, const Strain<Real>& e, const Constants<Real>& k,
                                Real inverse_dt, ExtremePacks<Real>& extremes) {
  using P = Pack<Real>;
  // sound speed with the pressure of the last step, artificial viscosity
  const P dilation = f[Column::dilation], ratio = 1 + dilation, specific_volume = k.inverse_rho0 * ratio;
  const P mu = e.mu, theta = e.rate_xx + e.rate_yy;
  const P old_pressure = f[Column::pressure];
  const P cold = mu * (k.cold_c + mu * (k.cold_d + mu * k.cold_s));
  const P cold_slope = k.cold_c + mu * (2 * k.cold_d + 3 * mu * k.cold_s);
  const P away = 1 + Real(0.5) * k.gamma0 * dilation, ratio_square = ratio * ratio;
  P bulk_square =
      (cold_slope * away + k.gamma0 * ratio_square * (old_pressure - Real(0.5) * cold)) * k.inverse_rho0;
  bulk_square = larger(bulk_square, all(k.least_sound_square));
  P line_cold = cold * away, line_thermal = all(k.gamma0 * k.rho0);
  if constexpr (variant.linear_tension) {
    line_cold = mu < 0 ? k.cold_c * mu : line_cold;
    line_thermal = mu < 0 ? P{} : line_thermal;
    bulk_square = mu < 0 ? all(k.cold_c * k.inverse_rho0) : bulk_square;
  }
  const P bulk_sound = square_root(bulk_square);
  const P closing = smaller(theta * (inverse_dt * k.viscous_length), P{});  // h theta of compression [m/s]
  const P viscous = closing < 0 ? k.linear_viscosity * bulk_sound - k.quadratic_viscosity * closing : P{};
  const P density = k.rho0 * (1 + mu);
  const P q = -(density * closing) * viscous;

  // pressure at the end of the step, implicit in the energy
  const P power =
      (f[deviator_xx] * e.rate_xx + f[deviator_yy] * e.rate_yy + 2 * (f[deviator_xy] * e.rate_xy)) -
      q * theta;
  const P energy_end = f[energy] + Real(0.5) * specific_volume * power;
  P held = (line_cold + line_thermal * energy_end) * e.divisor;
  held = larger(held, all(k.pressure_floor));
  f[Column::pressure] = held;
  f[viscous_pressure] = q;

  const P longitudinal = bulk_square + (Real(4.0 / 3.0) * k.shear_modulus) * specific_volume;
  const P speed = larger(magnitude(f[velocity_x]), magnitude(f[velocity_y]));
  // The signal is speed + viscous + sqrt(root); the root is taken only where it may raise the largest.
  const P root = viscous * viscous + longitudinal, rest = extremes.signal - (speed + viscous);
  // Lanes without a particle are at rest; their signal is nobody's.
  const auto record = ((root > rest * rest) | (rest < 0)) & (f[initial_volume] > 0);
  if (__builtin_expect(any(record), 0))
    extremes.signal = record ? speed + viscous + square_root(root) : extremes.signal;
  extremes.finite += Real(0) * root + Real(0) * speed + Real(0) * held;
  extremes.high_pressure = larger(extremes.high_pressure, held);
  extremes.low_dilation = smaller(extremes.low_dilation, dilation);
  extremes.high_dilation = larger(extremes.high_dilation, dilation);
}

template <class Real, Variant variant>
struct Constitutive {
  using P = Pack<Real>;

  static void update(Real* blocks, int count, int columns, int own, const Gradients<Real>& gradients,
                     const Constants<Real>& constants, Real inverse_dt, Extremes<Real>& sums) {
    const Constants<Real> k = constants;
    auto* const first = reinterpret_cast<P*>(blocks);
    const auto each_block = [&](auto&& work) __attribute__((always_inline)) {
      P* f = first;
      for (int b = 0; b < count; ++b, f += columns) work(f, b);
    };
    Strain<Real> strain[chunk_blocks];
    each_block([&](P * f, int b) __attribute__((always_inline)) {
      const auto* const l = reinterpret_cast<const P*>(gradients.of_block[b]);
      strain[b] = strain_of<Real, variant>(f, {l[0], l[1], l[2], l[3]}, k);
    });
    each_block([&](P * f, int b) __attribute__((always_inline)) {
      update_deviator<Real, variant>(f, f + own, strain[b], k);
    });
    const auto pack = [](Real * lanes) __attribute__((always_inline))->P& {
      return *reinterpret_cast<P*>(lanes);
    };
    ExtremePacks<Real> extremes{pack(sums.signal), pack(sums.low_dilation), pack(sums.high_dilation),
                                pack(sums.high_pressure), pack(sums.finite)};
    each_block([&](P * f, int b) __attribute__((always_inline)) {
      update_pressure<Real, variant>(f, strain[b], k, inverse_dt, extremes);
    });
    pack(sums.signal) = extremes.signal, pack(sums.finite) = extremes.finite;
    pack(sums.low_dilation) = extremes.low_dilation, pack(sums.high_dilation) = extremes.high_dilation;
    pack(sums.high_pressure) = extremes.high_pressure;
  }

  /// The mass beyond the equation of state. Most steps have none, so that it has a pass of its own.
  static void add_what_is_beyond(const Band<Real>& band, const Constants<Real>& k, SweepReport& report) {
    const auto* f = reinterpret_cast<const P*>(band.blocks);
    for (std::size_t b = 0; b < band.count; ++b, f += band.columns)
      for (int l = 0; l < Lanes<Real>::width; ++l) {
        const Real dilation = f[Column::dilation][l];
        if (f[Column::pressure][l] > k.pressure_limit) report.overpressed += f[initial_volume][l];
        if (dilation < k.least_dilation || dilation >= k.most_dilation)
          report.overstrained += f[initial_volume][l];
      }
  }

  static void report(const Band<Real>& band, const Constants<Real>& k, const Extremes<Real>& extremes,
                     SweepReport& report) {
    bool beyond = false;
    for (int l = 0; l < Lanes<Real>::width; ++l) {
      const auto raise = [](double& most, double v) { most = v > most ? v : most; };
      raise(report.largest_signal, extremes.signal[l]);
      raise(report.largest_dilation, extremes.high_dilation[l]);
      const double low = extremes.low_dilation[l];
      report.smallest_dilation = low < report.smallest_dilation ? low : report.smallest_dilation;
      report.broken |= extremes.finite[l] != 0;
      beyond |= extremes.high_pressure[l] > k.pressure_limit || extremes.low_dilation[l] < k.least_dilation ||
                extremes.high_dilation[l] >= k.most_dilation;
    }
    if (beyond) add_what_is_beyond(band, k, report);
  }
};

}  // namespace mpm::fast::MPM_ISA
