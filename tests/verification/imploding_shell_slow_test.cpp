#include "libmpm/verification/problems/problems.hpp"
#include "tests/verification/shell_cases.hpp"

namespace {

class FineImplodingShell : public testing::TestWithParam<ShellCase> {};

TEST_P(FineImplodingShell, StopsWhereItShould) {
  const auto solve = [](double cells) {
    return mpm::verification::imploding_shell_numbers(GetParam().inner_speed, GetParam().hardening,
                                                      {.cells = cells});
  };
  const auto fine = solve(1);
  expect_all_hold(fine);
  // The radius' error falls with the cell. That of the time does not have to: the shell rings as it stops,
  // its viscosity damps that more on coarse cells, and the two errors have opposite signs.
  double last = mpm::verification::number_of(fine, "stop radius, compressible").error();
  for (const double cells : {2, 4}) {
    const double error = mpm::verification::number_of(solve(cells), "stop radius, compressible").error();
    EXPECT_GT(error, last) << cells;
    last = error;
  }
}

INSTANTIATE_TEST_SUITE_P(Speeds, FineImplodingShell, testing::ValuesIn(shell_cases), name_of_shell);

}  // namespace
