#include "runner/slurm/client.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdlib>
#include <sstream>

#include "runner/slurm/command.hpp"

namespace mpmstudy {
namespace {

/// How long a command of Slurm may take [s]. With a busy controller clients wait for a minute and more.
double patience() {
  const char* text = std::getenv("MPMSTUDY_SLURM_TIMEOUT");
  const double seconds = text != nullptr ? std::strtod(text, nullptr) : 0;
  return seconds > 0 ? seconds : 120;
}

std::string lower(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

bool contains_any(const std::string& text, const auto& words) {
  return std::ranges::any_of(words, [&](const char* word) { return text.find(word) != std::string::npos; });
}

/// The begin of every line that is an answer, so that no notice is taken for one.
constexpr std::string_view mark = "mpmstudy|";

void add_clusters(std::vector<std::string>& words, const std::string& clusters) {
  if (!clusters.empty()) words.push_back("--clusters=" + clusters);
}

QueueAnswer ask(const std::string& which, const std::string& clusters) {
  std::vector<std::string> words = {"squeue", "--array",  "--states=all",
                                    which,    "--format", std::string(mark) + "%i|%t|%j|%r"};
  add_clusters(words, clusters);
  // A user's SQUEUE_PARTITION and the like would leave jobs out of the answer.
  const CommandAnswer said = run_command(words, patience(), {"SQUEUE_*", "SLURM_CLUSTERS"});
  QueueAnswer answer;
  if (!said.timed_out && said.code != 0 &&
      lower(said.err + said.out).find("invalid job id") != std::string::npos) {
    answer.no_such_job = true;
    return answer;
  }
  const auto rows = parse_queue(said.out);
  if (said.timed_out || said.code != 0 || !rows)
    answer.unknown = "squeue: " + said.words();
  else
    answer.rows = *rows;
  return answer;
}

}  // namespace

bool QueueRow::ended() const {
  static constexpr std::array states = {"CD", "CA", "F", "TO", "NF", "PR", "BF", "DL", "OOM"};
  return std::ranges::find(states, state) != states.end();
}

std::optional<std::vector<QueueRow>> parse_queue(std::string_view printed) {
  std::vector<QueueRow> rows;
  bool titles = false;
  std::istringstream lines{std::string(printed)};
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with(mark)) continue;
    std::istringstream fields(line.substr(mark.size()));
    QueueRow row;
    if (!std::getline(fields, row.id, '|') || !std::getline(fields, row.state, '|') ||
        !std::getline(fields, row.name, '|'))
      return {};  // cut short
    std::getline(fields, row.reason);
    if (row.id == "JOBID")
      titles = true;
    else
      rows.push_back(std::move(row));
  }
  if (!titles) return {};
  return rows;
}

QueueAnswer queue_by_name(const std::string& names, const std::string& clusters) {
  return ask("--name=" + names, clusters);
}

QueueAnswer queue_by_id(const std::string& ids, const std::string& clusters) {
  return ask("--jobs=" + ids, clusters);
}

std::optional<JobNumber> parse_job_number(std::string_view printed) {
  std::optional<JobNumber> found;
  std::istringstream lines{std::string(printed)};
  for (std::string line; std::getline(lines, line);) {
    while (!line.empty() && std::isspace(static_cast<unsigned char>(line.back()))) line.pop_back();
    // Without --parsable: "Submitted batch job 4711", "... on cluster fast".
    if (constexpr std::string_view words = "Submitted batch job "; line.starts_with(words)) {
      line.erase(0, words.size());
      constexpr std::string_view on = " on cluster ";
      if (const auto at = line.find(on); at != std::string::npos) line.replace(at, on.size(), ";");
    }
    const auto end = line.find(';');
    JobNumber number{line.substr(0, end), end == std::string::npos ? "" : line.substr(end + 1)};
    if (number.id.empty() || number.id.find_first_not_of("0123456789") != std::string::npos) continue;
    if (number.cluster.find_first_of(" \t;") != std::string::npos) continue;
    if (end != std::string::npos && number.cluster.empty()) continue;
    found = std::move(number);
  }
  return found;
}

SubmitAnswer sbatch(const std::string& name, const std::vector<std::string>& options,
                    const std::string& script) {
  std::vector<std::string> words = {"sbatch", "--parsable", "--job-name=" + name};
  words.insert(words.end(), options.begin(), options.end());
  words.push_back(script);
  // Of the user's settings for sbatch, these would make another array of it, or wait for its end.
  const CommandAnswer said = run_command(words, patience(), {"SBATCH_ARRAY_INX", "SBATCH_WAIT"});
  SubmitAnswer answer;
  answer.words = said.words();
  if (said.code == 0 && !said.timed_out) {
    answer.taken = parse_job_number(said.out);
    if (answer.taken) answer.words = said.err;
    return answer;
  }
  // Errors of the way to the controller do not say whether it has the job.
  static constexpr std::array of_the_way = {"timed out", "socket",     "connect", "contact", "communication",
                                            "bytes",     "unexpected", "backup",  "transmi", "retry"};
  const std::string text = lower(said.err + said.out);
  answer.never_asked = !said.started;
  answer.refused = !said.timed_out && said.code < 126 && text.find("error:") != std::string::npos &&
                   !contains_any(text, of_the_way);
  return answer;
}

std::string release_job(const std::string& id, const std::string& clusters) {
  std::vector<std::string> words = {"scontrol"};
  add_clusters(words, clusters);
  words.insert(words.end(), {"release", id});
  const CommandAnswer said = run_command(words, patience(), {"SLURM_CLUSTERS"});
  return said.code == 0 && !said.timed_out ? "" : said.words();
}

SlurmConfig slurm_config() {
  const CommandAnswer said = run_command({"scontrol", "show", "config"}, patience(), {"SLURM_CLUSTERS"});
  SlurmConfig config;
  if (said.code != 0 || said.timed_out) return config;
  std::istringstream lines(said.out);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string name, equals, value;
    words >> name >> equals >> value;
    if (equals != "=") continue;
    if (name == "ClusterName") config.cluster = value;
    if (name == "PrivateData") config.jobs_private = lower(value).find("jobs") != std::string::npos;
  }
  return config;
}

}  // namespace mpmstudy
