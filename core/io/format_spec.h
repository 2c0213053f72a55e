// SPDX-License-Identifier: GPL-3.0-or-later
// What reading knows of a file format. Each file of a format defines `Format name_format()`, listed in
// core/io/format_list.cpp.
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
#include "core/io/read_job.h"

namespace mes {

/// How sure a format is that some bytes are its own.
enum class Match : std::uint8_t {
  no,
  maybe,   ///< the bytes make sense in this format; a file name's extension outweighs it
  surely,  ///< the bytes say so themselves
};

struct Format {
  FormatDescriptor descriptor;
  std::function<Match(std::string_view bytes)> match{};
  /// Everything but `LoadedFile::format`. `name` stands for the file in messages. `job` goes through the bytes already;
  /// the reader says where it is. Throws `Cancelled`.
  /// Empty for maps, which have `read_map`.
  std::function<Expected<LoadedFile>(std::string_view bytes, const std::string& name, ReadJob& job)> read{};
  /// Of pictures: what `read` does, with a choice of what to trace; empty for all others.
  std::function<Expected<LoadedFile>(std::string_view bytes, const std::string& name, const TraceRequest& request,
                                     ReadJob& job)>
      read_traced{};
  /// Of formats whose files need others that lie beside them: what `read` does for a file at `path`; empty for
  /// all others.
  std::function<Expected<LoadedFile>(std::string_view bytes, const std::string& name,
                                     const std::filesystem::path& path, ReadJob& job)>
      read_beside{};
  /// Of maps: what `read` does, with a choice of what becomes of longitude and latitude. `path` is that of the file, null
  /// for bytes in memory.
  std::function<Expected<LoadedFile>(std::string_view bytes, const std::string& name, MapDegrees degrees,
                                     const std::filesystem::path* path, ReadJob& job)>
      read_map{};
  /// Its files may be XML or binary, and say so themselves: what looks like no text of samples may be one of them.
  bool may_look_foreign = false;
  /// Reads what lies beside the file in files of its own; may be empty. Only warns, never fails.
  std::function<void(const std::filesystem::path& path, LoadedFile& file)> read_companions{};
};

/// Adds those of the program, in the order in which contents are tried.
void add_formats(NamedList<Format>& to);

}  // namespace mes
