#pragma once
/// Opening a catalog. Include SQLiteCpp where you use what these return.
#include <filesystem>
#include <memory>

#include "runner/catalog/schema.hpp"

namespace SQLite {
class Database;
}

namespace mpmstudy {

/// results/catalog.db
std::filesystem::path catalog_path(const std::filesystem::path& results);

/// Is there a catalog that can be asked? A file without tables is none: another process makes it just now, or
/// was killed while it did. Throws CatalogError where open_for_reading does for another reason.
bool has_catalog(const std::filesystem::path& results);

/// Opens the catalog for its one writer; makes folder and file where there are none (their modes are left to
/// the umask), and brings an older layout to `schema` (a copy of the old file stays beside it as
/// catalog.db.vN.backup). On a network file system it has a rollback journal, elsewhere a log (WAL). A file
/// that is not a catalog, or that a newer version has written, is left as it is. Throws CatalogError, also
/// where the file system gives no locks.
std::unique_ptr<SQLite::Database> open_for_writing(const std::filesystem::path& results,
                                                   const CatalogSchema& schema = current_catalog_schema());

/// Opens the catalog read-only; on a local disk it never waits for a writer and never delays one. Where the
/// file system gives no locks it is read without. Throws CatalogError, also when there is no catalog.
std::unique_ptr<SQLite::Database> open_for_reading(const std::filesystem::path& results);

}  // namespace mpmstudy
