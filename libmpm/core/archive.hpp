#pragma once
/// What a run holds between two steps, as plain named columns; and the way in and out of them.
#include <cstdint>
#include <cstring>
#include <map>
#include <string>
#include <type_traits>
#include <vector>

#include "libmpm/core/errors.hpp"

namespace mpm {

/// The content of a checkpoint.
struct Record {
  std::map<std::string, std::vector<double>> numbers;
  std::map<std::string, std::vector<std::int64_t>> integers;
};

/// Passes members by name into a record, or back out of it. An object has one function `carry` for both ways,
/// so that they cannot differ:
///
///   void carry(Archive& a) { a.numbers("times", times_), a.integer("step", step_); }
///
/// Every bit is kept. Loading throws InputError where the record does not fit.
class Archive {
 public:
  static Archive to(Record& record) { return Archive(record, false, ""); }
  static Archive from(Record& record) { return Archive(record, true, ""); }
  bool loading() const { return loading_; }
  /// The same, with this before the names.
  Archive part(const std::string& name) const { return Archive(*record_, loading_, prefix_ + name + "/"); }

  /// A number, or something that is made of doubles alone (Vec2, PlaneTensor).
  template <class T>
  void number(const std::string& name, T& value) {
    std::vector<T> one(1, value);
    numbers(name, one);
    if (one.size() != 1) fail(name);
    value = one[0];
  }
  /// A column of the same; its length is kept too.
  template <class T>
  void numbers(const std::string& name, std::vector<T>& column) {
    static_assert(sizeof(T) % sizeof(double) == 0 && !std::is_integral_v<T>);
    constexpr std::size_t each = sizeof(T) / sizeof(double);
    std::vector<double>& flat = place(record_->numbers, name);
    if (loading_ && flat.size() % each != 0) fail(name);
    if (loading_)
      column.resize(flat.size() / each);
    else
      flat.resize(column.size() * each);
    if (flat.empty()) return;
    void* const values = column.data();
    if (loading_)
      std::memcpy(values, flat.data(), flat.size() * sizeof(double));
    else
      std::memcpy(flat.data(), values, flat.size() * sizeof(double));
  }
  /// An integer, a bool, an enum.
  template <class T>
  void integer(const std::string& name, T& value) {
    std::vector<T> one(1, value);
    integers(name, one);
    if (one.size() != 1) fail(name);
    value = one[0];
  }
  template <class T>
  void integers(const std::string& name, std::vector<T>& column) {
    std::vector<std::int64_t>& wide = place(record_->integers, name);
    if (loading_) {
      column.clear();
      for (const std::int64_t value : wide) column.push_back(static_cast<T>(value));
    } else {
      wide.clear();
      for (const auto value : column) wide.push_back(static_cast<std::int64_t>(value));
    }
  }

 private:
  Archive(Record& record, bool loading, std::string prefix)
      : record_(&record), loading_(loading), prefix_(std::move(prefix)) {}
  [[noreturn]] void fail(const std::string& name) const {
    throw InputError("checkpoint: " + prefix_ + name + " is missing, or is of another scene");
  }
  template <class Columns>
  typename Columns::mapped_type& place(Columns& columns, const std::string& name) {
    if (!loading_) return columns[prefix_ + name];
    const auto found = columns.find(prefix_ + name);
    if (found == columns.end()) fail(name);
    return found->second;
  }

  Record* record_;
  bool loading_;
  std::string prefix_;
};

}  // namespace mpm
