#pragma once
/// What the parts of the fault harness share: starting the program, and looking for damage.
#include <sys/types.h>

#include <filesystem>
#include <map>
#include <set>
#include <string>
#include <vector>

namespace mpmstudy::faults {

struct Options {
  int kills = 20;
  unsigned seed = 1;
  std::string program = PROGRAM, study = STUDY, folder;
  std::vector<std::string> compare;  ///< two results folders
  int disk = 0;                      ///< how many places of failure
  int every = 1;                     ///< the distance between them
  bool read_only = false;
  int disturb = 0;  ///< how many disturbances: signals, hosts, namespaces
};

struct Tally {
  int kills = 0, rounds = 0, starts = 0;
  int lost = 0, twice = 0, integrity = 0, different = 0, orphans = 0, refused = 0, uncounted = 0;
  bool clean() const { return lost + twice + integrity + different + orphans + refused + uncounted == 0; }
};

/// What a run that nobody disturbs leaves behind.
struct Undisturbed {
  std::string rows;
  std::set<std::string> files;
  double seconds = 0;  ///< how long it takes
};

/// Starts the program; what it says goes to RESULTS.log. An empty `words`: it runs the study.
pid_t start(const Options&, const std::filesystem::path& results,
            const std::map<std::string, std::string>& environment = {}, std::vector<std::string> words = {});
/// Starts a program that is looked for in PATH, standard output to `output`, errors to the end of a file.
pid_t start_words(std::vector<std::string> words, const std::map<std::string, std::string>& environment,
                  int output, const std::string& errors);
/// Exit code, or 1000 + the signal that ended it.
int wait_for(pid_t);
/// All that was said to RESULTS.log.
std::string words_of(const std::filesystem::path& results);

/// Throws std::runtime_error if the study does not run.
Undisturbed run_undisturbed(const Options&);
/// The same rows and the same files?
bool same_end(const std::filesystem::path& results, const Undisturbed&);
/// Paths under the results folder that are not the catalog's own.
std::set<std::string> files_of(const std::filesystem::path& results);

/// What must hold at every moment: what was done is done, once, and the catalog is whole. Gives back the keys
/// that are done.
std::set<std::string> look(const std::filesystem::path& results, const std::set<std::string>& done_before,
                           Tally&);

// The forms. Exit code of the harness.
int kill_runs(const Options&, const Undisturbed&);
int fail_disks(const Options&, const Undisturbed&);
int lock_folders(const Options&, const Undisturbed&);
int disturb_runs(const Options&, const Undisturbed&);

}  // namespace mpmstudy::faults
