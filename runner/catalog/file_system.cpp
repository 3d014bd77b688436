#include "runner/catalog/file_system.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <grp.h>
#include <pwd.h>
#include <sqlite3.h>
#include <sys/stat.h>
#include <sys/vfs.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <mutex>
#include <system_error>

namespace mpmstudy {
namespace {

namespace fs = std::filesystem;

struct Known {
  unsigned long magic;
  const char* name;
  bool shared;
};

/// Magic numbers of statfs(2). FUSE and 9P are mostly another machine's files (sshfs, gluster, a host's).
constexpr Known known[] = {
    {0xEF53, "ext4", false},        {0x58465342, "XFS", false},     {0x9123683E, "Btrfs", false},
    {0x01021994, "tmpfs", false},   {0x794C7630, "overlay", false}, {0x2FC12FC1, "ZFS", false},
    {0x6969, "NFS", true},          {0x0BD00BD0, "Lustre", true},   {0x47504653, "GPFS", true},
    {0x19830326, "BeeGFS", true},   {0x00C36400, "Ceph", true},     {0xAAD7AAEA, "PanFS", true},
    {0xFF534D42, "CIFS", true},     {0xFE534D42, "SMB", true},      {0x517B, "SMB", true},
    {0x5346414F, "AFS", true},      {0x6B414653, "AFS", true},      {0x73757245, "Coda", true},
    {0x20030528, "OrangeFS", true}, {0x01161970, "GFS2", true},     {0x7461636F, "OCFS2", true},
    {0x65735546, "FUSE", true},     {0x01021997, "9P", true},       {0x786F4256, "vboxsf", true},
    {0xBACBACBC, "vmhgfs", true}};

fs::path nearest_existing(fs::path path) {
  std::error_code ignored;
  path = fs::absolute(path, ignored);
  while (!fs::exists(path, ignored) && path.has_parent_path() && path != path.parent_path())
    path = path.parent_path();
  return path;
}

std::string user(uid_t id) {
  const passwd* entry = getpwuid(id);
  return fmt::format("{} ({})", entry != nullptr ? entry->pw_name : "unknown", id);
}
std::string group(gid_t id) {
  const struct group* entry = getgrgid(id);
  return fmt::format("{} ({})", entry != nullptr ? entry->gr_name : "unknown", id);
}

std::string owner_of(const fs::path& path) {
  struct stat s {};
  if (stat(path.c_str(), &s) != 0) return std::generic_category().message(errno);
  return fmt::format("owner {}, group {}, mode {:04o}", user(s.st_uid), group(s.st_gid), s.st_mode & 07777u);
}

std::atomic<int> lock_error{0};

/// SQLite takes ENOLCK for a lock that somebody has and waits for it. A file system that gives none says so
/// for ever: another number makes SQLite end with an error at once.
int watched_fcntl(int file, int command, ...) {
  va_list rest;
  va_start(rest, command);
  void* argument = va_arg(rest, void*);
  va_end(rest);
  const int result = fcntl(file, command, argument);
  if (result == -1 && command == F_SETLK && errno != EAGAIN && errno != EACCES && errno != EINTR) {
    lock_error = errno;
    if (errno == ENOLCK) errno = ENOTSUP;
  }
  return result;
}

}  // namespace

FileSystem file_system_with(long magic) {
  const unsigned long number = static_cast<unsigned long>(magic) & 0xFFFFFFFFUL;  // a signed int on some
  for (const Known& one : known)
    if (one.magic == number) return {one.name, one.shared, !one.shared};
  return {fmt::format("type {:#x}", number), false, false};
}

FileSystem file_system_of(const fs::path& path) {
  struct statfs about {};
  if (statfs(nearest_existing(path).c_str(), &about) != 0) return {"unknown", false, false};
  return file_system_with(static_cast<long>(about.f_type));
}

std::string share_note(const fs::path& results) {
  const FileSystem system = file_system_of(results);
  if (!system.shared) return {};
  return fmt::format(
      "{}: on a network file system ({}): the catalog is kept with a rollback journal, so that readers and "
      "runs wait for each other; a local folder (--results) is faster and safer",
      results.string(), system.name);
}

std::string refused_lock() {
  const int error = lock_error;
  if (error == 0) return {};
  constexpr int not_supported_by_kernel = 524;  // ENOTSUPP, which user space has no name for
  return error == not_supported_by_kernel ? "Operation not supported by the file system (524)"
                                          : std::generic_category().message(error);
}

void watch_locks() {
  static std::once_flag once;
  std::call_once(once, [] {
    sqlite3_vfs* vfs = sqlite3_vfs_find(nullptr);
    if (vfs == nullptr || vfs->iVersion < 3 || vfs->xSetSystemCall == nullptr) return;
    vfs->xSetSystemCall(vfs, "fcntl", reinterpret_cast<sqlite3_syscall_ptr>(watched_fcntl));
  });
}

std::string who_may(const fs::path& path) {
  const fs::path here = nearest_existing(path);
  std::error_code ignored;
  std::string text = fmt::format(" ({}: {}", here.string(), owner_of(here));
  if (!fs::is_directory(here, ignored)) text += fmt::format("; its folder: {}", owner_of(here.parent_path()));
  return text + fmt::format("; this process: {}, group {})", user(geteuid()), group(getegid()));
}

std::string who_may_if_denied(const fs::path& path) {
  const fs::path here = nearest_existing(path);
  std::error_code ignored;
  const bool folder = fs::is_directory(here, ignored);
  const bool may = eaccess(here.c_str(), folder ? R_OK | W_OK | X_OK : R_OK | W_OK) == 0 &&
                   (folder || eaccess(here.parent_path().c_str(), W_OK | X_OK) == 0);
  return may ? "" : who_may(path);
}

void make_by_umask(const fs::path& path) {
  // A file that is there is not opened: closing it would drop the locks that SQLite has on it in this
  // process.
  const int file = open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  if (file >= 0) close(file);  // where it cannot be made, opening it says why
}

}  // namespace mpmstudy
