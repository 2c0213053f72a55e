// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/format.h"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <new>
#include <system_error>
#include <utility>

#include "core/base/lower_case.h"
#include "core/base/zlib.h"
#include "core/io/bundle_file.h"
#include "core/io/carried_session.h"
#include "core/io/files/read_file.h"
#include "core/io/format_spec.h"
#include "core/io/systems/chosen_plane.h"
#include "core/io/systems/map_conversion.h"
#include "core/io/text/text_numbers.h"
#include "core/io/xml/xml_source.h"

namespace mes {
namespace {

namespace fs = std::filesystem;

// Share of the progress until the bytes of the file are read.
constexpr double kFileShare = 0.2;

using Formats = NamedList<Format>;

const Formats& formats_of(const ReadRequest& request) {
  static const Formats of_program = [] {
    Formats out;
    add_formats(out);
    return out;
  }();
  return request.formats != nullptr ? *request.formats : of_program;
}

std::string readable_ids(const Formats& formats) {
  std::string out;
  for (const auto& format : formats.all()) {
    if (!format->descriptor.can_read) continue;
    if (!out.empty()) out += ", ";
    out += format->descriptor.id;
  }
  return out;
}

const Format* format_by_extension(const Formats& formats, const std::string& name) {
  const std::string extension = lower_case_extension(name);
  for (const auto& format : formats.all())
    if (format->descriptor.can_read && std::ranges::count(format->descriptor.extensions, extension) != 0)
      return format.get();
  return nullptr;
}

/// Names a familiar kind of file that is not supported, for the beginning of a message.
std::string_view known_text(std::string_view bytes) {
  constexpr std::size_t kLookedAt = 8192;
  std::string_view text = without_bom(bytes).substr(0, kLookedAt);
  text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  if (text.starts_with("solid") && text.contains("facet normal")) return "an STL mesh, ";
  if (text.starts_with('{') && text.contains("\"Topology\"")) return "TopoJSON, ";
  if (text.starts_with('{') && text.contains("\"esriGeometry")) return "JSON of Esri, ";
  return {};
}

// Finds the format by certain content first, then by extension, then by possible content. Returns nothing for files
// known to be something else.
const Format* find_format(const Formats& formats, std::string_view bytes, const std::string& name) {
  const Format* possible = nullptr;
  for (const auto& format : formats.all()) {
    if (!format->descriptor.can_read) continue;
    const Match match = format->match(bytes);
    if (match == Match::surely) return format.get();
    if (match == Match::maybe && possible == nullptr) possible = format.get();
  }
  if (!known_text(bytes).empty()) return nullptr;
  const Format* by_name = format_by_extension(formats, name);
  return by_name != nullptr ? by_name : possible;
}

Expected<const Format*> choose_format(const Formats& formats, std::string_view bytes, const std::string& name,
                                      std::string_view wanted) {
  if (!wanted.empty()) {
    const auto format = formats.find(wanted);
    if (format != nullptr && format->descriptor.can_read) return format.get();
    return std::unexpected(
        Error{ErrorCode::usage,
              in_quotes(wanted) + " is not a format that can be read (" + readable_ids(formats) + ")",
              {},
              0,
              0});
  }
  if (const Format* format = find_format(formats, bytes, name); format != nullptr) return format;
  return bad_input(
      fmt::format("this is {}none of the formats that can be read ({})", known_text(bytes), readable_ids(formats)),
      name, 1, 1);
}

Expected<LoadedFile> read_carried(const Format& session, std::string_view text, const std::string& name,
                                  ReadJob& job) {
  job.begin(text);
  auto file = session.read(text, name, job);
  if (!file) {
    // The line and column would refer to the compressed text, which nobody can look at.
    Error error = std::move(file.error());
    return bad_input("the session that it carries: " + error.text, name, 0, 0);
  }
  file->format = "session";
  file->is_carried = true;
  return file;
}

Expected<LoadedFile> untraceable(const std::string& name) {
  return std::unexpected(Error{ErrorCode::usage, "only pictures are traced, and this is none", name});
}

/// Whether a format of XML or binary files recognises the bytes.
bool is_known_all_the_same(const Formats& formats, std::string_view bytes) {
  return std::ranges::any_of(formats.all(), [&](const auto& format) {
    return format->may_look_foreign && format->match(bytes) == Match::surely;
  });
}

/// The root element of XML, as " (gml:FeatureCollection)"; empty for anything else.
std::string root_of(std::string_view bytes) {
  constexpr std::size_t kLongest = 40;
  const std::string_view name = xml_root_name(bytes).substr(0, kLongest);
  return name.empty() ? std::string() : fmt::format(" ({})", printable(name));
}

std::unexpected<Error> no_system_for(std::string_view why, const std::string& name) {
  return std::unexpected(Error{ErrorCode::usage, fmt::format("a coordinate system is given, but {}", why), name});
}

/// Takes positions of a format without coordinate systems, as a table, as those of the system that is wanted.
Expected<LoadedFile> in_system(LoadedFile file, const Expected<CoordinateSystem>& system, MapDegrees degrees,
                               const std::string& name) {
  if (file.session || (file.data.map && is_on_earth(*file.data.map)))
    return no_system_for("this file already says where its plane lies", name);
  if (file.data.positions.empty()) return no_system_for("there are no samples here", name);
  if (!system) return std::unexpected(system.error());
  if (system->is_geographic && file.data.source)
    return no_system_for("curves of drawings have no longitude and latitude", name);
  const double half_turn = system->half_turn();
  const auto is_outside = [&](Vec2 p) { return std::abs(p.x) > 2.0 * half_turn || std::abs(p.y) > 0.5 * half_turn; };
  if (system->is_geographic && std::ranges::any_of(file.data.positions, is_outside))
    return bad_input(fmt::format("not every sample is a longitude and latitude, as {} needs", system->title()), name,
                     1, 1);
  // Curves are not projected.
  auto chosen = choose_plane(file.data.positions, *system, file.data.source ? MapDegrees::kept : degrees);
  if (!chosen) return std::unexpected(chosen.error());
  const auto conversion = MapConversion::of(chosen->plane, MapTarget::own_system);
  if (!conversion) return std::unexpected(conversion.error());
  conversion->to_plane(file.data.positions);
  const bool is_choice = chosen->is_choice && !file.data.source;
  file.data.map = std::move(chosen->plane);
  if (is_choice) file.degrees = degrees;
  file.warnings.insert(file.warnings.begin(), Error{ErrorCode::bad_input, chosen->remark, name}.message());
  return file;
}

Expected<LoadedFile> read_as(const Format& format, std::string_view bytes, const std::string& name,
                             const ReadRequest& request, const fs::path* path, ReadJob& job) {
  job.begin(bytes);
  if (!request.trace.is_default()) return format.read_traced(bytes, name, request.trace, job);
  if (format.read_map) return format.read_map(bytes, name, request, path, job);
  if (!request.system.empty() && format.read_traced) return no_system_for("pictures have none", name);
  auto file = path != nullptr && format.read_beside ? format.read_beside(bytes, name, *path, job)
                                                    : format.read(bytes, name, job);
  if (!file || (request.system.empty() && !file->has_degrees)) return file;
  const auto system = request.system.empty() ? Expected<CoordinateSystem>(CoordinateSystem{})
                                             : find_coordinate_system(request.system);
  return in_system(*std::move(file), system, request.degrees, name);
}

// Returns the drawing that a file of gzip holds, as .svgz files do; nothing for any other file. The text is at most so
// many times as large as the file, and one MiB.
Expected<std::optional<std::string>> compressed_drawing(const Formats& formats, std::string_view bytes,
                                                        const std::string& name) {
  constexpr std::size_t kMostTimes = 64;
  constexpr std::size_t kAlways = std::size_t{1} << 20U;
  if (!looks_like_gzip(bytes)) return std::nullopt;
  auto text = gzip_expanded(bytes, kAlways + kMostTimes * bytes.size());
  if (!text) return std::unexpected(Error{text.error().code, text.error().text, name});
  const auto svg = formats.find("svg");
  if (svg == nullptr || svg->match(*text) != Match::surely)
    return bad_input("this is gzip compressed data other than a drawing in SVG; gunzip expands it", name, 1, 1);
  return *std::move(text);
}

Expected<LoadedFile> read_bytes(std::string_view bytes, const std::string& name, std::string_view wanted,
                                const ReadRequest& request, const fs::path* path, JobControl* control) {
  try {
    const Formats& formats = formats_of(request);
    const auto drawing = compressed_drawing(formats, bytes, name);
    if (!drawing) return std::unexpected(drawing.error());
    if (*drawing) bytes = **drawing;
    ReadJob job(control, path != nullptr ? kFileShare : 0.0, request.keeps_vertices, request.wants_curves);
    if (wanted.empty() && may_carry_session(bytes)) {
      const auto text = carried_session(bytes, name);
      if (!text) return std::unexpected(text.error());
      const auto session = formats.find("session");
      if (*text && session != nullptr && !request.system.empty())
        return no_system_for("this file already says where its plane lies", name);
      if (*text && session != nullptr)
        return request.trace.is_default() ? read_carried(*session, **text, name, job) : untraceable(name);
    }
    if (looks_like_manifest(bytes))
      return bad_input("this is a manifest of frames that carries no session, not a text of samples", name, 1, 1);
    if (looks_like_bundles(bytes)) return bad_input("these are bundles of layers, not samples", name, 1, 1);
    const std::string_view kind = foreign_kind(bytes);
    if (kind == kUtf16Text) return bad_input("this is UTF-16 text, which must be saved as UTF-8", name, 1, 1);
    if (!kind.empty() && !is_known_all_the_same(formats, bytes))
      return bad_input("this is " + std::string(kind) + root_of(bytes) +
                           (may_carry_session(bytes) ? " that carries no session" : "") + ", not a text of samples",
                       name, 1, 1);
    if (without_bom(bytes).find_first_not_of(" \t\r\n\v\f") == std::string_view::npos)
      return bad_input("the file is empty", name, 1, 1);
    const auto format = choose_format(formats, bytes, name, wanted);
    if (!format) return std::unexpected(format.error());
    if (!request.trace.is_default() && !(*format)->read_traced) return untraceable(name);
    auto file = read_as(**format, bytes, name, request, path, job);
    if (!file) return file;
    file->format = (*format)->descriptor.id;
    if (path != nullptr && (*format)->read_companions) (*format)->read_companions(*path, *file);
    return file;
  } catch (const Cancelled&) {
    return std::unexpected(Error{ErrorCode::cancelled, "reading was cancelled", name});
  } catch (const std::bad_alloc&) {
    return std::unexpected(Error{ErrorCode::out_of_memory, "there is not enough memory to read it", name});
  }
}

// A file whose beginning is not text (a disk image, say) is not read to its end, unless it may carry a session or a
// format recognises it.
ReadOptions what_may_be_read(const Formats& formats, JobControl* job) {
  constexpr std::size_t kLargest = std::size_t{1} << 30U;
  return {.is_enough =
              [&formats](std::string_view bytes) {
                if (foreign_kind(bytes).empty()) return false;
                const bool may_be_read =
                    may_carry_session(bytes) || is_known_all_the_same(formats, bytes) || looks_like_gzip(bytes);
                return !may_be_read || bytes.size() > kLargest;
              },
          .job = job,
          .share = kFileShare};
}

}  // namespace

Expected<LoadedFile> read_sample_file(const fs::path& path, std::string_view format, JobControl* job,
                                      const ReadRequest& request) {
  const auto bytes = read_whole(path, what_may_be_read(formats_of(request), job));
  if (!bytes) return std::unexpected(bytes.error());
  auto file = read_bytes(*bytes, path.string(), format, request, &path, job);
  std::error_code error;
  if (file && fs::is_regular_file(path, error)) file->sources.push_back({path, fingerprint_of(*bytes)});
  return file;
}

Expected<LoadedFile> read_sample_stream(int descriptor, const std::string& name, std::string_view format,
                                        const ReadRequest& request, JobControl* job) {
  const auto bytes = read_whole(descriptor, name, what_may_be_read(formats_of(request), job));
  if (!bytes) return std::unexpected(bytes.error());
  return read_bytes(*bytes, name, format, request, nullptr, job);
}

Expected<LoadedFile> read_sample_bytes(std::string_view bytes, const std::string& name, std::string_view format,
                                       const ReadRequest& request, JobControl* job) {
  return read_bytes(bytes, name, format, request, nullptr, job);
}

}  // namespace mes
