// SPDX-License-Identifier: GPL-3.0-or-later
// Files that are locked for as long as the process that made them lives.
//
// What it guarantees: a file made by `create_locked` is never seen unlocked by a process that follows the protocol
// below, although creating and locking are two calls.
//
// The protocol: to judge a file that may have been abandoned, open it, lock it with `try_lock`, and then make sure
// with `is_named` that the name still stands for what was locked. Only then may it be removed.
//
// Files that several processes read, change and write whole have another kind of lock, `UpdateLock`.
//
// Threads: any. A lock belongs to the open file and goes when its last descriptor is closed, also by a crash.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <expected>
#include <filesystem>

namespace mes {

enum class LockTry : std::uint8_t {
  locked,
  taken,       ///< another process holds it
  impossible,  ///< this file system has no locks
};

/// Does not wait.
LockTry try_lock(int descriptor);

/// Whether the path is this very regular file, not a link to it and not another file of the same name.
bool is_named(const std::filesystem::path& path, int descriptor);

struct LockedFile {
  int descriptor = -1;
  bool is_locked = false;  ///< false: the file system has no locks
};

/// A new file, open for reading and writing; links are not followed. Error: errno. EEXIST also if the name was taken
/// away before the lock was there: the caller tries another one.
std::expected<LockedFile, int> create_locked(const std::filesystem::path& path, mode_t mode);

/// Held from reading a file that several processes change until it is written again: without it, of two that read the
/// same state the later one would undo what the earlier one wrote. It is a file of its own beside the other, which is
/// replaced by each writing; it stays there, empty.
///
/// Smallest use:
///     const UpdateLock lock(path);
///     write(path, changed(read(path)));
class UpdateLock {
 public:
  /// Far longer than reading and writing a small file takes, with a dozen others before it.
  static constexpr std::chrono::milliseconds kPatience{3000};

  /// Waits for those that have it, but no longer than `patience`: one may have been stopped while it had it. What such a
  /// one still writes is to be noticed in another way where that matters (`replace_file`).
  explicit UpdateLock(const std::filesystem::path& path, std::chrono::milliseconds patience = kPatience);
  ~UpdateLock();
  UpdateLock(const UpdateLock&) = delete;
  UpdateLock& operator=(const UpdateLock&) = delete;

  bool is_held() const { return is_held_; }

 private:
  int descriptor_;
  bool is_held_ = false;
};

}  // namespace mes
