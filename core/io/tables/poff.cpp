// SPDX-License-Identifier: GPL-3.0-or-later
// POFF: "POFF n 0 0" and n pairs of numbers, white space anywhere unless the lines contradict pairs.
//
// Two notations give the order of the points on curves: lines `# loop closed i0 i1 ...` (or `open`), which old readers
// skip as comments, and a file `x.contours` beside `x.poff` with the number of points of each closed contour, in file
// order. The lines in the file take precedence.
//
// A line gives the location on the Earth of points that were a map: `# map UNIT of SYSTEM` if they are in a coordinate
// system, `# map metres about LONGITUDE LATITUDE of SYSTEM` if they were projected. Without a system this is longitude
// and latitude on WGS 84; old files have `kilometres` and the equirectangular projection, or just `# map degrees`.
// Points of a drawing may have a unit: `# unit mm`, and after that the width and height of its page: `# page 210 297`.
#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <system_error>

#include "core/io/files/read_file.h"
#include "core/io/format_spec.h"
#include "core/io/meshes/off_header.h"
#include "core/io/text/ascii_text.h"
#include "core/io/text/repeated_corners.h"
#include "core/io/text/text_numbers.h"

namespace mes {
namespace {

std::string_view other_than_points(std::size_t columns) {
  return columns == 3 ? "balls (WPOFF) or points in space" : "";
}

constexpr OffKind kPoffPoints{
    .magic = "POFF", .things = "points", .numbers = "coordinates", .numbers_each = 2, .guess = other_than_points};

/// Takes a word off the front of a text.
std::string_view take_word(std::string_view& text) {
  constexpr std::string_view kBlanks = " \t\v\f";
  text.remove_prefix(std::min(text.find_first_not_of(kBlanks), text.size()));
  const std::string_view word = text.substr(0, text.find_first_of(kBlanks));
  text.remove_prefix(word.size());
  return word;
}

/// "of SYSTEM", or nothing for longitude and latitude on WGS 84. False if it is neither.
bool read_map_system(std::string_view rest, MapPlane& map) {
  if (trimmed(rest).empty()) return true;
  if (take_word(rest) != "of" || trimmed(rest).empty()) return false;
  map.system = trimmed(rest);
  return true;
}

/// Nothing if the comment is not a map line.
std::optional<MapPlane> read_map(std::string_view rest) {
  take_word(rest);
  const std::string_view whole = rest;
  const std::string_view unit = take_word(rest);
  MapPlane out;
  if (unit == "degrees" && trimmed(rest).empty()) return out;
  if (take_word(rest) != "about") {
    // The unit may be several words.
    const std::size_t of = whole.find(" of ");
    if (of == std::string_view::npos || whole.find_first_of(":[", of) == std::string_view::npos ||
        !read_map_system(whole.substr(of), out))
      return std::nullopt;
    out.unit = trimmed(whole.substr(0, of));
    return out.unit.empty() ? std::nullopt : std::optional(out);
  }
  if (unit != "kilometres" && unit != "metres") return std::nullopt;
  out.projection = unit == "metres" ? MapProjection::azimuthal : MapProjection::equirectangular;
  const auto longitude = parse_number(take_word(rest));
  const auto latitude = parse_number(take_word(rest));
  if (!longitude || !latitude || !read_map_system(rest, out) || !is_origin_of_map(*longitude, *latitude, out))
    return std::nullopt;
  out.longitude = *longitude;
  out.latitude = *latitude;
  return out;
}

/// Whether the text is the symbol of a unit of a drawing; a comment may say more.
bool is_unit(std::string_view text) {
  constexpr std::size_t kLongest = 20;
  return !text.empty() && text.size() <= kLongest && text != "degree" &&
         text.find_first_of(" \t") == std::string_view::npos && printable(text) == text;
}

/// Width and height of a page; nothing if the comment says something else.
std::optional<Vec2> read_page(std::string_view rest) {
  take_word(rest);
  const auto width = parse_number(take_word(rest));
  const auto height = parse_number(take_word(rest));
  if (!width || !height || !(*width > 0.0) || !(*height > 0.0) || !trimmed(rest).empty()) return std::nullopt;
  return Vec2{*width, *height};
}

/// Records the comments about loops, which can be checked only after the points, and about a map.
class PoffScanner final : public Scanner {
 public:
  using Scanner::Scanner;
  struct Note {
    std::string_view text;
    std::uint64_t line;
    std::uint64_t column;
  };
  const std::vector<Note>& notes() const { return notes_; }
  const std::optional<MapPlane>& map() const { return map_; }

 private:
  void on_comment(std::string_view text) override {
    const std::size_t begin = text.find_first_not_of(" \t");
    if (begin == std::string_view::npos) return;
    text.remove_prefix(begin);
    if (const auto map = text.starts_with("map ") ? read_map(text) : std::nullopt) map_ = map;
    if (const auto unit = text.starts_with("unit ") ? trimmed(text.substr(5)) : std::string_view(); is_unit(unit))
      map_ = MapPlane{.unit = std::string(unit)};
    const auto page = text.starts_with("page ") ? read_page(text) : std::nullopt;
    if (page && map_ && map_->is_of_drawing()) map_->page = *page;
    if (text.starts_with("loop")) notes_.push_back({text, line(), column_of(text.data())});
  }
  std::vector<Note> notes_;
  std::optional<MapPlane> map_;
};

/// A loop, nothing if the comment is not one, or an error that tells what is wrong with it.
Expected<std::optional<SampleData::Contour>> read_loop(const PoffScanner::Note& note, std::size_t points,
                                                       const std::string& name) {
  std::string_view rest = note.text;
  if (take_word(rest) != "loop") return std::nullopt;
  const std::string_view kind = take_word(rest);
  if (kind != "closed" && kind != "open") return std::nullopt;
  SampleData::Contour contour{kind == "closed", {}};
  for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest)) {
    const auto index = parse_count(word);
    if (index && *index < points) {
      contour.points.push_back(static_cast<std::uint32_t>(*index));
      continue;
    }
    const std::uint64_t column = note.column + static_cast<std::uint64_t>(word.data() - note.text.data());
    return bad_input(fmt::format("this loop is ignored, because {} is not the number of one of the {} points",
                                 in_quotes(word), points),
                     name, note.line, column);
  }
  // A point that is repeated in succession, also across the end of a closed loop, is one corner.
  contour.points.erase(std::ranges::unique(contour.points).begin(), contour.points.end());
  if (contour.closed && contour.points.size() > 1 && contour.points.front() == contour.points.back())
    contour.points.pop_back();
  if (contour.points.empty()) return std::nullopt;
  return contour;
}

Match match_poff(std::string_view bytes) {
  return has_off_magic(bytes, kPoffPoints) ? Match::surely : Match::no;
}

Expected<LoadedFile> read_poff(std::string_view bytes, const std::string& name, ReadJob& job) {
  PoffScanner scanner(bytes);
  OffReader reader(kPoffPoints, scanner, bytes, name, job);
  const auto count = reader.read_header();
  if (!count) return std::unexpected(count.error());

  LoadedFile file;
  file.data.positions.reserve(reader.likely_count());
  for (std::uint64_t i = 0; i < *count; ++i) {
    std::array<double, 2> point{};
    if (auto read = reader.read_next(point); !read) return std::unexpected(read.error());
    file.data.positions.push_back({point[0], point[1]});
  }
  auto remarks = reader.finish();
  if (!remarks) return std::unexpected(remarks.error());
  file.warnings = std::move(*remarks);
  file.data.map = scanner.map();
  RepeatedCorners repeated;
  std::size_t ignored = 0;
  for (const PoffScanner::Note& note : scanner.notes()) {
    auto loop = read_loop(note, file.data.positions.size(), name);
    if (!loop) {
      if (ignored++ == 0) file.warnings.push_back(loop.error().message());
    } else if (*loop) {
      repeated.add(**loop, note.line);
      file.data.contours.push_back(std::move(**loop));
    }
  }
  if (ignored > 1)
    file.warnings.push_back(
        fmt::format("{}: {} ignored as well", name,
                    ignored == 2 ? "one more loop is" : fmt::format("{} more loops are", ignored - 1)));
  if (auto remark = repeated.remark(name)) file.warnings.push_back(*std::move(remark));
  return file;
}

/// Reads `x.contours` into closed contours over all points, in order.
Expected<std::vector<SampleData::Contour>> read_contours(std::string_view bytes, const std::string& name,
                                                         std::size_t points) {
  Scanner scanner(bytes);
  std::vector<std::uint64_t> sizes;
  std::uint64_t sum = 0;
  while (scanner.next()) {
    const auto size = parse_count(scanner.token());
    if (!size || *size > points - sum)
      return bad_input(size ? fmt::format("the contours have more points than the file ({})", points)
                            : "expected the number of points of a contour, found " + in_quotes(scanner.token()),
                       name, scanner.line(), scanner.column());
    sum += *size;
    if (*size != 0) sizes.push_back(*size);
  }
  if (sum != points)
    return bad_input(fmt::format("the contours have {} points, the file has {}", sum, points), name, scanner.line(),
                     scanner.column());
  std::vector<SampleData::Contour> contours;
  std::uint32_t next = 0;
  for (const std::uint64_t size : sizes) {
    SampleData::Contour& contour = contours.emplace_back();
    contour.points.reserve(static_cast<std::size_t>(size));
    for (std::uint64_t i = 0; i < size; ++i) contour.points.push_back(next++);
  }
  return contours;
}

void read_poff_companions(const std::filesystem::path& path, LoadedFile& file) {
  if (!file.data.contours.empty()) return;
  std::filesystem::path beside = path;
  beside.replace_extension(".contours");
  std::error_code error;
  if (beside == path || !std::filesystem::exists(beside, error)) return;
  // A number for each contour, and room for what stands between them.
  constexpr std::uint64_t kLeastBytes = 1U << 16U;
  constexpr std::uint64_t kBytesEach = 32;
  const auto bytes = read_regular_file(beside, {.most_bytes = kLeastBytes + kBytesEach * file.data.positions.size()});
  if (bytes) file.sources.push_back({beside, fingerprint_of(*bytes)});
  auto contours = bytes ? read_contours(*bytes, beside.string(), file.data.positions.size())
                        : Expected<std::vector<SampleData::Contour>>(std::unexpected(bytes.error()));
  if (contours) {
    file.data.contours = std::move(*contours);
  } else {
    file.warnings.push_back(contours.error().message() + "; the order of the curve is ignored");
  }
}

}  // namespace

Format poff_format() {
  return {.descriptor =
              {.id = "poff", .name = "POFF points", .extensions = {".poff"}, .can_read = true, .can_write = true},
          .match = match_poff,
          .read = read_poff,
          .read_companions = read_poff_companions};
}

}  // namespace mes
