#include "runner/study/sweep_request.hpp"

#include <algorithm>
#include <array>

#include "libmpm/core/enumerators.hpp"
#include "runner/study/schema.hpp"

namespace mpmstudy {
namespace {

constexpr auto mode_names = mpm::words<SweepMode>({{SweepMode::grid, "grid"},
                                                   {SweepMode::zip, "zip"},
                                                   {SweepMode::random, "random"},
                                                   {SweepMode::latin_hypercube, "latin-hypercube"},
                                                   {SweepMode::sobol, "sobol"},
                                                   {SweepMode::halton, "halton"}});
constexpr std::array<std::string_view, 2> invalid_words = {"error", "skip"};

std::string sampled_modes() {
  std::vector<std::string_view> sampled;
  for (std::size_t k = 0; k < mode_names.size(); ++k)
    if (is_sampled(static_cast<SweepMode>(k))) sampled.push_back(mode_names[k]);
  return listed(sampled);
}

/// Reads a whole number that sampling needs and the other modes do not have.
void read_whole(const Table& table, std::string_view key, std::int64_t least, SweepMode mode,
                const Place& place, std::uint64_t& number, Mistakes& mistakes) {
  const Entry* entry = table.find(key);
  if (!is_sampled(mode)) {
    if (entry)
      mistakes.add(key, entry->value,
                   {"does not go with mode \"" + std::string(to_string(mode)) + "\"",
                    "remove it, or write mode = \"...\" with one of " + sampled_modes()});
    return;
  }
  if (!entry) {
    mistakes.add(
        place, key,
        {"missing", "mode \"" + std::string(to_string(mode)) + "\" needs samples = ... and seed = ..."});
    return;
  }
  const auto* whole = std::get_if<std::int64_t>(&entry->value.data);
  if (!whole || *whole < least)
    mistakes.add(key, entry->value,
                 {"not a whole number of " + std::to_string(least) + " or more",
                  "write for example " + std::string(key) + " = 100"});
  else
    number = static_cast<std::uint64_t>(*whole);
}

/// One list of names. Empty after adding a mistake.
std::optional<ZipGroup> read_group(const Value& value, Mistakes& mistakes) {
  constexpr const char* allowed =
      "allowed: groups of two names or more, such as [[\"material\", \"impact_speed\"]]";
  ZipGroup group{{}, value.place, "zip", value.written()};
  const List* names = value.list();
  if (!names || names->size() < 2) {
    mistakes.add("zip", value, {"not a group of swept parameters", allowed});
    return std::nullopt;
  }
  for (const Value& name : *names) {
    if (!name.string()) {
      mistakes.add("zip", name, {"not the name of a parameter", allowed});
      return std::nullopt;
    }
    group.names.push_back(*name.string());
  }
  return group;
}

void read_groups(const Table& table, SweepRequest& request, Mistakes& mistakes) {
  const Entry* entry = table.find("zip");
  if (!entry) return;
  if (request.mode != SweepMode::grid) {
    mistakes.add("zip", entry->value,
                 {"does not go with mode \"" + std::string(to_string(request.mode)) + "\"",
                  "groups are of a grid; remove mode, or zip"});
    return;
  }
  const List one = {entry->value};
  const List& groups = entry->value.list() ? *entry->value.list() : one;
  std::vector<std::string> named;
  for (const Value& value : groups)
    if (auto group = read_group(value, mistakes)) {
      for (const std::string& name : group->names) {
        if (std::ranges::find(named, name) != named.end())
          mistakes.add("zip", value, {name + " stands in it twice", "allowed: each parameter once"});
        named.push_back(name);
      }
      request.groups.push_back(std::move(*group));
    }
}

}  // namespace

std::string_view to_string(SweepMode mode) { return mode_names[static_cast<std::size_t>(mode)]; }

bool is_sampled(SweepMode mode) { return mode != SweepMode::grid && mode != SweepMode::zip; }

std::optional<SweepRequest> read_sweep(const Table* table, Mistakes& mistakes) {
  SweepRequest request;
  if (!table) return request;
  if (const Entry* entry = table->find("mode")) {
    const auto word = find_word("mode", entry->value, "mode", mode_names, mistakes);
    if (!word) return std::nullopt;
    request.mode = static_cast<SweepMode>(*word);
    request.place = entry->value.place;
    request.written = entry->value.written();
  }
  if (const Entry* entry = table->find("samples")) request.samples_place = entry->value.place;
  read_whole(*table, "samples", 1, request.mode, request.place, request.samples, mistakes);
  read_whole(*table, "seed", 0, request.mode, request.place, request.seed, mistakes);
  read_groups(*table, request, mistakes);
  if (const Entry* entry = table->find("invalid")) {
    request.invalid_place = entry->value.place;
    request.skips_invalid =
        find_word("invalid", entry->value, "choice", invalid_words, mistakes).value_or(0) == 1;
  }
  if (is_sampled(request.mode) && request.samples == 0) return std::nullopt;
  return request;
}

}  // namespace mpmstudy
