// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/files/file_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <thread>

namespace mes {

LockTry try_lock(int descriptor) {
  for (;;) {
    if (::flock(descriptor, LOCK_EX | LOCK_NB) == 0) return LockTry::locked;
    if (errno == EWOULDBLOCK) return LockTry::taken;
    if (errno != EINTR) return LockTry::impossible;
  }
}

bool is_named(const std::filesystem::path& path, int descriptor) {
  struct stat open {};
  struct stat named {};
  return ::fstat(descriptor, &open) == 0 && ::lstat(path.c_str(), &named) == 0 && S_ISREG(named.st_mode) &&
         open.st_dev == named.st_dev && open.st_ino == named.st_ino;
}

std::expected<LockedFile, int> create_locked(const std::filesystem::path& path, mode_t mode) {
  const int descriptor = ::open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, mode);
  if (descriptor < 0) return std::unexpected(errno);
  const LockTry lock = try_lock(descriptor);
  // Another process may have found the file unlocked and removed it.
  const bool is_ours = lock != LockTry::taken && is_named(path, descriptor);
  if (is_ours) return LockedFile{descriptor, lock == LockTry::locked};
  if (lock == LockTry::taken && is_named(path, descriptor)) ::unlink(path.c_str());
  ::close(descriptor);
  return std::unexpected(EEXIST);
}

// The blocking lock call of the system takes no timeout.
UpdateLock::UpdateLock(const std::filesystem::path& path, std::chrono::milliseconds patience)
    : descriptor_(::open((path.string() + ".lock").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600)) {
  constexpr std::chrono::milliseconds kPause{2};
  if (descriptor_ < 0) return;
  const auto end = std::chrono::steady_clock::now() + patience;
  LockTry tried = try_lock(descriptor_);
  for (; tried == LockTry::taken && std::chrono::steady_clock::now() < end; tried = try_lock(descriptor_))
    std::this_thread::sleep_for(kPause);
  is_held_ = tried == LockTry::locked;
}

UpdateLock::~UpdateLock() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

}  // namespace mes
