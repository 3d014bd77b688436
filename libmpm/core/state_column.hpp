#pragma once
/// What a material keeps of a particle beside stress, density and energy. A model lists its columns; from the
/// list follow the memory of the particles, the checkpoint and the lanes of the fast step.
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace mpm {

/// What the numbers of a column are the components of.
enum class StateForm {
  number,
  deviator,  ///< xx, yy, xy; of three axes xz, yz too
  symmetric  ///< xx, yy, zz, xy; of three axes xz, yz too
};

constexpr int numbers_in(StateForm form, int axes) {
  switch (form) {
    case StateForm::number:
      return 1;
    case StateForm::deviator:
      return axes == 2 ? 3 : 5;
    case StateForm::symmetric:
      return axes == 2 ? 4 : 6;
  }
  return 0;
}

/// In SI units; every number of it is 0 in material at rest.
struct StateColumn {
  std::string_view name;  ///< "plastic_strain"
  StateForm form = StateForm::number;
};

/// Numbers of all columns of a particle.
template <class Columns>
constexpr int numbers_in(const Columns& columns, int axes) {
  int sum = 0;
  for (const StateColumn& column : columns) sum += numbers_in(column.form, axes);
  return sum;
}

/// A column with its values, `each` for a particle, side by side.
struct MaterialColumn {
  std::string name;
  int each;
  std::vector<double> values;
};

}  // namespace mpm
