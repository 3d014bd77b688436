#include "analysis/plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string_view>

#include "analysis/gnuplot.hpp"
#include "analysis/log_axis.hpp"

namespace analysis {
namespace {

/// Okabe & Ito's colours without yellow, which is faint on white; told apart by every kind of colour vision.
constexpr std::array<std::string_view, 7> colours = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                                     "#56b4e9", "#e69f00", "#000000"};
/// Filled circle, square, triangle, diamond ...: told apart without colour.
constexpr std::array<int, 6> marks = {7, 5, 9, 13, 11, 15};
constexpr int marks_on_a_curve = 9;
constexpr int fit_samples = 200;

std::string_view colour(std::size_t i) { return colours[i % colours.size()]; }
int mark(std::size_t i) { return marks[i % marks.size()]; }
/// Solid first; dashes once the colours have all been used.
int dash(std::size_t i) { return 1 + static_cast<int>(i / colours.size()); }

double largest(const std::vector<Series>& all, std::vector<double> Series::*column) {
  double result = 0;
  for (const Series& series : all)
    for (const double value : series.*column)
      if (std::isfinite(value)) result = std::max(result, std::abs(value));
  return result;
}

bool is_drawn(const Plot& plot, const Series& s, std::size_t i) {
  return std::isfinite(s.x[i]) && std::isfinite(s.y[i]) && (!plot.log_x || s.x[i] > 0) &&
         (!plot.log_y || s.y[i] > 0);
}

void check(const Plot& plot) {
  bool something = false;
  for (const Series& s : plot.series) {
    if (s.x.size() != s.y.size() || (!s.y_error.empty() && s.y_error.size() != s.y.size()))
      throw std::invalid_argument("figure '" + plot.title + "': x, y and y_error of '" + s.label +
                                  "' have unequal lengths");
    for (std::size_t i = 0; i < s.x.size(); ++i) something = something || is_drawn(plot, s, i);
  }
  if (!something) throw std::invalid_argument("figure '" + plot.title + "': there is nothing to draw");
}

/// x, y, error in the units of the axes, one row per point.
std::string rows_of(const Plot& plot, const Series& s, const DisplayUnit& x, const DisplayUnit& y) {
  std::string rows;
  for (std::size_t i = 0; i < s.x.size(); ++i) {
    if (!is_drawn(plot, s, i)) continue;
    const double error = s.y_error.empty() || !std::isfinite(s.y_error[i]) ? 0 : s.y_error[i];
    rows += fmt::format("{:.9g} {:.9g} {:.9g}\n", s.x[i] * x.factor, s.y[i] * y.factor, error * y.factor);
  }
  return rows;
}

/// x, y, low, high of the fit; low = high = y where its errors are unknown.
std::string rows_of(const Fit& fit, bool log_x, const DisplayUnit& x, const DisplayUnit& y) {
  std::string rows;
  const double margin = 0.03 * (fit.x_max - fit.x_min);
  for (int i = 0; i <= fit_samples; ++i) {
    double at = fit.x_min - margin + (fit.x_max - fit.x_min + 2 * margin) * i / fit_samples;
    if (log_x) at = fit.x_min * std::pow(fit.x_max / fit.x_min, static_cast<double>(i) / fit_samples);
    const double value = fit(at), half = fit.band(at).value_or(0);
    rows += fmt::format("{:.9g} {:.9g} {:.9g} {:.9g}\n", at * x.factor, value * y.factor,
                        (value - half) * y.factor, (value + half) * y.factor);
  }
  return rows;
}

/// With one point to spare Student's t is 12.7: the band would fill the figure and say nothing.
bool has_band(const Fit& fit) { return !fit.standard_errors.empty() && fit.degrees_of_freedom > 1; }

std::string file_of(std::size_t i) { return fmt::format("'series{}.dat'", i); }

std::size_t characters(std::string_view utf8) {
  return static_cast<std::size_t>(std::ranges::count_if(utf8, [](char c) { return (c & 0xC0) != 0x80; }));
}

/// More entries, or more letters, than this stand at the side: above the axes they would cover title and
/// caption.
constexpr std::size_t most_entries_above = 4, most_letters_above = 60;

std::size_t legend_entries(const Plot& plot) {
  std::size_t count = 0;
  if (plot.fit && plot.fit->ok()) count += has_band(*plot.fit) ? 2 : 1;
  for (const Series& s : plot.series) count += s.label.empty() ? 0 : 1;
  return count;
}

std::string every_text(std::size_t every, std::size_t curves) {
  return fmt::format("one in {} of {} is named", every, curves);
}

std::size_t legend_letters(const Plot& plot) {
  std::size_t count = 0;
  for (const Series& s : plot.series) count += characters(s.label);
  return count;
}

/// The legend at the side. Many curves have a smaller font; where that would become too small to be read,
/// every second, third, ... curve is named, and the legend says so.
struct SideLegend {
  double font = 11;       ///< size in points
  std::size_t every = 1;  ///< which curves are named
  double width = 0;       ///< share of the figure's width

  bool names(std::size_t series) const { return series % every == 0; }
};

SideLegend side_legend(const Plot& plot) {
  constexpr double height = 440, line = 1.55, smallest = 6;  // [points], [font sizes], [points]
  SideLegend legend;
  const double most =
      std::floor(height / (smallest * line)) - 3;  // a fit, its band, and what is said of others
  const double entries = static_cast<double>(legend_entries(plot));
  legend.every = static_cast<std::size_t>(std::max(1.0, std::ceil(entries / most)));
  legend.font =
      std::clamp(height / (line * (entries / static_cast<double>(legend.every) + 3)), smallest, 11.0);
  std::size_t longest = plot.fit ? name(plot.fit->model).size() + std::string_view(" fit").size() : 0;
  for (const Series& s : plot.series) longest = std::max(longest, characters(s.label));
  if (legend.every > 1) longest = std::max(longest, every_text(legend.every, plot.series.size()).size());
  // Lines and marks, and 0.65 of the font's size per character.
  legend.width =
      longest == 0
          ? 0.02
          : std::min(0.45, (74 + 0.65 * legend.font * static_cast<double>(longest)) / figure_size.width);
  return legend;
}

/// Width of the widest number at the y axis, in characters; gnuplot has about five steps on an axis.
std::size_t tick_characters(const Plot& plot, const DisplayUnit& y) {
  double low = plot.y_from_zero ? 0 : std::numeric_limits<double>::infinity(), high = -low;
  if (plot.y_from_zero) high = 0;
  for (const Series& s : plot.series)
    for (std::size_t i = 0; i < s.y.size(); ++i) {
      if (!is_drawn(plot, s, i)) continue;
      const double error = s.y_error.empty() || !std::isfinite(s.y_error[i]) ? 0 : s.y_error[i];
      low = std::min(low, (s.y[i] - error) * y.factor);
      high = std::max(high, (s.y[i] + error) * y.factor);
    }
  if (!(high > low)) return fmt::format("{:.6g}", high).size();
  const double step = std::pow(10, std::floor(std::log10((high - low) / 5)));
  std::size_t widest = 0;
  for (double at = std::floor(low / step); at <= std::ceil(high / step); ++at)
    widest = std::max(widest, fmt::format("{:.6g}", at * step).size());
  return widest;
}

std::string history_clauses(const Plot& plot, const SideLegend& legend) {
  std::string clauses;
  for (std::size_t i = 0; i < plot.series.size(); ++i)
    if (!plot.series[i].y_error.empty())
      clauses += fmt::format(
          "{} using 1:($2-$3):($2+$3) with filledcurves lc rgb '{}' fs transparent solid 0.18 notitle, ",
          file_of(i), colour(i));
  for (std::size_t i = 0; i < plot.series.size(); ++i) {
    const Series& s = plot.series[i];
    // A mark now and then, each curve at its own places, so that curves can be told apart in grey.
    const auto every = std::max<std::size_t>(1, s.x.size() / marks_on_a_curve);
    clauses +=
        fmt::format("{} using 1:2 every {}::{} with points pt {} ps 0.9 lc rgb '{}' notitle, ", file_of(i),
                    every, (i * every) / std::max<std::size_t>(1, plot.series.size()), mark(i), colour(i));
    clauses += fmt::format("{} using 1:2 with lines lw 1.8 dt {} lc rgb '{}' notitle, ", file_of(i), dash(i),
                           colour(i));
    if (!s.label.empty() && legend.names(i))
      clauses += fmt::format("keyentry with linespoints lw 1.8 dt {} pt {} ps 0.9 lc rgb '{}' title {}, ",
                             dash(i), mark(i), colour(i), gnuplot_text(s.label));
  }
  return clauses;
}

std::string xy_clauses(const Plot& plot, const SideLegend& legend, bool several) {
  std::string clauses;
  if (plot.fit && plot.fit->ok()) {
    if (has_band(*plot.fit))
      clauses +=
          "'fit.dat' using 1:3:4 with filledcurves lc rgb '#999999' fs transparent solid 0.25 title '95 % "
          "band', ";
    clauses += fmt::format("'fit.dat' using 1:2 with lines lw 1.8 lc rgb '#555555' title {}, ",
                           gnuplot_text(std::string(name(plot.fit->model)) + " fit"));
  }
  for (std::size_t i = 0; i < plot.series.size(); ++i) {
    const Series& s = plot.series[i];
    const std::string title =
        s.label.empty() || !legend.names(i) ? "notitle" : "title " + gnuplot_text(s.label);
    if (several)
      clauses +=
          fmt::format("{} using 1:2 with lines lw 1 dt 3 lc rgb '{}' notitle, ", file_of(i), colour(i));
    clauses += fmt::format("{} using {} pt {} ps 1.1 lw 1.4 lc rgb '{}' {}, ", file_of(i),
                           s.y_error.empty() ? "1:2 with points" : "1:2:3 with yerrorbars", mark(i),
                           colour(i), title);
  }
  return clauses;
}

/// With few points to spare a band is many times as wide as the data: the axis follows points and curve, and
/// a band that is wider is cut off.
std::string range_of_points(const Plot& plot, const DisplayUnit& y) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  const auto include = [&](double value) {
    if (!std::isfinite(value)) return;
    low = std::min(low, value);
    high = std::max(high, value);
  };
  bool negative = false;
  for (const Series& s : plot.series)
    for (std::size_t i = 0; i < s.y.size(); ++i) {
      const double error = s.y_error.empty() || !std::isfinite(s.y_error[i]) ? 0 : s.y_error[i];
      negative = negative || s.y[i] < 0;
      include(s.y[i] - error);
      include(s.y[i] + error);
    }
  for (int i = 0; i <= fit_samples; ++i)
    include((*plot.fit)(plot.fit->x_min + (plot.fit->x_max - plot.fit->x_min) * i / fit_samples));
  const double margin = 0.15 * (high - low);
  if (!(margin > 0)) return {};
  // An error bar may reach below zero; speeds and shares that are all positive have no room there.
  const double bottom = negative ? low - margin : std::max(0.0, low - margin);
  return fmt::format("set yrange [{:.9g}:{:.9g}]\n", bottom * y.factor, (high + margin) * y.factor);
}

/// A logarithmic axis around what is drawn, in units of the axis.
template <class Low, class High>
std::string log_axis_of(const Plot& plot, const std::string& axis, double factor, Low low_of, High high_of) {
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (const Series& s : plot.series)
    for (std::size_t i = 0; i < s.x.size(); ++i) {
      if (!is_drawn(plot, s, i)) continue;
      if (const double value = low_of(s, i); value > 0) low = std::min(low, value);
      high = std::max(high, high_of(s, i));
    }
  return log_axis(axis, low * factor, high * factor);
}

/// Room around the data so that no point lies on the frame.
std::string ranges(const Plot& plot, const DisplayUnit& x, const DisplayUnit& y) {
  const auto x_of = [](const Series& s, std::size_t i) { return s.x[i]; };
  const auto y_of = [](const Series& s, std::size_t i) { return s.y[i]; };
  const auto top_of = [](const Series& s, std::size_t i) {
    return s.y[i] + (s.y_error.empty() || !std::isfinite(s.y_error[i]) ? 0 : s.y_error[i]);
  };
  std::string text = plot.kind == Plot::Kind::history
                         ? "set offsets 0, 0, graph 0.05, graph 0.02\n"
                         : fmt::format("set offsets graph 0.04, graph 0.04, graph 0.06, {}\n",
                                       plot.y_from_zero ? "0" : "graph 0.06");  // no room below zero
  if (plot.log_x || plot.log_y) text = "";
  if (plot.log_x) text += log_axis_of(plot, "x", x.factor, x_of, x_of);
  if (plot.log_y)
    text += log_axis_of(plot, "y", y.factor, y_of, top_of);
  else if (plot.y_from_zero)
    text += "set yrange [0:*]\n";
  else if (plot.fit && plot.fit->ok() && has_band(*plot.fit))
    text += range_of_points(plot, y);
  return text;
}

std::string caption_of(const Plot& plot, const DisplayUnit& x, const DisplayUnit& y) {
  if (!plot.fit) return {};
  if (!plot.fit->ok()) return "no fit: " + plot.fit->failure;
  return fit_caption(*plot.fit, plot.x, x, plot.y, y);
}

std::string script(const Plot& plot, const DisplayUnit& x, const DisplayUnit& y) {
  const bool history = plot.kind == Plot::Kind::history;
  const bool at_side =
      history || legend_entries(plot) > most_entries_above || legend_letters(plot) > most_letters_above;
  const SideLegend legend = at_side ? side_legend(plot) : SideLegend{};
  const std::string caption = caption_of(plot, x, y);
  std::string text;
  text +=
      fmt::format("set label 1 {} at screen 0.5, screen 0.955 center font ',14'\n", gnuplot_text(plot.title));
  if (!caption.empty())
    text += fmt::format("set label 2 {} at screen 0.5, screen 0.9 center font ',10' tc rgb '#444444'\n",
                        gnuplot_text(caption));
  if (!plot.footer.empty())
    text += fmt::format("set label 3 {} at screen 0.985, screen 0.018 right font ',7.5' tc rgb '#888888'\n",
                        gnuplot_text(plot.footer));
  text += fmt::format("set xlabel {} offset 0,-0.3\nset ylabel {} offset -1,0\n",
                      gnuplot_text(axis_label(plot.x, x)), gnuplot_text(axis_label(plot.y, y)));
  text += "set border 3 lw 1 lc rgb '#333333'\nset tics nomirror out scale 0.7 tc rgb '#222222'\n";
  text += "set grid xtics ytics lt 1 lw 0.5 lc rgb '#dddddd'\nset format '%g'\n";
  // Title of the axis, gaps, and 6.8 points per character of the widest number; powers of ten are wider yet.
  const double left = (47 + 6.8 * static_cast<double>(tick_characters(plot, y))) / figure_size.width;
  text += fmt::format("set lmargin at screen {:.4f}\nset bmargin at screen 0.135\n",
                      plot.log_y ? 0.13 : std::max(0.105, left));
  if (at_side) {
    const double right = 0.985 - legend.width;
    text += fmt::format("set tmargin at screen {}\nset rmargin at screen {}\n",
                        caption.empty() ? 0.915 : 0.87, right);
    // Lines of a legend are `spacing` times the height of the figure's own font apart, whatever its font is;
    // where they do not fit gnuplot begins a second column outside.
    constexpr double line_of_font_11 = 13.3;  // [points]
    text += fmt::format(
        "set key at screen {}, graph 1 left top Left reverse samplen 2.5 spacing {:.3f} font ',{:.1f}'\n",
        right + 0.01, 1.5 * legend.font / line_of_font_11, legend.font);
  } else {
    const double top = caption.empty() ? 0.86 : 0.815;
    text += fmt::format("set tmargin at screen {}\nset rmargin at screen 0.965\n", top);
    text += fmt::format(
        "set key at screen 0.535, screen {} center center horizontal Left reverse samplen 2\n", top + 0.04);
  }
  text += ranges(plot, x, y);
  std::string clauses =
      history ? history_clauses(plot, legend) : xy_clauses(plot, legend, plot.series.size() > 1 && !plot.fit);
  if (legend.every > 1)
    clauses += fmt::format("keyentry with dots lc rgb '#ffffff' title {}, ",
                           gnuplot_text(every_text(legend.every, plot.series.size())));
  clauses.resize(clauses.size() - 2);
  return text + "plot " + clauses + "\n";
}

}  // namespace

void draw(const Plot& plot, const std::filesystem::path& stem) {
  check(plot);
  const DisplayUnit x = display_unit(plot.x.unit, largest(plot.series, &Series::x));
  const DisplayUnit y = display_unit(plot.y.unit, largest(plot.series, &Series::y));
  const FigureFolder folder(stem);
  for (std::size_t i = 0; i < plot.series.size(); ++i)
    folder.write(fmt::format("series{}.dat", i), rows_of(plot, plot.series[i], x, y));
  if (plot.fit && plot.fit->ok()) folder.write("fit.dat", rows_of(*plot.fit, plot.log_x, x, y));
  run_gnuplot(folder, script(plot, x, y), figure_size, stem);
}

}  // namespace analysis
