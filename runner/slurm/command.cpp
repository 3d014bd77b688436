#include "runner/slurm/command.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstring>
#include <string_view>
#include <system_error>

namespace mpmstudy {
namespace {

using Clock = std::chrono::steady_clock;

bool drops(const std::vector<std::string>& names, std::string_view entry) {
  const std::string_view name = entry.substr(0, entry.find('='));
  return std::ranges::any_of(names, [&](std::string_view drop) {
    if (drop.ends_with('*')) return name.starts_with(drop.substr(0, drop.size() - 1));
    return name == drop;
  });
}

/// A pipe whose reading end does not block.
struct Pipe {
  int ends[2];
  Pipe() {
    if (pipe2(ends, O_CLOEXEC) != 0) throw std::system_error(errno, std::generic_category(), "a pipe");
    fcntl(ends[0], F_SETFL, O_NONBLOCK);
  }
  ~Pipe() {
    close_end(0);
    close_end(1);
  }
  Pipe(const Pipe&) = delete;
  void close_end(int i) {
    if (ends[i] >= 0) close(ends[i]);
    ends[i] = -1;
  }
  /// Appends what is there; closes at the end.
  void drain(std::string& text) {
    std::array<char, 4096> block;
    while (ends[0] >= 0) {
      const ssize_t got = read(ends[0], block.data(), block.size());
      if (got > 0)
        text.append(block.data(), static_cast<std::size_t>(got));
      else if (got < 0 && errno == EINTR)
        continue;
      else if (got < 0 && errno == EAGAIN)
        return;
      else
        close_end(0);
    }
  }
};

pid_t spawn(const std::vector<std::string>& words, const std::vector<std::string>& drop, Pipe& out, Pipe& err,
            int& error) {
  std::vector<char*> arguments, environment;
  for (const auto& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  for (char** entry = environ; *entry != nullptr; ++entry)
    if (!drops(drop, *entry)) environment.push_back(*entry);
  environment.push_back(nullptr);
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_adddup2(&actions, out.ends[1], STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, err.ends[1], STDERR_FILENO);
  posix_spawnattr_t attributes;
  posix_spawnattr_init(&attributes);
  posix_spawnattr_setflags(&attributes, POSIX_SPAWN_SETPGROUP);  // a wrapper's children end with it
  posix_spawnattr_setpgroup(&attributes, 0);
  pid_t child = -1;
  error = posix_spawnp(&child, words[0].c_str(), &actions, &attributes, arguments.data(), environment.data());
  posix_spawnattr_destroy(&attributes);
  posix_spawn_file_actions_destroy(&actions);
  return error == 0 ? child : -1;
}

std::string trimmed(const std::string& text) {
  std::string line;
  for (const char c : text) {
    const bool blank = static_cast<unsigned char>(c) <= ' ';
    if (!blank)
      line += c;
    else if (!line.empty() && line.back() != ' ')
      line += ' ';
  }
  if (line.ends_with(' ')) line.pop_back();
  return line;
}

}  // namespace

std::string CommandAnswer::words() const {
  std::string text = trimmed(err);
  const std::string printed = trimmed(out);
  if (!printed.empty()) text += (text.empty() ? "" : " ") + printed;
  const std::string end = timed_out ? "no answer in time" : fmt::format("exit code {}", code);
  return text.empty() ? end : fmt::format("{} ({})", text, end);
}

CommandAnswer run_command(const std::vector<std::string>& words, double seconds,
                          const std::vector<std::string>& drop) {
  CommandAnswer answer;
  Pipe out, err;
  int error = 0;
  const pid_t child = spawn(words, drop, out, err, error);
  if (child < 0) {
    answer.code = 127;
    answer.started = false;
    answer.err = error == ENOENT ? words[0] + " is not installed here"
                                 : words[0] + ": " + std::generic_category().message(error);
    return answer;
  }
  out.close_end(1);
  err.close_end(1);
  const auto end = Clock::now() + std::chrono::duration<double>(seconds);
  int status = 0;
  while (true) {
    std::array<pollfd, 2> ready{{{out.ends[0], POLLIN, 0}, {err.ends[0], POLLIN, 0}}};
    poll(ready.data(), ready.size(), 20);
    out.drain(answer.out);
    err.drain(answer.err);
    // A process that it left behind may hold the pipes: its own end counts.
    const pid_t ended = waitpid(child, &status, WNOHANG);
    if (ended == child || (ended < 0 && errno != EINTR)) break;
    if (Clock::now() < end) continue;
    answer.timed_out = true;
    kill(-child, SIGKILL);
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {
    }
    break;
  }
  out.drain(answer.out);
  err.drain(answer.err);
  answer.code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return answer;
}

}  // namespace mpmstudy
