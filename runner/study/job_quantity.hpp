#pragma once
/// A number of a study that may be an expression of its parameters: read once, valued job by job.
#include <optional>
#include <string>
#include <string_view>
#include <variant>

#include "runner/study/quantity_reader.hpp"

namespace mpmstudy {

class JobQuantity {
 public:
  /// "2 ns", a plain number where the unit is "1", or an expression. Empty after adding a mistake.
  static std::optional<JobQuantity> read(std::string_view key, const Value&, const Expected&, const Units&,
                                         const KnownParameters&, Mistakes&);
  /// The same of a part of a text: of "mean 1 ns to 3 ns", "rear > limit".
  static std::optional<JobQuantity> read_part(std::string_view key, const Value& whole, std::string_view part,
                                              const Expected&, const Units&, const KnownParameters&,
                                              Mistakes&);

  const Place& place() const { return place_; }
  const std::string& written() const { return written_; }
  /// The same in every job. Null: each has its own.
  const double* constant() const { return std::get_if<double>(&number_); }
  /// Of one job, `of` its parameters [SI]. Empty after adding a mistake: it cannot have that value.
  std::optional<double> value(const ValueOf& of, Mistakes&) const;

 private:
  static std::optional<JobQuantity> read(std::string_view key, const Value&, const Value& whole,
                                         const Expected&, const Units&, const KnownParameters&, Mistakes&);
  JobQuantity(std::string_view key, const Value&, const Expected&, std::variant<double, Expression>);

  Place place_;
  std::string key_, written_;
  Expected expected_;  ///< its unit is text of a table
  std::variant<double, Expression> number_;
};

}  // namespace mpmstudy
