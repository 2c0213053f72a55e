// SPDX-License-Identifier: GPL-3.0-or-later
// Tells whether a file still holds what it held.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string_view>

namespace mes {

/// Size and hash of the bytes. Times do not count: a file that was only touched has not changed, and one that was
/// written twice within a tick of the clock has.
struct FileFingerprint {
  std::uint64_t size = 0;
  std::uint64_t hash = 0;
  friend bool operator==(const FileFingerprint&, const FileFingerprint&) = default;
};

/// Two texts of equal size that differ in a single word of eight bytes never have the same fingerprint; others do by
/// a chance of 2^-64.
FileFingerprint fingerprint_of(std::string_view bytes);

/// Of a regular file, links followed, as it is now; nothing if there is none that can be read.
std::optional<FileFingerprint> fingerprint_of_file(const std::filesystem::path& path);

/// A file that was read, and what it held then.
struct SourceFile {
  std::filesystem::path path;
  FileFingerprint fingerprint{};
};

}  // namespace mes
