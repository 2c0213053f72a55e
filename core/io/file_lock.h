// SPDX-License-Identifier: GPL-3.0-or-later
// Files that are locked for as long as the process that made them lives.
//
// What it guarantees: a file made by `create_locked` is never seen unlocked by a process that follows the protocol
// below, although creating and locking are two calls.
//
// The protocol: to judge a file that may have been abandoned, open it, lock it with `try_lock`, and then make sure
// with `is_named` that the name still stands for what was locked. Only then may it be removed.
//
// Threads: any. A lock belongs to the open file and goes when its last descriptor is closed, also by a crash.
#pragma once

#include <sys/types.h>

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

}  // namespace mes
