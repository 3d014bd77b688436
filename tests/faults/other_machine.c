/* Another machine, or another file system, for LD_PRELOAD:
 *   FAKE_HOST, FAKE_BOOT   name of the host; a file that stands for /proc/sys/kernel/random/boot_id
 *   FAKE_CLOCK             seconds that the clock of the day is ahead; with FAKE_CLOCK_STEPS it steps between that and
 *                          the same behind, every half second
 *   FAKE_FILE_SYSTEM       magic number that statfs gives
 *   FAKE_LOCK_ERRNO        record locks (fcntl) fail with this number
 *   FAKE_FLOCK_ERRNO       flock fails with this number */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/vfs.h>
#include <time.h>

#define NEXT(type, name, ...)       \
  static type (*next)(__VA_ARGS__); \
  if (!next) next = (type(*)(__VA_ARGS__))dlsym(RTLD_NEXT, name)

int gethostname(char* name, size_t size) {
  NEXT(int, "gethostname", char*, size_t);
  const char* fake = getenv("FAKE_HOST");
  if (!fake) return next(name, size);
  snprintf(name, size, "%s", fake);
  return 0;
}

static const char* instead_of(const char* path) {
  const char* fake = getenv("FAKE_BOOT");
  return fake && strcmp(path, "/proc/sys/kernel/random/boot_id") == 0 ? fake : path;
}
FILE* fopen(const char* path, const char* mode) {
  NEXT(FILE*, "fopen", const char*, const char*);
  return next(instead_of(path), mode);
}
FILE* fopen64(const char* path, const char* mode) {
  NEXT(FILE*, "fopen64", const char*, const char*);
  return next(instead_of(path), mode);
}

int clock_gettime(clockid_t clock, struct timespec* time) {
  NEXT(int, "clock_gettime", clockid_t, struct timespec*);
  const int result = next(clock, time);
  const char* ahead = getenv("FAKE_CLOCK");
  if (result != 0 || clock != CLOCK_REALTIME || !ahead) return result;
  struct timespec steady;
  next(CLOCK_MONOTONIC, &steady);
  const int back = getenv("FAKE_CLOCK_STEPS") && steady.tv_nsec < 500000000;
  time->tv_sec += back ? -atol(ahead) : atol(ahead);
  return 0;
}

int statfs(const char* path, struct statfs* about) {
  NEXT(int, "statfs", const char*, struct statfs*);
  const int result = next(path, about);
  const char* fake = getenv("FAKE_FILE_SYSTEM");
  if (result == 0 && fake) about->f_type = (__fsword_t)strtol(fake, NULL, 0);
  return result;
}

static int refused(int command) {
  const char* fake = getenv("FAKE_LOCK_ERRNO");
  if (!fake || (command != F_SETLK && command != F_SETLKW && command != F_OFD_SETLK && command != F_OFD_SETLKW))
    return 0;
  errno = atoi(fake);
  return 1;
}
int fcntl(int file, int command, ...) {
  NEXT(int, "fcntl", int, int, ...);
  va_list rest;
  va_start(rest, command);
  void* argument = va_arg(rest, void*);
  va_end(rest);
  return refused(command) ? -1 : next(file, command, argument);
}
int fcntl64(int file, int command, ...) {
  NEXT(int, "fcntl64", int, int, ...);
  va_list rest;
  va_start(rest, command);
  void* argument = va_arg(rest, void*);
  va_end(rest);
  return refused(command) ? -1 : next(file, command, argument);
}

int flock(int file, int operation) {
  NEXT(int, "flock", int, int);
  const char* fake = getenv("FAKE_FLOCK_ERRNO");
  if (!fake) return next(file, operation);
  errno = atoi(fake);
  return -1;
}
