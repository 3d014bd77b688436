#include "runner/study/searched.hpp"

#include <algorithm>

namespace mpmstudy {

Searched::Searched(const Study& study) : quantity_(mpm::find_quantity(study.search->critical)) {
  for (const mpm::Quantity& row : mpm::quantities())
    if (row.derived && row.name != quantity_->name && row.belongs_to(study.kind) &&
        std::ranges::find(study.given, row.name) != study.given.end())
      kept_.push_back(&row);
}

void Searched::set(mpm::Scene& scene, double value) const {
  std::vector<double> said;
  for (const mpm::Quantity* row : kept_) said.push_back(row->get(scene));
  quantity_->set(scene, value);
  for (std::size_t i = 0; i < kept_.size(); ++i) kept_[i]->set(scene, said[i]);
}

}  // namespace mpmstudy
