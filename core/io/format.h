// SPDX-License-Identifier: GPL-3.0-or-later
// Reads and writes files of samples or balls in any format.
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
#include "core/base/jobs/job_control.h"
#include "core/base/named_list.h"
#include "core/document/sample_data.h"
#include "core/io/files/file_fingerprint.h"
#include "core/raster/trace_request.h"

namespace mes {

class Document;
struct Format;
struct Session;

/// Options for reading a file.
struct ReadRequest {
  TraceRequest trace{};                        ///< for pictures; if not the default, other formats are refused
  MapDegrees degrees = MapDegrees::projected;  ///< for maps; no effect on other formats
  /// Coordinate system of the positions, as `find_coordinate_system` (core/io/systems/coordinate_system.h) understands
  /// it, whatever the file says; empty: that of the file, if it has one. Refused for a file that stores its plane.
  std::string system{};
  /// Samples are only the vertices of curves; otherwise `default_sampling` samples the curves.
  bool keeps_vertices = false;
  /// The caller takes samples of the curves itself. So those of the file are only the vertices, and no warning counts
  /// them; the curves are the same as otherwise.
  bool wants_curves = false;
  const NamedList<Format>* formats = nullptr;  ///< available formats; null: those of the program
};

/// The content of a file.
struct LoadedFile {
  SampleData data;
  std::string format;                 ///< id of the format it was read as
  std::vector<std::string> warnings;  ///< one line each, already with file, line and column
  std::vector<SourceFile> sources{};  ///< regular files that were read for it
  /// The whole session if the file is one; `data` is then its last state.
  std::shared_ptr<const Session> session;
  std::optional<MapDegrees> degrees{};  ///< treatment of longitude and latitude; none: the file had none
  bool has_degrees = false;             ///< a table: its columns are called longitude and latitude, and hold such
  bool has_added_samples = false;       ///< between the vertices of curves; a warning gives their number
  bool is_carried = false;              ///< the session was in a picture or figure (core/io/carried_session.h)
};

struct FormatDescriptor {
  std::string id{};                       ///< public name, kebab case
  std::string name{};                     ///< shown name
  std::vector<std::string> extensions{};  ///< with the dot, lower case
  bool can_read = false;
  bool can_write = false;
  bool is_map = false;  ///< positions may be longitude and latitude
};

/// Reads a file; the format is found by content first, then by extension, unless `format` names one. A picture or
/// figure that carries a session is read as that session. A regular `.contours` file beside a POFF file is read too.
/// Never allocates memory by the sizes in a header. Error: `bad_input` with file, line, column; `usage` for a request
/// that does not fit the file; `cancelled` soon after `job` is stopped, also while waiting for a pipe.
Expected<LoadedFile> read_sample_file(const std::filesystem::path& path, std::string_view format = {},
                                      JobControl* job = nullptr, const ReadRequest& request = {});

/// The same for bytes in memory; `name` stands for the file in messages.
Expected<LoadedFile> read_sample_bytes(std::string_view bytes, const std::string& name, std::string_view format = {},
                                       const ReadRequest& request = {}, JobControl* job = nullptr);

/// The same from an open file descriptor, e.g. standard input, read to its end and left open.
Expected<LoadedFile> read_sample_stream(int descriptor, const std::string& name, std::string_view format = {},
                                        const ReadRequest& request = {}, JobControl* job = nullptr);

/// POFF text of the live samples in input order, with curve order as `# loop` lines and the location on the Earth as a
/// `# map` line; every double reads back bit for bit.
std::string write_poff(const Document& document);

/// Appends the POFF line with the location on the Earth; nothing if the points were no map.
void append_map_line(std::string& out, const std::optional<MapPlane>& map);

/// WPOFF text of balls; every double reads back bit for bit.
std::string write_wpoff(std::span<const Disk> balls);
/// WPOFF text of the live balls of the document in input order.
std::string write_wpoff(const Document& document);

}  // namespace mes
