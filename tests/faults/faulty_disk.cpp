// SPDX-License-Identifier: GPL-3.0-or-later
// The checked forms of the C library are inline functions of the same names.
#undef _FORTIFY_SOURCE

#include "tests/faults/faulty_disk.h"

#include <fcntl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstddef>
#include <mutex>

namespace {

using mes::test::DiskCall;

std::atomic<bool> is_failing{false};
std::atomic<bool> fails_on{false};
std::atomic<DiskCall> failing_kind{DiskCall::write};
std::atomic<int> calls_left{0};
std::atomic<int> failing_error{ENOSPC};

bool fails(DiskCall kind) {
  if (!is_failing || failing_kind != kind) return false;
  const int left = calls_left--;
  if (left > 0 || (left < 0 && !fails_on)) return false;
  errno = failing_error;
  return true;
}

/// -1 with errno when it is to fail and nothing fits any more; else how many bytes to write.
std::ptrdiff_t room_for(int file, std::size_t bytes) {
  constexpr int kLastOfTheTerminal = 2;
  if (file <= kLastOfTheTerminal) return static_cast<std::ptrdiff_t>(bytes);
  static thread_local bool was_short = false;
  if (was_short) {
    was_short = false;
    errno = failing_error;
    return -1;
  }
  if (!fails(DiskCall::write)) return static_cast<std::ptrdiff_t>(bytes);
  was_short = bytes > 1;
  return was_short ? static_cast<std::ptrdiff_t>(bytes / 2) : -1;
}

}  // namespace

extern "C" {

ssize_t write(int file, const void* bytes, size_t count) {
  const std::ptrdiff_t room = room_for(file, count);
  return room < 0 ? -1 : ::syscall(SYS_write, file, bytes, static_cast<size_t>(room));
}
ssize_t pwrite(int file, const void* bytes, size_t count, off_t offset) {
  const std::ptrdiff_t room = room_for(file, count);
  return room < 0 ? -1 : ::syscall(SYS_pwrite64, file, bytes, static_cast<size_t>(room), offset);
}
int fsync(int file) {
  return fails(DiskCall::sync) ? -1 : static_cast<int>(::syscall(SYS_fsync, file));
}
int fdatasync(int file) {
  return fails(DiskCall::sync) ? -1 : static_cast<int>(::syscall(SYS_fdatasync, file));
}
int rename(const char* from, const char* to) noexcept {
  return fails(DiskCall::rename) ? -1 : static_cast<int>(::syscall(SYS_rename, from, to));
}
int open(const char* path, int flags, ...) {
  va_list rest;
  va_start(rest, flags);
  const mode_t mode = (flags & O_CREAT) != 0 ? va_arg(rest, mode_t) : 0;
  va_end(rest);
  if ((flags & O_CREAT) != 0 && fails(DiskCall::open)) return -1;
  return static_cast<int>(::syscall(SYS_openat, AT_FDCWD, path, flags, mode));
}

}  // extern "C"

namespace mes::test {

FailingDisk::FailingDisk(DiskCall kind, int call, bool and_later, int error) {
  failing_error = error;
  failing_kind = kind;
  calls_left = call;
  fails_on = and_later;
  is_failing = true;
}
FailingDisk::~FailingDisk() {
  is_failing = false;
}
bool FailingDisk::has_failed() const {
  return calls_left < 0;
}

}  // namespace mes::test
