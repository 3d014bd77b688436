#include "analysis/field_plot.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string_view>

#include "analysis/gnuplot.hpp"
#include "analysis/palette.hpp"

namespace analysis {
namespace {

/// Room around and between panels, in points; panel images have `pixels_per_point` pixels per point.
constexpr double left = 76, right = 118, top = 50, bottom = 76, gap_x = 18, gap_y = 30;
constexpr double figure_width = 900;
constexpr double pixels_per_point = 2;

constexpr std::string_view grey = "(0 '#000000', 1 '#ffffff')";

void check(const FieldPlot& plot) {
  bool something = false;
  for (const FieldPanel& panel : plot.panels) {
    const ParticleSquares& p = panel.particles;
    if (p.y.size() != p.x.size() || p.size.size() != p.x.size() || p.value.size() != p.x.size() ||
        (!p.material.empty() && p.material.size() != p.x.size()))
      throw std::invalid_argument("figure '" + plot.title + "': columns of panel '" + panel.title +
                                  "' have unequal lengths");
    something = something || !p.x.empty();
  }
  if (!something) throw std::invalid_argument("figure '" + plot.title + "': there is nothing to draw");
}

/// What all but 1 % of the particles of all panels lie in; from zero where no value is negative, and then to
/// what one in a thousand exceeds: hot spots are small.
std::pair<double, double> colour_range(const FieldPlot& plot) {
  if (plot.range) return *plot.range;
  std::vector<double> values;
  for (const FieldPanel& panel : plot.panels)
    std::ranges::copy_if(panel.particles.value, std::back_inserter(values),
                         [](double v) { return std::isfinite(v); });
  if (values.empty()) return {0, 1};
  std::ranges::sort(values);
  const std::size_t cut = values.size() / 200;
  double low = values[cut], high = values[values.size() - 1 - cut];
  // Fields like pressure are near zero where nothing has happened: begin there, not at the noise.
  if (low > 0 && low < 0.2 * high) low = 0;
  if (values.front() >= 0 && low == 0) high = values[values.size() - 1 - values.size() / 1000];
  if (!(high > low)) high = low + (low == 0 ? 1 : std::abs(low));
  return {low, high};
}

/// Where the panels go; points from the upper left corner of the figure.
struct Layout {
  int columns, rows;
  double panel_width, panel_height;
  double gap;         ///< between panels of a row: titles of narrow ones need room
  double title_font;  ///< size in points
  FigureSize figure;

  double x(int column) const { return left + column * (panel_width + gap); }
  double y(int row) const { return top + gap_y + row * (panel_height + gap_y); }
};

/// Letters of the longest title of a panel.
std::size_t longest_title(const std::vector<FieldPanel>& panels) {
  std::size_t longest = 1;
  for (const FieldPanel& panel : panels) longest = std::max(longest, panel.title.size());
  return longest;
}

Layout layout_of(const std::vector<FieldPanel>& panels, const Window& window) {
  Layout l{};
  const int count = static_cast<int>(panels.size());
  l.columns = count <= 3 ? count : count == 4 ? 2 : 3;
  l.rows = (count + l.columns - 1) / l.columns;
  l.panel_width = (figure_width - left - right - (l.columns - 1) * gap_x) / l.columns;
  l.panel_height = l.panel_width * window.height() / window.width();
  // A tall or lone panel is held to the height of a page.
  constexpr double most = 560;
  if (l.panel_height > most / std::min(l.rows, 2)) {
    l.panel_height = most / std::min(l.rows, 2);
    l.panel_width = l.panel_height * window.width() / window.height();
  }
  // A letter is about 0.62 of the font's size wide. Titles become smaller first, then panels stand farther
  // apart.
  constexpr double letter = 0.62, largest = 10.5, smallest = 8, apart = 8;
  const double letters = letter * static_cast<double>(longest_title(panels));
  l.title_font = std::clamp((l.panel_width + gap_x - apart) / letters, smallest, largest);
  l.gap = std::max(gap_x, letters * l.title_font + apart - l.panel_width);
  l.figure.width = static_cast<int>(std::ceil(l.x(l.columns - 1) + l.panel_width + right));
  l.figure.height = static_cast<int>(std::ceil(l.y(l.rows - 1) + l.panel_height + bottom));
  return l;
}

/// Pixels in the units of the colour bar, as gnuplot's binary array.
std::string bytes_of(Raster raster, double factor) {
  for (float& v : raster.values) v = static_cast<float>(v * factor);
  return {reinterpret_cast<const char*>(raster.values.data()), raster.values.size() * sizeof(float)};
}

/// As lines of gnuplot.
std::string lines_of(const std::vector<Piece>& pieces, double factor) {
  std::string text;
  for (const Piece& p : pieces)
    text += fmt::format("{:.6g} {:.6g}\n{:.6g} {:.6g}\n\n", p.x0 * factor, p.y0 * factor, p.x1 * factor,
                        p.y1 * factor);
  return text;
}

/// The largest of 1, 2, 5, 10, 20, ... in this unit that is at most a fifth of the width.
double bar_length(double width) {
  const double most = width / 5, power = std::pow(10, std::floor(std::log10(most)));
  for (const double digit : {5.0, 2.0})
    if (digit * power <= most) return digit * power;
  return power;
}

/// A bar of a round length in the lower left corner of the first panel, on a ground of its own.
std::string scale_bar_script(const Window& w, const DisplayUnit& length, const Layout& l) {
  const double width = w.width() * length.factor, height = w.height() * length.factor;
  const double bar = bar_length(width), point = width / l.panel_width;
  const double x = w.x_min * length.factor + 0.03 * width, y = w.y_min * length.factor + 0.03 * height;
  return fmt::format(
      "set object 2 rectangle from first {:.9g},{:.9g} to first {:.9g},{:.9g} front fs solid 1 noborder fc "
      "rgb "
      "'#ffffff'\n"
      "set arrow 1 from first {:.9g},{:.9g} to first {:.9g},{:.9g} nohead front lw 2.5 lc rgb '#000000'\n"
      "set label 3 {} at first {:.9g},{:.9g} center front font ',8' tc rgb '#000000'\n",
      x, y, x + bar + 10 * point, y + 17 * point, x + 5 * point, y + 4 * point, x + bar + 5 * point,
      y + 4 * point, gnuplot_text(fmt::format("{:g} {}", bar, length.text)), x + 0.5 * bar + 5 * point,
      y + 11 * point);
}

std::string panel_script(const FieldPlot& plot, const Layout& l, const Window& w, const DisplayUnit& length,
                         const Raster& raster, bool outlined, std::size_t i) {
  const int column = static_cast<int>(i) % l.columns, row = static_cast<int>(i) / l.columns;
  const double width = l.figure.width, height = l.figure.height;
  const bool lowest = i + static_cast<std::size_t>(l.columns) >= plot.panels.size();
  std::string text = fmt::format(
      "set lmargin at screen {}\nset rmargin at screen {}\nset tmargin at screen {}\nset bmargin at screen "
      "{}\n",
      l.x(column) / width, (l.x(column) + l.panel_width) / width, 1 - l.y(row) / height,
      1 - (l.y(row) + l.panel_height) / height);
  text += fmt::format("set title {} offset 0,-0.6 font ',{:.1f}'\n", gnuplot_text(plot.panels[i].title),
                      l.title_font);
  text += lowest ? fmt::format("set format x '%g'\nset xlabel {} offset 0,0.3\n",
                               gnuplot_text(fmt::format("{} ({})", plot.across, length.text)))
                 : "set format x ''\nunset xlabel\n";
  text += column == 0 ? fmt::format("set format y '%g'\nset ylabel {} offset -0.5,0\n",
                                    gnuplot_text(fmt::format("{} ({})", plot.up, length.text)))
                      : "set format y ''\nunset ylabel\n";
  const double dx = w.width() / raster.columns, dy = w.height() / raster.rows;
  text += fmt::format(
      "plot 'panel{}.bin' binary array=({},{}) format='%float' dx={:.9g} dy={:.9g} origin=({:.9g},{:.9g}) "
      "with image notitle",
      i, raster.columns, raster.rows, dx * length.factor, dy * length.factor,
      (w.x_min + dx / 2) * length.factor, (w.y_min + dy / 2) * length.factor);
  if (outlined)  // dark beside light: seen on every colour
    for (const char* line : {"lw 2.2 lc rgb '#000000'", "lw 0.8 lc rgb '#ffffff'"})
      text += fmt::format(", 'outline{}.txt' using 1:2 with lines {} notitle", i, line);
  return text + "\n";
}

std::string frame_script(const FieldPlot& plot, const Layout& l, const Window& w, const DisplayUnit& length,
                         const DisplayUnit& value, std::pair<double, double> range) {
  const double width = l.figure.width, height = l.figure.height;
  const double bar_x = (l.x(l.columns - 1) + l.panel_width + 16) / width;
  const double bar_low = 1 - (l.y(l.rows - 1) + l.panel_height) / height, bar_high = 1 - l.y(0) / height;
  std::string text = fmt::format("set palette defined {}\n", plot.palette == Palette::grey ? grey : viridis);
  // Grey goes to white: emptiness has a tint, to be told from what is hottest.
  if (plot.palette == Palette::grey)
    text +=
        "set object 1 rectangle from graph 0, graph 0 to graph 1, graph 1 behind fs solid noborder fc rgb "
        "'#cfe2f3'\n";
  text +=
      fmt::format("set cbrange [{:.6g}:{:.6g}]\n", range.first * value.factor, range.second * value.factor);
  text += fmt::format("set xrange [{:.9g}:{:.9g}]\nset yrange [{:.9g}:{:.9g}]\n", w.x_min * length.factor,
                      w.x_max * length.factor, w.y_min * length.factor, w.y_max * length.factor);
  text +=
      "set border 15 lw 0.8 lc rgb '#333333'\nset tics out nomirror scale 0.5 font ',9.5' tc rgb "
      "'#222222'\nunset key\n";
  text += fmt::format("set colorbox user origin {},{} size {},{} border\n", bar_x, bar_low, 13 / width,
                      bar_high - bar_low);
  text += fmt::format("set format cb '%g'\nset cblabel {} offset 0.5,0\n",
                      gnuplot_text(axis_label(plot.value, value)));
  // Narrow figures have narrow titles: a letter is about six tenths of the font's size wide.
  const double size = std::min(14.0, (width - 16) / (0.6 * static_cast<double>(plot.title.size() + 1)));
  text += fmt::format("set label 1 {} at screen 0.5, screen {} center font ',{:.1f}'\n",
                      gnuplot_text(plot.title), 1 - 28 / height, size);
  if (!plot.footer.empty())
    text += fmt::format("set label 2 {} at screen {}, screen {} right font ',7.5' tc rgb '#888888'\n",
                        gnuplot_text(plot.footer), 1 - 12 / width, 11 / height);
  return text;
}

}  // namespace

void draw(const FieldPlot& plot, const std::filesystem::path& stem) {
  check(plot);
  std::vector<const ParticleSquares*> snapshots;
  for (const FieldPanel& panel : plot.panels)
    if (!panel.particles.x.empty()) snapshots.push_back(&panel.particles);
  const Window window = plot.window ? *plot.window : window_of(snapshots, plot.mirrored);
  const auto range = colour_range(plot);
  const DisplayUnit length = display_unit("m", std::max(window.width(), window.height()));
  const double largest = std::max(std::abs(range.first), std::abs(range.second));
  const DisplayUnit value = plot.palette == Palette::grey ? fixed_unit(plot.value.unit, largest)
                                                          : display_unit(plot.value.unit, largest);
  const Layout layout = layout_of(plot.panels, window);
  const int columns = std::max(1, static_cast<int>(std::lround(layout.panel_width * pixels_per_point)));
  const int rows = std::max(1, static_cast<int>(std::lround(layout.panel_height * pixels_per_point)));

  const FigureFolder folder(stem);
  std::string script = frame_script(plot, layout, window, length, value, range) +
                       scale_bar_script(window, length, layout) + "set multiplot\n";
  for (std::size_t i = 0; i < plot.panels.size(); ++i) {
    const Raster raster = rasterise(plot.panels[i].particles, plot.mirrored, window, columns, rows);
    folder.write(fmt::format("panel{}.bin", i), bytes_of(raster, value.factor));
    const auto pieces = outlines(plot.panels[i].particles, plot.mirrored, window, columns, rows);
    if (!pieces.empty()) folder.write(fmt::format("outline{}.txt", i), lines_of(pieces, length.factor));
    script += panel_script(plot, layout, window, length, raster, !pieces.empty(), i);
    // they belong to the figure: once is enough
    if (i == 0) script += "unset label\nunset colorbox\nunset arrow\nunset object 2\n";
  }
  run_gnuplot(folder, script + "unset multiplot\n", layout.figure, stem);
}

}  // namespace analysis
