#include "runner/slurm/queue.hpp"

#include <fmt/format.h>

#include <ctime>
#include <exception>
#include <fstream>
#include <map>
#include <stdexcept>

#include "runner/slurm/client.hpp"

namespace mpmstudy {
namespace {

namespace fs = std::filesystem;

/// Counts the jobs that squeue lists; the numbers that they have.
void count(Submission& submission, const std::vector<QueueRow>& rows) {
  SubmissionRecord& record = submission.record;
  for (const auto& row : rows) {
    const bool merge = row.name == record.name + "-merge";
    auto& id = merge ? record.merge_id : record.array_id;
    if (id.empty()) id = row.array_id();
    if (row.ended()) continue;
    if (merge)
      submission.merge_queued = true;
    else
      ++(row.state == "PD" ? submission.pending : submission.running);
    const bool stranded =
        row.reason.find("failed") != std::string::npos && row.reason.find("held") != std::string::npos;
    if (stranded) submission.stranded.push_back(row.id);
    submission.held += stranded || row.reason.find("Held") != std::string::npos;
  }
}

/// What is in a folder; nothing where there is none. One that cannot be read is an error, not an empty one.
std::set<fs::path> list(const fs::path& folder) {
  std::set<fs::path> entries;
  std::error_code error;
  for (fs::directory_iterator next(folder, error), end; !error && next != end; next.increment(error))
    entries.insert(next->path());
  if (error && error != std::errc::no_such_file_or_directory)
    throw std::runtime_error(folder.string() + ": cannot be read: " + error.message());
  return entries;
}

/// Something of an element or of the merge is in the folder: Slurm had the job.
bool has_run(const fs::path& folder) {
  for (const auto& entry : list(folder)) {
    const std::string name = entry.filename().string();
    if (name.starts_with("shard-") || name.starts_with("log-")) return true;
  }
  return false;
}

/// Why a job that Slurm has no record of may still not be over; "": it is over.
std::string doubt(const Submission& submission) {
  const SubmissionRecord& record = submission.record;
  if (record.clusters.empty() && !record.cluster.empty()) {
    const SlurmConfig here = slurm_config();
    if (here.cluster.empty())
      return fmt::format("scontrol does not say whether this is the cluster '{}', where it was submitted",
                         record.cluster);
    if (here.cluster != record.cluster)
      return fmt::format("it was submitted to the cluster '{}'; the Slurm of this machine is '{}'",
                         record.cluster, here.cluster);
    if (here.jobs_private && record.user != user_name())
      return fmt::format("it was submitted by {}, and this Slurm shows users their own jobs only",
                         record.user);
  }
  const std::int64_t age = std::time(nullptr) - record.asked_at;
  if (record.array_id.empty() && age < may_still_be_taken_s && !has_run(submission.folder))
    return fmt::format("sbatch gave no number, and Slurm may still take the job; asked again after {} s",
                       may_still_be_taken_s - age);
  return "";
}

}  // namespace

void ask_queue(Submission& submission) {
  SubmissionRecord& record = submission.record;
  submission.pending = submission.running = submission.held = 0;
  submission.merge_queued = false;
  submission.stranded.clear();
  QueueAnswer answer = queue_by_name(record.name + "," + record.name + "-merge", record.clusters);
  if (answer.unknown.empty() && answer.rows.empty() && !record.array_id.empty())
    answer = queue_by_id(record.array_id + (record.merge_id.empty() ? "" : "," + record.merge_id),
                         record.clusters);
  submission.unknown = answer.unknown;
  for (const auto& row : answer.rows)
    if (row.name != record.name && row.name != record.name + "-merge" && !row.ended())
      submission.unknown =
          fmt::format("job {} is called '{}', not '{}': renamed, or its number was given to another job",
                      row.id, row.name, record.name);
  if (!submission.unknown.empty()) return;
  if (answer.rows.empty()) {
    submission.unknown = doubt(submission);
    return;
  }
  const SubmissionRecord before = record;
  count(submission, answer.rows);
  if (record.array_id == before.array_id && record.merge_id == before.merge_id) return;
  try {
    write_record(submission.folder, record);
  } catch (const std::exception&) {  // who only reads may have no right to write; it is asked for again
  }
}

std::vector<fs::path> whole_shards(const Submission& submission) {
  std::error_code none;
  std::vector<fs::path> shards;
  for (std::size_t i = 0; i < submission.record.shards; ++i)
    if (const auto shard = submission.folder / fmt::format("shard-{}", i); fs::exists(shard, none))
      shards.push_back(shard);
  return shards;
}

std::vector<Submission> read_submissions(const fs::path& results) {
  std::vector<Submission> all;
  std::map<std::string, std::string> silence;  // a cluster that does not answer is asked once
  for (const auto& folder : list(results / "slurm")) {
    if (is_closed(folder)) continue;
    Submission submission;
    submission.folder = folder;
    try {
      const auto record = read_record(folder);
      if (!record) continue;
      submission.record = *record;
      submission.whole = whole_shards(submission).size();
      std::string& unknown = silence[record->clusters];
      submission.unknown = unknown;
      if (unknown.empty()) ask_queue(submission);
      if (submission.unknown.starts_with("squeue: ")) unknown = submission.unknown;
    } catch (const std::exception& error) {
      submission.unknown = error.what();
    }
    all.push_back(std::move(submission));
  }
  return all;
}

std::set<std::string> keys_of(const Submission& submission) {
  std::set<std::string> keys;
  for (const auto& entry : list(submission.folder)) {
    if (!entry.filename().string().starts_with("keys-")) continue;
    std::ifstream file(entry);
    if (!file) throw std::runtime_error(entry.string() + ": cannot be read");
    for (std::string key; file >> key;) keys.insert(key);
  }
  return keys;
}

std::set<std::string> queued_keys(const std::vector<Submission>& submissions) {
  std::set<std::string> keys;
  for (const auto& submission : submissions)
    if (submission.may_be_queued()) keys.merge(keys_of(submission));
  return keys;
}

std::set<std::string> last_submitted(const fs::path& results, const std::string& study) {
  Submission last;  // the names end in the time: the greatest is the newest
  for (const auto& folder : list(results / "slurm")) try {
      if (const auto record = read_record(folder); record && record->study == study) last.folder = folder;
    } catch (const std::exception&) {  // read_submissions tells it
    }
  return last.folder.empty() ? std::set<std::string>{} : keys_of(last);
}

Released release_stranded(const std::vector<Submission>& submissions) {
  Released released;
  for (const auto& submission : submissions)
    for (const auto& id : submission.stranded) {
      const std::string refusal = release_job(id, submission.record.clusters);
      if (refusal.empty())
        released.ids.push_back(id);
      else
        released.refusals.push_back(id + ": " + refusal);
    }
  return released;
}

}  // namespace mpmstudy
