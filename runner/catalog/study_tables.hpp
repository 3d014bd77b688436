#pragma once
/// Tables of one study for people: the report's. Each call opens the catalog read-only; all throw
/// CatalogError.
#include <filesystem>
#include <string>
#include <vector>

#include "runner/catalog/query.hpp"

namespace mpmstudy {

struct StudyTable {
  struct Row {
    std::string key;  ///< of its job; "" where a row is of no single job
    std::vector<SqlValue> cells;
  };
  std::vector<std::string> head;  ///< names of columns, as the views have them
  std::vector<Row> rows;          ///< in the order of the sweep
};

/// `parameters`: of the scene, whose columns come first.
StudyTable table_of_jobs(const std::filesystem::path& results, const std::string& study,
                         const std::vector<std::string>& parameters);
StudyTable table_of_metrics(const std::filesystem::path& results, const std::string& study);
/// Intervals of a quantity from several cells.
StudyTable table_of_accuracy(const std::filesystem::path& results, const std::string& study,
                             const std::vector<std::string>& parameters, const std::string& quantity);
/// Of a search; its parameters without the cells, which have a column of their own.
StudyTable table_of_brackets(const std::filesystem::path& results, const std::string& study,
                             const std::vector<std::string>& parameters);
/// Runs of a search that stopped when decided, beside those of its audit ("NAME-audit"), which went on to
/// their end: the same in all that is given.
StudyTable table_of_audit(const std::filesystem::path& results, const std::string& study,
                          const std::vector<std::string>& parameters);
/// What every study has cost, by name.
StudyTable table_of_costs(const std::filesystem::path& results);

}  // namespace mpmstudy
