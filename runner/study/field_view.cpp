#include "runner/study/field_view.hpp"

#include <algorithm>
#include <array>

#include "runner/study/quantity_text.hpp"
#include "runner/study/schema.hpp"

namespace mpmstudy {
namespace {

constexpr std::array<std::string_view, 3> axes = {"x", "y", "z"};
constexpr std::array<std::string_view, 2> projections = {"largest", "mean"};

/// The only entry of { z = ... }. Null after adding a mistake.
const Entry* only_entry(const Entry& entry, const char* allowed, Mistakes& mistakes) {
  const auto& entries = entries_of(entry.value.table());
  if (entries.size() == 1) return &entries.front();
  mistakes.add(entry.key, entry.value, {"not a table of one key", std::string("allowed: ") + allowed});
  return nullptr;
}

void read_slice(const Entry& entry, const Units& units, FieldView& view, Mistakes& mistakes) {
  const Entry* one = only_entry(entry, "{ z = \"1 um\" }, or x, or y", mistakes);
  if (!one) return;
  const auto axis = std::ranges::find(axes, one->key);
  if (axis == axes.end()) return mistakes.add(one->key, one->value, unknown_word(one->key, "axis", axes));
  view.axis = static_cast<int>(axis - axes.begin());
  const Number at = read_quantity(one->value, {"m"}, units);
  if (const auto* refusal = std::get_if<Refusal>(&at))
    mistakes.add(one->key, one->value, *refusal);
  else
    view.at = std::get<double>(at);
}

void read_projection(const Entry& entry, FieldView& view, Mistakes& mistakes) {
  const Entry* one = only_entry(entry, "{ largest = \"z\" }, or mean, along x, y or z", mistakes);
  if (!one) return;
  const auto of = std::ranges::find(projections, one->key);
  if (of == projections.end())
    return mistakes.add(one->key, one->value, unknown_word(one->key, "projection", projections));
  view.of = *of == "largest" ? FieldView::Of::largest : FieldView::Of::mean;
  if (const auto axis = find_word(one->key, one->value, "axis", axes, mistakes))
    view.axis = static_cast<int>(*axis);
}

}  // namespace

FieldView read_field_view(const Table& figure, const FigureKindRow& row, const RequestContext& context,
                          const Units& units, Mistakes& mistakes) {
  FieldView view;
  const Entry *slice = figure.find("slice"), *projection = figure.find("projection");
  for (const Entry* entry : {slice, projection}) {
    if (!entry) continue;
    const auto refuse = [&](Refusal refusal) {
      mistakes.add(entry->key, entry->value, std::move(refusal));
      return view;
    };
    if (!row.of_snapshots)
      return refuse({"a figure of kind " + std::string(row.word) + " shows no snapshots", "remove it"});
    if (std::ranges::any_of(context.spaces, [](mpm::Space s) { return s != mpm::Space::three_d; }))
      return refuse({"is of jobs in three dimensions", "write space = \"three-d\", or remove it"});
  }
  if (slice && projection)
    mistakes.add("projection", projection->value, {"is given beside slice", "write two figures"});
  else if (slice)
    read_slice(*slice, units, view, mistakes);
  else if (projection)
    read_projection(*projection, view, mistakes);
  return view;
}

}  // namespace mpmstudy
