#pragma once
#include <cstddef>
#include <map>
#include <optional>
#include <string>

namespace mpmstudy {

/// When a run will be over, from what it has done so far against what was predicted. One thread at a time.
class Eta {
 public:
  /// predicted: of all jobs together, in any unit (seconds); workers share it.
  Eta(double predicted, unsigned workers);

  void add(double predicted) { total_ += predicted; }                        ///< more jobs
  void progress(const std::string& key, double predicted, double fraction);  ///< of a running job, 0 ... 1
  void finished(const std::string& key, double predicted);
  void stopped(const std::string& key);

  /// Seconds that are left, elapsed seconds after the start; empty while too little is known.
  std::optional<double> remaining(double elapsed) const;
  /// Share of the work that is done, 0 ... 1.
  double fraction() const;

 private:
  struct Running {
    double predicted, fraction;
  };
  double total_;
  unsigned workers_;
  double finished_ = 0;
  std::map<std::string, Running> running_;
};

}  // namespace mpmstudy
