#include "runner/catalog/answers.hpp"

#include <SQLiteCpp/SQLiteCpp.h>

#include <cmath>
#include <map>

#include "libmpm/measure/results.hpp"
#include "runner/catalog/catalog_error.hpp"
#include "runner/catalog/connection.hpp"

namespace mpmstudy {

struct CatalogAnswers::Impl {
  explicit Impl(const std::filesystem::path& results) : db(open_for_reading(results)) {}

  /// The statement that reads a quantity: a column of its own, or a metric.
  SQLite::Statement& reader(const std::string& quantity) {
    auto& statement = readers[quantity];
    if (!statement) {
      const mpm::ResultRow* row = mpm::find_result(quantity);
      const bool column = row && !row->error_column.empty();
      const std::string value = column ? "j." + quantity : "m.value";
      const std::string error = column ? "j." + std::string(row->error_column) : "m.error";
      statement = std::make_unique<SQLite::Statement>(
          *db, "SELECT " + value + ", " + error +
                   " FROM job j LEFT JOIN metric m ON m.job_id = j.id AND m.name = ?2 "
                   "WHERE j.key = ?1 AND j.status = 'done'");
    }
    return *statement;
  }

  std::unique_ptr<SQLite::Database> db;
  SQLite::Statement decided{*db,
                            "SELECT j.status, coalesce(j.outcome, ''), coalesce(m.value, 0.0) FROM job j "
                            "LEFT JOIN metric m ON m.job_id = j.id AND m.name = 'decision_margin' "
                            "WHERE j.key = ?1 AND j.status IN ('done', 'failed')"};
  SQLite::Statement flags{*db, "SELECT coalesce(flags, '') FROM jobs WHERE key = ?1 LIMIT 1"};
  std::map<std::string, std::unique_ptr<SQLite::Statement>> readers;
};

namespace {

/// Calls use(statement) if there is a row; the statement holds no read transaction afterwards.
template <class Use>
void first_row(SQLite::Statement& statement, Use use) try {
  struct Reset {
    SQLite::Statement& statement;
    ~Reset() { statement.tryReset(); }
  } reset{statement};
  if (statement.executeStep()) use(statement);
} catch (const SQLite::Exception& error) {
  throw CatalogError(std::string("reading the catalog: ") + error.what());
}

}  // namespace

CatalogAnswers::CatalogAnswers(const std::filesystem::path& results) {
  if (has_catalog(results)) impl_ = std::make_unique<Impl>(results);
}
CatalogAnswers::~CatalogAnswers() = default;

std::optional<Answer> CatalogAnswers::of(const std::string& key) const {
  std::optional<Answer> answer;
  if (!impl_) return answer;
  impl_->decided.bind(1, key);
  first_row(impl_->decided, [&](SQLite::Statement& row) {
    if (row.getColumn(0).getString() == "done")
      answer = Answer{true, row.getColumn(1).getString(), row.getColumn(2).getDouble()};
    else
      answer.emplace();
  });
  return answer;
}

std::optional<Reading> CatalogAnswers::reading(const std::string& key, const std::string& quantity) const {
  std::optional<Reading> reading;
  if (!impl_) return reading;
  SQLite::Statement& statement = impl_->reader(quantity);
  statement.bind(1, key);
  statement.bind(2, quantity);
  first_row(statement, [&](SQLite::Statement& row) {
    if (row.isColumnNull(0) || !std::isfinite(row.getColumn(0).getDouble())) return;
    const double error = row.isColumnNull(1) ? 0 : row.getColumn(1).getDouble();
    reading = Reading{row.getColumn(0).getDouble(), std::isfinite(error) ? std::abs(error) : 0};
  });
  return reading;
}

std::string CatalogAnswers::flags(const std::string& key) const {
  std::string flags;
  if (!impl_) return flags;
  impl_->flags.bind(1, key);
  first_row(impl_->flags, [&](SQLite::Statement& row) { flags = row.getColumn(0).getString(); });
  return flags;
}

}  // namespace mpmstudy
