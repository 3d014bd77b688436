#include "runner/slurm/script.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "runner/slurm/shell_word.hpp"

namespace mpmstudy {
namespace {

/// A value as a line of #SBATCH takes it: in quotes where a blank or a '#' would end it.
std::string option_value(const std::string& value) {
  if (value.find_first_of(" \t#'\"\\") == std::string::npos) return value;
  std::string quoted = "\"";
  for (const char c : value) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c;
  }
  return quoted + "\"";
}

/// The shell has taken the quotes of --slurm=--comment="a b" away. Several options in one, "-t 10 -p long",
/// and what has quotes of its own, stand as they are.
std::string option_line(const std::string& option) {
  const auto equals = option.find('=');
  if (equals == std::string::npos || option.find_first_of(" \t") < equals) return option;
  const std::string value = option.substr(equals + 1);
  if (value.find(" -") != std::string::npos || value.find_first_of("'\"") != std::string::npos) return option;
  return option.substr(0, equals + 1) + option_value(value);
}

/// In the name of a log, Slurm puts its own text for '%' and the letter after it.
std::string log_pattern(const std::string& path) {
  std::string pattern;
  for (const char c : path) pattern += c == '%' ? std::string("%%") : std::string(1, c);
  return pattern;
}

bool has_control_character(const std::string& text) {
  return std::ranges::any_of(text, [](unsigned char c) { return c < ' ' || c == 127; });
}

std::string head(const SlurmScripts& s, const std::string& what, const std::string& log) {
  std::string text = "#!/bin/bash\n";
  text += fmt::format("#SBATCH --job-name={}{}\n", s.job_name, what);
  text += fmt::format("#SBATCH --output={}\n", option_value(log_pattern(s.folder) + "/" + log));
  // What cannot be started ends. Slurm would hold it until a user releases it if it were to be tried again,
  // and what depends on it would wait.
  text += "#SBATCH --no-requeue\n#SBATCH --open-mode=append\n";
  for (const auto& option : s.options) text += "#SBATCH " + option_line(option) + "\n";
  return text;
}

std::string words(const std::vector<std::string>& all) {
  std::string text;
  for (const auto& word : all) text += " " + shell_word(word);
  return text;
}

}  // namespace

std::string clusters_of(const std::vector<std::string>& options) {
  std::string clusters;
  for (const auto& option : options)
    for (const std::string flag : {"--clusters", "--cluster", "-M"})
      if (option.starts_with(flag)) {
        const auto begin = option.find_first_not_of("= \t", flag.size());
        if (begin == std::string::npos) break;
        clusters = option.substr(begin, option.find_first_of(" \t", begin) - begin);
        break;
      }
  return clusters;
}

std::string wrong_option(const std::string& option) {
  if (has_control_character(option)) return "has a line break or another control character";
  if (!option.starts_with('-')) return "is no option; write for example --slurm=--partition=long";
  const std::string name = option.substr(0, option.find_first_of("= \t"));
  static constexpr const char* ours[] = {"--array", "-a", "--job-name",  "-J",
                                         "--wait",  "-W", "--test-only", "--wrap"};
  if (std::ranges::find(ours, name) != std::end(ours))
    return "is not for the user to give: the program sets it, or needs it as it is";
  return "";
}

std::string wrong_path(const std::string& path) {
  if (has_control_character(path)) return "has a line break or another control character";
  if (path.find('\\') != std::string::npos) return "has a backslash, which Slurm takes out of names of logs";
  return "";
}

std::string array_script(const SlurmScripts& s) {
  return head(s, "", "log-%a.txt") +
         fmt::format(R"(#SBATCH --array=0-{last}
#SBATCH --cpus-per-task={workers}
set -u
folder={folder}
shard=$folder/shard-$SLURM_ARRAY_TASK_ID
[ -e "$shard" ] && exit 0  # run again after it was whole
local=$(mktemp -d "${{TMPDIR:-/tmp}}/mpmstudy-XXXXXX") || exit 75
trap 'rm -rf "$local"' EXIT
{program} run "$folder/study.toml"{run} --yes -q -j {workers} \
  --only "$folder/keys-$SLURM_ARRAY_TASK_ID.txt" --shard --results "$local/results" &
trap 'kill -TERM $!' TERM INT
wait $!
code=$?
while [ $code -gt 128 ] && kill -0 $! 2>/dev/null; do wait $!; code=$?; done  # a signal ended the wait only
[ $code -le 1 ] || exit $code  # not whole: the merge submits what is left
partial=$shard.$SLURM_JOB_ID.tmp
rm -rf "$partial"
cp -r "$local/results" "$partial" && sync "$partial"/* && mv -T "$partial" "$shard" 2>/dev/null || rm -rf "$partial"
[ -e "$shard" ]
)",
                     fmt::arg("last", s.shards - 1), fmt::arg("workers", s.workers),
                     fmt::arg("folder", shell_word(s.folder)), fmt::arg("program", shell_word(s.program)),
                     fmt::arg("run", words(s.run)));
}

std::string merge_script(const SlurmScripts& s) {
  return head(s, "-merge", "log-merge.txt") +
         fmt::format(R"(#SBATCH --cpus-per-task=1
#SBATCH --array=0-1%1
set -u
shopt -s nullglob extglob
folder={folder}
[ -e "$folder/went-on" ] && exit 0  # the second element is there for a first one that was lost
shards=("$folder"/shard-+([0-9]))
code=0
if [ ${{#shards[@]}} -gt 0 ]; then
  {program} merge "${{shards[@]}}" --results {results} || code=$?
fi
[ $code -le 1 ] || exit $code
touch "$folder/merged"
{program} run "$folder/study.toml"{run}{again} --yes --engine slurm --round {round} --results {results} || code=$?
[ $code -le 1 ] && touch "$folder/went-on"
exit $code
)",
                     fmt::arg("folder", shell_word(s.folder)), fmt::arg("program", shell_word(s.program)),
                     fmt::arg("results", shell_word(s.results)), fmt::arg("run", words(s.run)),
                     fmt::arg("again", words(s.again)), fmt::arg("round", s.round + 1));
}

}  // namespace mpmstudy
