#include "runner/cli/report.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string_view>

#include "runner/catalog/output_file.hpp"
#include "runner/catalog/stored_jobs.hpp"
#include "runner/catalog/writer.hpp"
#include "runner/cli/last_run.hpp"
#include "runner/cli/missing.hpp"
#include "runner/exec/git_revision.hpp"
#include "runner/finish/claims.hpp"
#include "runner/finish/paper_scenes.hpp"
#include "runner/finish/reference_claims.hpp"
#include "runner/finish/report.hpp"

namespace mpmstudy {
namespace {

/// What the fine cells say, where it is something else.
std::optional<ReferenceClaim> other_reference(const Claim& c) {
  const auto found = reference_claims().find(c.name);
  if (found == reference_claims().end() || found->second.verdict == c.verdict) return std::nullopt;
  return found->second;
}

void print(const std::vector<Claim>& claims) {
  constexpr int width = 26;
  for (const Claim& c : claims) {
    fmt::print("{:<{}} {}\n", c.verdict, width, c.sentence);
    if (!c.measured.empty()) fmt::print("{:<{}} {} ({})\n", "", width, c.measured, c.study);
    if (const auto fine = other_reference(c))
      fmt::print("{:<{}} fine cells (results/reference): {}; {}\n", "", width, fine->verdict, fine->measured);
  }
}

void print_json(const std::vector<Claim>& claims) {
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const Claim& c : claims) {
    const auto fine = reference_claims().find(c.name);
    const bool known = fine != reference_claims().end();
    all.push_back({{"claim", c.name},
                   {"sentence", c.sentence},
                   {"verdict", c.verdict},
                   {"measured", c.measured},
                   {"note", c.note},
                   {"study", c.study},
                   {"reference_verdict", known ? fine->second.verdict : ""},
                   {"reference_measured", known ? fine->second.measured : ""}});
  }
  fmt::print("{}\n", all.dump(2));
}

/// Pictures and animations of a page.
std::ptrdiff_t pictures_of(const std::string& html) {
  std::ptrdiff_t count = 0;
  for (const std::string_view mark : {"src=\"data:image/", "<canvas "})
    for (auto at = html.find(mark); at != std::string::npos; at = html.find(mark, at + 1)) ++count;
  return count;
}

/// A page with more pictures than the one that takes its place is kept under another name, and that is said.
void keep_fuller_page(const std::filesystem::path& output, const std::string& page) {
  std::error_code error;  // `-o /dev/stdout` has nothing to keep
  std::ifstream in;
  if (std::filesystem::is_regular_file(output, error)) in.open(output, std::ios::binary);
  if (!in.is_open()) return;
  const std::string before(std::istreambuf_iterator<char>(in), {});
  const auto had = pictures_of(before), has = pictures_of(page);
  if (had <= has) return;
  std::filesystem::path kept = output;
  kept.replace_filename(
      fmt::format("{}-{}-pictures{}", output.stem().string(), had, output.extension().string()));
  std::filesystem::rename(output, kept);
  fmt::print(stderr, "{} had {} pictures, the page that takes its place has {}; the one before is now {}\n",
             output.string(), had, has, kept.string());
}

/// Files of the studies that claims rest on, as the files say: those of `forms`, or of the catalog. Files
/// that bear such a name and say something else are left out: name -> what they say.
std::vector<Study> studies_as_written(const std::vector<StudyForm>& forms, const std::string& results,
                                      std::map<std::string, std::string>& unlike) {
  std::map<std::string, StudyForm> by_name;
  for (const StoredStudy& stored : read_studies(results))
    if (std::filesystem::exists(stored.source.path)) {
      StudyForm form{stored.source.path, {}};
      form.options.set = stored.source.set;
      form.options.cells = stored.source.cells;
      form.options.yes = true;
      by_name[stored.name] = std::move(form);
    }
  for (const StudyForm& form : forms) by_name[read_study(form.path, form.options).name] = form;
  std::vector<Study> studies;
  for (const std::string& name : studies_of_claims()) {
    const auto found = by_name.find(name);
    if (found == by_name.end()) continue;
    const StudyForm form = as_written(found->second);
    try {
      Study study = read_study(form.path, form.options);
      if (study.name != name) continue;
      if (const std::string text = unlike_the_paper(study); !text.empty())
        unlike[name] = form.path + " has " + text;
      else
        studies.push_back(std::move(study));
    } catch (const StudyError& error) {
      fmt::print(stderr, "{}\n", error.what());  // its claims are not judged, and say so
    }
  }
  return studies;
}

/// Claims of the studies that are reported; without files, of all that the catalog has, if only by name. Says
/// in one line of which studies given there are none.
std::vector<Claim> claims_to_show(std::vector<Claim> claims, const std::vector<ReportedStudy>& reported,
                                  const ReportOptions& options) {
  std::set<std::string> names;
  for (const ReportedStudy& one : reported) names.insert(one.study.name);
  if (options.files.empty())
    for (const StoredStudy& stored : read_studies(options.results)) names.insert(stored.name);
  std::set<std::string> without = names;
  for (const Claim& c : claims) without.erase(c.study);
  std::erase_if(claims, [&](const Claim& c) { return !names.contains(c.study); });
  if (!without.empty() && (claims.empty() || !options.files.empty()))
    fmt::print(stderr, "the paper claims nothing of {}\n", fmt::join(without, ", "));
  return claims;
}

}  // namespace

void setup_report(CLI::App& app) {
  const auto options = std::make_shared<ReportOptions>();
  CLI::App& verb =
      *app.add_subcommand("report", "Write one HTML page from the catalog; judge the paper's claims");
  verb.add_option("STUDY", options->files, "Study files [every study of the catalog]");
  verb.add_option("-o,--output", options->output, "The page [report.html in the results folder]")
      ->type_name("FILE");
  verb.add_flag("--json", options->json, "Print the claims as JSON");
  add_study_options(verb, options->study);
  add_results_option(verb, options->results);
  verb.callback([options] { finish(run_report(*options)); });
}

int run_report(const ReportOptions& options) {
  bool all_there = true;
  const auto forms = forms_of(options.files, options.study, options.results, all_there);
  std::vector<ReportedStudy> studies;
  for (const StudyForm& form : forms)
    studies.push_back(
        {read_study(form.path, form.options), options_text(form.options.set, form.options.cells)});
  std::map<std::string, std::string> unlike;
  std::vector<Claim> claims =
      judge_claims(options.results, studies_as_written(forms, options.results, unlike));
  for (Claim& c : claims)
    if (const auto found = unlike.find(c.study); found != unlike.end()) c.measured = found->second;
  {
    WriterOptions writer_options;
    writer_options.store.git_revision = git_revision();
    CatalogWriter(options.results, writer_options).replace_claims(claims);
  }
  claims = claims_to_show(std::move(claims), studies, options);
  const std::string page = report_page(studies, options.results, claims);
  const std::filesystem::path output = options.output.empty()
                                           ? std::filesystem::path(options.results) / "report.html"
                                           : std::filesystem::path(options.output);
  keep_fuller_page(output, page);
  OutputFile file(output);
  file.stream() << page;
  file.commit();
  if (options.json)
    print_json(claims);
  else
    print(claims);
  fmt::print(stderr, "{}\n", output.string());
  int code = all_there ? exit_ok : exit_failed;
  for (const ReportedStudy& reported : studies)
    code = std::max(code, say_what_is_missing(reported.study, read_results(reported.study, options.results),
                                              reported.study.path.string() + reported.options));
  return code;
}

}  // namespace mpmstudy
