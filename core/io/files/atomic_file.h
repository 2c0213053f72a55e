// SPDX-License-Identifier: GPL-3.0-or-later
// Output files appear complete or not at all.
#pragma once

#include <filesystem>
#include <string_view>

#include "core/base/error.h"
#include "core/io/files/file_fingerprint.h"
#include "core/io/files/temporary.h"

namespace mes {

/// Writes beside the target, calls fsync, and renames over the target. On any failure the old file, if any, is
/// untouched and no partial file remains. Error: `cannot_write`, with the file and the reason.
///
/// A symbolic link stays, and its target file is replaced; a file keeps its permissions; a target that is not a regular
/// file (a device, a pipe) is written directly.
Expected<void> write_file_atomically(const std::filesystem::path& path, std::string_view bytes);

enum class Replaced : std::uint8_t { done, changed };

/// Whether the file has the expected content; links are followed. Also true if the file no longer exists: writing it
/// again loses nothing.
bool is_as_expected(const std::filesystem::path& path, const FileFingerprint& expected);

/// Like `write_file_atomically`, but does not replace a file with unexpected content. Checks before anything is
/// written, and again when everything is on disk and only the rename remains.
Expected<Replaced> replace_file(const std::filesystem::path& path, std::string_view bytes,
                                const FileFingerprint& expected);

/// Predicts whether the functions above will succeed, so that a caller can refuse before long work. Creates a file
/// beside the target and removes it.
Expected<void> check_writable(const std::filesystem::path& path);

/// A target that an outside program writes: the program writes a file beside it, which `finish` renames to the target.
class OutsideWriting {
 public:
  /// Error: as `check_writable`, or the target is not a regular file.
  static Expected<OutsideWriting> begin(const std::filesystem::path& path);
  /// The path that the program writes to; an empty file at first.
  const std::filesystem::path& part() const { return part_.path(); }
  Expected<void> finish();

 private:
  OutsideWriting(std::filesystem::path path, std::filesystem::path target, PartFile part)
      : path_(std::move(path)), target_(std::move(target)), part_(std::move(part)) {}

  std::filesystem::path path_;    // as requested
  std::filesystem::path target_;  // links followed
  PartFile part_;
};

}  // namespace mes
