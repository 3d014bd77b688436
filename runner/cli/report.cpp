#include "runner/cli/report.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>

#include "runner/catalog/output_file.hpp"
#include "runner/catalog/writer.hpp"
#include "runner/exec/git_revision.hpp"
#include "runner/finish/report.hpp"

namespace mpmstudy {
namespace {

void print(const std::vector<Claim>& claims) {
  for (const Claim& c : claims) {
    fmt::print("{:<15} {}\n", c.verdict, c.sentence);
    if (!c.measured.empty()) fmt::print("{:<15} {} ({})\n", "", c.measured, c.study);
  }
}

void print_json(const std::vector<Claim>& claims) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const Claim& c : claims)
    all.push_back({{"claim", c.name},
                   {"sentence", c.sentence},
                   {"verdict", c.verdict},
                   {"measured", c.measured},
                   {"note", c.note},
                   {"study", c.study}});
  fmt::print("{}\n", all.dump(2));
}

}  // namespace

void setup_report(CLI::App& app) {
  const auto options = std::make_shared<ReportOptions>();
  CLI::App& verb =
      *app.add_subcommand("report", "Write one HTML page from the catalog; judge the paper's claims");
  verb.add_option("STUDY", options->files, "Study files")->required();
  verb.add_option("-o,--output", options->output, "The page [report.html in the results folder]")
      ->type_name("FILE");
  verb.add_flag("--json", options->json, "Print the claims as JSON");
  add_study_options(verb, options->study);
  add_results_option(verb, options->results);
  verb.callback([options] { finish(run_report(*options)); });
}

int run_report(const ReportOptions& options) {
  std::vector<Study> studies;
  for (const std::string& file : options.files) studies.push_back(read_study(file, options.study));
  const std::vector<Claim> claims = judge_claims(options.results);
  const std::string page = report_page(studies, options.results, claims);
  {
    WriterOptions writer_options;
    writer_options.store.git_revision = git_revision();
    CatalogWriter(options.results, writer_options).replace_claims(claims);
  }
  const std::filesystem::path output = options.output.empty()
                                           ? std::filesystem::path(options.results) / "report.html"
                                           : std::filesystem::path(options.output);
  OutputFile file(output);
  file.stream() << page;
  file.commit();
  if (options.json)
    print_json(claims);
  else
    print(claims);
  fmt::print(stderr, "{}\n", output.string());
  return exit_ok;
}

}  // namespace mpmstudy
