#pragma once
/// What a job came to, so that two of them can be compared bit for bit. Durations, hosts and times of day are
/// no part of it.
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

namespace SQLite {
class Database;
}

namespace mpmstudy {

/// One value: where it stands ("final_area_m2", "metrics roundness value", "fields 000_1.000ns.vtkhdf
/// checksum") and its text, which tells every bit.
struct ResultValue {
  std::string name;
  std::string text;
  bool operator==(const ResultValue&) const = default;
};
using ResultValues = std::vector<ResultValue>;

/// Everything that the job with this key came to; empty if the catalog does not have it. Names of columns and
/// rows are in a fixed order.
ResultValues results_of(SQLite::Database&, const std::string& key);
ResultValues results_of(const std::filesystem::path& results, const std::string& key);

/// "final_area_m2: 1.5e-12 and 1.6e-12" for the first few values that differ; "" if the results are the same.
std::string difference(const ResultValues& one, const ResultValues& other);

}  // namespace mpmstudy
