#include "analysis/plot.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "analysis/gnuplot.hpp"
#include "temporary_folder.hpp"

namespace {

using namespace analysis;
using testing::HasSubstr;

class PlotTest : public TemporaryFolderTest {};

Plot make_history(int curves) {
  Plot plot;
  plot.title = "Area against time";
  plot.footer = "catalog 0123abcd, physics version 1";
  plot.x = quantity_label("time", "s", "t");
  plot.y = quantity_label("area", "m^2", "A", "Cavity area");
  for (int k = 1; k <= curves; ++k) {
    Series series;
    series.label = value_label(quantity_label("cavity_radius", "m", "R"), 0.5e-6 * k);
    for (int i = 0; i <= 100; ++i) {
      series.x.push_back(0.16e-9 * i);
      series.y.push_back(1e-12 * k * std::exp(-0.03 * i));
    }
    plot.series.push_back(series);
  }
  return plot;
}

Plot make_xy(const std::vector<double>& x) {
  Plot plot;
  plot.kind = Plot::Kind::xy;
  plot.title = "Collapsibility against radius";
  plot.x = quantity_label("cavity_radius", "m", "R");
  plot.y = quantity_label("collapsibility", "1", "Φ");
  Series series{"simulations", x, {}, {}};
  for (const double radius : x) {
    series.y.push_back(1.1 - 0.2e6 * radius + 0.01 * std::sin(1e7 * radius));
    series.y_error.push_back(0.01);
  }
  plot.fit = fit_polynomial(FitModel::quadratic, series.x, series.y);
  plot.series = {series};
  return plot;
}

std::string error_of(auto&& call) {
  try {
    call();
  } catch (const std::exception& error) {
    return error.what();
  }
  return "no error";
}

TEST_F(PlotTest, HistoryHasEveryCurveAndItsLabels) {
  draw(make_history(4), folder_ / "a");
  EXPECT_EQ(png_size(read("a.png")), std::pair(1800, 1200));
  const std::string svg = read("a.svg");
  for (const char* text : {"Area against time", "Time t (ns)", "Cavity area A (µm²)", "R = 0.5 µm",
                           "R = 1 µm", "R = 1.5 µm", "R = 2 µm", "catalog 0123abcd, physics version 1"})
    EXPECT_THAT(svg, HasSubstr(text));
  EXPECT_EQ(count(svg, "R = "), 4);
  for (const char* colour :
       {"rgb(  0, 114, 178)", "rgb(213,  94,   0)", "rgb(  0, 158, 115)", "rgb(204, 121, 167)"})
    EXPECT_EQ(count(svg, std::string("<path stroke='") + colour), 2) << "a curve and its legend: " << colour;
  EXPECT_EQ(entries(), 2) << "nothing but the two figures is left behind";
}

TEST_F(PlotTest, ALegendNamesEveryCurveOrSaysHowMany) {
  draw(make_history(40), folder_ / "forty");
  const std::string forty = read(folder_ / "forty.svg");
  for (const char* label : {"R = 0.5 µm", "R = 10.5 µm", "R = 20 µm"}) EXPECT_THAT(forty, HasSubstr(label));
  // In one column: a second one would lie outside.
  const auto place = [&](const std::string& svg, const std::string& label) {
    return std::stod(svg.substr(svg.rfind("translate(", svg.find(label)) + 10));
  };
  EXPECT_EQ(place(forty, "R = 0.5 µm"), place(forty, "R = 20 µm"));
  draw(make_history(200), folder_ / "many");
  const std::string many = read(folder_ / "many.svg");
  EXPECT_THAT(many, HasSubstr("one in 5 of 200 is named"));
  EXPECT_THAT(many, HasSubstr("R = 98 µm"));
  EXPECT_EQ(place(many, "R = 0.5 µm"), place(many, "R = 98 µm"));
}

TEST_F(PlotTest, AWeightedFitSaysWhetherItHolds) {
  Plot plot = make_xy({1e-6, 1.5e-6, 2e-6, 2.5e-6, 3e-6});
  Series& s = plot.series[0];
  plot.fit = fit_polynomial(FitModel::quadratic, s.x, s.y, s.y_error);
  EXPECT_THAT(fit_caption(*plot.fit, plot.x, {1e6, "µm"}, plot.y, {1, ""}), HasSubstr("χ²/ν = 0."));
  s.y_error.assign(5, 1e-5);
  plot.fit = fit_polynomial(FitModel::quadratic, s.x, s.y, s.y_error);
  EXPECT_THAT(fit_caption(*plot.fit, plot.x, {1e6, "µm"}, plot.y, {1, ""}), HasSubstr(": lack of fit"));
  plot.fit = fit_polynomial(FitModel::quadratic, s.x, s.y);
  EXPECT_FALSE(plot.fit->reduced_chi2());
}

TEST_F(PlotTest, XyHasPointsErrorBarsFitAndBand) {
  const Plot plot = make_xy({1e-6, 1.5e-6, 2e-6, 2.5e-6, 3e-6});
  draw(plot, folder_ / "b");
  EXPECT_EQ(png_size(read("b.png")), std::pair(1800, 1200));
  const std::string svg = read("b.svg");
  for (const char* text :
       {"Cavity radius R (µm)", "Collapsibility Φ", "quadratic fit", "95 % band", "simulations", "Φ = ("})
    EXPECT_THAT(svg, HasSubstr(text));
  EXPECT_THAT(svg, HasSubstr("±"));
  EXPECT_EQ(count(svg, "xlink:href='#gpPt6'"), 2 * 5 + 1) << "each point under and over its bar; the legend";
}

TEST_F(PlotTest, CaptionIsInTheUnitsOfTheAxes) {
  const std::vector<double> x = {1e-6, 2e-6, 3e-6, 4e-6}, y = {2, 4, 4, 6};
  const Fit fit = fit_polynomial(FitModel::linear, x, y);
  const QuantityLabel radius = quantity_label("cavity_radius", "m", "R"),
                      phi = quantity_label("collapsibility", "1", "Φ");
  EXPECT_EQ(fit_caption(fit, radius, display_unit("m", 1e-6), phi, display_unit("1", 1)),
            "Φ = (1.00 ± 0.77) + (1.20 ± 0.28) R;  R in µm;  r² = 0.9000");
}

TEST_F(PlotTest, AFitThatFailedIsSaidOnTheFigure) {
  draw(make_xy({1e-6, 2e-6}), folder_ / "b");
  EXPECT_THAT(read("b.svg"), HasSubstr("no fit: a quadratic fit needs at least 3 points; there are 2"));
}

TEST_F(PlotTest, AFitThroughAllPointsHasNoBand) {
  draw(make_xy({1e-6, 2e-6, 3e-6}), folder_ / "b");
  EXPECT_THAT(read("b.svg"), HasSubstr("quadratic fit"));
  EXPECT_THAT(read("b.svg"), testing::Not(HasSubstr("95 % band")));
}

TEST_F(PlotTest, TextIsTextAndNothingElse) {
  Plot plot = make_history(1);
  const std::string made = (folder_ / "made").string();
  plot.title =
      "it's `touch " + made + "` $(touch " + made + ") \"; system('touch " + made + "'); @x a_b^c {d}\nline";
  plot.series[0].label = "<R> & \\n 'x'";
  draw(plot, folder_ / "a");
  EXPECT_FALSE(std::filesystem::exists(made));
  EXPECT_THAT(read("a.svg"), HasSubstr("a_b^c {d} line"));
  EXPECT_THAT(read("a.svg"), HasSubstr("&lt;R> &amp; \\n 'x'"));
}

TEST_F(PlotTest, ASinglePointAndGapsAreDrawn) {
  Plot plot = make_xy({1e-6});
  plot.fit.reset();
  draw(plot, folder_ / "one");
  EXPECT_EQ(png_size(read("one.png")), std::pair(1800, 1200));
  Plot gaps = make_history(2);
  gaps.series[0].y[50] = std::numeric_limits<double>::quiet_NaN();
  gaps.series[1].y_error.assign(101, 1e-14);
  draw(gaps, folder_ / "gaps");
  EXPECT_EQ(png_size(read("gaps.png")), std::pair(1800, 1200));
}

TEST_F(PlotTest, NothingToDrawIsAnError) {
  Plot plot = make_history(0);
  EXPECT_THAT(error_of([&] { draw(plot, folder_ / "a"); }),
              HasSubstr("'Area against time': there is nothing to draw"));
  plot = make_history(1);
  plot.series[0].y.pop_back();
  EXPECT_THAT(error_of([&] { draw(plot, folder_ / "a"); }), HasSubstr("unequal lengths"));
  EXPECT_EQ(entries(), 0);
}

TEST_F(PlotTest, AFailureKeepsTheOldFigureAndSaysWhatGnuplotSaid) {
  draw(make_history(1), folder_ / "a");
  const std::string before = read("a.png");
  const FigureFolder work(folder_ / "a");
  EXPECT_THAT(error_of([&] { run_gnuplot(work, "plot 'no such file'", {}, folder_ / "a"); }),
              testing::AllOf(HasSubstr("gnuplot failed"), HasSubstr("no such file")));
  EXPECT_EQ(read("a.png"), before);
}

TEST_F(PlotTest, AMissingGnuplotNamesItsPackage) {
  const std::string path = getenv("PATH");
  setenv("PATH", folder_.c_str(), 1);
  const std::string error = error_of([&] { draw(make_history(1), folder_ / "a"); });
  setenv("PATH", path.c_str(), 1);
  EXPECT_THAT(error, HasSubstr("gnuplot-nox"));
  EXPECT_EQ(entries(), 0);
}

TEST(FitCaption, OfAPowerLawAndAnExponential) {
  const std::vector<double> x = {1e-6, 2e-6, 3e-6, 4e-6}, y = {0.5, 0.36, 0.28, 0.26};
  const auto caption = [&](FitModel model) {
    const auto r = quantity_label("cavity_radius", "m", "R"),
               phi = quantity_label("collapsibility", "1", "Φ");
    return fit_caption(fit_curve(model, x, y), r, display_unit("m", 4e-6), phi, display_unit("1", 0.5));
  };
  EXPECT_THAT(caption(FitModel::power),
              testing::StartsWith("Φ = (0.5002 ± 0.0096) R^(−(0.492 ± 0.026));  R in µm"));
  EXPECT_THAT(caption(FitModel::exponential),
              testing::StartsWith("Φ = (0.620 ± 0.053) exp(−(0.244 ± 0.039) R);  R in µm"));
}

}  // namespace
