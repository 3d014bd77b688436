/* A disk that fails, for LD_PRELOAD: from the FAULT_AT-th change of a regular file on (write, sync, truncate,
 * rename), every one fails with FAULT_ERRNO; with FAULT_ONCE set, that one only. FAULT_MARK is made when the
 * first one does. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <sys/stat.h>
#include <sys/types.h>
#include <sys/uio.h>
#include <unistd.h>

static atomic_long changes;

static int number(const char* name) {
  const char* text = getenv(name);
  return text ? atoi(text) : 0;
}

/* Is this change one that fails? */
static int fails(void) {
  const int at = number("FAULT_AT");
  if (at <= 0) return 0;
  const long n = atomic_fetch_add(&changes, 1) + 1;
  if (n < at || (n > at && getenv("FAULT_ONCE"))) return 0;
  const char* mark = getenv("FAULT_MARK");
  if (n == at && mark) {
    const int file = open(mark, O_CREAT | O_WRONLY, 0644);
    if (file >= 0) close(file);
  }
  errno = number("FAULT_ERRNO");
  return 1;
}

static int is_file(int fd) {
  struct stat s;
  return fd > 2 && fstat(fd, &s) == 0 && S_ISREG(s.st_mode);
}

#define NEXT(type, name, ...)       \
  static type (*next)(__VA_ARGS__); \
  if (!next) next = (type(*)(__VA_ARGS__))dlsym(RTLD_NEXT, name)

ssize_t write(int fd, const void* data, size_t size) {
  NEXT(ssize_t, "write", int, const void*, size_t);
  return is_file(fd) && fails() ? -1 : next(fd, data, size);
}
ssize_t writev(int fd, const struct iovec* data, int count) {
  NEXT(ssize_t, "writev", int, const struct iovec*, int);
  return is_file(fd) && fails() ? -1 : next(fd, data, count);
}
ssize_t pwrite(int fd, const void* data, size_t size, off_t at) {
  NEXT(ssize_t, "pwrite", int, const void*, size_t, off_t);
  return is_file(fd) && fails() ? -1 : next(fd, data, size, at);
}
ssize_t pwrite64(int fd, const void* data, size_t size, off64_t at) {
  NEXT(ssize_t, "pwrite64", int, const void*, size_t, off64_t);
  return is_file(fd) && fails() ? -1 : next(fd, data, size, at);
}
int fsync(int fd) {
  NEXT(int, "fsync", int);
  return fd > 2 && fails() ? -1 : next(fd);
}
int fdatasync(int fd) {
  NEXT(int, "fdatasync", int);
  return fd > 2 && fails() ? -1 : next(fd);
}
int ftruncate(int fd, off_t size) {
  NEXT(int, "ftruncate", int, off_t);
  return is_file(fd) && fails() ? -1 : next(fd, size);
}
int ftruncate64(int fd, off64_t size) {
  NEXT(int, "ftruncate64", int, off64_t);
  return is_file(fd) && fails() ? -1 : next(fd, size);
}
int rename(const char* from, const char* to) {
  NEXT(int, "rename", const char*, const char*);
  return fails() ? -1 : next(from, to);
}
int mkdir(const char* path, mode_t mode) {
  NEXT(int, "mkdir", const char*, mode_t);
  return fails() ? -1 : next(path, mode);
}
