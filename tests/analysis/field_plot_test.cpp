#include "analysis/field_plot.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "temporary_folder.hpp"

namespace {

using namespace analysis;
using testing::HasSubstr;

class FieldPlotTest : public TemporaryFolderTest {};

/// Half a block of 2 x 2 around a round hole at the origin, x >= 0; value y.
ParticleSquares make_block(double spacing, double hole) {
  ParticleSquares p;
  for (double x = spacing / 2; x < 1; x += spacing)
    for (double y = -1 + spacing / 2; y < 1; y += spacing) {
      if (std::hypot(x, y) < hole) continue;
      p.x.push_back(x);
      p.y.push_back(y);
      p.size.push_back(spacing);
      p.value.push_back(y);
    }
  return p;
}

TEST(Raster, KeepsAreaOfTheHoleAndMirrors) {
  const Raster raster = rasterise(make_block(0.02, 0.5), true, {-1, 1, -1, 1}, 400, 400, 1.0);
  int empty = 0;
  for (const float v : raster.values) empty += std::isnan(v);
  EXPECT_NEAR(4.0 * empty / 160000, std::numbers::pi * 0.25, 0.02);
  for (int j = 0; j < 400; ++j)
    for (int i = 0; i < 200; ++i) {
      const float left = raster.values[j * 400 + i], right = raster.values[j * 400 + 399 - i];
      EXPECT_TRUE(left == right || (std::isnan(left) && std::isnan(right)));
    }
  EXPECT_NEAR(raster.values[0], -0.99, 1e-6) << "the first row is the lowest";
}

TEST(Raster, AParticleSmallerThanAPixelIsSeen) {
  const Raster raster = rasterise({{0.31}, {0.52}, {1e-9}, {7}}, false, {0, 1, 0, 1}, 10, 10);
  EXPECT_EQ(raster.values[5 * 10 + 3], 7);
}

TEST(Raster, WhatIsOutsideOrNotANumberIsLeftOut) {
  const double nan = std::nan("");
  const ParticleSquares p{{5, nan, 0.5}, {5, 0.5, 0.5}, {0.1, 0.1, 0.1}, {1, 1, nan}};
  for (const float v : rasterise(p, true, {0, 1, 0, 1}, 10, 10).values) EXPECT_TRUE(std::isnan(v));
}

TEST(Raster, WindowLeavesAStrayParticleOut) {
  ParticleSquares p = make_block(0.02, 0.5);
  p.x.push_back(0.1), p.y.push_back(1000), p.size.push_back(0.02), p.value.push_back(0);
  const Window w = window_of({&p}, true);
  EXPECT_LT(w.y_max, 1.2);
  EXPECT_EQ(w.x_min, -w.x_max);
  EXPECT_GT(w.x_max, 0.99);
}

TEST_F(FieldPlotTest, PanelsTitlesUnitsAndSize) {
  FieldPlot plot;
  plot.title = "Pressure";
  plot.footer = "physics version 1";
  plot.value = quantity_label("pressure", "Pa", "P");
  plot.mirrored = true;
  for (const double t : {1.0e-9, 1.62e-9, 2.2e-9, 16e-9}) {
    FieldPanel panel{value_label(quantity_label("time", "s", "t"), t), make_block(0.05, 0.5)};
    for (auto column : {&ParticleSquares::x, &ParticleSquares::y, &ParticleSquares::size})
      for (double& v : panel.particles.*column) v *= 5e-6;
    for (double& v : panel.particles.value) v *= 3e9;
    plot.panels.push_back(panel);
  }
  draw(plot, folder_ / "f");
  const std::string svg = read("f.svg");
  for (const char* text : {"t = 1 ns", "t = 1.62 ns", "t = 2.2 ns", "t = 16 ns", "x (µm)", "y (µm)",
                           "Pressure P (GPa)", "physics version 1"})
    EXPECT_THAT(svg, HasSubstr(text));
  EXPECT_EQ(count(svg, "<image "), 4);
  EXPECT_EQ(count(svg, "Pressure P (GPa)"), 1) << "one colour bar";
  EXPECT_LT(svg.size(), 1000000u);
  const auto [width, height] = png_size(read("f.png"));
  EXPECT_LE(width, 1800);
  EXPECT_GT(height, 600);
  EXPECT_EQ(entries(), 2);

  plot.palette = Palette::grey;
  draw(plot, folder_ / "g");
  EXPECT_NE(read("f.png"), read("g.png"));
}

/// x of the middle of a text in an SVG of gnuplot.
double place_of(const std::string& svg, const std::string& text) {
  const auto end = svg.find(text), at = svg.rfind("translate(", end);
  return std::stod(svg.substr(at + 10));
}

// A line between materials that touch, along their border; none around them, and none beside the hole.
TEST(Raster, OutlinesMaterials) {
  ParticleSquares p = make_block(0.02, 0.5);
  EXPECT_TRUE(outlines(p, true, {-1.1, 1.1, -1.1, 1.1}, 440, 440).empty());
  for (const double y : p.y) p.material.push_back(y > 0.75 ? 1 : 0);
  double length = 0;
  for (const Piece& piece : outlines(p, true, {-1.1, 1.1, -1.1, 1.1}, 440, 440)) {
    length += std::hypot(piece.x1 - piece.x0, piece.y1 - piece.y0);
    EXPECT_NEAR(piece.y0, 0.75, 0.02);
  }
  EXPECT_NEAR(length, 2, 0.05);
}

TEST_F(FieldPlotTest, MaterialsAreOutlinedAndLengthsHaveABar) {
  FieldPlot plot;
  plot.value = quantity_label("pressure", "Pa", "P");
  plot.panels.push_back({"t = 0 ns", make_block(0.05, 0.5)});
  plot.panels.push_back(plot.panels[0]);
  draw(plot, folder_ / "one");
  EXPECT_EQ(count(read("one.svg"), ">0.2 m<"), 1) << "in the first panel";
  for (FieldPanel& panel : plot.panels)
    for (const double y : panel.particles.y) panel.particles.material.push_back(y > 0);
  draw(plot, folder_ / "two");
  EXPECT_GT(count(read("two.svg"), "<path "), count(read("one.svg"), "<path "));
  plot.panels[0].particles.material.pop_back();
  EXPECT_THROW(draw(plot, folder_ / "f"), std::invalid_argument);
}

TEST_F(FieldPlotTest, TitlesOfNarrowPanelsStandApart) {
  FieldPlot plot;
  plot.title = "Pressure";
  plot.value = quantity_label("pressure", "Pa", "P");
  for (const char* title : {"t = 1.6201 ns", "t = 1.6202 ns", "t = 1.6203 ns"}) {
    ParticleSquares p = make_block(0.05, 0.5);
    for (double& x : p.x) x /= 20;  // a tall, narrow body
    plot.panels.push_back({title, p});
  }
  draw(plot, folder_ / "narrow");
  const std::string svg = read(folder_ / "narrow.svg");
  const double apart = place_of(svg, "t = 1.6202 ns") - place_of(svg, "t = 1.6201 ns");
  EXPECT_GT(apart, 13 * 0.55 * 8) << "thirteen letters of at least 8 points";
}

TEST_F(FieldPlotTest, OneParticleWithoutAValueToSpeakOfIsDrawn) {
  FieldPlot plot;
  plot.value = quantity_label("plastic_work", "J/m^3");
  plot.panels.push_back({"t = 0 ns", {{1e-6}, {2e-6}, {1e-7}, {0}}});
  draw(plot, folder_ / "one");
  EXPECT_GT(png_size(read("one.png")).first, 0);
}

TEST_F(FieldPlotTest, NothingToDrawIsAnError) {
  FieldPlot plot;
  EXPECT_THROW(draw(plot, folder_ / "f"), std::invalid_argument);
  plot.panels.push_back({"t", {{1}, {1}, {1}, {}}});
  EXPECT_THROW(draw(plot, folder_ / "f"), std::invalid_argument);
}

TEST(Raster, ShowsTheParticleThatIsNearestToThePlaneOfThePicture) {
  for (const bool swapped : {false, true}) {
    ParticleSquares two{{0, 0}, {0, 0}, {1, 1}, {7, 8}};
    two.depth = swapped ? std::vector<double>{0.9, 0.2} : std::vector<double>{0.2, 0.9};
    const auto raster = rasterise(two, false, {-0.5, 0.5, -0.5, 0.5}, 3, 3);
    for (const float value : raster.values) EXPECT_EQ(value, swapped ? 8 : 7);
  }
}

}  // namespace
