#pragma once
/// The program as a user has it, in a folder of its own.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include "tests/runner/fakes.hpp"

namespace mpmstudy {

using Arguments = std::vector<std::string>;

class Program : public testing::Test {
 protected:
  pid_t start(Arguments arguments) {
    arguments.insert(arguments.begin(), PROGRAM);
    const pid_t child = fork();
    if (child != 0) return child;
    const int file = open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
    dup2(file, STDOUT_FILENO);
    dup2(file, STDERR_FILENO);
    std::vector<char*> raw;
    for (auto& argument : arguments) raw.push_back(argument.data());
    raw.push_back(nullptr);
    execv(PROGRAM, raw.data());
    _exit(127);
  }
  int wait_for(pid_t child) {
    int end = 0;
    waitpid(child, &end, 0);
    std::ifstream file(log);
    std::stringstream text;
    text << file.rdbuf();
    output = text.str();
    return WIFEXITED(end) ? WEXITSTATUS(end) : 1000 + WTERMSIG(end);
  }
  int run(const Arguments& arguments) { return wait_for(start(arguments)); }
  /// Standard output alone of a command line of a shell; exit code in `code`.
  std::string out(const std::string& arguments) {
    const std::string file = (folder.path() / "out").string();
    code = WEXITSTATUS(std::system(
        ("'" PROGRAM "' " + arguments + " --results '" + results + "' > '" + file + "' 2> '" + log + "'")
            .c_str()));
    std::ifstream stream(file);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  fakes::TemporaryFolder folder;
  std::string log = (folder.path() / "log").string();
  std::string results = (folder.path() / "results").string();
  std::string smoke = SOURCE_DIR "/studies/examples/smoke.toml";
  std::string output;
  int code = -1;
};

}  // namespace mpmstudy
