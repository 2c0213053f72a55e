// SPDX-License-Identifier: GPL-3.0-or-later
// A file that something else has written to since it was opened or saved here.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "core/base/named_list.h"
#include "core/document/document.h"
#include "core/io/file_fingerprint.h"
#include "core/io/session.h"

namespace mes {

struct Format;

/// What a document or a file holds, in counts.
struct Holdings {
  std::size_t samples = 0;
  std::size_t balls = 0;
  std::optional<std::size_t> edits{};  ///< of a session
  friend bool operator==(const Holdings&, const Holdings&) = default;
};

struct FileConflict {
  std::filesystem::path file;
  Holdings mine{};
  std::optional<Holdings> theirs{};           ///< of the file now; nothing if it cannot be read
  std::string problem{};                      ///< why not
  std::optional<std::size_t> shared_edits{};  ///< first edits that two sessions of the same data have in common
  std::optional<FileFingerprint> found{};     ///< what all this is about
};

/// Reads the file, of one of the formats. `mine` is null for a document that is not saved as a session.
FileConflict look_into(const std::filesystem::path& file, const Document& document, const Session* mine,
                       const NamedList<Format>& formats);

}  // namespace mes
