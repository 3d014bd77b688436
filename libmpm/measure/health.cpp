#include "libmpm/measure/health.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <sstream>

#include "libmpm/material/model.hpp"
#include "libmpm/measure/energy.hpp"

namespace mpm {
namespace {

constexpr ResultRow rows[] = {
    {.name = "overstrained_mass_fraction",
     .unit = "1",
     .meaning = "largest share of the mass whose rho0/rho was below 1/4 or at 10 at one time; what has "
                "expanded tenfold keeps its volume",
     .has_interval = false,
     .lower = 0,
     .upper = 1},
    {.name = "smallest_density_ratio",
     .unit = "1",
     .meaning = "rho/rho0 of a particle, smallest over the run; 0.1 at least",
     .has_interval = false,
     .lower = 0},
    {.name = "largest_density_ratio",
     .unit = "1",
     .meaning = "rho/rho0 of a particle, largest over the run",
     .has_interval = false,
     .lower = 0},
    {.name = "largest_cfl",
     .unit = "1",
     .meaning = "largest CFL number of a step, time step x fastest signal / cell, the signal as it was after "
                "the step",
     .has_interval = false,
     .lower = 0},
};

constexpr double most_beyond = 0.01;             // of the mass, beyond the equation of state
constexpr double crushed = -0.95;                // J - 1 that no particle may have but of an ideal gas
constexpr double largest_kinetic_growth = 0.01;  // beyond all the energy there is
constexpr double largest_energy_error = 0.01;
constexpr double largest_cfl = 1;
constexpr double largest_signal_growth = 100;

template <int axes>
bool is_finite(const BasicParticles<axes>& ps, std::size_t p) {
  return ps.position[p].allFinite() && ps.velocity[p].allFinite() && std::isfinite(ps.dilation[p]) &&
         std::isfinite(ps.pressure[p]) && std::isfinite(ps.energy[p]);
}

/// From x to the nearest open face [m].
template <int axes>
double way_to_open_face(const BasicState<axes>& s, const Vec<axes>& x) {
  const auto& grid = s.grid;
  const Vec<axes> from = x - grid.origin();
  double way = std::numeric_limits<double>::infinity();
  const auto look = [&](bool open, double to) { way = open ? std::min(way, to) : way; };
  look(s.floor == Floor::open, from.y());
  look(s.open.left, from.x());
  look(s.open.right, grid.columns() * grid.cell().x() - from.x());
  if constexpr (axes == 3) {
    look(s.open.front, from.z());
    look(s.open.back, grid.slices() * grid.cell().z() - from.z());
  }
  return way;
}

/// The particle that stands out in what is wrong.
template <int axes>
std::size_t worst_particle(typename BasicHealth<axes>::Trouble trouble, const BasicState<axes>& s) {
  using Trouble = typename BasicHealth<axes>::Trouble;
  const auto& ps = s.particles;
  const auto badness = [&](std::size_t p) {
    switch (trouble) {
      case Trouble::not_finite:
        return is_finite(ps, p) ? (s.grid.holds(ps.position[p]) ? 0.0 : 1.0) : 2.0;
      case Trouble::density:  // by how much it is beyond its end of the range
        return std::max(ps.dilation[p] / most_dilation, ps.dilation[p] / least_dilation);
      case Trouble::pressure:
        return ps.pressure[p];
      case Trouble::open_face:
        return -way_to_open_face(s, ps.position[p]);
      default:
        return ps.velocity[p].squaredNorm();
    }
  };
  std::size_t worst = 0;
  double most = badness(0);
  for (std::size_t p = 1; p < ps.size(); ++p)
    if (const double b = badness(p); b > most) most = b, worst = p;
  return worst;
}

template <class Trouble>
std::string_view advice(Trouble trouble) {
  switch (trouble) {
    case Trouble::pressure:
      return "beyond pressure_limit the equation of state means nothing: lower the speed, or take a material "
             "that is valid further";
    case Trouble::density:
      return "try a smaller cfl, a smaller cell_size, or tension = \"cutoff\" where the material is torn";
    case Trouble::open_face:
      return "make the box larger on that side, or the run shorter";
    default:
      return "try a smaller cfl, or a larger linear_viscosity";
  }
}

}  // namespace

template <int axes>
std::span<const ResultRow> BasicHealth<axes>::results() {
  return rows;
}

template <int axes>
BasicHealth<axes>::BasicHealth(const Scene& scene, const State& s, double speed)
    : initial_energy_(energy_of(s.particles).total()),
      mass_(std::accumulate(s.particles.mass.begin(), s.particles.mass.end(), 0.0)),
      pressure_limit_(largest_of(scene, [](const Material& m) { return m.pressure_limit; })),
      cell_(s.grid.cell().minCoeff()),
      least_dilation_(largest_of(scene, [](const Material& m) { return m.is_ideal_gas() ? 1.0 : 0.0; }) > 0
                          ? -1
                          : crushed),
      largest_signal_(largest_signal_growth * (largest_of(scene, sound_speed_at_rest) + speed)),
      loads_(Loads::of(s)) {}

template <int axes>
void BasicHealth<axes>::after_step(const State&, const StepReport& report, double dt) {
  overstrained_mass_ = std::max(overstrained_mass_, report.overstrained_mass);
  last_ = report;
  loads_.add(report);
  last_cfl_ = dt * report.largest_signal / cell_;
  largest_cfl_ = std::max(largest_cfl_, last_cfl_);
  smallest_dilation_ = std::min(smallest_dilation_, report.smallest_dilation);
  largest_dilation_ = std::max(largest_dilation_, report.largest_dilation);
}

template <int axes>
typename BasicHealth<axes>::Trouble BasicHealth<axes>::trouble(double energy_error) const {
  if (!std::isfinite(last_.largest_signal)) return Trouble::not_finite;
  if (last_.at_open_face) return Trouble::open_face;
  if (last_.smallest_dilation < least_dilation_ || last_.overstrained_mass > most_beyond * mass_)
    return Trouble::density;
  if (last_.overpressed_mass > most_beyond * mass_) return Trouble::pressure;
  if (last_.largest_signal > largest_signal_) return Trouble::signal;
  if (last_cfl_ > largest_cfl) return Trouble::time_step;
  if (last_.kinetic_energy > (1 + largest_kinetic_growth) * (initial_energy_ + loads_.gross_work))
    return Trouble::growth;
  if (!(energy_error < largest_energy_error)) return Trouble::energy;
  return Trouble::none;
}

template <int axes>
std::string BasicHealth<axes>::describe(Trouble trouble, const State& s, double energy_error) const {
  std::ostringstream text;
  const char* const unit = axes == 2 ? " J/m" : " J";
  switch (trouble) {
    case Trouble::none:
      return {};
    case Trouble::not_finite:
      text << "a particle's state is not finite, or a particle left the grid";
      break;
    case Trouble::open_face:
      text << "a body has reached an open face of the box";
      break;
    case Trouble::density:
      text << "density left its range: rho0/rho from " << 1 + last_.smallest_dilation << " to "
           << 1 + last_.largest_dilation << ", " << 100 * last_.overstrained_mass / mass_
           << " % of the mass below " << 1 + least_dilation << " or at " << 1 + most_dilation << "; allowed "
           << 100 * most_beyond << " %, and no particle below " << 1 + least_dilation_;
      break;
    case Trouble::pressure:
      text << 100 * last_.overpressed_mass / mass_
           << " % of the mass is beyond the equation of state, pressure_limit = " << pressure_limit_
           << " Pa; allowed " << 100 * most_beyond << " %";
      break;
    case Trouble::signal:
      text << "the fastest signal is " << last_.largest_signal << " m/s, allowed " << largest_signal_
           << " m/s: steps become too small to go on";
      break;
    case Trouble::time_step:
      text << "the time step was too long: CFL number " << last_cfl_ << ", allowed " << largest_cfl;
      break;
    case Trouble::growth:
      text << "the motion grows by itself: kinetic energy " << last_.kinetic_energy << unit << ", of "
           << initial_energy_ + loads_.gross_work << unit << " that there were in all";
      break;
    case Trouble::energy:
      text << "energy error " << energy_error << ", allowed " << largest_energy_error;
      break;
  }
  const auto& ps = s.particles;
  const std::size_t p = worst_particle(trouble, s);
  text << " (step " << s.step << ", t = " << s.time << " s; particle " << p << " at ";
  for (int k = 0; k < axes; ++k) text << "xyz"[k] << " = " << ps.position[p][k] << " m, ";
  text << "velocity ";
  for (int k = 0; k < axes; ++k) text << ps.velocity[p][k] << (k + 1 < axes ? ", " : " m/s");
  text << ", rho0/rho " << 1 + ps.dilation[p] << ", pressure " << ps.pressure[p] << " Pa, specific energy "
       << ps.energy[p] << " J/kg); " << advice(trouble);
  return text.str();
}

template <int axes>
void BasicHealth<axes>::finish(const State&, RunResult& result) const {
  result.metrics.push_back(metric(row_of(rows, "smallest_density_ratio"), 1 / (1 + largest_dilation_)));
  result.metrics.push_back(metric(row_of(rows, "largest_density_ratio"), 1 / (1 + smallest_dilation_)));
  result.metrics.push_back(metric(row_of(rows, "overstrained_mass_fraction"), overstrained_mass_ / mass_));
  result.metrics.push_back(metric(row_of(rows, "largest_cfl"), largest_cfl_));
}

template <int axes>
void BasicHealth<axes>::carry(Archive& a) {
  a.number("largest_cfl", largest_cfl_), a.number("overstrained_mass", overstrained_mass_);
  a.number("smallest_dilation", smallest_dilation_), a.number("largest_dilation", largest_dilation_);
  loads_.carry(a);
}

template class BasicHealth<2>;
template class BasicHealth<3>;

}  // namespace mpm
