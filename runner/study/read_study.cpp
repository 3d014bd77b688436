#include <algorithm>

#include "libmpm/scene/kinds/kind.hpp"
#include "runner/study/axes.hpp"
#include "runner/study/combine.hpp"
#include "runner/study/figure_files.hpp"
#include "runner/study/gauges.hpp"
#include "runner/study/ladder.hpp"
#include "runner/study/overrides.hpp"
#include "runner/study/own_parameters.hpp"
#include "runner/study/points_file.hpp"
#include "runner/study/quantity_text.hpp"
#include "runner/study/requests.hpp"
#include "runner/study/scenes.hpp"
#include "runner/study/schema.hpp"
#include "runner/study/study.hpp"
#include "runner/study/surface_request.hpp"
#include "runner/study/units.hpp"
#include "runner/study/written_unit.hpp"

namespace mpmstudy {
namespace {

/// Reads one document, top to bottom; every part adds what is wrong with it and the rest goes on.
class Reader {
 public:
  Reader(const std::filesystem::path& path, const ReadOptions& options, const Units& units)
      : options_(options), units_(units), document_(read_document(path)), top_{path.string(), 1, 1} {
    study_.path = path;
  }

  Study read() {
    apply_overrides(document_, options_.set, mistakes_);
    const auto points = add_points(document_, study_.path, mistakes_);
    if (!points && table("sweep") && table("sweep")->find("points"))
      mistakes_.throw_if_any();  // without its columns the rest would be said to be missing
    read_top();
    read_material();
    read_parameters();
    read_snapshots();
    read_all_gauges();
    read_ladder_of_cells();
    read_requests();
    check_complete();
    auto sweep = read_sweep(table("sweep"), mistakes_);
    if (sweep && points) add_group(*sweep, *points);
    if (sweep && study_.surface) check_surface(*sweep, *document_.find("surface"), study_, mistakes_);
    const auto swept = swept_axes(request_);
    for (const Axis* axis : swept) study_.swept.emplace_back(axis->name());
    if (sweep) study_.together = swept_together(*sweep, swept);
    if (sweep && is_sampled(sweep->mode))
      for (const Axis* axis : swept)
        if (axis->range)
          study_.distributions[std::string(axis->name())] = [range = *axis->range](double share) {
            return range.at(share);
          };
    std::optional<std::uint64_t> jobs;
    if (sweep) jobs = count_jobs(*sweep, swept, options_.most_jobs, top_, mistakes_);
    mistakes_.throw_if_any();
    request_.units = study_.units;
    request_.cells = study_.ladder.finds_cell ? 1 : options_.cells;
    if (bodies_) request_.bodies = &*bodies_;
    read_requirements_of(*sweep);
    SweptScenes built = build_scenes(request_, Combinations(*sweep, swept, *jobs), mistakes_);
    study_.scenes = std::move(built.scenes);
    study_.skipped = std::move(built.skipped);
    mistakes_.throw_if_any();
    if (study_.search && study_.ladder.cells > 1) sweep_ladder(study_);
    if (study_.surface) read_candidates(*sweep, swept);
    check_figure_files(document_, study_.scenes.size(), mistakes_);
    mistakes_.throw_if_any();
    return std::move(study_);
  }

 private:
  const Table* table(std::string_view name) const { return document_.find_table(name); }
  /// Where a key that `name` lacks would have to be written.
  Place place_of_table(std::string_view name) const {
    const Entry* entry = document_.find(name);
    return entry ? entry->place : top_;
  }

  /// The columns of `points`; a parameter that is one is in no other group.
  void add_group(SweepRequest& sweep, const ZipGroup& columns) {
    for (const ZipGroup& group : sweep.groups)
      for (const std::string& name : group.names)
        if (std::ranges::find(columns.names, name) != columns.names.end())
          mistakes_.add(group.place, group.key, group.written,
                        {name + " is a column of points, whose columns go together", "remove it here"});
    sweep.groups.push_back(columns);
    study_.points_file = *table("sweep")->find("points")->value.string();
  }

  void read_requirements_of(const SweepRequest& sweep) {
    request_.requirements = read_requirements(table("sweep"), study_.search ? study_.search->critical : "",
                                              units_, own_->known(mistakes_), mistakes_);
    request_.skips_invalid = sweep.skips_invalid;
    request_.invalid_place = sweep.invalid_place;
    mistakes_.throw_if_any();
  }

  /// Places for the runs that [surface] adds.
  void read_candidates(const SweepRequest& sweep, const std::vector<const Axis*>& swept) {
    const SweepRequest more = candidates_of(sweep, *study_.surface);
    study_.surface->candidates =
        build_scenes(request_, Combinations(more, swept, more.samples), mistakes_).scenes;
  }

  void read_top() {
    if (const Entry* schema = document_.find("schema")) {
      const auto* number = std::get_if<std::int64_t>(&schema->value.data);
      if (!number || *number != schema_version)
        mistakes_.add("schema", schema->value,
                      {"not a schema that this program reads", "allowed: " + std::to_string(schema_version)});
    } else {
      mistakes_.add(top_, "schema", {"missing", "write schema = " + std::to_string(schema_version)});
    }
    if (const auto name = required_string(document_, top_, "name", "the name of the study", mistakes_)) {
      study_.name = *name;
      if (!is_file_name(*name))
        mistakes_.add("name", document_.find("name")->value, {"cannot be a study's name", allowed_file_name});
      else if (name->ends_with("-audit"))
        mistakes_.add("name", document_.find("name")->value,
                      {"is kept for the runs that an audit of a search makes",
                       "allowed: a name that does not end in -audit"});
    }
    study_.title = study_.name;
    if (document_.find("title")) study_.title = required_title(document_, top_, mistakes_).value_or("");
    request_.place = top_;
    if (const auto name =
            required_string(document_, top_, "scene", listed(mpm::scene_kind_names()), mistakes_)) {
      request_.place = document_.find("scene")->value.place;
      kind_ = mpm::scene_kind_from(*name);
      if (!kind_)
        mistakes_.add("scene", document_.find("scene")->value,
                      unknown_word(*name, "scene", mpm::scene_kind_names()));
    }
    if (kind_) request_.kind = study_.kind = *kind_;
    own_.emplace(document_, kind_, units_);
    check_keys(document_, "", kind_, mistakes_);
    for (const Entry& entry : document_.entries) read_row("", entry);
    if (kind_ && mpm::kind_of(*kind_).is_composed) {
      bodies_.emplace(document_, units_, own_->known(mistakes_));
      for (std::string& line : bodies_->warnings()) study_.warnings.push_back(std::move(line));
    }
  }

  void read_material() {
    const Table* parameters = table("parameters");
    const Entry* entry = parameters ? parameters->find("material") : nullptr;
    if (bodies_ && !bodies_->uses_study_material()) {
      // a name that is wrong may be meant for it
      if (!bodies_->knows_all_materials()) return;
      const Entry* of_study = document_.find(table_name(mpm::Section::material));
      if (!entry) entry = of_study;
      for (const mpm::Quantity& row : mpm::quantities())
        if (const Entry* constant = parameters ? parameters->find(row.name) : nullptr;
            constant && mpm::is_of_material(row))
          mistakes_.add(constant->key, constant->value,
                        {"is of the study's own material, and no body is of it",
                         "say it in [materials.NAME], or leave material out of a [[body]]"});
      if (entry)
        mistakes_.add(entry->place, "material",
                      {"no body is of it", "remove it, or leave material out of a [[body]]"});
    } else if (entry)
      study_.material_place = entry->value.place.text();
    else
      mistakes_.add(place_of_table("parameters"), "material",
                    {"missing", "one of: " + listed(mpm::material_names())});
  }

  /// Every table that has rows of the parameter table, and [sweep], [search]: keys, then values.
  void read_parameters() {
    for (const Entry& entry : document_.entries) {
      const auto tables = table_names();
      if (std::find(tables.begin(), tables.end(), entry.key) == tables.end() || keys_of(entry.key).empty())
        continue;
      if (is_array_table(entry.key)) continue;
      const Table* entries = entry.value.table();
      if (!entries) {
        mistakes_.add(entry.place, entry.key, entry.value.written(),
                      {"not a table", "write [" + entry.key + "]"});
        continue;
      }
      check_keys(entry.key == "parameters" ? without_own(*entries) : *entries, entry.key, kind_, mistakes_);
      for (const Entry& one : entries->entries) read_row(entry.key, one);
    }
    refuse_cycles(request_.axes, mistakes_);
  }

  Table without_own(Table table) const {
    std::erase_if(table.entries, [&](const Entry& entry) { return own_->has(entry.key); });
    return table;
  }

  /// The value of a row: an expression, or a number, or a sweep.
  std::optional<Axis> read_value(const mpm::Quantity& row, const Entry& entry) {
    const Expected expected{row.unit, row.range};
    if (!own_->is_expression(entry.value, expected)) return read_axis(row, entry, units_, mistakes_);
    auto expression =
        read_expression(entry.key, entry.value, expected, units_, own_->known(mistakes_), mistakes_);
    if (!expression) return std::nullopt;
    return expression_axis(row, entry, std::move(*expression));
  }

  void read_row(std::string_view table, const Entry& entry) {
    std::optional<Axis> axis;
    if (table == "parameters" && own_->has(entry.key)) {
      if (const mpm::Quantity* own = own_->row(entry, mistakes_)) axis = read_value(*own, entry);
      if (axis) axis->own = true;
    } else if (const mpm::Quantity* row = mpm::find_quantity(entry.key);
               row && table_name(row->section) == table) {
      said_.push_back(entry.key);
      if (kind_ && !row->belongs_to(*kind_)) return;  // said by check_keys
      axis = read_value(*row, entry);
    } else if (const mpm::Choice* choice = mpm::find_choice(entry.key);
               choice && table_name(choice->section) == table) {
      said_.push_back(entry.key);
      if (kind_ && !choice->belongs_to(*kind_)) return;
      axis = read_axis(*choice, entry, mistakes_);
    }
    if (!axis) return;
    const bool scaled = entry.key == "cell_size" && options_.cells != 1;
    if (scaled) scale_cells(*axis, options_.cells, mistakes_);
    if (!axis->swept && !axis->expression && entry.place.line > 0) fixed_.push_back(entry.key);
    if (axis->quantity && !axis->expression) remember_unit(*axis->quantity, entry.value);
    if (axis->own) {
      study_.own.push_back({entry.key, std::string(axis->quantity->unit), entry.value.place.text()});
      said_.push_back(entry.key);
      request_.axes.push_back(std::move(*axis));
      return;
    }
    study_.given.push_back(entry.key);
    study_.places.push_back(entry.value.place.text() + (scaled ? ", times --cells" : ""));
    request_.axes.push_back(std::move(*axis));
  }

  void remember_unit(const mpm::Quantity& row, const Value& value) {
    if (auto unit = written_unit(value, row.unit, units_))
      study_.units[std::string(row.name)] = std::move(*unit);
  }

  void read_snapshots() {
    const Table* measure = table("measure");
    const Entry* entry = measure ? measure->find("snapshots") : nullptr;
    if (!entry) return;
    study_.given.emplace_back("snapshots");
    study_.places.push_back(entry->value.place.text());
    const List* list = entry->value.list();
    if (!list) {
      mistakes_.add("snapshots", entry->value, {"not a list", "allowed: times such as [\"1 ns\", \"2 ns\"]"});
      return;
    }
    for (const Value& value : *list)
      if (auto time = JobQuantity::read("snapshots", value, {"s", mpm::Range::non_negative}, units_,
                                        own_->known(mistakes_), mistakes_))
        request_.snapshots.push_back(std::move(*time));
  }

  void read_all_gauges() {
    request_.gauges = read_gauges(document_, units_, own_->known(mistakes_), mistakes_);
    read_stops(document_, spaces_of(request_.axes), units_, own_->known(mistakes_), request_.gauges,
               mistakes_);
    for (const GaugeRequest& one : request_.gauges) study_.gauges.push_back(one.gauge);
    if (request_.gauges.empty()) return;
    study_.given.emplace_back("gauges");
    study_.places.push_back(document_.find("gauge")->place.text());
  }

  void read_ladder_of_cells() {
    study_.ladder = read_ladder(table("numerics"), kind_, metrics_of(study_.gauges), units_, mistakes_);
    for (const mpm::Gauge& gauge : study_.gauges)
      if (study_.ladder.quantity.starts_with(gauge.name + "."))
        study_.ladder.unit =
            mpm::unit_of_metric(gauge, study_.ladder.quantity, spaces_of(request_.axes).front());
    if (study_.ladder.finds_cell) said_.emplace_back("cell_size");
    request_.ladder = study_.ladder;
    const Table* numerics = table("numerics");
    if (study_.ladder.finds_cell && options_.cells != 1)
      study_.warnings.push_back(top_.text() + ": --cells has no effect: the file gives no cell_size");
    for (const char* key : {"ladder", "accuracy"})
      if (const Entry* entry = numerics ? numerics->find(key) : nullptr) {
        request_.ladder_place = entry->place;
        study_.ladder_place = entry->place.text();
      }
  }

  void read_requests() {
    study_.search = read_search(document_, kind_, units_, mistakes_);
    if (study_.search) place_search();
    RequestContext context{kind_,
                           fixed_,
                           said_,
                           study_.ladder.cells,
                           may_decide_ejection(request_.axes, request_.seeks_ejection),
                           spaces_of(request_.axes),
                           !request_.snapshots.empty(),
                           study_.search ? study_.search->critical : ""};
    for (const mpm::Gauge& gauge : study_.gauges) context.gauges.push_back(gauge.name);
    context.own = study_.own;
    context.gauge_results = metrics_of(study_.gauges);
    study_.fits = read_fits(document_, context, mistakes_);
    study_.figures = read_figures(document_, context, units_, mistakes_);
    study_.surface = read_surface(document_, context, units_, mistakes_);
    study_.expectation = read_expectation(document_, units_, mistakes_);
  }

  /// A searched quantity is not given; until a search says otherwise, scenes hold its lower bound.
  void place_search() {
    const std::string& name = study_.search->critical;
    const Table& search = *table("search");
    if (name == "cell_size" && options_.cells != 1)
      study_.warnings.push_back(search.find("critical")->value.place.text() +
                                ": --cells has no effect: cell_size is looked for");
    if (says(name)) {
      mistakes_.add("critical", search.find("critical")->value,
                    {"is looked for and given", "remove " + name + " from the file, or [search]"});
      return;
    }
    const Table* numerics = table("numerics");
    if (const Entry* accuracy = numerics ? numerics->find("accuracy") : nullptr)
      mistakes_.add("accuracy", accuracy->value,
                    {"is of single runs, and the study has a [search]",
                     "write ladder = 3 instead: a bracket on each of three cells, and the interval of the "
                     "critical value"});
    if (const Entry* between = search.find("between"))
      remember_unit(*mpm::find_quantity(name), between->value);
    request_.seeks_ejection = study_.search->outcome == "ejected" || study_.search->outcome == "arrested";
    Axis axis;
    axis.quantity = mpm::find_quantity(name);
    axis.place = axis.value_place = search.find("critical")->value.place;
    axis.points = {{study_.search->lower, axis.place}};
    request_.axes.push_back(std::move(axis));
    said_.push_back(name);
    refuse_other_outcomes(search);
  }

  /// Jobs that decide collapse never have the outcome "ejected", and the other way round.
  void refuse_other_outcomes(const Table& search) {
    if (!kind_) return;
    for (const Axis& axis : request_.axes) {
      if (axis.name() != "decides") continue;
      for (const Point& point : axis.points)
        if ((point.value == static_cast<double>(mpm::Decides::ejection)) != request_.seeks_ejection)
          mistakes_.add("outcome", search.find("outcome")->value,
                        {"no run that decides " +
                             std::string(axis.choice->allowed[static_cast<std::size_t>(point.value)]) +
                             " has this outcome",
                         "remove decides from [measure], or look for another outcome"});
    }
  }

  bool says(std::string_view name) const {
    return std::find(said_.begin(), said_.end(), name) != said_.end();
  }

  /// Everything that has no default is there, once.
  void check_complete() {
    if (!kind_) return;
    for (const mpm::Quantity& row : mpm::quantities()) {
      if (!row.required || row.derived || !row.belongs_to(*kind_)) continue;
      const bool alternative = !row.alternative.empty() && says(row.alternative);
      const std::string_view home = table_name(row.section);
      const std::string other = row.alternative.empty() ? "" : " (or " + std::string(row.alternative) + ")";
      if (says(row.name) && alternative) {
        const Entry* entry = table(home)->find(row.name);
        mistakes_.add(entry->place, row.name, entry->value.written(),
                      {"given twice, also by " + std::string(row.alternative), "give one of the two"});
      } else if (!says(row.name) && !alternative) {
        mistakes_.add(place_of_table(home), std::string(row.name) + other,
                      {"missing", "[" + std::string(home) + "] needs it: " + std::string(row.meaning) + ", " +
                                      allowed_quantity({row.unit, row.range})});
      }
    }
  }

  const ReadOptions& options_;
  const Units& units_;
  Table document_;
  Place top_;
  Mistakes mistakes_;
  Study study_;
  SceneRequest request_;
  std::optional<OwnParameters> own_;
  std::optional<BodiesReader> bodies_;
  std::optional<mpm::SceneKind> kind_;
  std::vector<std::string> said_;   ///< rows of the parameter table that the file has, readable or not
  std::vector<std::string> fixed_;  ///< rows that the file itself gives one value
};

}  // namespace

Study read_study(const std::filesystem::path& path, const ReadOptions& options) {
  return read_study(path, options, Units());
}

Study read_study(const std::filesystem::path& path, const ReadOptions& options, const Units& units) {
  return Reader(path, options, units).read();
}

}  // namespace mpmstudy
