#include "runner/cli/export.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string_view>
#include <vector>

#include "runner/catalog/catalog_error.hpp"
#include "runner/catalog/output_file.hpp"
#include "runner/catalog/reader.hpp"
#include "runner/catalog/row_format.hpp"
#include "runner/catalog/view_rows.hpp"
#include "runner/study/schema.hpp"

namespace mpmstudy {
namespace {

namespace fs = std::filesystem;

void write(const View& view, const ExportOptions& options, RowFormat format, std::ostream& out) {
  write_view(options.results, view, options.study, *make_row_sink(format, out));
}

void write_file(const View& view, const ExportOptions& options, RowFormat format, const fs::path& path) {
  OutputFile file(path);
  write(view, options, format, file.stream());
  file.commit();
  fmt::print("{}\n", path.string());
}

std::string no_such_view(const std::string& name, const std::vector<View>& views) {
  std::vector<std::string_view> names;
  for (const auto& view : views) names.push_back(view.name);
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
  verb.callback([options] { end_with(run_export(*options)); });
}

int run_export(const ExportOptions& options) {
  const auto format = row_format_from(options.format);
  if (!format || *format == RowFormat::table)
    throw CatalogError("--format: " + options.format + ": csv or json");
  if (!options.study.empty()) read_state(options.results, {options.study});  // throws if there is none
  const auto name_of = [&](const View& view) { return view.name + "." + options.format; };
  const auto views = views_of(options.results);

  if (options.what == "all") {
    if (options.output == "-") throw CatalogError("--output: -: all views go to files; name a folder");
    const fs::path folder =
        options.output.empty() ? fs::path(options.results) / "export" : fs::path(options.output);
    for (const auto& view : views) write_file(view, options, *format, folder / name_of(view));
    return exit_ok;
  }
  const auto exported = std::ranges::find(views, options.what, &View::name);
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
