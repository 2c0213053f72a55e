// SPDX-License-Identifier: GPL-3.0-or-later
// Files and folders that exist while something is being made.
//
// What it guarantees:
//  1. Each has a new name that cannot be guessed, and is made without following a link.
//  2. Its owner removes it in the destructor, or, when a signal ends the process, by `remove_own_temporaries`.
//  3. What a killed process left is removed by a later one, which tells it by a lock: the owner holds it for as long
//     as it lives. Nothing is removed that is locked, that belongs to another user, that is a link or that has
//     another name; where the file system has no locks, nothing is removed.
//
// Threads: any.
#pragma once

#include <chrono>
#include <expected>
#include <filesystem>

#include "core/base/error.h"

namespace mes {

/// The folder that the file lies in; "." for a mere name.
inline std::filesystem::path folder_with(const std::filesystem::path& file) {
  return file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
}

/// A file beside the one it will become. The first one in a folder removes what killed processes left there.
class PartFile {
 public:
  /// Error: errno.
  static std::expected<PartFile, int> create_beside(const std::filesystem::path& target);
  ~PartFile();
  PartFile(PartFile&& other) noexcept;
  PartFile& operator=(PartFile&&) = delete;

  int descriptor() const { return descriptor_; }
  const std::filesystem::path& path() const { return path_; }
  /// Everything is on the disk. 0 or errno.
  int sync();
  /// 0 or errno. Afterwards there is nothing left to remove.
  int rename_to(const std::filesystem::path& target);

 private:
  PartFile(int descriptor, std::filesystem::path path) : descriptor_(descriptor), path_(std::move(path)) {}

  int descriptor_;
  std::filesystem::path path_;  // empty: it has become the target
};

/// A folder for files that only this process needs, `mesecina-film-...` in the folder for temporary files.
class ScratchFolder {
 public:
  /// Also removes those that killed processes left.
  static Expected<ScratchFolder> make();
  ~ScratchFolder();
  ScratchFolder(ScratchFolder&& other) noexcept;
  ScratchFolder& operator=(ScratchFolder&&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  ScratchFolder(int owner, std::filesystem::path path) : owner_(owner), path_(std::move(path)) {}

  int owner_;  // the locked file in it
  std::filesystem::path path_;
};

/// Removes `.mesecina-....part` files that killed processes left in the folder.
void remove_abandoned_parts(const std::filesystem::path& folder);
/// Removes scratch folders that killed processes left.
void remove_abandoned_scratch();

/// For a process that ends without destructors: removes what it owns, as far as the time allows, and lets nothing new
/// be made, nor become a target.
void remove_own_temporaries(std::chrono::steady_clock::time_point until);

}  // namespace mes
