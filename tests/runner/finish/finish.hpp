#pragma once
/// The program as a user has it, and studies whose results are made up.
#include <gmock/gmock.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "runner/catalog/query.hpp"
#include "runner/catalog/writer.hpp"
#include "runner/study/study.hpp"
#include "tests/runner/fakes.hpp"

namespace mpmstudy {

class Finish : public testing::Test {
 protected:
  /// Exit code and what it printed.
  int run(const std::string& arguments, std::string& printed) const {
    printed.clear();
    const std::string command =
        std::string(MPMSTUDY) + " " + arguments + " --results " + results().string() + " 2>&1";
    FILE* pipe = popen(command.c_str(), "r");
    std::array<char, 4096> buffer{};
    while (fgets(buffer.data(), buffer.size(), pipe)) printed += buffer.data();
    return WEXITSTATUS(pclose(pipe));
  }
  std::filesystem::path write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_.path() / name) << text;
    return folder_.path() / name;
  }
  std::filesystem::path results() const { return folder_.path() / "results"; }

  TemporaryFolder folder_;
};

/// A study of these scenes, as if a file had said so.
inline Study made_study(const std::string& name, std::vector<mpm::Scene> scenes,
                        std::vector<std::string> swept = {}) {
  Study study;
  study.name = study.title = name;
  study.kind = mpm::SceneKind::cavity_impact;
  study.swept = std::move(swept);
  study.scenes = std::move(scenes);
  return study;
}

/// Registers a study and decides its jobs; equal scenes are one job and share the first one's result.
inline void put(CatalogWriter& writer, const Study& study, const std::vector<mpm::RunResult>& results) {
  const Plan plan = make_plan(study);
  writer.register_study(study.name, study.title, plan.jobs, false);
  for (std::size_t i = 0; i < plan.jobs.size(); ++i) {
    writer.reserve(plan.jobs[i].key);
    FinishedJob done;
    done.key = plan.jobs[i].key;
    done.result = results.at(i);
    writer.complete(done);
  }
  writer.flush();
}

}  // namespace mpmstudy
