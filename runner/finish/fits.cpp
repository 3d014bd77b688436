#include "runner/finish/fits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "libmpm/scene/parameters.hpp"
#include "runner/study/parameter_value.hpp"
#include "runner/study/searched.hpp"

namespace mpmstudy {
namespace {

/// Unit of y over a power of x: "1/m^2", "Pa/(m/s)".
std::string unit_over_power(const std::string& y, std::string_view x, std::size_t power) {
  if (power == 0 || x == "1") return y;
  std::string divisor(x);
  if (x.find('/') != std::string_view::npos) divisor = fmt::format("({})", x);
  return power == 1 ? fmt::format("{}/{}", y, divisor) : fmt::format("{}/{}^{}", y, divisor, power);
}

std::string coefficient_unit(const analysis::Fit& fit, const std::string& y, std::string_view x,
                             std::size_t k) {
  if (analysis::is_polynomial(fit.model)) return unit_over_power(y, x, k);
  if (k == 0) return y;
  return fit.model == analysis::FitModel::power ? "1" : unit_over_power("1", x, 1);
}

}  // namespace

bool stands_elsewhere(const Group& group, const std::string& y) {
  return critical_result(y) == CriticalResult::extrapolated &&
         std::ranges::none_of(group.jobs,
                              [](const JobResults* job) { return job->extrapolated.has_value(); });
}

/// A quantity of the scene, or another result of the job. Empty where the job has none.
std::optional<double> abscissa_of(const StudyResults& results, const JobResults& job, const std::string& x) {
  if (const auto quantity = quantity_value(job.scene, x)) return quantity;
  const auto result = result_of(results, job, x);
  return result ? std::optional(result->value) : std::nullopt;
}

Column column_of(const StudyResults& results, const Group& group, const std::string& x,
                 const std::string& y) {
  Column column;
  bool errors = false;
  for (const JobResults* job : group.jobs) {
    const auto measured = result_of(results, *job, y);
    if (!measured) continue;
    const auto place = abscissa_of(results, *job, x);
    if (!place) continue;
    column.x.push_back(*place);
    column.y.push_back(measured->value);
    column.y_error.push_back(measured->error.value_or(0));
    errors |= measured->error.value_or(0) > 0;
  }
  if (!errors) column.y_error.clear();
  return column;
}

analysis::Fit fit_column(const FitRequest& request, const Column& c) {
  const bool weighed =
      !c.y_error.empty() && std::ranges::all_of(c.y_error, [](double error) { return error > 0; });
  return analysis::fit_curve(*analysis::fit_model(request.model), c.x, c.y,
                             weighed ? std::span<const double>(c.y_error) : std::span<const double>());
}

Fits fit_study(const Study& study, const StudyResults& results) {
  Fits fits;
  for (const FitRequest& request : study.fits) {
    const std::string y_unit = unit_of(results, request.y);
    const std::string x_unit = quantity_unit(study, request.x);
    for (const Group& group : group_jobs(study, results, curve_of(study, request.x, request.y))) {
      const Column c = column_of(results, group, request.x, request.y);
      if (c.x.empty() && stands_elsewhere(group, request.y)) continue;
      const analysis::Fit fit = fit_column(request, c);
      const std::string model = group.label.empty() ? request.model : request.model + ", " + group.label;
      if (!fit.ok()) {
        fits.not_made.push_back(
            fmt::format("{} of {} against {}: {}", model, request.y, request.x, fit.failure));
        continue;
      }
      for (std::size_t k = 0; k < fit.coefficients.size(); ++k) {
        FitRow row{request.y,
                   request.x,
                   model,
                   fmt::format("c{}", k),
                   fit.coefficients[k],
                   {},
                   fit.r2,
                   coefficient_unit(fit, y_unit, x_unit, k),
                   {}};
        if (!fit.standard_errors.empty()) row.standard_error = fit.standard_errors[k];
        if (!fit.covariance.empty()) {
          const auto first =
              fit.covariance.begin() + static_cast<std::ptrdiff_t>(k * fit.coefficients.size());
          row.covariance.assign(first, first + static_cast<std::ptrdiff_t>(fit.coefficients.size()));
        }
        row.reduced_chi2 = fit.reduced_chi2();
        row.points = fit.points;
        row.family = group.family;
        row.r2_text = fit.r2_text();
        fits.rows.push_back(std::move(row));
      }
      if (const auto chi2 = fit.reduced_chi2(); chi2 && *chi2 > 1)
        fits.notes.push_back(
            fmt::format("{} of {} against {}: the points are off the curve by {:.2g} times "
                        "their intervals (reduced chi^2 = {:.3g})",
                        model, request.y, request.x, std::sqrt(*chi2), *chi2));
    }
  }
  return fits;
}

}  // namespace mpmstudy
