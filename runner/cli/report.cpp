#include "runner/cli/report.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <memory>
#include <optional>
#include <string_view>

#include "runner/catalog/output_file.hpp"
#include "runner/catalog/stored_jobs.hpp"
#include "runner/cli/last_run.hpp"
#include "runner/cli/missing.hpp"
#include "runner/finish/report.hpp"

namespace mpmstudy {
namespace {

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

/// Forms by the names of their studies: those of `forms`, and of the catalog where the file is still there.
std::map<std::string, StudyForm> forms_by_name(const std::vector<StudyForm>& forms,
                                               const std::string& results) {
  std::map<std::string, StudyForm> by_name;
  for (const StoredStudy& stored : read_studies(results))
    if (auto form = recorded_form(stored)) by_name[stored.name] = std::move(*form);
  for (const StudyForm& form : forms) by_name[read_study(form.path, form.options).name] = form;
  return by_name;
}

PrefaceRequest request_of(const ReportOptions& options, const std::vector<StudyForm>& forms,
                          const std::vector<ReportedStudy>& studies) {
  PrefaceRequest request{options.results, {}, !options.files.empty(), {}};
  for (const ReportedStudy& one : studies) request.shown.insert(one.study.name);
  if (options.files.empty())
    for (const StoredStudy& stored : read_studies(options.results)) request.shown.insert(stored.name);
  request.as_written =
      [by_name = forms_by_name(forms, options.results)](const std::string& name) -> std::optional<Study> {
    const auto found = by_name.find(name);
    if (found == by_name.end()) return std::nullopt;
    const StudyForm form = as_written(found->second);
    Study study = read_study(form.path, form.options);
    return study.name == name ? std::optional(std::move(study)) : std::nullopt;
  };
  return request;
}

}  // namespace

void setup_report(CLI::App& app, ReportSeams seams) {
  const auto options = std::make_shared<ReportOptions>();
  CLI::App& verb = *app.add_subcommand(
      "report", "Write one HTML page from the catalog" + (seams.of.empty() ? "" : "; judge " + seams.of));
  verb.add_option("STUDY", options->files, "Study files [every study of the catalog]");
  verb.add_option("-o,--output", options->output, "The page [report.html in the results folder]")
      ->type_name("FILE");
  verb.add_flag("--json", options->json,
                seams.of.empty() ? "Print an empty list" : "Print " + seams.of + " as JSON");
  add_study_options(verb, options->study);
  add_results_option(verb, options->results);
  verb.callback([options, seams = std::move(seams)] { end_with(run_report(*options, seams.make_preface)); });
}

int run_report(const ReportOptions& options, const MakePreface& make_preface) {
  bool all_there = true;
  const auto forms = forms_of(options.files, options.study, options.results, all_there);
  std::vector<ReportedStudy> studies;
  for (const StudyForm& form : forms)
    studies.push_back(
        {read_study(form.path, form.options), options_text(form.options.set, form.options.cells)});
  const Preface preface = make_preface ? make_preface(request_of(options, forms, studies)) : Preface();
  const std::string page = report_page(studies, options.results, preface);
  const std::filesystem::path output = options.output.empty()
                                           ? std::filesystem::path(options.results) / "report.html"
                                           : std::filesystem::path(options.output);
  keep_fuller_page(output, page);
  OutputFile file(output);
  file.stream() << page;
  file.commit();
  fmt::print("{}", options.json ? preface.json : preface.text);
  fmt::print(stderr, "{}\n", output.string());
  int code = all_there ? exit_ok : exit_failed;
  for (const ReportedStudy& reported : studies)
    code = std::max(code, say_what_is_missing(reported.study, read_results(reported.study, options.results),
                                              reported.study.path.string() + reported.options));
  return code;
}

}  // namespace mpmstudy
