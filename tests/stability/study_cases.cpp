#include <algorithm>
#include <filesystem>
#include <sstream>
#include <stdexcept>

#include "libmpm/scene/parameters.hpp"
#include "runner/study/document.hpp"
#include "runner/study/requests.hpp"
#include "runner/study/study.hpp"
#include "tests/stability/case.hpp"

namespace stability {
namespace {

using mpmstudy::Expectation;
namespace fs = std::filesystem;

/// "impact_speed = 5, scheme = gimp", in SI.
std::string variant_of(const mpm::Scene& scene, const std::vector<std::string>& swept) {
  std::ostringstream text;
  for (const std::string& name : swept) {
    if (text.tellp() > 0) text << ", ";
    text << name << " = ";
    if (const mpm::Quantity* q = mpm::find_quantity(name))
      text << q->get(scene) << (q->unit == "1" ? "" : " " + std::string(q->unit));
    else if (const mpm::Choice* c = mpm::find_choice(name))
      text << c->allowed[c->get(scene)];
  }
  return text.str();
}

Outcome run_expecting(const mpm::Scene& scene, const Expectation& expected) {
  const mpm::RunResult r = mpm::run(scene);
  Outcome o = judge(r, expected.energy_error);
  if (expected.outcome == Expectation::Outcome::breaks)
    o.as_expected = r.status == mpm::RunStatus::failed && r.reason.find(expected.reason) != std::string::npos;
  return o;
}

/// The study is refused: its [expect] is read by itself.
Case refused_case(const fs::path& path, const std::string& message) {
  mpmstudy::Problems problems;
  const auto expected =
      mpmstudy::read_expectation(mpmstudy::read_document(path), mpmstudy::Units(), problems);
  if (!expected || expected->outcome != Expectation::Outcome::refused) throw std::runtime_error(message);
  Outcome o;
  o.as_expected = message.find(expected->reason) != std::string::npos;
  o.verdict = "refused";
  o.note = message.substr(message.find(": ") + 2);
  return {path.stem(), "", "refused", expected->why, 0, [o] { return o; }};
}

}  // namespace

std::vector<Case> study_cases(const std::string& folder) {
  std::vector<fs::path> paths;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().extension() == ".toml") paths.push_back(entry.path());
  std::ranges::sort(paths);
  std::vector<Case> cases;
  for (const fs::path& path : paths) {
    mpmstudy::Study study;
    try {
      study = mpmstudy::read_study(path);
    } catch (const mpmstudy::StudyError& error) {
      cases.push_back(refused_case(path, error.what()));
      continue;
    }
    if (!study.expectation) throw std::runtime_error(path.string() + ": has no [expect]");
    const Expectation expected = *study.expectation;
    for (const mpm::Scene& scene : study.scenes) {
      const mpm::Estimate e = mpm::estimate(scene);
      const char* word = expected.outcome == Expectation::Outcome::breaks ? "breaks" : "holds";
      cases.push_back({path.stem(), variant_of(scene, study.swept), word, expected.why,
                       static_cast<double>(e.particles) * static_cast<double>(e.steps),
                       [scene, expected] { return run_expecting(scene, expected); }});
    }
  }
  return cases;
}

}  // namespace stability
