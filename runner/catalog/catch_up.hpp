#pragma once
#include <cstdint>

namespace SQLite {
class Database;
}

namespace mpmstudy {

/// What a migration cannot say in SQL: values of older rows that are worked out with the table of parameters.
/// `version`: that the catalog had before; all columns of the present one are there. Throws
/// SQLite::Exception.
void catch_up(SQLite::Database&, std::int32_t version);

}  // namespace mpmstudy
