#include <algorithm>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>
#include <sstream>
#include <stdexcept>

#include "libmpm/scene/parameters.hpp"
#include "libmpm/verification/problems/scenes.hpp"
#include "runner/study/document.hpp"
#include "runner/study/requests.hpp"
#include "runner/study/study.hpp"
#include "tests/stability/bodies.hpp"

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

constexpr std::int64_t compared_steps = 500;
constexpr double reference_cost = 6;  ///< of a step, in steps of the fast kernel

/// The first steps by the fast step and by the reference: areas and extremes of density agree. The contour
/// counts until the topology changes.
Outcome run_by_both(mpm::Scene scene) {
  const mpm::RunResult fast = mpm::run(scene);
  scene.numerics.kernel = mpm::Kernel::reference;
  const mpm::RunResult reference = mpm::run(scene);
  const double changed = mpm::verification::scenes::metric(reference, "topology_changed_time_s",
                                                           std::numeric_limits<double>::infinity());
  const Outcome a = judge(fast, 0.01), b = judge(reference, 0.01);
  double off = std::max(std::abs(a.smallest_density - b.smallest_density),
                        std::abs(a.largest_density - b.largest_density));
  const bool same_steps =
      fast.steps == reference.steps && fast.area_history.size() == reference.area_history.size();
  for (std::size_t k = 0; same_steps && k < fast.area_history.size(); ++k) {
    const mpm::AreaSample &x = fast.area_history[k], &y = reference.area_history[k];
    const double initial = reference.area_history[0].area;
    off = std::max(off, std::abs(x.void_area - y.void_area) / initial);
    if (y.time < changed) off = std::max(off, std::abs(x.area - y.area) / initial);
  }
  return also(a, b.as_expected && same_steps && off < 1e-9,
              text("areas and densities of the reference to", off));
}

/// The study is refused: its [expect] is read by itself.
Case refused_case(const fs::path& path, const std::string& message) {
  mpmstudy::Mistakes mistakes;
  const auto expected =
      mpmstudy::read_expectation(mpmstudy::read_document(path), mpmstudy::Units(), mistakes);
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
      if (scene.numerics.kernel != mpm::Kernel::fast ||
          scene.numerics.precision != mpm::Precision::double_precision ||
          expected.outcome != Expectation::Outcome::holds)
        continue;
      mpm::Scene first = scene;
      const auto steps = static_cast<double>(std::min(compared_steps, e.steps));
      first.end_time *= steps / static_cast<double>(e.steps);
      cases.push_back({"both kernels", path.stem().string() + " " + variant_of(scene, study.swept), "holds",
                       "the fast step against the reference",
                       static_cast<double>(e.particles) * steps * reference_cost,
                       [first] { return run_by_both(first); }});
    }
  }
  return cases;
}

}  // namespace stability
