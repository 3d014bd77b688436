#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "libmpm/verification/exact/hugoniot.hpp"
#include "libmpm/verification/exact/root.hpp"
#include "libmpm/verification/exact/uniaxial_strain.hpp"
#include "libmpm/verification/problems/material_point.hpp"
#include "libmpm/verification/problems/problems.hpp"
#include "libmpm/verification/problems/scenes.hpp"

namespace mpm::verification {
namespace {

const mpm::Material aluminium = mpm::named_material("aluminium");

/// Hardens as much as it yields within the strains here, so that its kind shows.
mpm::Material hard(double kinematic_fraction) {
  mpm::Material m = aluminium;
  m.hardening_measure = mpm::HardeningMeasure::equivalent;
  m.hardening_modulus = 10e9;
  m.kinematic_fraction = kinematic_fraction;
  return m;
}

/// The speeds of hugoniot.csv.
std::vector<double> hugoniot_speeds() {
  std::vector<double> all = {20, 50, 1120};
  for (int speed = 100; speed <= 3000; speed += 100) all.push_back(speed);
  return all;
}

/// Compression to 0.18, release into tension and again, in strain ln(rho/rho0): the largest differences of
/// the two descriptions on the way, over the largest values.
struct PathErrors {
  double stress = 0, von_mises = 0, plastic_strain = 0, energy = 0;
};
PathErrors walk(const mpm::Material& m) {
  MaterialPoint ours(m);
  exact::UniaxialStrain exact(scenes::exact_solid(m), m.kinematic_fraction);
  PathErrors worst;
  struct Largest {
    double difference = 0, value = 0;
    void add(double ours, double exact) {
      difference = std::max(difference, std::abs(ours - exact));
      value = std::max(value, std::abs(exact));
    }
    double error() const { return difference / value; }
  } stress, von_mises, plastic_strain, energy;
  for (const double end : {0.18, -0.02, 0.1, 0.0}) {
    constexpr int looks = 200, steps = 20;
    const double from = exact.strain();
    for (int k = 1; k <= looks; ++k) {
      const double strain = from + (end - from) * k / looks;
      exact.strain_to(strain);
      ours.strain_to(strain, steps);
      stress.add(ours.normal_stress(), exact.normal_stress());
      von_mises.add(ours.von_mises(), exact.von_mises());
      plastic_strain.add(ours.plastic_strain(), exact.plastic_strain());
      energy.add(ours.specific_energy(), exact.specific_energy());
    }
  }
  return {stress.error(), von_mises.error(), plastic_strain.error(), energy.error()};
}

/// From compression to 0.05 back: by how much q falls until the line of the elastic way meets that of the
/// flow.
double reverse_yield(const mpm::Material& m) {
  MaterialPoint point(m);
  point.strain_to(0.05, 500);
  constexpr double step = 1e-4;
  const double loaded = point.plastic_strain(), from = point.von_mises(), strain = point.strain();
  point.strain_to(strain - step, 1);
  const double elastic = (from - point.von_mises()) / step;
  while (point.plastic_strain() == loaded) point.strain_to(point.strain() - step, 1);
  point.strain_to(point.strain() - step, 1);
  const double q = point.von_mises(), at = strain - point.strain();
  point.strain_to(point.strain() - step, 1);
  const double flow = (q - point.von_mises()) / step;
  return elastic * (from - q - flow * at) / (elastic - flow);
}

}  // namespace

ExactNumbers hugoniot_numbers(const ExactOptions&) {
  const exact::MieGruneisenFluid fluid = scenes::exact_solid(aluminium).fluid;
  double pressure = 0, speed = 0, density = 0, temperature = 0;
  for (const double up : hugoniot_speeds()) {
    const MaterialHugoniot ours = material_hugoniot(aluminium, up);
    const exact::HugoniotState exact = exact::hugoniot(fluid, up);
    pressure = std::max(pressure, std::abs(ours.pressure / exact.pressure - 1));
    speed = std::max(speed, std::abs(ours.shock_speed / exact.shock_speed - 1));
    density = std::max(density, std::abs(ours.density / exact.density - 1));
    temperature = std::max(temperature, std::abs(ours.temperature / exact.temperature - 1));
  }
  const MaterialHugoniot ours = material_hugoniot(aluminium, 1120);
  const exact::HugoniotState exact = exact::hugoniot(fluid, 1120);
  constexpr double tolerance = 1e-6;  // of the temperature's quadrature, 1e-7; the rest is exact
  return {{"pressure at 1120 m/s", "Pa", exact.pressure, ours.pressure, tolerance},
          {"shock speed at 1120 m/s", "m/s", exact.shock_speed, ours.shock_speed, tolerance},
          {"temperature at 1120 m/s", "K", exact.temperature, ours.temperature, tolerance},
          {"pressure, worst of 33 speeds", "1", 0, pressure, tolerance, Judged::absolute},
          {"shock speed, worst of 33 speeds", "1", 0, speed, tolerance, Judged::absolute},
          {"density, worst of 33 speeds", "1", 0, density, tolerance, Judged::absolute},
          {"temperature, worst of 33 speeds", "1", 0, temperature, tolerance, Judged::absolute}};
}

ExactNumbers uniaxial_path_numbers(const ExactOptions&) {
  exact::UniaxialStrain exact(scenes::exact_solid(aluminium));
  exact.strain_to(0.18);
  MaterialPoint ours(aluminium);
  ours.strain_to(0.18, 4000);
  constexpr double tolerance = 1e-7;  // of 4000 steps per leg
  ExactNumbers numbers = {
      {"normal stress at strain 0.18", "Pa", exact.normal_stress(), ours.normal_stress(), tolerance},
      {"von Mises stress at strain 0.18", "Pa", exact.von_mises(), ours.von_mises(), tolerance}};
  struct Case {
    const char* name;
    mpm::Material material;
  };
  for (const Case& c :
       {Case{"aluminium", aluminium}, Case{"kinematic 0.5", hard(0.5)}, Case{"kinematic 1", hard(1)}}) {
    const PathErrors worst = walk(c.material);
    const auto add = [&](const char* what, double value) {
      numbers.push_back(
          {std::string(what) + " on the path, " + c.name, "1", 0, value, tolerance, Judged::absolute});
    };
    add("normal stress", worst.stress);
    add("von Mises stress", worst.von_mises);
    add("plastic strain", worst.plastic_strain);
    add("energy", worst.energy);
  }
  return numbers;
}

ExactNumbers release_numbers(const ExactOptions&) {
  ExactNumbers numbers;
  const auto solid = scenes::exact_solid(aluminium);
  for (const double speed : {200.0, 1120.0, 3000.0}) {
    const exact::ImpactState shocked = exact::elastic_plastic_impact(solid, speed);
    const exact::SimpleRelease exact = exact::simple_release(solid, shocked);
    MaterialPoint at(aluminium, shocked);
    const double step = at.strain() / 4000;
    const auto after = [&](double part) {
      MaterialPoint next = at;
      next.strain_to(at.strain() - part * step, 1);
      return next;
    };
    while (after(1).normal_stress() > 0) at = after(1);
    at = after(exact::bisect([&](double part) { return -after(part).normal_stress(); }, 0, 1));
    const std::string from = " from " + std::to_string(static_cast<int>(speed)) + " m/s";
    constexpr double tolerance = 1e-6;  // of 4000 steps
    numbers.push_back(
        {"free-surface speed" + from, "m/s", exact.surface_speed, speed + at.wave_speed_change(), tolerance});
    numbers.push_back({"density" + from, "kg/m3", exact.density, at.density(), tolerance});
    numbers.push_back(
        {"plastic strain" + from, "1", exact.equivalent_plastic_strain, at.plastic_strain(), tolerance});
  }
  return numbers;
}

ExactNumbers bauschinger_numbers(const ExactOptions&) {
  ExactNumbers numbers;
  for (const double kinematic : {0.0, 0.5, 1.0}) {
    const mpm::Material m = hard(kinematic);
    exact::UniaxialStrain exact(scenes::exact_solid(m), kinematic);
    exact.strain_to(0.05);
    numbers.push_back({"fall of q to reverse yield, kinematic " + std::string(kinematic == 0   ? "0"
                                                                              : kinematic == 1 ? "1"
                                                                                               : "0.5"),
                       "Pa", exact.elastic_range(), reverse_yield(m), 1e-6});
  }
  return numbers;
}

}  // namespace mpm::verification
