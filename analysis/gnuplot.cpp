#include "analysis/gnuplot.hpp"

#include "analysis/fonts.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <spawn.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <system_error>

namespace analysis {
namespace {

std::filesystem::path with_suffix(std::filesystem::path path, const char* suffix) {
  path += suffix;
  return path;
}

std::string read_text(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

/// Exit status of `gnuplot --default-settings script` in the folder; its words go to the file "messages".
int spawn_gnuplot(const std::filesystem::path& folder, const char* script) {
  const std::string messages = (folder / "messages").string();
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
  posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, messages.c_str(), O_WRONLY | O_CREAT | O_TRUNC,
                                   0600);
  posix_spawn_file_actions_adddup2(&actions, STDOUT_FILENO, STDERR_FILENO);
  posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
  std::string program = "gnuplot", option = "--default-settings", file = script;
  char* const arguments[] = {program.data(), option.data(), file.data(), nullptr};
  pid_t child = 0;
  const int error = posix_spawnp(&child, "gnuplot", &actions, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error == ENOENT)
    throw std::runtime_error("gnuplot is not installed (Debian: apt-get install gnuplot-nox)");
  if (error != 0) throw std::runtime_error("cannot start gnuplot: " + std::generic_category().message(error));
  int status = 0;
  while (waitpid(child, &status, 0) < 0)
    if (errno != EINTR) throw std::runtime_error("lost gnuplot: " + std::generic_category().message(errno));
  return status;
}

void draw_one(const FigureFolder& folder, const std::string& terminal, const std::string& body,
              const char* script, const char* output) {
  folder.write(script, fmt::format("set encoding utf8\nset terminal {}\nset output {}\n{}\nunset output\n",
                                   terminal, gnuplot_text(output), body));
  const int status = spawn_gnuplot(folder.path(), script);
  std::error_code ignored;
  if (status == 0 && std::filesystem::file_size(folder.path() / output, ignored) > 0 && !ignored) return;
  throw std::runtime_error("gnuplot failed: " + read_text(folder.path() / "messages"));
}

}  // namespace

std::string gnuplot_text(std::string_view text) {
  std::string result(1, '\'');
  for (const char c : drawable(text)) {
    if (c == '\'' || c == '`')  // a backquote would be a command in other quotes
      result += "''";
    else
      result += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
  }
  result += '\'';
  return result;
}

FigureFolder::FigureFolder(const std::filesystem::path& stem) {
  std::error_code error;
  const std::filesystem::path parent = stem.has_parent_path() ? stem.parent_path() : ".";
  std::filesystem::create_directories(parent, error);
  std::string name = (parent / fmt::format(".{}.XXXXXX", stem.filename().string())).string();
  if (mkdtemp(name.data()) == nullptr)
    throw std::runtime_error(parent.string() +
                             ": cannot make a folder in it: " + std::generic_category().message(errno));
  path_ = std::filesystem::absolute(name);
}

FigureFolder::~FigureFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

void FigureFolder::write(const std::string& name, std::string_view content) const {
  std::ofstream out(path_ / name, std::ios::binary);
  out.write(content.data(), static_cast<std::streamsize>(content.size()));
  out.close();
  if (!out) throw std::runtime_error((path_ / name).string() + ": cannot write");
}

void run_gnuplot(const FigureFolder& folder, const std::string& body, FigureSize size,
                 const std::filesystem::path& stem) {
  const std::string png = fmt::format(
      "pngcairo noenhanced background '#ffffff' font 'DejaVu Sans,11' size {},{} fontscale 2 linewidth 2 "
      "pointscale 2",
      2 * size.width, 2 * size.height);
  const std::string svg = fmt::format(
      "svg noenhanced standalone background '#ffffff' font 'DejaVu Sans,11' size {},{} linewidth 1",
      size.width, size.height);
  draw_one(folder, png, body, "png.gp", "figure.png");
  draw_one(folder, svg, body, "svg.gp", "figure.svg");
  for (const char* suffix : {".png", ".svg"}) {
    const std::filesystem::path figure = with_suffix(stem, suffix);
    std::error_code error;
    std::filesystem::rename(with_suffix(folder.path() / "figure", suffix), figure, error);
    if (error)
      throw std::runtime_error(fmt::format("{}: cannot be written: {}", figure.string(), error.message()));
  }
}

}  // namespace analysis
