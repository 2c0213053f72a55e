// SPDX-License-Identifier: GPL-3.0-or-later
// Reading and writing of files of samples or balls, whatever their format.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/error.h"
#include "core/base/job_control.h"
#include "core/base/named_list.h"
#include "core/document/commands.h"
#include "core/document/map_plane.h"
#include "core/io/file_fingerprint.h"
#include "core/raster/trace_request.h"

namespace mes {

struct Format;
struct Session;

/// How a file is read, where there is a choice.
struct ReadRequest {
  TraceRequest trace{};  ///< of pictures; a request that is not the default fits no other format
  MapDegrees degrees = MapDegrees::projected;  ///< of maps; of no effect on other formats
  /// Curves have their vertices as samples, and nothing between; otherwise they are sampled by `default_sampling`.
  bool keeps_vertices = false;
  const NamedList<Format>* formats = nullptr;  ///< that there are; null: those of the program
};

/// What a file held.
struct LoadedFile {
  SampleData data;
  std::string format;                 ///< id of the format it was read as
  std::vector<std::string> warnings;  ///< one line each, already with file, line and column
  std::vector<SourceFile> sources{};  ///< regular files that were read for it
  /// Of a session, all of it; `data` is its last state then.
  std::shared_ptr<const Session> session;
  std::optional<MapDegrees> degrees{};  ///< what became of longitude and latitude; none: the file had none
  bool is_carried = false;              ///< the session was in a picture or figure (core/io/carried_session.h)
};

struct FormatDescriptor {
  std::string id{};                       ///< public name, kebab case
  std::string name{};                     ///< as shown
  std::vector<std::string> extensions{};  ///< with the dot, lower case
  bool can_read = false;
  bool can_write = false;
  bool is_map = false;  ///< positions may be longitude and latitude
};

/// Reads a file; the format is found by content first, extension second, unless `format` names one. A picture or a
/// figure that carries a session is read as that session. A `.contours` file beside a POFF file is read too, if it is a
/// regular file. Never allocates by what a header promises. Error: `bad_input` with file, line, column; `usage` for a
/// request that does not fit the file; `cancelled`, a moment after `job` is stopped, also while a pipe is waited for.
Expected<LoadedFile> read_sample_file(const std::filesystem::path& path, std::string_view format = {},
                                      JobControl* job = nullptr, const ReadRequest& request = {});

/// The same for bytes in memory; `name` stands for the file in messages.
Expected<LoadedFile> read_sample_bytes(std::string_view bytes, const std::string& name, std::string_view format = {},
                                       const ReadRequest& request = {}, JobControl* job = nullptr);

/// The same from an open file descriptor, e.g. standard input, read to its end and left open.
Expected<LoadedFile> read_sample_stream(int descriptor, const std::string& name, std::string_view format = {},
                                        const ReadRequest& request = {}, JobControl* job = nullptr);

/// POFF text of the live samples in input order, curve order as `# loop` lines, where on the Earth they lie as a `# map` line; every double reads back bit for bit.
std::string write_poff(const Document& document);

/// The line of POFF that says where on the Earth its points lie; nothing for those that were no map in degrees.
void append_map_line(std::string& out, const std::optional<MapPlane>& map);

/// WPOFF text of balls; every double reads back bit for bit.
std::string write_wpoff(std::span<const Disk> balls);
/// The live balls of the document in input order.
std::string write_wpoff(const Document& document);

}  // namespace mes
