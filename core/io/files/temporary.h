// SPDX-License-Identifier: GPL-3.0-or-later
// Temporary files and folders for unfinished output.
//
// Guarantees:
//  1. Each has a new name that cannot be guessed, and is made without following a link.
//  2. Its owner removes it in the destructor, or, when a signal ends the process, by `remove_own_temporaries`.
//  3. A later process removes the remains of a killed one. It recognises them by a lock, which the owner holds while it
//     lives. Files that are locked, belong to another user, are links or have another name are never removed; if the
//     file system has no locks, nothing is removed.
//
// Threads: any.
#pragma once

#include <chrono>
#include <expected>
#include <filesystem>

#include "core/base/error.h"

namespace mes {

/// The folder of the file; "." for a mere name.
inline std::filesystem::path folder_with(const std::filesystem::path& file) {
  return file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
}

/// A file beside its future name. The first one in a folder removes the remains of killed processes there.
class PartFile {
 public:
  /// Error: errno.
  static std::expected<PartFile, int> create_beside(const std::filesystem::path& target);
  ~PartFile();
  PartFile(PartFile&& other) noexcept;
  PartFile& operator=(PartFile&&) = delete;

  int descriptor() const { return descriptor_; }
  const std::filesystem::path& path() const { return path_; }
  /// Writes everything to the disk. Returns 0 or errno.
  int sync();
  /// Returns 0 or errno. After it nothing remains to be removed.
  int rename_to(const std::filesystem::path& target);

 private:
  PartFile(int descriptor, std::filesystem::path path) : descriptor_(descriptor), path_(std::move(path)) {}

  int descriptor_;
  std::filesystem::path path_;  // empty: already renamed to the target
};

/// A private folder of this process, `mesecina-film-...` in the folder for temporary files.
class ScratchFolder {
 public:
  /// Also removes the remains of killed processes.
  static Expected<ScratchFolder> make();
  ~ScratchFolder();
  ScratchFolder(ScratchFolder&& other) noexcept;
  ScratchFolder& operator=(ScratchFolder&&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  ScratchFolder(int owner, std::filesystem::path path) : owner_(owner), path_(std::move(path)) {}

  int owner_;  // descriptor of the locked file in it
  std::filesystem::path path_;
};

/// Removes `.mesecina-....part` files of killed processes from the folder.
void remove_abandoned_parts(const std::filesystem::path& folder);
/// Removes scratch folders of killed processes.
void remove_abandoned_scratch();

/// For a process that ends without destructors: removes its files, as far as the time allows, and blocks the creation
/// of new ones and their renaming to a target.
void remove_own_temporaries(std::chrono::steady_clock::time_point until);

}  // namespace mes
