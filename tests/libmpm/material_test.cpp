// The equations of the material, each against an independent statement of it.
#include <gtest/gtest.h>

#include <cmath>

#include "libmpm/material/artificial_viscosity.hpp"
#include "libmpm/material/eos/temperature.hpp"
#include "libmpm/material/list.hpp"
#include "libmpm/material/rows.hpp"
#include "libmpm/material/solid.hpp"

namespace {

using mpm::MieGrueneisen;
using Volume = MieGrueneisen::Volume;

const mpm::Material aluminium = mpm::named_material("aluminium");

// E and nu stand for G of the table and the bulk modulus rho0 c0^2; every constant is there.
TEST(NamedMaterials, HaveTheModuliOfTheirSources) {
  const std::pair<const char*, double> shear_moduli[] = {
      {"aluminium-6061-t6", 27.6e9}, {"copper", 47.7e9},  {"pmma", 2.32e9},
      {"steel-1006", 81.8e9},        {"tungsten", 160e9}, {"tantalum", 69e9}};
  for (const auto& [name, shear] : shear_moduli) {
    const mpm::Material m = mpm::named_material(name);
    EXPECT_EQ(m.name, name);
    EXPECT_NEAR(m.shear_modulus() / shear, 1, 1e-14) << name;
    const double bulk = m.youngs_modulus / (3 * (1 - 2 * m.poissons_ratio));
    EXPECT_NEAR(bulk / (m.reference_density * m.bulk_sound_speed * m.bulk_sound_speed), 1, 1e-14) << name;
  }
  for (const std::string_view name : mpm::material_names()) {
    const mpm::Material m = mpm::named_material(name);
    EXPECT_TRUE(mpm::has_model(m)) << name;
    for (const double constant : {m.specific_heat, m.initial_temperature, m.pressure_limit})
      EXPECT_GT(constant, 0) << name;
    // every constant of the model that the material has
    for (const mpm::MaterialRow& row : mpm::material_rows)
      if (row.range == mpm::Range::positive && (!row.use.holds || row.use.holds(m))) {
        EXPECT_GT(m.*row.value, 0) << name << " " << row.name;
      }
    EXPECT_EQ(m.yield_stress > 0, m.strength != mpm::StrengthModel::none) << name;
  }
  EXPECT_EQ(mpm::named_material("copper-johnson-cook").melting_temperature, 1356);
  EXPECT_EQ(mpm::named_material("copper-johnson-cook").hugoniot_slope,
            mpm::named_material("copper").hugoniot_slope);
  EXPECT_EQ(mpm::named_material("steel-1006").yield_stress, 350e6);
  EXPECT_NEAR(mpm::sound_speed_at_rest(mpm::named_material("water")), std::sqrt(2.35e6), 1e-9);
  EXPECT_THROW(mpm::named_material("lead"), std::out_of_range);
}

TEST(Material, HardeningModulusFollowsItsMeasure) {
  mpm::Material m = aluminium;
  EXPECT_NEAR(m.hardening_per_equivalent_strain(), 470.302e6, 1e3);  // sqrt(3/2) 384 MPa
  m.hardening_measure = mpm::HardeningMeasure::equivalent;
  EXPECT_EQ(m.hardening_per_equivalent_strain(), 384e6);
  m.hardening_measure = mpm::HardeningMeasure::tangent;
  EXPECT_NEAR(m.hardening_per_equivalent_strain(), 386.15e6, 1e4);
}

// Jump conditions: with the energy of the Hugoniot, e = P eta / (2 rho0), the form returns P = C mu + D mu^2
// + S mu^3.
TEST(MieGrueneisen, ReturnsItsHugoniot) {
  const MieGrueneisen eos(aluminium);
  for (const double mu : {0.004, 0.04, 0.2, 0.5}) {
    const double hugoniot = mu * (77.28075e9 + mu * (129.83166e9 + mu * 79.351874e9));
    const double dilation = 1 / (1 + mu) - 1;
    const double energy = -hugoniot * dilation / (2 * 2700);
    EXPECT_NEAR(eos.pressure(Volume(dilation), energy) / hugoniot, 1, 1e-7) << mu;
  }
}

TEST(MieGrueneisen, SoundSpeedIsTheSlopeOfTheIsentrope) {
  const MieGrueneisen eos(aluminium);
  for (const double dilation : {-0.3, -0.05, 0.0, 0.05}) {
    const double energy = 3e5, p = eos.pressure(Volume(dilation), energy);
    const double d = 1e-6;  // of J; along the isentrope de = -P dV
    const double de = -p * d / 2700;
    const double slope =
        (eos.pressure(Volume(dilation + d), energy + de) - eos.pressure(Volume(dilation - d), energy - de)) /
        (2 * d);
    const double square = -slope * (1 + dilation) * (1 + dilation) / 2700;
    EXPECT_NEAR(eos.sound_speed_squared(Volume(dilation), p) / square, 1, 1e-7) << dilation;
  }
  EXPECT_NEAR(std::sqrt(eos.sound_speed_squared(Volume(0), 0)), 5350, 1e-6);
}

TEST(MieGrueneisen, TensionModels) {
  mpm::Material m = aluminium;
  const Volume expanded(0.02);
  const double polynomial = MieGrueneisen(m).pressure(expanded, 1e4);
  m.tension = mpm::Tension::linear;
  EXPECT_NEAR(MieGrueneisen(m).pressure(expanded, 1e4), -77.28075e9 * 0.02 / 1.02, 1e3);
  m.tension = mpm::Tension::cutoff;
  m.spall_strength = 1e9;
  EXPECT_LT(polynomial, -1e9);
  EXPECT_EQ(MieGrueneisen(m).pressure(expanded, 1e4), -1e9);
}

// Temperatures of the Hugoniot, from the reference table (cv = 880 J/kg/K, T0 = 300 K).
TEST(Temperature, MatchesTheHugoniot) {
  const mpm::Temperature temperature(aluminium);
  // particle speed [m/s], density [kg/m^3], temperature [K]
  const double rows[][3] = {{20, 2710.08, 302.196}, {100, 2750.15, 311.01}, {200, 2799.67, 322.424}};
  for (const auto& [up, density, expected] : rows)
    EXPECT_NEAR(temperature(2700 / density - 1, 0.5 * up * up), expected, 2e-3) << up;
  EXPECT_EQ(temperature(0, 0), 300);
}

TEST(ArtificialViscosity, ActsInCompressionOnly) {
  const mpm::ArtificialViscosity q{0.5, 1.5, 1e-7};
  const double dt = 1e-12;
  EXPECT_EQ(q.response(2700.0, dt * 1e9, 1 / dt, 5000.0).pressure, 0);
  EXPECT_DOUBLE_EQ(q.response(2700.0, dt * -1e9, 1 / dt, 5000.0).pressure,
                   2700 * 100 * (0.5 * 5000 + 1.5 * 100));
}

/// Strains a point uniaxially along y in small steps up to the logarithmic strain, from the state given.
template <class Strength>
struct Point {
  mpm::Deviator<double> deviator{};
  double own[mpm::numbers_in(Strength::state, 2)] = {};
  double plastic_strain() const { return own[mpm::own_plastic_strain]; }
  double work() const { return own[mpm::own_plastic_work]; }  // of a volume of 1
  void strain(const mpm::J2& j2, double total, int steps) {
    const mpm::Strain<double> step{{0, total / steps, 0}, {1, 0}, 0, 1};
    for (int k = 0; k < steps; ++k) Strength::update(j2, deviator, own, step, 1.0, 1.0);
  }
};

// Uniaxial strain eps: q = 2 G eps up to Y, then q = Y + H (2 G eps - Y) / (3 G + H).
TEST(J2, UniaxialStrain) {
  const mpm::J2 j2(aluminium);
  const double g = aluminium.shear_modulus(), h = aluminium.hardening_per_equivalent_strain(), y = 120e6;
  for (const double strain : {0.001, 0.0023, 0.01, 0.1}) {
    Point<mpm::IsotropicHardening> p;
    p.strain(j2, -strain, 100);
    const double elastic = 2 * g * strain;
    const double q = elastic < y ? elastic : y + h * (elastic - y) / (3 * g + h);
    EXPECT_NEAR(std::sqrt(3 * mpm::second_invariant(p.deviator)) / q, 1, 1e-10) << strain;
    EXPECT_NEAR(p.deviator.yy / (-2.0 / 3 * q), 1, 1e-10) << strain;  // compression is negative
    const double dp = elastic < y ? 0 : (elastic - y) / (3 * g + h);
    EXPECT_NEAR(p.plastic_strain(), dp, 1e-12);
    EXPECT_NEAR(p.work(), dp * (y + 0.5 * h * dp), 1e-9 * y);
  }
}

// Bauschinger: after loading to q, reverse flow begins when the stress has moved by twice the yield stress of
// the moment: 2 (Y + H p) if hardening is isotropic, 2 Y if it is kinematic.
TEST(J2, ReverseLoadingShowsTheKinematicShare) {
  for (const double fraction : {0.0, 0.5, 1.0}) {
    mpm::Material m = aluminium;
    m.hardening_modulus = 10e9;
    m.kinematic_fraction = fraction;
    const mpm::J2 j2(m);
    const double g = m.shear_modulus(), h = m.hardening_per_equivalent_strain();
    Point<mpm::KinematicHardening> p;
    p.strain(j2, -0.05, 200);
    const double loaded = p.plastic_strain(), q = 1.5 * -p.deviator.yy;
    EXPECT_NEAR(q / (120e6 + h * loaded), 1, 1e-9);  // loading does not tell them apart
    const double back = 2 * (120e6 + (1 - fraction) * h * loaded) / (2 * g);
    p.strain(j2, 0.999 * back, 50);
    EXPECT_EQ(p.plastic_strain(), loaded) << fraction;
    p.strain(j2, 0.002 * back, 50);
    EXPECT_GT(p.plastic_strain(), loaded) << fraction;
  }
}

TEST(J2, RotationTurnsStressAndDoesNoWork) {
  const mpm::J2 j2(aluminium);
  Point<mpm::IsotropicHardening> p;
  p.deviator = {30e6, -20e6, 15e6};
  const double before = mpm::second_invariant(p.deviator);
  const mpm::Strain<double> quarter_turn{{0, 0, 0}, {0, 1}, 0, 1};
  mpm::IsotropicHardening::update(j2, p.deviator, p.own, quarter_turn, 1.0, 1.0);
  EXPECT_EQ(p.work(), 0);
  EXPECT_NEAR(p.deviator.xx, -20e6, 1e-6);
  EXPECT_NEAR(p.deviator.yy, 30e6, 1e-6);
  EXPECT_NEAR(p.deviator.xy, -15e6, 1e-6);
  EXPECT_NEAR(mpm::second_invariant(p.deviator) / before, 1, 1e-14);
}

/// A rigid rotation by any angle: dt L is made of the half-angle formula, and the deviator turns with it.
TEST(StrainOver, ARigidRotationStrainsNothing) {
  const mpm::Solid<double, mpm::MieGrueneisenEos, mpm::Elastic> solid(mpm::MaterialModel{aluminium, {}});
  const double angle = 0.3, c = std::cos(angle), s = std::sin(angle);
  double dilation = 0.1;
  const mpm::Strain<double> e = mpm::strain_over<double>(dilation, {c - 1, -s, s, c - 1}, solid);
  EXPECT_NEAR(dilation, 0.1, 1e-15);
  EXPECT_NEAR(e.compression, 1 / 1.1 - 1, 1e-15);
  EXPECT_NEAR(e.rate.xx, 0, 1e-15);
  EXPECT_NEAR(e.rate.yy, 0, 1e-15);
  EXPECT_NEAR(e.rate.xy, 0, 1e-15);
  EXPECT_NEAR(e.rotation.cosine, c, 1e-15);
  EXPECT_NEAR(e.rotation.sine, s, 1e-15);
  EXPECT_NEAR(e.divisor, 1, 1e-15);
}

}  // namespace
