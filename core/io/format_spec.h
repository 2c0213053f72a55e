// SPDX-License-Identifier: GPL-3.0-or-later
// The interface of a file format. Each format's file defines `Format name_format()`, listed in core/io/format_list.cpp.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/base/named_list.h"
#include "core/io/format.h"
#include "core/io/text/read_job.h"

namespace mes {

/// Certainty of a format that some bytes are its own.
enum class Match : std::uint8_t {
  no,
  maybe,   ///< the bytes fit this format; a file name's extension outweighs this
  surely,  ///< the bytes identify the format
};

struct Format {
  FormatDescriptor descriptor;
  std::function<Match(std::string_view bytes)> match{};
  /// Fills everything but `LoadedFile::format`. `name` stands for the file in messages. `job` already follows the
  /// bytes; the reader reports its position. Throws `Cancelled`. Empty for maps, which have `read_map`.
  std::function<Expected<LoadedFile>(std::string_view bytes, const std::string& name, ReadJob& job)> read{};
  /// For pictures: like `read`, with a choice of what to trace; empty for all other formats.
  std::function<Expected<LoadedFile>(std::string_view bytes, const std::string& name, const TraceRequest& request,
                                     ReadJob& job)>
      read_traced{};
  /// For formats whose files need others beside them: like `read`, for a file at `path`; empty for all other formats.
  std::function<Expected<LoadedFile>(std::string_view bytes, const std::string& name,
                                     const std::filesystem::path& path, ReadJob& job)>
      read_beside{};
  /// For maps: like `read`, with a coordinate system and a treatment of longitude and latitude. `path` is that of the
  /// file, null for bytes in memory.
  std::function<Expected<LoadedFile>(std::string_view bytes, const std::string& name, const ReadRequest& request,
                                     const std::filesystem::path* path, ReadJob& job)>
      read_map{};
  /// Its files may be XML or binary and identify themselves: bytes that do not look like text may be of this format.
  bool may_look_foreign = false;
  /// Reads companion files beside the file; may be empty. Only warns, never fails.
  std::function<void(const std::filesystem::path& path, LoadedFile& file)> read_companions{};
};

/// Adds the formats of the program, in the order in which contents are tried.
void add_formats(NamedList<Format>& to);

}  // namespace mes
