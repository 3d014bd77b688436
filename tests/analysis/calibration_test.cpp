#include "analysis/calibration.hpp"

#include <gmock/gmock.h>

#include <stdexcept>

#include "analysis/calibration_plot.hpp"
#include "tests/analysis/temporary_folder.hpp"

namespace analysis {
namespace {

TEST(Calibration, CountsWhatHoldsAndTakesTheMedian) {
  const std::vector<std::pair<double, double>> pairs = {{0.1, 0.1}, {0.2, 0.21}, {0.4, 0.0}, {0.3, 0.1}};
  const auto c = calibrate(pairs);
  EXPECT_EQ(c.points, 4);
  EXPECT_DOUBLE_EQ(c.covered, 0.75);
  EXPECT_DOUBLE_EQ(c.median_half_width, 0.25);
  EXPECT_DOUBLE_EQ(calibrate(std::span(pairs).first(3)).median_half_width, 0.2);
  EXPECT_THROW(calibrate({}), std::invalid_argument);
}

class CalibrationFigure : public TemporaryFolderTest {};

TEST_F(CalibrationFigure, SaysHowOften) {
  const std::vector<CalibrationPoint> points = {{0.02, 0.01, 0.01, 0.004}, {0.03, 0.05, 0.02, 0.0}};
  const std::string caption = calibration_caption(points);
  EXPECT_THAT(caption, testing::HasSubstr("2 jobs"));
  EXPECT_THAT(caption, testing::HasSubstr("about the value: 50 % hold, median ± 2.5 %"));
  EXPECT_THAT(caption, testing::HasSubstr("about the extrapolated value: 100 % hold, median ± 1.5 %"));
  draw({"Title", "footer", points}, folder_ / "calibration");
  EXPECT_TRUE(std::filesystem::exists(folder_ / "calibration.svg"));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "calibration.png"));
  EXPECT_THROW(draw({"Title", "", {}}, folder_ / "none"), std::invalid_argument);
}

}  // namespace
}  // namespace analysis
