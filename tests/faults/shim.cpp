// SPDX-License-Identifier: MIT
/// \file
/// A library to preload, which makes calls to the system fail as the environment says. Linux with glibc.
///
///     UMBILIC_FAULT="CALL POSITION ACTION"
///
/// CALL is write, fsync, close (of a file with something written), renameat, openat or fchmod. POSITION is the one of
/// the calls that is hit, from 1; for `write`, the number of bytes that are written before. ACTION is "fail", once, or
/// "kill". Only files that the program opens for writing count. UMBILIC_CLOCK=realtime|monotonic lets that clock jump
/// by a year to and fro with each look.
#include <dlfcn.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <sys/time.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>

namespace {

struct Fault {
  char call[16] = "";
  long position = 0;
  char action[8] = "";

  Fault() {
    const char* text = std::getenv("UMBILIC_FAULT");
    if (text && std::sscanf(text, "%15s %ld %7s", call, &position, action) != 3) call[0] = '\0';
  }
  bool hits(const char* name) const { return std::strcmp(call, name) == 0; }
};

Fault& fault() {
  static Fault the_fault;
  return the_fault;
}

/// Kills the program, or leaves the reason of a failure that happens once.
void happen(int error) {
  if (std::strcmp(fault().action, "kill") == 0) raise(SIGKILL);
  fault().call[0] = '\0';
  errno = error;
}

/// Counts a call; whether it is the one to be hit.
bool counted(const char* name) { return fault().hits(name) && --fault().position == 0; }

constexpr int kMostFiles = 1024;

enum class Use : char { kNone, kOpen, kWritten };
Use uses[kMostFiles];  // by descriptor

bool has(int file, Use least) { return file >= 0 && file < kMostFiles && uses[file] >= least; }

template <class Function>
Function* next(Function*, const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

bool clock_jumps(const char* name) {
  const char* which = std::getenv("UMBILIC_CLOCK");
  return which && std::strcmp(which, name) == 0;
}

long jump() {
  static long looks = 0;
  constexpr long kYear = 365 * 86400L;
  return ++looks % 2 ? kYear : -kYear;
}

}  // namespace

#pragma GCC visibility push(default)
extern "C" {

int openat(int folder, const char* path, int flags, ...) {
  std::va_list arguments;
  va_start(arguments, flags);
  const mode_t mode = flags & O_CREAT ? va_arg(arguments, mode_t) : 0;
  va_end(arguments);
  if (flags & O_CREAT && counted("openat")) return happen(EIO), -1;
  const int file = next(&openat, "openat")(folder, path, flags, mode);
  if (file >= 0 && file < kMostFiles) uses[file] = (flags & O_ACCMODE) != O_RDONLY ? Use::kOpen : Use::kNone;
  return file;
}

ssize_t write(int file, const void* bytes, std::size_t size) {
  const auto original = next(&write, "write");
  if (has(file, Use::kOpen)) uses[file] = Use::kWritten;
  if (!has(file, Use::kOpen) || !fault().hits("write")) return original(file, bytes, size);
  if (fault().position == 0) return happen(ENOSPC), -1;
  const auto fits = static_cast<std::size_t>(fault().position);
  const ssize_t count = original(file, bytes, size < fits ? size : fits);
  if (count > 0) fault().position -= count;
  return count;
}

int fsync(int file) {
  if (has(file, Use::kOpen) && counted("fsync")) return happen(EIO), -1;
  return next(&fsync, "fsync")(file);
}

int fchmod(int file, mode_t mode) {
  if (has(file, Use::kOpen) && counted("fchmod")) return happen(EIO), -1;
  return next(&fchmod, "fchmod")(file, mode);
}

/// Linux closes the file even if it tells of an error.
int close(int file) {
  const bool fails = has(file, Use::kWritten) && counted("close");
  if (fails && std::strcmp(fault().action, "kill") == 0) happen(EIO);
  if (file >= 0 && file < kMostFiles) uses[file] = Use::kNone;
  const int closed = next(&close, "close")(file);
  if (!fails) return closed;
  return happen(EIO), -1;
}

int renameat(int from_folder, const char* from, int to_folder, const char* to) {
  if (counted("renameat")) return happen(EIO), -1;
  return next(&renameat, "renameat")(from_folder, from, to_folder, to);
}

int clock_gettime(clockid_t clock, timespec* time) {
  const int status = next(&clock_gettime, "clock_gettime")(clock, time);
  if (clock == CLOCK_REALTIME && clock_jumps("realtime")) time->tv_sec += jump();
  if (clock == CLOCK_MONOTONIC && clock_jumps("monotonic")) time->tv_sec += jump();
  return status;
}

int gettimeofday(timeval* time, void* zone) noexcept {
  timespec now;
  const int status = clock_gettime(CLOCK_REALTIME, &now);
  *time = {now.tv_sec, now.tv_nsec / 1000};
  (void)zone;
  return status;
}

time_t time(time_t* out) noexcept {
  timespec now;
  clock_gettime(CLOCK_REALTIME, &now);
  if (out) *out = now.tv_sec;
  return now.tv_sec;
}
}
