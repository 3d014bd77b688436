#include "runner/slurm/script.hpp"

#include <fmt/format.h>

namespace mpmstudy {
namespace {

std::string head(const SlurmScripts& s, const std::string& what, const std::string& log) {
  std::string text = "#!/bin/bash\n";
  text += fmt::format("#SBATCH --job-name=mpmstudy-{}{}\n", s.study, what);
  text += fmt::format("#SBATCH --output={}/{}\n", s.folder, log);
  // What cannot be started ends. Slurm would hold it until a human comes if it were to be tried again, and
  // what depends on it would wait.
  text += "#SBATCH --no-requeue\n#SBATCH --open-mode=append\n";
  for (const auto& option : s.options) text += "#SBATCH " + option + "\n";
  return text;
}

std::string words(const std::vector<std::string>& all) {
  std::string text;
  for (const auto& word : all) text += " " + shell_word(word);
  return text;
}

}  // namespace

std::string shell_word(const std::string& word) {
  const auto plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./=:,+%@";
  if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) return word;
  std::string quoted = "'";
  for (const char c : word) quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return quoted + "'";
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
  --only "$folder/keys-$SLURM_ARRAY_TASK_ID.txt" --results "$local/results" &
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
