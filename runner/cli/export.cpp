#include "runner/cli/export.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string_view>
#include <vector>

#include "runner/catalog/catalog_error.hpp"
#include "runner/catalog/output_file.hpp"
#include "runner/catalog/query.hpp"
#include "runner/catalog/reader.hpp"
#include "runner/catalog/row_format.hpp"
#include "runner/study/schema.hpp"

namespace mpmstudy {
namespace {

namespace fs = std::filesystem;

/// A view of the catalog, and how its rows are told by study and ordered.
struct Exported {
  std::string view;
  std::vector<std::string> columns;

  bool has(std::string_view column) const { return std::ranges::find(columns, column) != columns.end(); }
};

/// Every view that the catalog has, in the order of their names.
std::vector<Exported> views_of(const std::string& results) {
  std::vector<Exported> views;
  for (const auto& row :
       query(results, "SELECT name FROM sqlite_master WHERE type = 'view' ORDER BY name").rows) {
    const auto& name = std::get<std::string>(row[0]);
    views.push_back({name, query(results, fmt::format("SELECT * FROM \"{}\" LIMIT 0", name)).names});
  }
  return views;
}

/// Columns that come first in the order of rows; the others break ties, so that the same catalog gives the
/// same file.
constexpr std::string_view order_first[] = {"id",       "study",   "position", "key",
                                            "name",     "path",    "time_s",   "cell_size_m",
                                            "quantity", "against", "model",    "coefficient"};
/// Rows that these tell apart need no ties broken: sorting a long history by all columns takes its time.
constexpr std::string_view identities[] = {"id", "time_s", "path"};

std::string order_of(const Exported& exported) {
  std::vector<std::string> order;
  const auto add = [&](std::string_view column) {
    if (std::ranges::find(order, column) == order.end()) order.emplace_back(column);
  };
  for (const auto column : order_first)
    if (exported.has(column)) add(column);
  if (std::ranges::none_of(identities, [&](auto column) { return exported.has(column); }))
    std::ranges::for_each(exported.columns, add);
  return fmt::format("\"{}\"", fmt::join(order, "\", \""));
}

/// Views without a study are told by the keys of its jobs, or by its name.
std::string sql_of(const Exported& exported, bool one_study) {
  std::string filter;
  if (one_study && exported.has("study"))
    filter = " WHERE study = ?1";
  else if (one_study && exported.has("key"))
    filter = " WHERE key IN (SELECT key FROM jobs WHERE study = ?1)";
  else if (one_study && exported.view == "studies")
    filter = " WHERE name = ?1";
  return fmt::format("SELECT * FROM \"{}\"{} ORDER BY {}", exported.view, filter, order_of(exported));
}

void write(const Exported& exported, const ExportOptions& options, RowFormat format, std::ostream& out) {
  const auto sink = make_row_sink(format, out);
  const SqlValue study = options.study;
  const bool one_study = !options.study.empty();
  const std::string sql = sql_of(exported, one_study);
  const bool asks = sql.find("?1") != std::string::npos;
  query(options.results, sql, *sink, asks ? std::span(&study, 1) : std::span<const SqlValue>());
}

void write_file(const Exported& exported, const ExportOptions& options, RowFormat format,
                const fs::path& path) {
  OutputFile file(path);
  write(exported, options, format, file.stream());
  file.commit();
  fmt::print("{}\n", path.string());
}

std::string no_such_view(const std::string& name, const std::vector<Exported>& views) {
  std::vector<std::string_view> names;
  for (const auto& exported : views) names.push_back(exported.view);
  names.push_back("all");
  const auto near = nearest(name, names);
  return fmt::format("{}: there is no such view; {}", name,
                     near.empty() ? "allowed: " + listed(names) : fmt::format("did you mean {}?", near));
}

}  // namespace

void setup_export(CLI::App& app) {
  const auto options = std::make_shared<ExportOptions>();
  CLI::App& verb = *app.add_subcommand("export", "Write views of the catalog as CSV or JSON");
  verb.add_option("--what", options->what,
                  "A view of the catalog (runner/catalog/VIEWS.md lists them), or all of them")
      ->type_name("VIEW|all")
      ->capture_default_str();
  verb.add_option("--study", options->study, "Rows of this study only")->type_name("NAME");
  verb.add_option("--format", options->format, "csv or json")
      ->check(CLI::IsMember({"csv", "json"}))
      ->capture_default_str();
  verb.add_option("-o,--output", options->output, "File or folder [standard output; for all: RESULTS/export]")
      ->type_name("FILE|DIR");
  add_results_option(verb, options->results);
  verb.callback([options] { finish(run_export(*options)); });
}

int run_export(const ExportOptions& options) {
  const auto format = row_format_from(options.format);
  if (!format || *format == RowFormat::table)
    throw CatalogError("--format: " + options.format + ": csv or json");
  if (!options.study.empty()) read_state(options.results, {options.study});  // throws if there is none
  const auto name_of = [&](const Exported& exported) { return exported.view + "." + options.format; };
  const auto views = views_of(options.results);

  if (options.what == "all") {
    if (options.output == "-") throw CatalogError("--output: -: all views go to files; name a folder");
    const fs::path folder =
        options.output.empty() ? fs::path(options.results) / "export" : fs::path(options.output);
    for (const auto& exported : views) write_file(exported, options, *format, folder / name_of(exported));
    return exit_ok;
  }
  const auto exported = std::ranges::find(views, options.what, &Exported::view);
  if (exported == views.end()) throw CatalogError("--what: " + no_such_view(options.what, views));
  if (options.output.empty() || options.output == "-") {
    write(*exported, options, *format, std::cout);
    return exit_ok;
  }
  const fs::path output = options.output;
  const bool is_folder = fs::is_directory(output) || !output.has_filename();
  write_file(*exported, options, *format, is_folder ? output / name_of(*exported) : output);
  return exit_ok;
}

}  // namespace mpmstudy
