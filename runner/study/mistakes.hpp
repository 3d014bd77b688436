#pragma once
/// What is wrong with a study file, collected: a user sees everything at once.
#include <string>
#include <string_view>
#include <vector>

#include "runner/study/document.hpp"

namespace mpmstudy {

/// What is wrong with a value, and what it may be.
struct Refusal {
  std::string wrong;
  std::string allowed;
};

class Mistakes {
 public:
  /// "place: key = value: wrong; allowed". The same line is kept once.
  void add(const Place&, std::string_view key, std::string_view value, const Refusal&);
  void add(std::string_view key, const Value& value, const Refusal& refusal) {
    add(value.place, key, value.written(), refusal);
  }
  /// About a key as a whole: "place: key: wrong; allowed".
  void add(const Place&, std::string_view key, const Refusal&);

  /// All that is in another list.
  void add(const Mistakes&);

  bool empty() const { return lines_.empty(); }
  std::size_t size() const { return lines_.size(); }
  /// The key and the whole line of the first one; there is one.
  const std::string& first_key() const { return lines_.front().key; }
  const std::string& first_line() const { return lines_.front().text; }
  /// Throws StudyError with a line each, in the order of the file; does nothing if there is none.
  void throw_if_any() const;

 private:
  struct Line {
    Place place;
    std::string key, text;
  };
  void keep(const Place&, std::string_view key, std::string text);
  std::vector<Line> lines_;
};

}  // namespace mpmstudy
