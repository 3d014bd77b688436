#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "libmpm/scene/scene.hpp"

namespace mpm {

/// A number for a message: the shortest text that reads as the same bits.
std::string text_of(double);

/// Collects what is wrong with a scene; values and units come from the table of parameters. A limit that is a
/// quantity stands in `allowed` in parentheses, with its SI unit and nothing else: "at most cavity_radius ("
/// + text_of(r) + " m)". Who knows the units of a file writes it in them (runner/study/written_unit.hpp).
class Report {
 public:
  explicit Report(const Scene& scene) : scene_(scene) {}

  void add(std::string_view quantity, std::string allowed);
  void add_choice(std::string_view choice, std::string allowed);
  /// Of what has no row in the table.
  void add_other(std::string what, std::string value, std::string allowed);
  void require(bool fine, std::string_view quantity, std::string allowed);
  bool empty() const { return problems_.empty(); }
  std::vector<Problem> take() { return std::move(problems_); }

 private:
  const Scene& scene_;
  std::vector<Problem> problems_;
};

}  // namespace mpm
