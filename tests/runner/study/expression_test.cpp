// Expressions of the parameters of a study.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "runner/study/expression.hpp"

namespace mpmstudy {
namespace {

const Units& units() {
  static const Units units;
  return units;
}

/// A parameter: its value and its unit.
const std::map<std::string, std::pair<double, std::string>, std::less<>> parameters = {
    {"radius", {1.5e-6, "m"}}, {"height", {5e-6, "m"}}, {"speed", {200, "m/s"}}, {"share", {2, "1"}}};

std::variant<Expression, ExpressionRefusal> read(std::string_view text) {
  return Expression::read(text, units(),
                          [](std::string_view name) -> std::optional<Dimension> {
                            const auto found = parameters.find(name);
                            if (found == parameters.end()) return std::nullopt;
                            return units().dimension(found->second.second);
                          },
                          {"radius", "height", "speed", "share"});
}

struct Valued {
  double value;
  std::string dimension;
};
Valued valued(std::string_view text) {
  const auto result = read(text);
  if (const auto* refusal = std::get_if<ExpressionRefusal>(&result)) {
    ADD_FAILURE() << text << ": " << refusal->wrong;
    return {};
  }
  const auto& e = std::get<Expression>(result);
  return {e.value([](const std::string& name) { return parameters.find(name)->second.first; }),
          e.dimension().text()};
}
void expect(std::string_view text, double value, const std::string& dimension) {
  const Valued got = valued(text);
  EXPECT_NEAR(got.value, value, 1e-12 * std::abs(value)) << text;
  EXPECT_EQ(got.dimension, dimension) << text;
}

std::string refused(std::string_view text) {
  const auto result = read(text);
  const auto* refusal = std::get_if<ExpressionRefusal>(&result);
  if (!refusal) return "";
  return std::to_string(refusal->at) + ": " + refusal->wrong + "; " + refusal->allowed;
}

TEST(Expression, HasAValueAndAUnit) {
  expect("height - radius", 3.5e-6, "m");
  expect("2*radius + 0.2 um", 3.2e-6, "m");
  expect("-speed", -200, "m s-1");
  expect("height/speed", 2.5e-8, "s");
  expect("(height - 2 * radius) / 2", 1e-6, "m");
  expect("radius^2 * pi", 1.5e-6 * 1.5e-6 * M_PI, "m2");
  expect("sqrt(radius*height)", std::sqrt(7.5e-12), "m");
  expect("max(radius, 1mm)", 1e-3, "m");
  expect("2 kg/m3 * speed^2", 80000, "m-1 kg s-2");
  expect("3 m/s + speed", 203, "m s-1");
  expect("radius / height", 0.3, "1");
  expect("cos(60 deg)", 0.5, "1");
  expect("5 GPa", 5e9, "m-1 kg s-2");
  expect("1 um + 2 um", 3e-6, "m");
  expect("share * radius", 3e-6, "m");
  expect("radius > 1 um ? radius : height", 1.5e-6, "m");
}

TEST(Expression, NothingHasEveryUnit) {
  const auto zero = read("0 * speed"), speed = read("speed");
  EXPECT_TRUE(std::get<Expression>(zero).has(*units().dimension("m")));
  EXPECT_FALSE(std::get<Expression>(speed).has(*units().dimension("m")));
}

TEST(Expression, SaysWhatIsWrongAndWhere) {
  EXPECT_EQ(refused("height - radus"),
            "9: no such parameter: radus; did you mean \"radius\"? allowed: radius, height, speed, share");
  EXPECT_THAT(refused("height - 3"), testing::HasSubstr("adds or compares quantities of different units"));
  EXPECT_THAT(refused("height + speed"), testing::HasSubstr("different units"));
  EXPECT_THAT(refused("height * 3 parsnip"), testing::StartsWith("9: 'parsnip' is not a unit"));
  EXPECT_THAT(refused("height * (2"), testing::HasSubstr("not an expression: "));
  EXPECT_THAT(refused("height +"), testing::HasSubstr("not an expression: "));
  EXPECT_THAT(refused("height + 20 degC"), testing::HasSubstr("zero point"));
  EXPECT_THAT(refused("radius > 1e-7 s ? radius : 2 * radius"), testing::HasSubstr("different units"));
  EXPECT_THAT(refused("radius = 2 um"), testing::StartsWith("7: an expression gives nothing a value"));
  EXPECT_THAT(refused("radius, 2 * radius"), testing::StartsWith("6: more than one value"));
  EXPECT_THAT(refused("sin(height)"), testing::HasSubstr("different units"));
}

TEST(Expression, NamesAreWordsBehindNoNumber) {
  EXPECT_THAT(names_in("2 um + radius * max(b_2, 3 m/s)"), testing::ElementsAre("radius", "b_2"));
  EXPECT_THAT(names_in("10 um"), testing::IsEmpty());
}

}  // namespace
}  // namespace mpmstudy
