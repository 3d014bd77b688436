#pragma once
#include <string>

#include "tests/libmpm/scenes.hpp"
#include "tests/verification/expect_numbers.hpp"

/// Rows of verney_cylinder_al.csv, with and without hardening.
struct ShellCase {
  double inner_speed;  ///< [m/s]
  bool hardening;      ///< H = sqrt(3/2) 384 MPa, else none
};
inline constexpr ShellCase shell_cases[] = {{131.0531, false}, {185.0293, false}, {225.0374, false},
                                            {255.9773, false}, {131.0531, true},  {185.0293, true},
                                            {225.0374, true},  {255.9773, true}};

inline std::string name_of_shell(const testing::TestParamInfo<ShellCase>& info) {
  return "u" + std::to_string(static_cast<int>(info.param.inner_speed)) +
         (info.param.hardening ? "hardening" : "ideal");
}
