#pragma once
#include <stdexcept>
#include <string>

namespace mpmstudy {

/// The catalog or a file next to it cannot be used. what() names the path, what is wrong and what to do.
/// Verbs end with exit code 2.
class CatalogError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A process was killed, or the disk failed, while the catalog was made: the next one that writes finishes
/// it.
class UnfinishedCatalog : public CatalogError {
 public:
  using CatalogError::CatalogError;
};

}  // namespace mpmstudy
