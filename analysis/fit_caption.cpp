#include "analysis/fit_caption.hpp"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <optional>

namespace analysis {
namespace {

/// A number and its standard error, to two digits of the error.
std::string with_error(double value, std::optional<double> error) {
  if (!error || !(*error > 0)) return fmt::format("{:.4g}", value);
  const int decimals = std::max(0, 1 - static_cast<int>(std::floor(std::log10(*error))));
  if (decimals > 6) return fmt::format("({:.4g} ± {:.2g})", value, *error);
  return fmt::format("({:.{}f} ± {:.{}f})", value, decimals, *error, decimals);
}

/// " (1.02 ± 0.03) R^(0.41 ± 0.02)", " 0.9 exp(−(0.11 ± 0.01) R)".
std::string curve_text(const Fit& fit, const std::string& x, double x_factor, double y_factor) {
  const bool power = fit.model == FitModel::power;
  Fit::Prefactor before{fit.coefficients[0] * y_factor, {}};
  std::optional<double> error;
  const double scale = power ? 1 : 1 / x_factor;
  if (!fit.standard_errors.empty()) {
    before.standard_error = fit.standard_errors[0] * y_factor;
    error = fit.standard_errors[1] * scale;
  }
  if (power) before = fit.prefactor(x_factor, y_factor);
  const std::string sign = fit.coefficients[1] < 0 ? "−" : "";
  const std::string exponent = sign + with_error(std::abs(fit.coefficients[1] * scale), error);
  const std::string number =
      (before.value < 0 ? " −" : " ") + with_error(std::abs(before.value), before.standard_error);
  if (!power) return fmt::format("{} exp({} {})", number, exponent, x);
  return sign.empty() && exponent.starts_with('(') ? fmt::format("{} {}^{}", number, x, exponent)
                                                   : fmt::format("{} {}^({})", number, x, exponent);
}

}  // namespace

std::string fit_caption(const Fit& fit, const QuantityLabel& x, const DisplayUnit& x_unit,
                        const QuantityLabel& y, const DisplayUnit& y_unit) {
  const auto symbol = [](const QuantityLabel& q) { return q.symbol.empty() ? q.name : q.symbol; };
  constexpr std::array<const char*, 3> powers = {"", "", "²"};
  std::string text = symbol(y) + " =";
  if (!is_polynomial(fit.model)) text += curve_text(fit, symbol(x), x_unit.factor, y_unit.factor);
  for (std::size_t k = 0; k < fit.coefficients.size() && is_polynomial(fit.model); ++k) {
    const double factor = y_unit.factor / std::pow(x_unit.factor, static_cast<double>(k));
    const double value = fit.coefficients[k] * factor;
    std::optional<double> error;
    if (!fit.standard_errors.empty()) error = fit.standard_errors[k] * factor;
    text += value < 0 ? " − " : k > 0 ? " + " : " ";
    text += with_error(std::abs(value), error);
    if (k > 0) text += fmt::format(" {}{}", symbol(x), powers[k]);
  }
  if (!x_unit.text.empty()) text += fmt::format(";  {} in {}", symbol(x), x_unit.text);
  if (!y_unit.text.empty()) text += fmt::format(", {} in {}", symbol(y), y_unit.text);
  if (fit.r2)
    text += ";  r² = " + fit.r2_text();
  else if (!fit.r2_text().empty())
    text += ";  r² " + fit.r2_text();
  if (const auto chi2 = fit.reduced_chi2())
    text += fmt::format(";  χ²/ν = {:.2g}{}", *chi2, *chi2 > 1 ? ": lack of fit" : "");
  return text;
}

}  // namespace analysis
