#include "runner/study/figure_files.hpp"

#include <fmt/format.h>

#include <charconv>
#include <map>
#include <string>
#include <string_view>

#include "runner/study/figure_kinds.hpp"

namespace mpmstudy {

void check_figure_files(const Table& document, std::size_t jobs, Mistakes& mistakes) {
  const Entry* entry = document.find("figure");
  const List* list = entry ? entry->value.list() : nullptr;
  if (!list) return;
  std::map<std::string, const Value*> names;
  std::map<std::string, bool> fields;  // figures that have several files; whether each is there in grey, too
  for (const Value& one : *list) {
    const Table* table = one.table();
    const Entry *name = table->find("name"), *kind = table->find("kind");
    names.emplace(*name->value.string(), &name->value);
    const FigureKindRow& row = *find_figure_kind(*kind->value.string());
    if (row.of_snapshots || row.has_colour) fields.emplace(*name->value.string(), row.of_snapshots);
  }
  const auto refuse = [&](const std::string& file, const std::string& of) {
    if (const auto other = names.find(file); other != names.end())
      mistakes.add("name", *other->second,
                   {fmt::format("{}.png is also a file of figure \"{}\", which has a file per {}: NAME-1, "
                                "NAME-2, ...{}",
                                file, of, fields.at(of) ? "job" : "group of jobs",
                                fields.at(of) ? ", and each as NAME-1-grey, ..." : ""),
                    "allowed: a name that is none of these"});
  };
  for (const auto& [name, is_grey] : fields) {
    if (is_grey) refuse(name + "-grey", name);  // without a number where one job is done only
    for (const auto& [other, value] : names) {
      // One that has a file per job has a number at its end where this one has, and is another file.
      if (fields.contains(other) || !other.starts_with(name + "-")) continue;
      std::string_view rest = std::string_view(other).substr(name.size() + 1);
      if (is_grey && rest.ends_with("-grey")) rest.remove_suffix(5);
      std::size_t number = 0;
      const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), number);
      const bool whole = error == std::errc() && end == rest.data() + rest.size() && rest[0] != '0';
      if (whole && jobs > 1 && number <= jobs) refuse(other, name);
    }
  }
}

}  // namespace mpmstudy
