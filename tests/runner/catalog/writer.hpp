#pragma once
/// A catalog that tests write to.
#include <gmock/gmock.h>

#include <string>

#include "runner/catalog/query.hpp"
#include "runner/catalog/writer.hpp"
#include "tests/runner/fakes.hpp"

namespace mpmstudy {

class Writer : public testing::Test {
 protected:
  std::int64_t count(const std::string& sql) {
    return std::get<std::int64_t>(query(folder.path(), "SELECT count(*) FROM " + sql).rows.at(0).at(0));
  }
  SqlValue one(const std::string& sql) { return query(folder.path(), sql).rows.at(0).at(0); }
  static FinishedJob finished(const Job& job) {
    FinishedJob f;
    f.key = job.key;
    f.result = fakes::result_of(job.scene);
    f.snapshots = {{1e-9, 3, "fields/" + job.key + "/000_1.000ns.vtkhdf", 10, "00ff"}};
    f.wall_s = 1.5;
    f.cpu_s = 1.25;
    return f;
  }
  fakes::TemporaryFolder folder;
};

}  // namespace mpmstudy
