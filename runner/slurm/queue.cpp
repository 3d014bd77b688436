#include "runner/slurm/queue.hpp"

#include <fmt/format.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <fstream>
#include <memory>
#include <nlohmann/json.hpp>
#include <sstream>
#include <stdexcept>

namespace mpmstudy {
namespace {

namespace fs = std::filesystem;

struct Answer {
  int code = 0;
  std::string text;
};

Answer shell(const std::string& command) {
  Answer answer;
  std::FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return {127, "no shell"};
  std::array<char, 4096> block;
  for (std::size_t got = 0; (got = std::fread(block.data(), 1, block.size(), pipe)) > 0;)
    answer.text.append(block.data(), got);
  const int end = pclose(pipe);
  answer.code = WIFEXITED(end) ? WEXITSTATUS(end) : 128 + WTERMSIG(end);
  return answer;
}

/// "1234" of what `sbatch --parsable` prints: "1234" or "1234;cluster".
std::string sbatch(const std::string& arguments) {
  const Answer answer = shell("sbatch --parsable " + arguments + " 2>&1");
  const std::string id = answer.text.substr(0, answer.text.find_first_not_of("0123456789"));
  if (answer.code != 0 || id.empty()) throw std::runtime_error("sbatch: " + answer.text);
  return id;
}

void write(const fs::path& path, const std::string& text) {
  std::ofstream file(path);
  file << text;
  file.close();
  if (!file) throw std::runtime_error(path.string() + ": cannot be written");
}

/// Counts the elements that squeue lists: "1234_5 PD launch failed requeued held".
void ask_queue(Submission& submission) {
  const auto ids = submission.array_id + (submission.merge_id.empty() ? "" : "," + submission.merge_id);
  std::istringstream lines(shell("squeue -h -r -j " + ids + " -o '%i %t %r' 2>/dev/null").text);
  std::string id, state, reason;
  while (lines >> id >> state && std::getline(lines, reason)) {
    if (id.substr(0, id.find('_')) == submission.merge_id)
      submission.merge_queued = true;
    else
      ++(state == "PD" ? submission.pending : submission.running);
    const bool stranded =
        reason.find("failed") != std::string::npos && reason.find("held") != std::string::npos;
    if (stranded) submission.stranded.push_back(id);
    submission.held += stranded || reason.find("Held") != std::string::npos;
  }
}

void read_keys(const fs::path& folder, std::set<std::string>& keys) {
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(folder, none)) {
    if (!entry.path().filename().string().starts_with("keys-")) continue;
    std::ifstream file(entry.path());
    for (std::string key; file >> key;) keys.insert(key);
  }
}

std::set<fs::path> submission_folders(const fs::path& results) {
  std::error_code none;
  std::set<fs::path> folders;
  for (const auto& entry : fs::directory_iterator(results / "slurm", none)) folders.insert(entry.path());
  return folders;
}

}  // namespace

std::vector<Submission> read_submissions(const fs::path& results) {
  std::vector<Submission> all;
  for (const auto& folder : submission_folders(results)) {
    std::ifstream file(folder / "submitted.json");
    const auto json = nlohmann::json::parse(file, nullptr, false);
    if (!json.is_object() || fs::exists(folder / "merged")) continue;
    Submission submission;
    submission.folder = folder;
    submission.study = json.value("study", "");
    submission.array_id = json.value("array", "");
    submission.merge_id = json.value("merge", "");
    submission.shards = json.value("shards", std::size_t{0});
    for (std::size_t i = 0; i < submission.shards; ++i)
      submission.whole += fs::exists(folder / fmt::format("shard-{}", i));
    ask_queue(submission);
    all.push_back(std::move(submission));
  }
  return all;
}

std::set<std::string> queued_keys(const std::vector<Submission>& submissions) {
  std::set<std::string> keys;
  for (const auto& submission : submissions)
    if (submission.in_queue()) read_keys(submission.folder, keys);
  return keys;
}

std::set<std::string> last_submitted(const fs::path& results, const std::string& study) {
  fs::path last;  // the names end in the time: the greatest is the newest
  for (const auto& folder : submission_folders(results)) {
    std::ifstream file(folder / "submitted.json");
    const auto json = nlohmann::json::parse(file, nullptr, false);
    if (json.is_object() && json.value("study", "") == study) last = folder;
  }
  std::set<std::string> keys;
  read_keys(last, keys);
  return keys;
}

std::vector<std::string> release_stranded(const std::vector<Submission>& submissions) {
  std::vector<std::string> released;
  for (const auto& submission : submissions)
    for (const auto& id : submission.stranded)
      if (shell("scontrol release " + id + " 2>&1").code == 0) released.push_back(id);
  return released;
}

Submission submit(const SlurmScripts& scripts, const fs::path& study_file,
                  const std::vector<std::vector<std::string>>& keys) {
  const fs::path folder = scripts.folder;
  Submission submission;
  try {
    fs::create_directories(folder);
    fs::copy_file(study_file, folder / "study.toml");
    for (std::size_t i = 0; i < keys.size(); ++i) {
      std::string lines;
      for (const auto& key : keys[i]) lines += key + "\n";
      write(folder / fmt::format("keys-{}.txt", i), lines);
    }
    write(folder / "array.sh", array_script(scripts));
    write(folder / "merge.sh", merge_script(scripts));
    submission.folder = folder;
    submission.study = scripts.study;
    submission.shards = scripts.shards;
    submission.array_id = sbatch(shell_word((folder / "array.sh").string()));
    submission.merge_id = sbatch("--dependency=afterany:" + submission.array_id + " " +
                                 shell_word((folder / "merge.sh").string()));
    write(folder / "submitted.json", nlohmann::json({{"study", submission.study},
                                                     {"array", submission.array_id},
                                                     {"merge", submission.merge_id},
                                                     {"shards", submission.shards}})
                                             .dump(2) +
                                         "\n");
    return submission;
  } catch (const std::exception&) {
    for (const auto& id : {submission.merge_id, submission.array_id})
      if (!id.empty()) shell("scancel " + id + " 2>&1");
    std::error_code ignored;
    fs::remove_all(folder, ignored);
    throw;
  }
}

}  // namespace mpmstudy
