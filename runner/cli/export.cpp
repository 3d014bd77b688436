#include "runner/cli/export.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>

#include "runner/catalog/catalog_error.hpp"
#include "runner/catalog/output_file.hpp"
#include "runner/catalog/query.hpp"
#include "runner/catalog/reader.hpp"
#include "runner/catalog/row_format.hpp"

namespace mpmstudy {
namespace {

namespace fs = std::filesystem;

/// A view, and how its rows are told by study and ordered: the same catalog gives the same file.
struct Exported {
  const char* view;
  bool has_study;  ///< a column of its own; or by the keys of the study's jobs
  const char* order;
};
constexpr Exported views[] = {
    {"jobs", true, "study, position, key"},
    {"metrics", false, "key, name"},
    {"area_history", false, "key, time_s"},
    {"fits", true, "study, quantity, against, model, coefficient"},
    {"brackets", true, "study, position"},
    {"critical_speed", true, "study, wall_thickness_m, cell_size_m"},
    {"snapshots", false, "key, path"},
    {"accuracy", true, "study, key, quantity"},
    {"ladders", true, "study, position, key, cell_size_m, quantity"},
};

std::string sql_of(const Exported& exported, bool one_study) {
  const char* filter = !one_study           ? ""
                       : exported.has_study ? " WHERE study = ?1"
                                            : " WHERE key IN (SELECT key FROM jobs WHERE study = ?1)";
  return fmt::format("SELECT * FROM {}{} ORDER BY {}", exported.view, filter, exported.order);
}

void write(const Exported& exported, const ExportOptions& options, RowFormat format, std::ostream& out) {
  const auto sink = make_row_sink(format, out);
  const SqlValue study = options.study;
  const bool one_study = !options.study.empty();
  query(options.results, sql_of(exported, one_study), *sink,
        one_study ? std::span(&study, 1) : std::span<const SqlValue>());
}

void write_file(const Exported& exported, const ExportOptions& options, RowFormat format,
                const fs::path& path) {
  OutputFile file(path);
  write(exported, options, format, file.stream());
  file.commit();
  fmt::print("{}\n", path.string());
}

}  // namespace

void setup_export(CLI::App& app) {
  const auto options = std::make_shared<ExportOptions>();
  CLI::App& verb = *app.add_subcommand("export", "Write views of the catalog as CSV or JSON");
  verb.add_option("--what", options->what,
                  "jobs, metrics, area_history, fits, brackets, critical_speed, snapshots, accuracy, ladders or all")
      ->check(CLI::IsMember({"jobs", "metrics", "area_history", "fits", "brackets", "critical_speed", "snapshots",
                             "accuracy", "ladders", "all"}))
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
  const auto name_of = [&](const Exported& exported) {
    return std::string(exported.view) + "." + options.format;
  };

  if (options.what == "all") {
    if (options.output == "-") throw CatalogError("--output: -: all views go to files; name a folder");
    const fs::path folder =
        options.output.empty() ? fs::path(options.results) / "export" : fs::path(options.output);
    for (const auto& exported : views) write_file(exported, options, *format, folder / name_of(exported));
    return exit_ok;
  }
  const auto* exported =
      std::ranges::find_if(views, [&](const Exported& e) { return e.view == options.what; });
  if (exported == std::end(views)) throw CatalogError("--what: " + options.what + ": there is no such view");
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
