// SPDX-License-Identifier: GPL-3.0-or-later
// A file that another program has written to since it was opened or saved here.
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "core/base/named_list.h"
#include "core/document/document.h"
#include "core/io/files/file_fingerprint.h"
#include "core/io/session/session.h"

namespace mes {

struct Format;

/// The contents of a document or a file, in counts.
struct Holdings {
  std::size_t samples = 0;
  std::size_t balls = 0;
  std::optional<std::size_t> edits{};  ///< only for a session
  friend bool operator==(const Holdings&, const Holdings&) = default;
};

struct FileConflict {
  std::filesystem::path file;
  Holdings mine{};
  std::optional<Holdings> theirs{};           ///< contents of the file now; nothing if it cannot be read
  std::string problem{};                      ///< why the file cannot be read
  std::optional<std::size_t> shared_edits{};  ///< number of first edits that two sessions of the same data share
  std::optional<FileFingerprint> found{};     ///< the state of the file that all this describes
};

/// Compares the document with the file, which has one of the formats. `mine` is null if the document is not saved as
/// a session.
FileConflict look_into(const std::filesystem::path& file, const Document& document, const Session* mine,
                       const NamedList<Format>& formats);

}  // namespace mes
