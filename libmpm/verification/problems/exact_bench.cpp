#include "libmpm/verification/problems/exact_bench.hpp"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <exception>
#include <stdexcept>
#include <thread>

#include "libmpm/core/thread_clock.hpp"
#include "libmpm/verification/problems/problems.hpp"

namespace mpm::verification {
namespace {

template <int Speed>
ExactNumbers planar(const ExactOptions& o) {
  return planar_impact_numbers(Speed, o);
}

/// Rows of verney_cylinder_al.csv.
constexpr double shell_speeds[] = {131.0531, 185.0293, 225.0374, 255.9773};
template <int Row, bool Hardening>
ExactNumbers shell(const ExactOptions& o) {
  return imploding_shell_numbers(shell_speeds[Row], Hardening, o);
}

/// Stop at 0.75, 0.625, 0.5 of the inner radius: closed form.
constexpr double sphere_speeds[] = {234.7, 277.3, 306.9};
template <int Row>
ExactNumbers sphere(const ExactOptions& o) {
  return imploding_sphere_numbers(sphere_speeds[Row], o);
}

template <int Row>
ExactNumbers octant(const ExactOptions& o) {
  return imploding_octant_numbers(sphere_speeds[Row], o);
}

/// Share of the pressure that closes it, in percent.
template <int Percent>
ExactNumbers pressed(const ExactOptions& o) {
  return pressed_cavity_numbers(Percent / 100.0, o);
}

template <mpm::Space Space>
ExactNumbers noh(const ExactOptions& o) {
  return noh_numbers(Space, o);
}
template <mpm::Space Space>
ExactNumbers sedov(const ExactOptions& o) {
  return sedov_numbers(Space, o);
}

template <int Degrees, int PercentOfFriction, bool Turned>
ExactNumbers rolling(const ExactOptions& o) {
  return rolling_numbers(Degrees, PercentOfFriction / 100.0, Turned, o);
}

template <int Speed>
ExactNumbers spheres(const ExactOptions& o) {
  return spheres_numbers(Speed, o);
}

const ExactProblem ladder[] = {
    {"hugoniot", "material point behind a steady shock, 20 to 3000 m/s: jump conditions", hugoniot_numbers},
    {"uniaxial-path", "material point loaded, unloaded and loaded again in uniaxial strain",
     uniaxial_path_numbers},
    {"release", "material point let go from behind a shock to zero stress", release_numbers},
    {"bauschinger", "material point: yield in reverse, isotropic to kinematic hardening",
     bauschinger_numbers},
    {"planar-20", "block on a wall at 20 m/s: two waves, hardly plastic", planar<20>},
    {"planar-200", "block on a wall at 200 m/s: two waves", planar<200>},
    {"planar-1120", "block on a wall at 1120 m/s: overdriven", planar<1120>},
    {"planar-1500", "block on a wall at 1500 m/s: overdriven", planar<1500>},
    {"planar-3000", "block on a wall at 3000 m/s: overdriven", planar<3000>},
    {"surface-history", "free-surface speed over all waves, against a 1D Lagrangian code",
     surface_history_numbers},
    {"shell-131", "imploding shell, 131.1 m/s, perfectly plastic", shell<0, false>},
    {"shell-185", "imploding shell, 185.0 m/s, perfectly plastic", shell<1, false>},
    {"shell-225", "imploding shell, 225.0 m/s, perfectly plastic", shell<2, false>},
    {"shell-255", "imploding shell, 256.0 m/s, perfectly plastic", shell<3, false>},
    {"shell-131-hardening", "imploding shell, 131.1 m/s, H = 470.3 MPa", shell<0, true>},
    {"shell-185-hardening", "imploding shell, 185.0 m/s, H = 470.3 MPa", shell<1, true>},
    {"shell-225-hardening", "imploding shell, 225.0 m/s, H = 470.3 MPa", shell<2, true>},
    {"shell-255-hardening", "imploding shell, 256.0 m/s, H = 470.3 MPa", shell<3, true>},
    {"sphere-234", "imploding sphere in axisymmetry, 234.7 m/s, perfectly plastic", sphere<0>},
    {"sphere-277", "imploding sphere in axisymmetry, 277.3 m/s, perfectly plastic", sphere<1>},
    {"sphere-306", "imploding sphere in axisymmetry, 306.9 m/s, perfectly plastic", sphere<2>},
    {"octant-234", "imploding sphere in three dimensions, 234.7 m/s, perfectly plastic", octant<0>},
    {"octant-277", "imploding sphere in three dimensions, 277.3 m/s, perfectly plastic", octant<1>},
    {"octant-306", "imploding sphere in three dimensions, 306.9 m/s, perfectly plastic", octant<2>},
    {"pressed-cavity-50", "spherical cavity at 0.5 of the pressure that closes it", pressed<50>},
    {"pressed-cavity-80", "spherical cavity at 0.8 of that pressure", pressed<80>},
    {"pressed-cavity-95", "spherical cavity at 0.95 of that pressure: it stays open", pressed<95>},
    {"pressed-cavity-105", "spherical cavity at 1.05 of that pressure: it closes", pressed<105>},
    {"pressed-cavity-150", "spherical cavity at 1.5 of that pressure", pressed<150>},
    {"lagrange-weak", "weak collapse of a cavity, against a Lagrangian code on three meshes",
     lagrange_weak_numbers},
    {"noh-cylinder", "ideal gas that flows to the axis of a cylinder, gamma = 5/3",
     noh<mpm::Space::plane_strain>},
    {"noh-sphere", "ideal gas that flows to the centre of a sphere, in axisymmetry",
     noh<mpm::Space::axisymmetric>},
    {"sedov-cylinder", "explosion along the axis of a cylinder of ideal gas, gamma = 1.4",
     sedov<mpm::Space::plane_strain>},
    {"sedov-sphere", "explosion at a point of ideal gas, in axisymmetry", sedov<mpm::Space::axisymmetric>},
    {"axis-aligned", "manufactured solution at 16 % strain: order of convergence", axis_aligned_numbers},
    {"vortex", "generalised vortex: order of convergence", vortex_numbers},
    {"vibrating-bar", "first mode of a bar fixed at one end", vibrating_bar_numbers},
    {"elastic-disks", "two elastic disks meet, rebound and part", elastic_disks_numbers},
    {"cylinder-waves", "manufactured solution in axisymmetry: order of convergence", cylinder_waves_numbers},
    {"cube-waves", "manufactured solution in three dimensions: order of convergence", cube_waves_numbers},
    {"free-flight", "a cube that turns freely keeps its momentum and its angular momentum",
     free_flight_numbers},
    {"planar-spaces", "block on a wall in axisymmetry and in three dimensions: the wave of plane strain",
     planar_spaces_numbers},
    {"spherical-cavity", "spherical cavity at 200 m/s in three dimensions: as in axisymmetry",
     spherical_cavity_numbers},
    {"scale", "lengths and times 1024 times larger: the same bits", scale_numbers},
    {"half-and-full", "half of a symmetric scene against all of it", half_and_full_numbers},
    {"wall-and-two-bodies", "block on a wall against two blocks that meet", wall_and_two_bodies_numbers},
    {"moving-frame", "two blocks that meet, seen from one of them", moving_frame_numbers},
    {"rolling-stick", "cylinder on an incline of 30 degrees, mu = 0.3: it rolls", rolling<30, 30, false>},
    {"rolling-stick-turned", "the same, the plane across the grid", rolling<30, 30, true>},
    {"rolling-slip", "cylinder on an incline of 45 degrees, mu = 0.2: it slides and turns",
     rolling<45, 20, false>},
    {"rolling-slip-turned", "the same, the plane across the grid", rolling<45, 20, true>},
    {"rolling-frictionless", "cylinder on an incline of 30 degrees across the grid, without friction",
     rolling<30, 0, true>},
    {"spheres-5", "two elastic spheres that meet at 5 m/s: Hertz", spheres<5>},
    {"spheres-20", "two elastic spheres that meet at 20 m/s: Hertz, at the edge of its validity",
     spheres<20>},
    {"taylor-plane", "copper Taylor bar on a rigid plane, by contact", taylor_numbers},
    {"four-spheres-square", "four elastic spheres that meet at the centre of a square", four_spheres_numbers},
    {"contact-shock", "copper on aluminium through contact: match of impedances", contact_shock_numbers},
};

std::vector<const ExactProblem*> wanted(const std::vector<std::string>& names) {
  std::vector<const ExactProblem*> some;
  for (const ExactProblem& p : ladder)
    if (names.empty() || std::ranges::find(names, p.name) != names.end()) some.push_back(&p);
  for (const std::string& name : names)
    if (std::ranges::find(ladder, name, &ExactProblem::name) == std::end(ladder)) {
      std::string allowed;
      for (const ExactProblem& p : ladder) allowed += (allowed.empty() ? "" : ", ") + p.name;
      throw std::invalid_argument("no problem is called " + name + "; there are: " + allowed);
    }
  return some;
}

std::vector<ExactRow> rows_of(const ExactProblem& problem, const ExactOptions& options) {
  const double start = mpm::thread_cpu_seconds();
  ExactNumbers numbers = problem.solve(options);
  const double cpu_s = mpm::thread_cpu_seconds() - start;
  std::vector<ExactRow> rows;
  for (ExactNumber& n : numbers) rows.push_back({&problem, std::move(n), cpu_s});
  return rows;
}

}  // namespace

double ExactNumber::error() const {
  switch (judged) {
    case Judged::relative:
      return std::abs(ours / exact - 1);
    case Judged::absolute:
      return std::abs(ours - exact);
    case Judged::shortfall:
      return std::isnan(ours) ? ours : std::max(exact - ours, 0.0);
  }
  throw std::logic_error("a judgement that is not known");
}

const ExactNumber& number_of(const ExactNumbers& numbers, std::string_view quantity) {
  const auto at = std::ranges::find(numbers, quantity, &ExactNumber::quantity);
  if (at != numbers.end()) return *at;
  std::string there;
  for (const ExactNumber& n : numbers) there += (there.empty() ? "" : ", ") + n.quantity;
  throw std::out_of_range("no number is called " + std::string(quantity) + "; there are: " + there);
}

std::span<const ExactProblem> exact_problems() { return ladder; }

std::vector<ExactRow> bench_exact(const std::vector<std::string>& names, const ExactOptions& options,
                                  unsigned workers) {
  const auto problems = wanted(names);
  std::vector<std::vector<ExactRow>> solved(problems.size());
  std::atomic<std::size_t> next{0};
  std::vector<std::exception_ptr> refused(problems.size());
  std::vector<std::thread> threads;
  for (unsigned t = 0; t < std::max(1u, workers); ++t)
    threads.emplace_back([&] {
      for (std::size_t i; (i = next.fetch_add(1)) < problems.size();) try {
          solved[i] = rows_of(*problems[i], options);
        } catch (...) {  // a scene that the options make impossible
          refused[i] = std::current_exception();
        }
    });
  for (std::thread& t : threads) t.join();
  for (const std::exception_ptr& e : refused)
    if (e) std::rethrow_exception(e);
  std::vector<ExactRow> rows;
  for (auto& some : solved)
    for (ExactRow& row : some) rows.push_back(std::move(row));
  return rows;
}

}  // namespace mpm::verification
