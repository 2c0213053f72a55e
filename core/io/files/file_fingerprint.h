// SPDX-License-Identifier: GPL-3.0-or-later
// Detects whether the content of a file has changed.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string_view>

namespace mes {

/// Size and hash of the bytes. Times do not count: touching a file does not change it, and a file that is written twice
/// within a clock tick has changed.
struct FileFingerprint {
  std::uint64_t size = 0;
  std::uint64_t hash = 0;
  friend bool operator==(const FileFingerprint&, const FileFingerprint&) = default;
};

/// Two texts of equal size that differ in a single word of eight bytes never have the same fingerprint; other texts
/// collide with probability 2^-64.
FileFingerprint fingerprint_of(std::string_view bytes);

/// Fingerprint of the current content of a regular file, links followed; nothing if there is no readable one.
std::optional<FileFingerprint> fingerprint_of_file(const std::filesystem::path& path);

/// A file that was read, and its content then.
struct SourceFile {
  std::filesystem::path path;
  FileFingerprint fingerprint{};
};

}  // namespace mes
