#include "runner/study/combine.hpp"

#include <algorithm>
#include <string>

#include "runner/study/quasi_random.hpp"
#include "runner/study/sampling.hpp"

namespace mpmstudy {
namespace {

std::optional<std::uint64_t> product(std::uint64_t a, std::uint64_t b) {
  std::uint64_t result = 0;
  return __builtin_mul_overflow(a, b, &result) ? std::nullopt : std::optional(result);
}

/// Modes that draw points need a range on every axis, the others need a number of values.
bool axis_suits(const SweepRequest& request, const Axis& axis, Mistakes& mistakes) {
  const std::string mode(to_string(request.mode));
  if (is_sampled(request.mode) && !axis.range) {
    mistakes.add(axis.value_place, axis.name(), axis.written,
                 {"a list of values in a " + mode + " sweep",
                  "allowed: a range { from = ..., to = ... } or a distribution"});
    return false;
  }
  if (is_sampled(request.mode) && axis.quantity->range == mpm::Range::count) {
    mistakes.add(axis.value_place, axis.name(), axis.written,
                 {"whole numbers in a " + mode + " sweep", "sweep it in a grid or zip, with values = [...]"});
    return false;
  }
  if (!is_sampled(request.mode) && axis.range && axis.range->is_distribution) {
    mistakes.add(axis.value_place, axis.name(), axis.written,
                 {"a distribution in a " + mode + " sweep",
                  "write mode = \"sobol\", \"latin-hypercube\", ... in [sweep], or values = [...]"});
    return false;
  }
  if (!is_sampled(request.mode) && axis.range && !axis.range->count) {
    mistakes.add(axis.value_place, axis.name(), axis.written,
                 {"no count", "a " + mode + " sweep needs count = ... beside from and to"});
    return false;
  }
  return true;
}

/// Axes whose values go together: one, or those of a group.
struct Group {
  std::vector<std::size_t> axes;
  const ZipGroup* of = nullptr;  ///< null: one axis by itself, or all of another mode than grid
};

/// Each where its first axis stands in the file.
std::vector<Group> groups_of(const SweepRequest& request, const std::vector<const Axis*>& swept) {
  std::vector<Group> groups;
  for (std::size_t axis = 0; axis < swept.size(); ++axis) {
    const ZipGroup* of = nullptr;
    for (const ZipGroup& group : request.groups)
      if (std::ranges::find(group.names, swept[axis]->name()) != group.names.end()) of = &group;
    const auto known = std::ranges::find_if(groups, [&](const Group& group) {
      return request.mode != SweepMode::grid || (of && group.of == of);
    });
    if (known != groups.end())
      known->axes.push_back(axis);
    else
      groups.push_back({{axis}, of});
  }
  return groups;
}

/// The axes of a group are swept, and have equally many values.
bool groups_suit(const SweepRequest& request, const std::vector<const Axis*>& swept, Mistakes& mistakes) {
  bool good = true;
  for (const ZipGroup& group : request.groups)
    for (const std::string& name : group.names) {
      if (group.of_file || std::ranges::find(swept, name, &Axis::name) != swept.end()) continue;
      std::string allowed;
      for (const Axis* axis : swept) allowed += (allowed.empty() ? "" : ", ") + std::string(axis->name());
      mistakes.add(group.place, group.key, group.written,
                   {name + " is not swept", allowed.empty() ? "nothing is" : "allowed: " + allowed});
      good = false;
    }
  for (const Group& group : groups_of(request, swept)) {
    const auto differs = [&](std::size_t axis) {
      return swept[axis]->size() != swept[group.axes.front()]->size();
    };
    if (std::ranges::none_of(group.axes, differs)) continue;
    std::string sizes;
    for (const std::size_t axis : group.axes)
      sizes += (sizes.empty() ? "" : ", ") + std::string(swept[axis]->name()) + " has " +
               std::to_string(swept[axis]->size());
    mistakes.add(group.of ? group.of->place : request.place, group.of ? group.of->key : "mode",
                 group.of ? group.of->written : request.written,
                 {"a zip of unequal lengths", "all need the same number of values: " + sizes});
    good = false;
  }
  return good;
}

UnitSamples samples_of(const SweepRequest& request, std::size_t axes, std::uint64_t samples) {
  switch (request.mode) {
    case SweepMode::sobol:
      return sobol_points(samples, axes, request.seed);
    case SweepMode::halton:
      return halton_points(samples, axes, request.seed);
    case SweepMode::latin_hypercube:
      return latin_hypercube(samples, axes, request.seed);
    default:
      return random_samples(samples, axes, request.seed);
  }
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

std::vector<std::vector<std::string>> swept_together(const SweepRequest& request,
                                                     const std::vector<const Axis*>& swept) {
  std::vector<std::vector<std::string>> together;
  for (const Group& group : groups_of(request, swept)) {
    if (group.axes.size() < 2) continue;
    together.emplace_back();
    for (const std::size_t axis : group.axes) together.back().emplace_back(swept[axis]->name());
  }
  return together;
}

std::optional<std::uint64_t> count_jobs(const SweepRequest& request, const std::vector<const Axis*>& swept,
                                        std::uint64_t most_jobs, const Place& file, Mistakes& mistakes) {
  bool good = true;
  for (const Axis* axis : swept) good = axis_suits(request, *axis, mistakes) && good;
  if (!good) return std::nullopt;

  const bool needs_axes = request.mode != SweepMode::grid;
  if (needs_axes && swept.empty()) {
    if (mistakes.empty())  // else what is swept may be what is wrong
      mistakes.add(request.place, "mode", request.written,
                   {"nothing is swept", "give a parameter several values, or remove [sweep]"});
    return std::nullopt;
  }
  std::optional<std::uint64_t> jobs = 1;
  if (is_sampled(request.mode)) {
    jobs = request.samples;
  } else {
    if (!groups_suit(request, swept, mistakes)) return std::nullopt;
    for (const Group& group : groups_of(request, swept))
      jobs = jobs ? product(*jobs, swept[group.axes.front()]->size()) : jobs;
  }
  if (jobs && *jobs <= most_jobs) return jobs;
  refuse_count(request, swept, jobs, most_jobs, file, mistakes);
  return std::nullopt;
}

Combinations::Combinations(const SweepRequest& request, const std::vector<const Axis*>& swept,
                           std::uint64_t jobs)
    : jobs_(jobs), columns_(swept.size()) {
  if (is_sampled(request.mode)) {
    const UnitSamples samples = samples_of(request, swept.size(), jobs);
    for (std::size_t axis = 0; axis < swept.size(); ++axis)
      for (const auto& sample : samples)
        columns_[axis].points.push_back({swept[axis]->range->at(sample[axis]), swept[axis]->value_place});
    return;
  }
  std::uint64_t stride = 1;
  const auto groups = groups_of(request, swept);
  for (auto group = groups.rbegin(); group != groups.rend(); ++group) {
    for (const std::size_t axis : group->axes) {
      Column& column = columns_[axis];
      for (std::uint64_t i = 0; i < swept[axis]->size(); ++i) column.points.push_back(swept[axis]->point(i));
      column.stride = stride;
    }
    stride *= swept[group->axes.front()]->size();
  }
}

}  // namespace mpmstudy
