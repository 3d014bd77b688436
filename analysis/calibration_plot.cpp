#include "analysis/calibration_plot.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "analysis/gnuplot.hpp"

namespace analysis {
namespace {

/// The axes end here; what is beyond is drawn on their edge.
constexpr double least_half_width = 1e-3, least_difference = 1e-5, most = 100;

std::string rows_of(const std::vector<std::pair<double, double>>& pairs) {
  std::string rows;
  for (const auto& [half_width, difference] : pairs)
    rows += fmt::format("{:.9g} {:.9g}\n", std::clamp(half_width, least_half_width, most),
                        std::clamp(difference, least_difference, most));
  return rows;
}

std::string summary(const char* what, const Calibration& c) {
  return fmt::format("{} {:.0f} % hold, median ± {:.2g} %", what, 100 * c.covered, 100 * c.median_half_width);
}

}  // namespace

std::string calibration_caption(const std::vector<CalibrationPoint>& points) {
  return fmt::format(
      "{} jobs;  {};  {}", points.size(), summary("about the value:", calibrate(about_the_value(points))),
      summary("about the extrapolated value:", calibrate(about_the_extrapolated_value(points))));
}

void draw(const CalibrationPlot& plot, const std::filesystem::path& stem) {
  const std::string caption = calibration_caption(plot.points);
  const FigureFolder folder(stem);
  folder.write("value.dat", rows_of(about_the_value(plot.points)));
  folder.write("extrapolated.dat", rows_of(about_the_extrapolated_value(plot.points)));
  std::string text;
  text +=
      fmt::format("set label 1 {} at screen 0.5, screen 0.955 center font ',14'\n", gnuplot_text(plot.title));
  text += fmt::format("set label 2 {} at screen 0.5, screen 0.9 center font ',10' tc rgb '#444444'\n",
                      gnuplot_text(caption));
  if (!plot.footer.empty())
    text += fmt::format("set label 3 {} at screen 0.985, screen 0.018 right font ',7.5' tc rgb '#888888'\n",
                        gnuplot_text(plot.footer));
  text += "set xlabel 'Half width that coarse cells give / value'\n";
  text += "set ylabel 'Difference from fine cells / value' offset -1,0\n";
  text += "set border 3 lw 1 lc rgb '#333333'\nset tics nomirror out scale 0.7 tc rgb '#222222'\n";
  text += "set grid xtics ytics lt 1 lw 0.5 lc rgb '#dddddd'\nset logscale xy\nset format '%g'\n";
  text +=
      fmt::format("set xrange [{}:{}]\nset yrange [{}:{}]\n", least_half_width, most, least_difference, most);
  text +=
      "set lmargin at screen 0.13\nset bmargin at screen 0.135\nset tmargin at screen 0.815\n"
      "set rmargin at screen 0.965\n"
      "set key at screen 0.535, screen 0.855 center center horizontal Left reverse samplen 2\n";
  text +=
      "plot x with lines lw 1.4 lc rgb '#555555' title 'as far as predicted', "
      "'value.dat' using 1:2 with points pt 7 ps 1.0 lc rgb '#0072b2' title 'about the value', "
      "'extrapolated.dat' using 1:2 with points pt 4 ps 1.1 lw 1.4 lc rgb '#d55e00' title "
      "'about the extrapolated value'\n";
  run_gnuplot(folder, text, figure_size, stem);
}

}  // namespace analysis
