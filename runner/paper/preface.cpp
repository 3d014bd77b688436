#include "runner/paper/preface.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "runner/catalog/writer.hpp"
#include "runner/exec/git_revision.hpp"
#include "runner/paper/claims.hpp"
#include "runner/paper/paper_scenes.hpp"
#include "runner/paper/reference_claims.hpp"

namespace mpmstudy {
namespace {

/// What the fine cells say, where it is something else.
std::optional<ReferenceClaim> other_reference(const Claim& c) {
  const auto found = reference_claims().find(c.name);
  if (found == reference_claims().end() || found->second.verdict == c.verdict) return std::nullopt;
  return found->second;
}

std::string text_of(const std::vector<Claim>& claims) {
  constexpr int width = 26;
  std::string text;
  for (const Claim& c : claims) {
    text += fmt::format("{:<{}} {}\n", c.verdict, width, c.sentence);
    if (!c.measured.empty()) text += fmt::format("{:<{}} {} ({})\n", "", width, c.measured, c.study);
    if (const auto fine = other_reference(c))
      text += fmt::format("{:<{}} fine cells (results/reference): {}; {}\n", "", width, fine->verdict,
                          fine->measured);
  }
  return text;
}

std::string json_of(const std::vector<Claim>& claims) {
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
  return all.dump(2) + "\n";
}

analysis::PageSection section_of(const std::vector<Claim>& claims) {
  analysis::PageSection judged{
      "claims",
      "Claims",
      "What the paper says of its results, and what was measured here. The paper gives no "
      "height of its blocks, no cell, no viscosity and no list of yield stresses: each study says "
      "which reading it rests on.",
      {},
      {},
      {}};
  analysis::PageTable table{
      "",
      {"paper", "verdict", "measured", "fine cells (results/reference)", "on what it rests", "study"},
      {}};
  for (const Claim& c : claims) {
    const auto fine = reference_claims().find(c.name);
    const std::string reference =
        fine == reference_claims().end() ? "" : fine->second.verdict + ": " + fine->second.measured;
    table.rows.push_back({c.sentence, c.verdict, c.measured, reference, c.note, c.study});
  }
  judged.tables.push_back(std::move(table));
  return judged;
}

/// Files of the studies that claims rest on, as the files say. Those that bear such a name and say something
/// else are left out: name -> what they say.
std::vector<Study> studies_as_written(const PrefaceRequest& request,
                                      std::map<std::string, std::string>& unlike) {
  std::vector<Study> studies;
  for (const std::string& name : studies_of_claims()) {
    try {
      auto study = request.as_written(name);
      if (!study) continue;
      if (const std::string text = unlike_the_paper(*study); !text.empty())
        unlike[name] = study->path.string() + " has " + text;
      else
        studies.push_back(std::move(*study));
    } catch (const StudyError& error) {
      fmt::print(stderr, "{}\n", error.what());  // its claims are not judged, and say so
    }
  }
  return studies;
}

/// Claims of the studies that are shown. Says in one line of which of them there are none.
std::vector<Claim> claims_to_show(std::vector<Claim> claims, const PrefaceRequest& request) {
  std::set<std::string> without = request.shown;
  for (const Claim& c : claims) without.erase(c.study);
  std::erase_if(claims, [&](const Claim& c) { return !request.shown.contains(c.study); });
  if (!without.empty() && (claims.empty() || request.files_given))
    fmt::print(stderr, "the paper claims nothing of {}\n", fmt::join(without, ", "));
  return claims;
}

}  // namespace

Preface claims_preface(const PrefaceRequest& request) {
  std::map<std::string, std::string> unlike;
  std::vector<Claim> claims = judge_claims(request.results, studies_as_written(request, unlike));
  for (Claim& c : claims)
    if (const auto found = unlike.find(c.study); found != unlike.end()) c.measured = found->second;
  {
    WriterOptions options;
    options.store.git_revision = git_revision();
    CatalogWriter(request.results, options).replace_claims(claims);
  }
  claims = claims_to_show(std::move(claims), request);
  Preface preface;
  preface.text = text_of(claims);
  preface.json = json_of(claims);
  if (claims.empty()) return preface;
  preface.title = "Cavity collapse under shock: the paper, reproduced";
  preface.subtitle =
      "A. Xu, X. F. Pan, G. Zhang, J. Zhu, J. Phys.: Condens. Matter 19 (2007) 326212, held against mpmstudy";
  preface.sections.push_back(section_of(claims));
  return preface;
}

}  // namespace mpmstudy
