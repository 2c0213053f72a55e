// SPDX-License-Identifier: GPL-3.0-or-later
// Each format file defines `Format name_format()`, listed in core/io/format_list.cpp. Private to core/io.
#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
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
  Match (*match)(std::string_view bytes);
  /// Everything but `LoadedFile::format`. `name` stands for the file in messages. `job` goes through the bytes already;
  /// the reader says where it is. Throws `Cancelled`.
  /// Null of maps, which have `read_map`.
  Expected<LoadedFile> (*read)(std::string_view bytes, const std::string& name, ReadJob& job) = nullptr;
  /// Of pictures: what `read` does, with a choice of what to trace; null for all others.
  Expected<LoadedFile> (*read_traced)(std::string_view bytes, const std::string& name, const TraceRequest& request,
                                      ReadJob& job) = nullptr;
  /// Of formats whose files need others that lie beside them: what `read` does for a file at `path`; null for all
  /// others.
  Expected<LoadedFile> (*read_beside)(std::string_view bytes, const std::string& name,
                                      const std::filesystem::path& path, ReadJob& job) = nullptr;
  /// Of maps: what `read` does, with a choice of what becomes of longitude and latitude. `path` is that of the file, null
  /// for bytes in memory.
  Expected<LoadedFile> (*read_map)(std::string_view bytes, const std::string& name, MapDegrees degrees,
                                   const std::filesystem::path* path, ReadJob& job) = nullptr;
  /// Its files may be XML or binary, and say so themselves: what looks like no text of samples may be one of them.
  bool may_look_foreign = false;
  /// Reads what lies beside the file in files of its own; may be null. Only warns, never fails.
  void (*read_companions)(const std::filesystem::path& path, LoadedFile& file) = nullptr;
};

/// In the order in which contents are tried.
std::span<const Format> formats();

}  // namespace mes
