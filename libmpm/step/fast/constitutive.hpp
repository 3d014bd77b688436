#pragma once
/// The stress update of stress_update.cpp for a pack of particles, without branches.
#include "libmpm/step/fast/kernels.hpp"
#include "libmpm/step/fast/lanes.hpp"

namespace mpm::fast::MPM_ISA {

/// Largest and smallest values of a sweep, lane by lane.
template <class Real>
struct Extremes {
  Pack<Real> signal{}, low_dilation{}, high_dilation{}, pressure{}, low, high;
  typename Lanes<Real>::Mask broken{};
};

/// dt L of a pack: the gradient of the displacement over the step.
template <class Real>
struct Gradient {
  Pack<Real> xx, xy, yx, yy;
};

template <class Real, bool back_stress_used, bool linear_tension>
MPM_INLINE void update_stress(Pack<Real>* f, Pack<Real>* back_stress, const Gradient<Real>& l,
                              const Constants<Real>& k, Real inverse_dt, Extremes<Real>& extremes) {
  using P = Pack<Real>;
  const P growth = (l.xx + l.yy) + (l.xx * l.yy - l.xy * l.yx);
  const P dilation = f[Column::dilation] + (1 + f[Column::dilation]) * growth;
  f[Column::dilation] = dilation;
  const P ratio = 1 + dilation;
  const P specific_volume = k.inverse_rho0 * ratio;

  // L (1 + dt L/2)^-1, with respect to positions in the middle of the step, times the determinant
  const P a = 1 + Real(0.5) * l.xx, b = Real(0.5) * l.xy, c = Real(0.5) * l.yx, d = 1 + Real(0.5) * l.yy;
  const P det = a * d - b * c;
  const P xx_det = l.xx * d - l.xy * c, xy_det = l.xy * a - l.xx * b;
  const P yx_det = l.yx * d - l.yy * c, yy_det = l.yy * a - l.yx * b;
  const P theta_det = xx_det + yy_det;
  // the rotation of the spin w: tan(w/2) = turn / det; see Rotation::of_spin
  const P turn = Real(0.25) * (yx_det - xy_det);
  const P det_square = det * det, turn_square = turn * turn, norm = det_square + turn_square;
  // the pressure is divided by implicit / det
  const P half = Real(0.5) * specific_volume;
  P line_thermal = all(k.gamma0 * k.rho0);
  if constexpr (linear_tension) line_thermal = dilation > 0 ? P{} : line_thermal;
  const P implicit = det + line_thermal * half * theta_det;

  // One division for four: they are slow, and these numbers are all near 1.
  const P ratio_det = ratio * det, norm_implicit = norm * implicit;
  const P inverse_all = 1 / (ratio_det * norm_implicit);
  const P inverse_first = inverse_all * norm_implicit, inverse_second = inverse_all * ratio_det;
  const P inverse_ratio = inverse_first * det, inverse_det = inverse_first * ratio;
  const P inverse_norm = inverse_second * implicit, inverse_implicit = inverse_second * norm;

  const P mu = -dilation * inverse_ratio;
  const P rate_xx = xx_det * inverse_det, rate_yy = yy_det * inverse_det;
  const P rate_xy = Real(0.5) * (xy_det + yx_det) * inverse_det, theta = theta_det * inverse_det;
  const P cosine = (det_square - turn_square) * inverse_norm, sine = (turn + turn) * det * inverse_norm;
  const P cc = cosine * cosine, ss = sine * sine, cs = cosine * sine, cs2 = cs + cs, double_cosine = cc - ss;
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
  const P mean = theta * Real(1.0 / 3.0);
  P rxx = sxx + twice * (rate_xx - mean), ryy = syy + twice * (rate_yy - mean), rxy = sxy + twice * rate_xy;
  P axx{}, ayy{}, axy{};
  if constexpr (back_stress_used) {
    axx = back_stress[0], ayy = back_stress[1], axy = back_stress[2];
    rotate(axx, ayy, axy);
    rxx -= axx, ryy -= ayy, rxy -= axy;
  }
  // q^2 = 3/2 s:s with s_zz = -(s_xx + s_yy)
  const P mises = square_root(3 * (rxx * rxx + ryy * ryy + rxx * ryy + rxy * rxy));
  const P excess = larger(mises - (k.yield_stress + k.isotropic_modulus * f[plastic_strain]), P{});
  const P dp = excess * k.inverse_return;
  const P flow = mises > 0 ? Real(1.5) * dp / mises : P{};
  const P kept = 1 - twice * flow;
  P work;  // mean stress of the return times the increment
  if constexpr (back_stress_used) {
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
  f[plastic_strain] += dp;
  f[plastic_work] += work * specific_volume;

  // sound speed with the pressure of the last step, artificial viscosity
  const P old_pressure = f[Column::pressure];
  const P cold = mu * (k.cold_c + mu * (k.cold_d + mu * k.cold_s));
  const P cold_slope = k.cold_c + mu * (2 * k.cold_d + 3 * mu * k.cold_s);
  const P away = 1 + Real(0.5) * k.gamma0 * dilation, ratio_square = ratio * ratio;
  P bulk_square =
      (cold_slope * away + k.gamma0 * ratio_square * (old_pressure - Real(0.5) * cold)) * k.inverse_rho0;
  bulk_square = larger(bulk_square, all(k.least_sound_square));
  P line_cold = cold * away;
  if constexpr (linear_tension) {
    line_cold = mu < 0 ? k.cold_c * mu : line_cold;
    bulk_square = mu < 0 ? all(k.cold_c * k.inverse_rho0) : bulk_square;
  }
  const P bulk_sound = square_root(bulk_square);
  const P closing = smaller(theta * (inverse_dt * k.viscous_length), P{});  // h theta of compression [m/s]
  const P viscous = closing < 0 ? k.linear_viscosity * bulk_sound - k.quadratic_viscosity * closing : P{};
  const P density = k.rho0 * (1 + mu);
  const P q = -(density * closing) * viscous;

  // pressure at the end of the step, implicit in the energy
  const P power = (sxx * rate_xx + syy * rate_yy + 2 * (sxy * rate_xy)) - q * theta;
  const P energy_end = f[energy] + half * power;
  P held = (line_cold + line_thermal * energy_end) * (det * inverse_implicit);
  held = larger(held, all(k.pressure_floor));
  f[Column::pressure] = held;
  f[viscous_pressure] = q;

  const P longitudinal = bulk_square + (Real(4.0 / 3.0) * k.shear_modulus) * specific_volume;
  const P speed = larger(magnitude(f[velocity_x]), magnitude(f[velocity_y]));
  // The signal is speed + viscous + sqrt(root); the root is taken only where it may raise the largest.
  const P root = viscous * viscous + longitudinal, rest = extremes.signal - (speed + viscous);
  const auto record = (root > rest * rest) | (rest < 0);
  if (__builtin_expect(any(record), 0))
    extremes.signal = larger(extremes.signal, speed + viscous + square_root(root));
  const Real infinite = __builtin_inf();
  extremes.broken |= ~((root + speed < infinite) & (magnitude(held) < infinite));
  extremes.pressure = larger(extremes.pressure, held);
  extremes.low_dilation = smaller(extremes.low_dilation, dilation);
  extremes.high_dilation = larger(extremes.high_dilation, dilation);
}

}  // namespace mpm::fast::MPM_ISA
