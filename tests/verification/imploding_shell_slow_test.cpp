#include "tests/verification/imploding_shell.hpp"

namespace {

class FineImplodingShell : public testing::TestWithParam<shell::Case> {};

TEST_P(FineImplodingShell, StopsWhereItShould) {
  const mpm::Scene s = shell::scene(GetParam(), 0.05e-6);
  const mpm::RunResult r = mpm::run(s);
  shell::expect_good_run(r);
  const shell::Errors to_formula = shell::errors(r, shell::incompressible(s));
  EXPECT_NEAR(to_formula.radius, 0, 0.01);
  EXPECT_NEAR(to_formula.time, 0, 0.02);
  const shell::Errors to_code = shell::errors(r, shell::compressible(s));
  EXPECT_NEAR(to_code.radius, 0, 0.0005);
  EXPECT_NEAR(to_code.time, 0, 0.005);
  EXPECT_LT(scenes::metric(r, "roundness"), 0.01);

  // The radius' error falls with the cell. That of the time does not have to: the shell rings as it stops,
  // its viscosity damps that more on coarse cells, and the two errors have opposite signs.
  double last = std::abs(to_code.radius);
  for (const double cell : {0.1e-6, 0.2e-6}) {
    const mpm::RunResult coarse = mpm::run(shell::scene(GetParam(), cell));
    const double error = std::abs(shell::errors(coarse, shell::compressible(s)).radius);
    EXPECT_GT(error, last) << cell;
    last = error;
  }
}

INSTANTIATE_TEST_SUITE_P(Speeds, FineImplodingShell, testing::ValuesIn(shell::cases),
                         [](const auto& info) { return shell::name_of(info.param); });

}  // namespace
