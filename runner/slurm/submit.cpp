#include "runner/slurm/submit.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <ctime>
#include <fstream>
#include <stdexcept>
#include <thread>

#include "runner/slurm/client.hpp"

namespace mpmstudy {
namespace {

namespace fs = std::filesystem;

void write(const fs::path& path, const std::string& text) {
  std::ofstream file(path);
  file << text;
  file.close();
  if (!file) throw std::runtime_error(path.string() + ": cannot be written");
}

void note(std::vector<std::string>& notes, const SubmitAnswer& answer) {
  if (answer.taken && !answer.words.empty()) notes.push_back(answer.words);
}

/// The folder with all that the elements need; the record last.
void prepare(const SlurmScripts& scripts, const StudyFiles& files,
             const std::vector<std::vector<std::string>>& keys, const SubmissionRecord& record) {
  const fs::path folder = scripts.folder;
  fs::create_directories(folder.parent_path());
  if (!fs::create_directory(folder))
    throw std::runtime_error(folder.string() + ": is there already; run again");
  try {
    fs::copy_file(files.study, folder / "study.toml");
    if (!files.points.empty() && !files.points.is_absolute()) {
      fs::create_directories((folder / files.points).parent_path());
      fs::copy_file(files.study.parent_path() / files.points, folder / files.points);
    }
    for (std::size_t i = 0; i < keys.size(); ++i) {
      std::string lines;
      for (const auto& key : keys[i]) lines += key + "\n";
      write(folder / fmt::format("keys-{}.txt", i), lines);
    }
    write(folder / "array.sh", array_script(scripts));
    write(folder / "merge.sh", merge_script(scripts));
    write_record(folder, record);
  } catch (const std::exception&) {
    std::error_code ignored;
    fs::remove_all(folder, ignored);
    throw;
  }
}

}  // namespace

SubmitOutcome submit(const SlurmScripts& scripts, const StudyFiles& files,
                     const std::vector<std::vector<std::string>>& keys) {
  SubmitOutcome outcome;
  Submission& submission = outcome.submission;
  submission.folder = scripts.folder;
  SubmissionRecord& record = submission.record;
  record.study = scripts.study;
  record.name = scripts.job_name;
  record.shards = scripts.shards;
  record.clusters = scripts.clusters;
  record.cluster = slurm_config().cluster;
  record.user = user_name();
  record.asked_at = std::time(nullptr);
  prepare(scripts, files, keys, record);
  const SubmitAnswer array = sbatch(record.name, {}, (submission.folder / "array.sh").string());
  note(outcome.notes, array);
  if (array.taken) {
    record.array_id = array.taken->id;
    if (!array.taken->cluster.empty()) record.clusters = array.taken->cluster;
  } else {
    if (array.refused) record.asked_at = 0;         // it has answered: there is nothing to wait for
    if (!array.never_asked) ask_queue(submission);  // an sbatch that fails may have handed the job over
    if (array.never_asked || (array.refused && !submission.may_be_queued() && record.array_id.empty())) {
      std::error_code ignored;
      fs::remove_all(submission.folder, ignored);
      outcome.folder_kept = false;
    }
    if (record.array_id.empty()) {
      if (outcome.folder_kept && array.refused) write_record(submission.folder, record);
      outcome.trouble = "sbatch: " + array.words;
      if (!submission.unknown.empty()) outcome.trouble += "; " + submission.unknown;
      return outcome;
    }
    outcome.notes.push_back(
        fmt::format("sbatch: {}; but squeue has the job as {}", array.words, record.array_id));
  }
  try {
    write_record(submission.folder, record);
  } catch (const std::exception& error) {  // its name is recorded: squeue will tell the number
    outcome.notes.push_back(error.what());
  }
  if (!submission.merge_queued) outcome.trouble = submit_merge(submission, outcome.notes);
  return outcome;
}

std::string submit_merge(Submission& submission, std::vector<std::string>& notes) {
  SubmissionRecord& record = submission.record;
  const SubmitAnswer merge = sbatch(record.name + "-merge", {"--dependency=afterany:" + record.array_id},
                                    (submission.folder / "merge.sh").string());
  note(notes, merge);
  if (merge.taken) {
    record.merge_id = merge.taken->id;
    submission.merge_queued = true;
    try {
      write_record(submission.folder, record);
    } catch (const std::exception& error) {
      notes.push_back(error.what());
    }
    return "";
  }
  ask_queue(submission);
  if (submission.merge_queued) {
    notes.push_back(fmt::format("sbatch: {}; but squeue has the merge as {}", merge.words, record.merge_id));
    return "";
  }
  return fmt::format(
      "the merge is not in the queue (sbatch: {}{}); array {} goes on, and running again asks "
      "for its merge again",
      merge.words, submission.unknown.empty() ? "" : "; " + submission.unknown, record.array_id);
}

SubmitLock::SubmitLock(const fs::path& results) {
  std::error_code ignored;
  fs::create_directories(results / "slurm", ignored);
  file_ = open((results / "slurm" / "lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666);
  if (file_ < 0) return;
  for (int tries = 0; flock(file_, LOCK_EX | LOCK_NB) != 0; ++tries) {
    if (errno != EWOULDBLOCK && errno != EINTR) return;  // a share without locks
    if (tries == 6000) {
      close(file_);
      throw std::runtime_error((results / "slurm").string() +
                               ": another `mpmstudy run --engine slurm` has been submitting for 10 minutes; "
                               "run again when it has ended");
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
}

SubmitLock::~SubmitLock() {
  if (file_ >= 0) close(file_);
}

}  // namespace mpmstudy
