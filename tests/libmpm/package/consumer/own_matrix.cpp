// Matrices of the library, used beyond what its headers use themselves: links with mpm.hpp alone.
#include "libmpm/mpm.hpp"

int main() {
  mpm::Mat2 stretch;
  stretch << 2, 1, 0, 4;
  return stretch.inverse()(1, 1) == 0.25 && stretch.determinant() == 8 ? 0 : 1;
}
