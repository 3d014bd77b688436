// The step of three axes: what it must keep, and that it is the plane step where nothing changes along one
// axis.
#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "libmpm/measure/energy.hpp"
#include "libmpm/scene/build.hpp"
#include "libmpm/shape/bspline2.hpp"
#include "libmpm/shape/bspline3.hpp"
#include "libmpm/shape/gimp.hpp"
#include "libmpm/shape/linear.hpp"
#include "libmpm/step/apic.hpp"
#include "libmpm/step/flip_pic.hpp"
#include "libmpm/step/step.hpp"
#include "libmpm/verification/problems/free_flight.hpp"
#include "tests/libmpm/scenes.hpp"

namespace {

using mpm::Vec2;
using mpm::Vec3;
using Space = mpm::space::ThreeD;
using State3 = mpm::BasicState<3>;

constexpr double cell = 0.2e-6, share = cell / 2;

template <class Shape>
class ThreeDTest : public testing::Test {};
using Shapes = testing::Types<mpm::Linear, mpm::Gimp, mpm::BSpline2, mpm::BSpline3>;
TYPED_TEST_SUITE(ThreeDTest, Shapes);

mpm::Material kinematic_aluminium() {
  mpm::Material m = mpm::named_material("aluminium");
  m.kinematic_fraction = 0.5;
  return m;
}
mpm::MaterialModel model_of(const mpm::Material& m, double viscous = 1) {
  return {m, {0.2 * viscous, 1.5 * viscous, cell}};
}

/// A lattice of nx, ny, nz particles from `low` on, at rest; the grid has `columns` and `slices` of cells.
State3 lattice(Vec3 low, int nx, int ny, int nz, int columns, int slices, double density) {
  State3 s{{}, mpm::BasicGrid<3>(Vec3::Zero(), Vec3::Constant(cell), columns, slices), {}};
  for (int j = 0; j < ny; ++j)
    for (int k = 0; k < nz; ++k)
      for (int i = 0; i < nx; ++i) {
        const double volume = share * share * share;
        s.particles.add(low + share * Vec3(i + 0.5, j + 0.5, k + 0.5), Vec3::Zero(), density * volume, volume,
                        Vec3::Constant(share / 2));
      }
  s.velocity_gradient.assign(s.particles.size(), mpm::Mat3::Zero());
  return s;
}

/// Random velocities and stresses, as in random_state.hpp.
State3 random_block(double lift, double density) {
  State3 s = lattice({0, lift, 0}, 8, 10, 6, 4, 3, density);
  std::mt19937 generator(7);
  const auto random = [&] { return generator() / 2147483648.0 - 1; };
  for (std::size_t p = 0; p < s.particles.size(); ++p) {
    s.particles.velocity[p] = 1000 * Vec3(random(), random(), random());
    s.particles.pressure[p] = 5e9 * random();
    const double xx = 1e8 * random(), yy = 1e8 * random();
    s.particles.deviator[p] = {xx, yy, -(xx + yy), 1e8 * random(), 1e8 * random(), 1e8 * random()};
    s.particles.energy[p] = 1e5 * random();
  }
  return s;
}

double kinetic_energy(const State3& s) {
  double sum = 0;
  for (std::size_t p = 0; p < s.particles.size(); ++p) sum += s.particles.kinetic_energy(p);
  return sum;
}
double total_energy(const State3& s) {
  double sum = kinetic_energy(s);
  for (std::size_t p = 0; p < s.particles.size(); ++p) sum += s.particles.mass[p] * s.particles.energy[p];
  return sum;
}
Vec3 momentum(const State3& s) { return mpm::momentum_of(s.particles); }

template <class Use>
void each_transfer(const Use& use) {
  use(mpm::Flip{}, "flip"), use(mpm::FlipPic{0.3}, "pic"), use(mpm::Apic{}, "apic");
}

TYPED_TEST(ThreeDTest, P2gKeepsMassAndMomentumAndItsForcesAddUpToZero) {
  State3 s = random_block(1e-6, 2700);
  s.grid.grow_to_row(16);
  mpm::p2g<TypeParam, mpm::Flip, Space>(s.particles, s.grid);
  double mass = 0, particle_mass = 0, force_scale = 0;
  Vec3 sum = Vec3::Zero(), force = Vec3::Zero();
  for (const auto& n : s.grid.nodes()) {
    mass += n.mass, sum += n.velocity, force += n.acceleration;
    force_scale += n.acceleration.norm();
  }
  for (const double m : s.particles.mass) particle_mass += m;
  EXPECT_NEAR(mass / particle_mass, 1, 1e-13);
  EXPECT_LT((sum - momentum(s)).norm(), 1e-13 * particle_mass * 1000);
  EXPECT_LT(force.norm(), 1e-13 * force_scale);
}

// Against the wall and far from it, in a corner of mirrors, with viscosity and plastic flow.
TYPED_TEST(ThreeDTest, KeepsEnergyAndBalancesMomentum) {
  const mpm::MaterialModel material = model_of(kinematic_aluminium());
  for (const double lift : {0.0, 0.13e-6, 1e-6})
    for (const mpm::Floor floor : {mpm::Floor::impact_wall, mpm::Floor::mirror})
      each_transfer([&](const auto& transfer, const char* name) {
        SCOPED_TRACE(testing::Message() << name << " lift " << lift);
        State3 s = random_block(lift, material.material.reference_density);
        s.floor = floor;
        const double energy = total_energy(s), kinetic = kinetic_energy(s);
        const Vec3 before = momentum(s);
        double scale = 0;
        for (std::size_t p = 0; p < s.particles.size(); ++p)
          scale += s.particles.mass[p] * s.particles.velocity[p].norm();
        Vec3 impulse = Vec3::Zero();
        double transfer_heat = 0;
        for (int k = 0; k < 3; ++k) {
          const auto report = mpm::reference_step<TypeParam, std::decay_t<decltype(transfer)>, Space>(
              s, material, 3e-12, transfer);
          ASSERT_TRUE(std::isfinite(report.largest_signal));
          impulse += report.wall_impulse, transfer_heat += report.transfer_heat;
          EXPECT_NEAR(report.kinetic_energy / kinetic_energy(s), 1, 1e-14);
        }
        EXPECT_GT(transfer_heat, 0);
        EXPECT_NEAR((total_energy(s) - energy) / kinetic, 0, 1e-13);
        const Vec3 unaccounted = momentum(s) - before - impulse;
        // mirrors take more than the acceleration from what PIC and APIC bring: the impact wall does not
        if (std::string_view(name) == "flip") {
          EXPECT_LT(unaccounted.norm(), 1e-13 * scale);
        }
        if (floor == mpm::Floor::impact_wall) {
          EXPECT_NEAR(unaccounted.y() / scale, 0, 1e-14);
        }
        if (floor == mpm::Floor::impact_wall && lift == 1e-6) {  // nothing touches along y
          EXPECT_NEAR((momentum(s) - before).y() / scale, 0, 1e-14);
        }
        EXPECT_GT(*std::ranges::max_element(s.particles.own_values("plastic_strain")), 0);
      });
}

// FLIP gains and loses angular momentum by quadrature, APIC does not.
TEST(ThreeD, ApicKeepsMomentumAndAngularMomentum) {
  const auto affine = mpm::verification::fly_freely(mpm::Transfer::apic);
  EXPECT_LT(affine.momentum_error, 1e-13);
  EXPECT_LT(affine.angular_momentum_error, 1e-12);
  const auto flip = mpm::verification::fly_freely(mpm::Transfer::flip);
  EXPECT_LT(flip.momentum_error, 1e-13);
  EXPECT_GT(flip.angular_momentum_error, 1e-6);
}

template <int axes>
std::span<const double> own(const mpm::BasicParticles<axes>& ps, const char* name) {
  return ps.own_values(name);
}

template <int axes>
std::vector<mpm::Tensor<axes>> back_stress(const mpm::BasicParticles<axes>& ps) {
  constexpr std::size_t each = axes == 2 ? 3 : 5;
  const auto numbers = ps.own_values("back_stress");
  std::vector<mpm::Tensor<axes>> all;
  for (std::size_t p = 0; p < ps.size(); ++p) {
    const double* n = &numbers[each * p];
    if constexpr (axes == 2)
      all.push_back({n[0], n[1], -(n[0] + n[1]), n[2]});
    else
      all.push_back({n[0], n[1], -(n[0] + n[1]), n[2], n[3], n[4]});
  }
  return all;
}

/// The largest difference of a plane state and its extrusion, relative to the largest value of each column.
/// Plane x is the axis `across` of three axes.
double difference(const mpm::State& plane, const State3& s, int across, int depth) {
  double most = 0;
  const auto compare = [&](const auto& of_plane, const auto& of_three) {
    double scale = 0, off = 0;
    for (std::size_t q = 0; q < plane.particles.size(); ++q)
      for (int k = 0; k < depth; ++k) {
        const double a = of_plane(q), b = of_three(q * static_cast<std::size_t>(depth) + k);
        scale = std::max(scale, std::abs(a)), off = std::max(off, std::abs(a - b));
      }
    most = std::max(most, off / scale);
  };
  const auto& a = plane.particles;
  const auto& b = s.particles;
  const auto axis = [&](int k) { return k == 0 ? across : k; };
  for (int k = 0; k < 2; ++k) {
    compare([&](std::size_t p) { return a.position[p][k]; },
            [&](std::size_t p) { return b.position[p][axis(k)]; });
    compare([&](std::size_t p) { return a.velocity[p][k]; },
            [&](std::size_t p) { return b.velocity[p][axis(k)]; });
    for (int l = 0; l < 2; ++l)
      compare([&](std::size_t p) { return plane.velocity_gradient[p](k, l); },
              [&](std::size_t p) { return s.velocity_gradient[p](axis(k), axis(l)); });
  }
  const auto column = [&](std::span<const double> x, std::span<const double> y) {
    compare([&](std::size_t p) { return x[p]; }, [&](std::size_t p) { return y[p]; });
  };
  column(a.dilation, b.dilation), column(a.energy, b.energy), column(a.pressure, b.pressure);
  column(a.viscous_pressure, b.viscous_pressure), column(own(a, "plastic_strain"), own(b, "plastic_strain"));
  column(own(a, "plastic_work"), own(b, "plastic_work"));
  const auto back_a = back_stress(a);
  const auto back_b = back_stress(b);
  for (const auto& [x, y] : {std::pair(&a.deviator, &b.deviator), std::pair(&back_a, &back_b)}) {
    compare([&, t = x](std::size_t p) { return (*t)[p].yy; },
            [&, t = y](std::size_t p) { return (*t)[p].yy; });
    compare([&, t = x](std::size_t p) { return (*t)[p].xx; },
            [&, t = y](std::size_t p) { return across == 0 ? (*t)[p].xx : (*t)[p].zz; });
    compare([&, t = x](std::size_t p) { return (*t)[p].zz; },
            [&, t = y](std::size_t p) { return across == 0 ? (*t)[p].zz : (*t)[p].xx; });
    compare([&, t = x](std::size_t p) { return (*t)[p].xy; },
            [&, t = y](std::size_t p) { return across == 0 ? (*t)[p].xy : (*t)[p].yz; });
  }
  return most;
}

// What does not change along z, between mirrors, is plane strain; and so is what does not change along x.
TYPED_TEST(ThreeDTest, AnExtrusionIsPlaneStrain) {
  constexpr int nx = 8, ny = 10, depth = 6;
  const mpm::MaterialModel material = model_of(kinematic_aluminium());
  for (const int across : {0, 2})
    for (const double lift : {0.0, 0.13e-6})
      each_transfer([&](const auto& transfer, const char* name) {
        using Transfer = std::decay_t<decltype(transfer)>;
        SCOPED_TRACE(testing::Message() << name << " lift " << lift << " across " << across);
        mpm::State plane{{}, mpm::Grid({0, 0}, {cell, cell}, nx / 2), {}};
        State3 s{{},
                 mpm::BasicGrid<3>(Vec3::Zero(), Vec3::Constant(cell), across == 0 ? nx / 2 : depth / 2,
                                   across == 0 ? depth / 2 : nx / 2),
                 {}};
        const auto turned = [&](double x, double y, double z) {
          return across == 0 ? Vec3(x, y, z) : Vec3(z, y, x);
        };
        std::mt19937 generator(7);
        const auto random = [&] { return generator() / 2147483648.0 - 1; };
        for (int j = 0; j < ny; ++j)
          for (int i = 0; i < nx; ++i) {
            const Vec2 x(share * (i + 0.5), lift + share * (j + 0.5)), v = 300 * Vec2(random(), random() - 1);
            plane.particles.add(x, v, material.material.reference_density * share * share, share * share,
                                Vec2::Constant(share / 2));
            const double volume = share * share * share;
            for (int k = 0; k < depth; ++k)
              s.particles.add(turned(x.x(), x.y(), share * (k + 0.5)), turned(v.x(), v.y(), 0),
                              material.material.reference_density * volume, volume,
                              Vec3::Constant(share / 2));
          }
        plane.velocity_gradient.assign(plane.particles.size(), mpm::Mat2::Zero());
        s.velocity_gradient.assign(s.particles.size(), mpm::Mat3::Zero());
        for (int k = 0; k < 10; ++k) {
          const auto a = mpm::reference_step<TypeParam>(plane, material, 4e-12, transfer);
          const auto b = mpm::reference_step<TypeParam, Transfer, Space>(s, material, 4e-12, transfer);
          const double thickness = share * depth;
          EXPECT_NEAR(b.kinetic_energy / (a.kinetic_energy * thickness), 1, 1e-12);
          EXPECT_NEAR(b.transfer_heat / (a.transfer_heat * thickness), 1, 1e-10);
          EXPECT_NEAR(b.largest_signal / a.largest_signal, 1, 1e-12);
        }
        EXPECT_GT(*std::ranges::max_element(plane.particles.own_values("plastic_strain")), 1e-3);
        EXPECT_LT(difference(plane, s, across, depth), 1e-10);
      });
}

// Lengths and times larger by a power of two: the same bits.
TYPED_TEST(ThreeDTest, ScalesBitForBit) {
  constexpr double k = 1024;
  const mpm::Material m = kinematic_aluminium();
  mpm::MaterialModel small = model_of(m), large = small;
  large.viscosity.length *= k;
  State3 a = random_block(0, m.reference_density), b = a;
  auto& ps = b.particles;
  b.grid = mpm::BasicGrid<3>(Vec3::Zero(), Vec3::Constant(k * cell), a.grid.columns(), a.grid.slices());
  for (std::size_t p = 0; p < ps.size(); ++p) {
    ps.position[p] *= k, ps.half_size[p] *= k;
    ps.mass[p] *= k * k * k, ps.initial_volume[p] *= k * k * k;
  }
  for (int step = 0; step < 3; ++step) {
    mpm::reference_step<TypeParam, mpm::Apic, Space>(a, small, 3e-12);
    mpm::reference_step<TypeParam, mpm::Apic, Space>(b, large, k * 3e-12);
  }
  for (std::size_t p = 0; p < ps.size(); ++p) {
    EXPECT_EQ(ps.position[p], k * a.particles.position[p]);
    EXPECT_EQ(ps.velocity[p], a.particles.velocity[p]);
    EXPECT_EQ(k * ps.affine[p], a.particles.affine[p]);
    EXPECT_EQ(ps.energy[p], a.particles.energy[p]);
    EXPECT_EQ(ps.pressure[p], a.particles.pressure[p]);
    EXPECT_EQ(ps.deviator[p].yz, a.particles.deviator[p].yz);
  }
}

// A particle outside of the grid along any axis, or nowhere: nothing is written, and the signal says so.
TEST(ThreeD, AParticleOutsideOfTheGridIsSaid) {
  const mpm::MaterialModel material = model_of(mpm::named_material("aluminium"));
  const State3 good = random_block(0, material.material.reference_density);
  for (const Vec3& x : {Vec3(-0.2e-6, 0, 0), Vec3(1e-6, 0, 0), Vec3(0, -0.2e-6, 0), Vec3(0, 0, -0.2e-6),
                        Vec3(0, 0, 0.8e-6), Vec3(0, 0, std::nan(""))}) {
    State3 s = good;
    s.particles.position[5] = x;
    EXPECT_TRUE(
        std::isnan(mpm::reference_step<mpm::BSpline2, mpm::Flip, Space>(s, material, 1e-12).largest_signal));
    EXPECT_EQ(s.step, 0);
  }
}

/// A standing wave of small amplitude in an elastic cube of edge 1 between six smooth mirrors, an exact mode
/// of linear elasticity: with c_i = cos(pi x_i), s_i = sin(pi x_i) and the amplitudes a_i of the
/// displacements
///   u = (a_x s_x c_y c_z, a_y c_x s_y c_z, a_z c_x c_y s_z) sin(omega t).
/// a parallel to (1, 1, 1): pressure wave, omega = c_p pi sqrt(3); a . (1, 1, 1) = 0: shear wave, with c_s.
/// Error of the displacement over a quarter of a period, relative to the amplitude.
template <class Shape>
double wave_error(int cells, const Vec3& a, bool shear) {
  constexpr double amplitude = 1e-5, pi = 3.14159265358979323846;
  mpm::Material m = mpm::named_material("aluminium");
  m.yield_stress = std::numeric_limits<double>::infinity();
  const mpm::MaterialModel material{m, {0, 0, 1}};
  const double g = m.shear_modulus(), bulk = m.reference_density * m.bulk_sound_speed * m.bulk_sound_speed;
  const double pressure_speed = std::sqrt((bulk + 4 * g / 3) / m.reference_density);
  const double omega = pi * std::sqrt(3.0) * (shear ? std::sqrt(g / m.reference_density) : pressure_speed);
  const double h = 1.0 / cells, end = 0.5 * pi / omega;
  const int steps = static_cast<int>(std::ceil(end * pressure_speed / (0.4 * h)));
  const double dt = end / steps;
  const auto mode = [&](const Vec3& x) {
    const Vec3 c(std::cos(pi * x.x()), std::cos(pi * x.y()), std::cos(pi * x.z()));
    const Vec3 s(std::sin(pi * x.x()), std::sin(pi * x.y()), std::sin(pi * x.z()));
    return Vec3(amplitude * Vec3(a.x() * s.x() * c.y() * c.z(), a.y() * c.x() * s.y() * c.z(),
                                 a.z() * c.x() * c.y() * s.z()));
  };
  State3 s{{}, mpm::BasicGrid<3>(Vec3::Zero(), Vec3::Constant(h), cells, cells), {}};
  std::vector<Vec3> initial;
  for (int j = 0; j < 2 * cells; ++j)
    for (int k = 0; k < 2 * cells; ++k)
      for (int i = 0; i < 2 * cells; ++i) {
        const Vec3 x = 0.5 * h * Vec3(i + 0.5, j + 0.5, k + 0.5);
        const double volume = h * h * h / 8;
        // velocities belong to half a step before
        s.particles.add(x, omega * std::cos(-0.5 * omega * dt) * mode(x),
                        material.material.reference_density * volume, volume, Vec3::Constant(h / 4));
        initial.push_back(x);
      }
  s.velocity_gradient.assign(initial.size(), mpm::Mat3::Zero());
  double most = 0;
  for (int step = 1; step <= steps; ++step) {
    s.grid.grow_to_row(cells + 1 + Shape::reach);
    s.grid.clear();
    mpm::p2g<Shape, mpm::Flip, Space>(s.particles, s.grid);
    mpm::reflect_sides(s.grid, cells + Shape::reach);
    mpm::reflect_floor(s.grid);
    mpm::reflect_row(s.grid, cells, s.grid.ghosts);
    mpm::update_grid(s.grid, dt);
    mpm::g2p<Shape, mpm::Flip, Space>(s.particles, s.grid, dt, s.velocity_gradient);
    mpm::BasicStepReport<3> report;
    mpm::update_stress(s, material, dt, report);
    double sum = 0;
    for (std::size_t p = 0; p < initial.size(); ++p)
      sum += (s.particles.position[p] - initial[p] - std::sin(omega * dt * step) * mode(initial[p]))
                 .squaredNorm();
    most = std::max(most, std::sqrt(sum / static_cast<double>(initial.size())) / amplitude);
  }
  return most;
}

TYPED_TEST(ThreeDTest, AnObliqueWaveConvergesAtSecondOrder) {
  for (const bool shear : {false, true}) {
    const Vec3 a = shear ? Vec3(1, -0.4, -0.6) : Vec3(1, 1, 1);
    const double coarse = wave_error<TypeParam>(4, a, shear), fine = wave_error<TypeParam>(8, a, shear);
    EXPECT_GT(std::log2(coarse / fine), 1.8)
        << (shear ? "shear" : "pressure") << ' ' << coarse << ' ' << fine;
    EXPECT_LT(fine, 0.06);
  }
}

}  // namespace
