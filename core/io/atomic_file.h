// SPDX-License-Identifier: GPL-3.0-or-later
// Output files appear complete or not at all.
#pragma once

#include <filesystem>
#include <string_view>

#include "core/base/error.h"
#include "core/io/file_fingerprint.h"
#include "core/io/temporary.h"

namespace mes {

/// Writes beside the target, fsyncs, renames over it. On any failure the old file, if any, is untouched and nothing
/// is left behind. Error: `cannot_write`, naming the file and the reason.
///
/// A symbolic link stays, and the file it names is replaced; a file keeps its permissions; a target that is not a
/// regular file (a device, a pipe) is written to directly.
Expected<void> write_file_atomically(const std::filesystem::path& path, std::string_view bytes);

enum class Replaced : std::uint8_t { done, changed };

/// Whether the file holds what is expected, links followed. True as well when the file no longer exists: writing it
/// anew loses nothing.
bool is_as_expected(const std::filesystem::path& path, const FileFingerprint& expected);

/// The same as `write_file_atomically`, but leaves a file that is not as expected alone. Checks before anything is
/// written, and again when everything is on the disk and only the renaming is left.
Expected<Replaced> replace_file(const std::filesystem::path& path, std::string_view bytes,
                                const FileFingerprint& expected);

/// Whether the above can be expected to succeed, to refuse before long work rather than after it. Creates a file
/// beside the target and removes it.
Expected<void> check_writable(const std::filesystem::path& path);

/// A target that another program is to write: it makes the file beside, and `finish` puts it in its place.
class OutsideWriting {
 public:
  /// Error: as `check_writable`, and for a target that is not a regular file.
  static Expected<OutsideWriting> begin(const std::filesystem::path& path);
  /// Empty, and to be written to under this name.
  const std::filesystem::path& part() const { return part_.path(); }
  Expected<void> finish();

 private:
  OutsideWriting(std::filesystem::path path, std::filesystem::path target, PartFile part)
      : path_(std::move(path)), target_(std::move(target)), part_(std::move(part)) {}

  std::filesystem::path path_;    // as it was asked for
  std::filesystem::path target_;  // links followed
  PartFile part_;
};

}  // namespace mes
