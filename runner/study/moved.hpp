#pragma once
/// Studies that were sorted into folders since somebody wrote down where they are.
#include <filesystem>
#include <string>
#include <vector>

namespace mpmstudy {

/// Files that bear the name of `path` in the folders directly below the one that it names, in the order of
/// their names; of "*.toml", which a shell hands on where it finds no file, those folders that have some:
/// "studies/examples/*.toml". Folders that cannot be read have none.
std::vector<std::filesystem::path> same_name_below(const std::filesystem::path& path);

}  // namespace mpmstudy
