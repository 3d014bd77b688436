#include "runner/study/combine.hpp"

#include <algorithm>

#include "libmpm/core/enumerators.hpp"
#include "runner/study/sampling.hpp"
#include "runner/study/schema.hpp"

namespace mpmstudy {
namespace {

constexpr auto mode_names = mpm::words<SweepMode>({{SweepMode::grid, "grid"},
                                                   {SweepMode::zip, "zip"},
                                                   {SweepMode::random, "random"},
                                                   {SweepMode::latin_hypercube, "latin-hypercube"}});

bool is_sampled(SweepMode mode) { return mode == SweepMode::random || mode == SweepMode::latin_hypercube; }

std::optional<std::uint64_t> product(std::uint64_t a, std::uint64_t b) {
  std::uint64_t result = 0;
  return __builtin_mul_overflow(a, b, &result) ? std::nullopt : std::optional(result);
}

/// Reads a whole number that sampling needs and the other modes do not have.
void read_whole(const Table& table, std::string_view key, std::int64_t least, SweepMode mode,
                const Place& place, std::uint64_t& number, Mistakes& mistakes) {
  const Entry* entry = table.find(key);
  if (!is_sampled(mode)) {
    if (entry)
      mistakes.add(key, entry->value,
                   {"does not go with this mode", "it belongs to random and latin-hypercube; remove it"});
    return;
  }
  if (!entry) {
    mistakes.add(place, key, {"missing", "random and latin-hypercube need samples = ... and seed = ..."});
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

/// Modes that draw points need a range on every axis, the others need a number of values.
bool axis_suits(const SweepRequest& request, const Axis& axis, Mistakes& mistakes) {
  const std::string mode(mode_names[static_cast<std::size_t>(request.mode)]);
  if (is_sampled(request.mode) && !axis.range) {
    mistakes.add(axis.value_place, axis.name(), axis.written,
                 {"a list of values in a " + mode + " sweep", "allowed: a range { from = ..., to = ... }"});
    return false;
  }
  if (is_sampled(request.mode) && axis.quantity->range == mpm::Range::count) {
    mistakes.add(axis.value_place, axis.name(), axis.written,
                 {"whole numbers in a " + mode + " sweep", "sweep it in a grid or zip, with values = [...]"});
    return false;
  }
  if (!is_sampled(request.mode) && axis.range && !axis.range->count) {
    mistakes.add(axis.value_place, axis.name(), axis.written,
                 {"no count", "a " + mode + " sweep needs count = ... beside from and to"});
    return false;
  }
  return true;
}

bool is_override(const Place& place) { return place.line == 0 && !place.file.empty(); }

/// Too many jobs. With a --set that sweeps or samples it is said of that one, the largest, since without it
/// the file may be valid; otherwise of the file as a whole, because all its sweeps share in the number.
void refuse_count(const SweepRequest& request, const std::vector<const Axis*>& swept,
                  std::optional<std::uint64_t> jobs, std::uint64_t most_jobs, const Place& file,
                  Mistakes& mistakes) {
  Refusal refusal{"more than can be counted", "sweep fewer values"};
  if (jobs)
    refusal = {"more than " + std::to_string(most_jobs) + " jobs",
               "sweep fewer values, or say --yes if that is meant"};
  if (is_sampled(request.mode) && is_override(request.samples_place)) {
    mistakes.add(request.samples_place, "samples", std::to_string(request.samples), refusal);
    return;
  }
  const Axis* largest = nullptr;
  if (!is_sampled(request.mode))
    for (const Axis* axis : swept)
      if (is_override(axis->value_place) && (!largest || axis->size() > largest->size())) largest = axis;
  if (largest) {
    refusal.wrong = jobs ? "makes " + std::to_string(*jobs) + " jobs, more than " + std::to_string(most_jobs)
                         : "makes more jobs than can be counted";
    mistakes.add(largest->value_place, largest->name(), largest->written, refusal);
  } else if (jobs) {
    mistakes.add(file, "jobs", std::to_string(*jobs), refusal);
  } else {
    mistakes.add(file, "jobs", refusal);
  }
}

}  // namespace

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
  if (is_sampled(request.mode) && request.samples == 0) return std::nullopt;
  return request;
}

std::optional<std::uint64_t> count_jobs(const SweepRequest& request, const std::vector<const Axis*>& swept,
                                        std::uint64_t most_jobs, const Place& file, Mistakes& mistakes) {
  bool good = true;
  for (const Axis* axis : swept) good = axis_suits(request, *axis, mistakes) && good;
  if (!good) return std::nullopt;

  const bool needs_axes = request.mode != SweepMode::grid;
  if (needs_axes && swept.empty()) {
    mistakes.add(request.place, "mode", request.written,
                 {"nothing is swept", "give a parameter several values, or remove [sweep]"});
    return std::nullopt;
  }
  std::optional<std::uint64_t> jobs = 1;
  if (is_sampled(request.mode)) {
    jobs = request.samples;
  } else if (request.mode == SweepMode::zip) {
    jobs = swept.front()->size();
    std::string sizes;
    for (const Axis* axis : swept) {
      sizes +=
          (sizes.empty() ? "" : ", ") + std::string(axis->name()) + " has " + std::to_string(axis->size());
      good = good && axis->size() == *jobs;
    }
    if (!good) {
      mistakes.add(request.place, "mode", request.written,
                   {"a zip of unequal lengths", "all need the same number of values: " + sizes});
      return std::nullopt;
    }
  } else {
    for (const Axis* axis : swept) jobs = jobs ? product(*jobs, axis->size()) : jobs;
  }
  if (jobs && *jobs <= most_jobs) return jobs;
  refuse_count(request, swept, jobs, most_jobs, file, mistakes);
  return std::nullopt;
}

Combinations::Combinations(const SweepRequest& request, const std::vector<const Axis*>& swept,
                           std::uint64_t jobs)
    : jobs_(jobs), columns_(swept.size()) {
  if (is_sampled(request.mode)) {
    const auto samples = request.mode == SweepMode::random
                             ? random_samples(jobs, swept.size(), request.seed)
                             : latin_hypercube(jobs, swept.size(), request.seed);
    for (std::size_t axis = 0; axis < swept.size(); ++axis)
      for (const auto& sample : samples)
        columns_[axis].points.push_back({swept[axis]->range->at(sample[axis]), swept[axis]->value_place});
    return;
  }
  std::uint64_t stride = 1;
  for (std::size_t axis = swept.size(); axis-- > 0;) {
    Column& column = columns_[axis];
    for (std::uint64_t i = 0; i < swept[axis]->size(); ++i) column.points.push_back(swept[axis]->point(i));
    column.stride = stride;
    if (request.mode == SweepMode::grid) stride *= column.points.size();
  }
}

}  // namespace mpmstudy
