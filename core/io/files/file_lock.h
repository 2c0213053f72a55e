// SPDX-License-Identifier: GPL-3.0-or-later
// Files that stay locked while the process that made them lives.
//
// Guarantees: a process that follows the protocol below never sees a file of `create_locked` unlocked, although
// creating and locking are two system calls.
//
// The protocol: to judge whether a file was abandoned, open it, lock it with `try_lock`, then check with `is_named`
// that the name still stands for the locked file. Only then may it be removed.
//
// Files that several processes read, change and rewrite use another kind of lock, `UpdateLock`.
//
// Threads: any. A lock belongs to the open file and ends when its last descriptor is closed, also by a crash.
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

/// Tries to lock without waiting.
LockTry try_lock(int descriptor);

/// Whether the path names this very regular file, not a link to it or another file of the same name.
bool is_named(const std::filesystem::path& path, int descriptor);

struct LockedFile {
  int descriptor = -1;
  bool is_locked = false;  ///< false: the file system has no locks
};

/// Creates a file and opens it for reading and writing; links are not followed. Error: errno. EEXIST also if the name
/// was removed before the file was locked: the caller tries another name.
std::expected<LockedFile, int> create_locked(const std::filesystem::path& path, mode_t mode);

/// A lock for a file that several processes change, held from reading the file until it is rewritten: without it, of
/// two processes that read the same state, the later writer would undo the earlier one. The lock is a separate, empty
/// file beside the other one, because each rewrite replaces that one; the lock file stays.
///
/// Smallest use:
///     const UpdateLock lock(path);
///     write(path, changed(read(path)));
class UpdateLock {
 public:
  /// Far longer than a dozen processes in turn take to read and write a small file.
  static constexpr std::chrono::milliseconds kPatience{3000};

  /// Waits for other holders, but no longer than `patience`: a holder may be a stopped process. Where it matters,
  /// detect a late write of such a process in another way (`replace_file`).
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
