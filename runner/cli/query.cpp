#include "runner/cli/query.hpp"

#include <CLI/CLI.hpp>
#include <iostream>
#include <memory>

#include "runner/catalog/catalog_error.hpp"
#include "runner/catalog/query.hpp"
#include "runner/catalog/row_format.hpp"
#include "runner/cli/amounts.hpp"

namespace mpmstudy {

void setup_query(CLI::App& app) {
  const auto options = std::make_shared<QueryOptions>();
  CLI::App& verb = *app.add_subcommand(
      "query", "Ask the catalog in SQL: SELECT over jobs, metrics, area_history, fits, brackets, ...");
  verb.add_option("SQL", options->sql, "One statement that reads; runner/catalog/VIEWS.md lists the views")
      ->required();
  verb.add_option("--format", options->format, "table, csv or json")
      ->check(CLI::IsMember({"table", "csv", "json"}))
      ->capture_default_str();
  verb.add_option("--timeout", options->timeout, "A query that takes longer is ended")->type_name("\"10 s\"");
  add_results_option(verb, options->results);
  verb.callback([options] { end_with(run_query(*options)); });
}

int run_query(const QueryOptions& options) {
  const auto format = row_format_from(options.format);
  if (!format) throw CatalogError("--format: " + options.format + ": table, csv or json");
  const auto sink = make_row_sink(*format, std::cout);
  query(options.results, options.sql, *sink, {}, read_duration("--timeout", options.timeout));
  return exit_ok;
}

}  // namespace mpmstudy
