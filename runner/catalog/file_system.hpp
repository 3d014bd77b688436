#pragma once
/// What a file system can do for a catalog, and who may use a file.
#include <filesystem>
#include <string>

namespace mpmstudy {

/// Of which kind the file system of a path (or of its nearest folder that exists) is.
struct FileSystem {
  std::string name;     ///< "NFS", or "type 0x..." of one that is not known here
  bool shared = false;  ///< over a network: other machines may change its files
  bool local = false;   ///< known to be of this machine alone; one that is not known is neither
};
FileSystem file_system_of(const std::filesystem::path&);

/// The same by the magic number of statfs(2).
FileSystem file_system_with(long magic);

/// What a user of a catalog on a shared file system has to know, in one line; "" elsewhere.
std::string share_note(const std::filesystem::path& results);

/// Has a file lock been refused to SQLite in this process for another reason than that somebody has it? Then
/// the system's reason ("No locks available"), else "".
std::string refused_lock();

/// Has SQLite see at once that a file system gives no locks (ENOLCK), which it takes for a file that is
/// locked; see refused_lock(). Any number of times.
void watch_locks();

/// " (catalog.db: owner anna (1000), group lab (100), mode 0644; folder /results: ...; this process: ben
/// (1001), group lab (100))". Of a path that does not exist, its nearest folder that does.
std::string who_may(const std::filesystem::path&);

/// The same if the path can not be written or read by this process, else "".
std::string who_may_if_denied(const std::filesystem::path&);

/// Makes an empty file that the umask decides about, as any program does; SQLite alone would deny the group
/// what the umask allows. Nothing happens if there is one. Its log and journal get the same mode.
void make_by_umask(const std::filesystem::path&);

}  // namespace mpmstudy
