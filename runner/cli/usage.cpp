#include "runner/cli/usage.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <vector>

#include "runner/study/schema.hpp"

namespace mpmstudy {
namespace {

/// The verb, or the part of a verb, that was understood last.
const CLI::App& innermost(const CLI::App& app) {
  const auto parsed = app.get_subcommands();
  return parsed.empty() ? app : innermost(*parsed.back());
}

std::vector<std::string> names_of_verbs(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* verb : app.get_subcommands({})) names.push_back(verb->get_name());
  return names;
}

std::vector<std::string> names_of_options(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_group().empty()) continue;  // not for people
    for (const auto& name : option->get_lnames()) names.push_back("--" + name);
    for (const auto& name : option->get_snames()) names.push_back("-" + name);
  }
  return names;
}

std::string choice(const std::string& word, const std::vector<std::string>& names, const char* what) {
  const auto near = nearest(word, std::vector<std::string_view>(names.begin(), names.end()));
  if (!near.empty()) return fmt::format("did you mean {}?", near);
  return fmt::format("{}: {}", what, listed(names));
}

/// What to say of one argument that has no place.
std::string unexpected(const CLI::App& app, const std::string& argument) {
  const CLI::App& verb = innermost(app);
  const bool is_program = &verb == &app;
  const std::string of = is_program ? "mpmstudy" : "mpmstudy " + verb.get_name();
  if (argument.starts_with('-')) {
    if (argument.find_first_of(" \t\n") != std::string::npos)
      return fmt::format(
          "what begins with '-' is taken for an option; behind -- it is not: {} -- \"...\"\n  it was: {}", of,
          argument.substr(0, argument.find('\n')));
    const std::string name = argument.substr(0, argument.find('='));
    return fmt::format("{}: no option of {}; {}", name, of, choice(name, names_of_options(verb), "options"));
  }
  const auto verbs = names_of_verbs(verb);
  if (!verbs.empty())
    return fmt::format("{}: no verb of {}; {}", argument, of, choice(argument, verbs, "verbs"));
  return fmt::format("{}: one argument too many for {}{}", argument, of,
                     verb.get_name() == "query" ? "; quote the SQL, so that it is one argument" : "");
}

}  // namespace

std::string usage_message(const CLI::App* app, const CLI::Error& error) {
  const CLI::App& verb = innermost(*app);
  std::string text;
  for (const auto& argument : app->remaining(true)) {
    text += unexpected(*app, argument) + "\n";
    if (!names_of_verbs(verb).empty() && !argument.starts_with('-')) break;  // the others are that verb's
  }
  if (text.empty()) text = std::string(error.what()) + "\n";
  return text + fmt::format("`mpmstudy {}--help` says more\n", &verb == app ? "" : verb.get_name() + " ");
}

}  // namespace mpmstudy
