#pragma once
/// What a run holds between two steps, in a file from which it goes on with the same bits.
///
///   /numbers/NAME, /integers/NAME    64-bit columns, named as Archive names them; compressed without loss
///   attribute `format`               raised when older files can no longer be read
///
/// A checkpoint belongs to the program that wrote it: names and columns are those of its classes.
#include <filesystem>

#include "libmpm/core/archive.hpp"

namespace mpm {

/// Replaces the file, or leaves it as it was: a file that has its name is whole. Throws std::runtime_error
/// naming path and cause. Any thread may call.
void write_checkpoint(const std::filesystem::path&, const Record&);

/// Throws std::runtime_error naming path and cause.
Record read_checkpoint(const std::filesystem::path&);

}  // namespace mpm
