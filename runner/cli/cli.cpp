#include "runner/cli/cli.hpp"

#include <CLI/CLI.hpp>
#include <cmath>
#include <limits>

namespace mpmstudy {
namespace {

/// CLI11's own check prints the largest double with its 309 digits.
CLI::Validator positive_factor() {
  return {[](std::string& text) {
            double factor = 0;
            const bool good = CLI::detail::lexical_cast(text, factor) && factor > 0 && std::isfinite(factor);
            return good ? std::string() : "a factor is a number above 0, such as 0.5; not " + text;
          },
          ""};
}

}  // namespace

void add_study_options(CLI::App& verb, StudyOptions& options) {
  verb.add_option("--set", options.set,
                  "Over the file: --set impact_speed=\"300 m/s\", --set cavity_radius='[\"1 um\", \"2 um\"]'")
      ->type_name("KEY=VALUE")
      ->allow_extra_args(false);
  verb.add_option("--cells", options.cells, "Every cell_size of the files times this: --cells 0.5 is finer")
      ->type_name("FACTOR")
      ->check(positive_factor())
      ->each([&options](const std::string&) { options.cells_told = true; });
  verb.add_flag("--yes", options.yes,
                "Allow more than a million jobs, more memory than is free, and more than 12 hours");
}

Study read_study(const std::string& path, const StudyOptions& options) {
  ReadOptions read;
  read.cells = options.cells;
  if (options.yes) read.most_jobs = std::numeric_limits<std::uint64_t>::max();
  for (const std::string& text : options.set) {
    const auto equals = text.find('=');
    if (equals == std::string::npos || equals == 0)
      throw StudyError("--set: " + text + ": not KEY=VALUE; write for example --set cell_size=\"0.1 um\"");
    read.set.emplace_back(text.substr(0, equals), text.substr(equals + 1));
  }
  return read_study(std::filesystem::path(path), read);
}

void add_results_option(CLI::App& verb, std::string& results) {
  if (results.empty()) results = "results";
  const auto named = [](const std::string& folder) {  // a variable of the shell that is not set
    return folder.empty() ? std::string("is empty; name a folder") : std::string();
  };
  verb.add_option("--results", results, "Folder of results")
      ->type_name("DIR")
      ->capture_default_str()
      ->check(CLI::Validator(named, ""));
}

void end_with(int exit_code) { throw CLI::RuntimeError(exit_code); }

}  // namespace mpmstudy
