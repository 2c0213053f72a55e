// SPDX-License-Identifier: GPL-3.0-or-later
// Shapefiles of ESRI (technical description of July 1998): only the geometry, the .shp file. Polygons, lines, points
// and sets of points; heights and measures are left out. The .prj file beside it names the coordinate system
// (core/io/maps/map_shapes.h); without it positions are coordinates of the plane.
#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <optional>
#include <system_error>

#include "core/base/geometry/coordinate_range.h"
#include "core/base/lower_case.h"
#include "core/io/files/read_file.h"
#include "core/io/format_spec.h"
#include "core/io/maps/map_features.h"
#include "core/io/maps/map_shapes.h"
#include "core/io/systems/coordinate_system.h"
#include "core/io/text/counted_remarks.h"
#include "core/io/text/text_numbers.h"

namespace mes {
namespace {

constexpr std::size_t kFileHeader = 100;
constexpr std::size_t kRecordHeader = 8;
constexpr std::uint32_t kCode = 9994;
constexpr std::uint32_t kVersion = 1000;

template <class Bits>
Bits bits_at(std::string_view bytes, std::size_t at, std::endian order) {
  Bits out = 0;
  std::memcpy(&out, bytes.data() + at, sizeof out);
  return order == std::endian::native ? out : std::byteswap(out);
}
std::uint32_t little(std::string_view bytes, std::size_t at) {
  return bits_at<std::uint32_t>(bytes, at, std::endian::little);
}
std::uint32_t big(std::string_view bytes, std::size_t at) {
  return bits_at<std::uint32_t>(bytes, at, std::endian::big);
}

/// Also recognises a file that is cut off within its header.
Match match_shapefile(std::string_view bytes) {
  constexpr std::size_t kVersionPlace = 28;
  const bool has_code = bytes.size() >= 4 && big(bytes, 0) == kCode;
  const bool is_shape_file =
      has_code && (bytes.size() < kVersionPlace + 4 || little(bytes, kVersionPlace) == kVersion);
  return is_shape_file ? Match::surely : Match::no;
}

/// Type numbers; with a height they are 10 more, with a measure 20 more.
enum class ShapeType : std::uint32_t { null = 0, point = 1, lines = 3, rings = 5, points = 8, patches = 31 };

class ShapeFileReader {
 public:
  ShapeFileReader(std::string_view bytes, const std::string& name, const ReadRequest& request, ReadJob& job)
      : bytes_(bytes), name_(name), job_(job), shapes_(request) {}

  Expected<void> name_system(std::string_view text) { return shapes_.name_system(text); }

  /// `has_system`: it is known what system the numbers are in, or that they are in none.
  Expected<LoadedFile> read(bool has_system) && {
    if (bytes_.size() < kFileHeader)
      return fail(fmt::format("the file ends at byte {}, within its header", bytes_.size()));
    if (match_shapefile(bytes_) == Match::no) return fail("at byte 0: this is not the header of a shapefile");
    for (at_ = kFileHeader; at_ < bytes_.size(); ++record_) {
      if (auto done = read_record(); !done) return std::unexpected(done.error());
      pass_over_padding();
    }
    auto file = std::move(shapes_).load(name_, job_);
    if (!file) return file;
    if (has_heights_) remark(*file, "heights and measures are left out");
    if (!has_system && is_on_earth_)
      remark(*file, "no .prj file beside it says whether these are degrees, so coordinates are taken as they are");
    remarks_.for_each([&](const std::string& text, std::size_t) { remark(*file, text); });
    return file;
  }

 private:
  void remark(LoadedFile& file, std::string text) const {
    file.warnings.push_back(Error{ErrorCode::bad_input, std::move(text), name_}.message());
  }
  std::unexpected<Error> fail(std::string text) const { return bad_input(std::move(text), name_, 0, 0); }
  std::unexpected<Error> fail_at(std::size_t place, const std::string& text) const {
    return fail(fmt::format("record {} at byte {}: {}", record_, place, text));
  }
  std::unexpected<Error> fail_here(const std::string& text) const { return fail_at(at_, text); }

  /// Whether a record can be at `at`: it has room, and a known type.
  bool may_be_record(std::size_t at) const {
    constexpr std::array<std::uint32_t, 14> kTypes{0, 1, 3, 5, 8, 11, 13, 15, 18, 21, 23, 25, 28, 31};
    if (bytes_.size() - at < kRecordHeader + 4) return false;
    const std::uint64_t length = 2 * std::uint64_t{big(bytes_, at + 4)};
    return length >= 4 && length <= bytes_.size() - at - kRecordHeader &&
           std::ranges::find(kTypes, little(bytes_, at + kRecordHeader)) != kTypes.end();
  }

  /// Skips zeros between records, which some programs write.
  void pass_over_padding() {
    const std::size_t begin = at_;
    std::size_t at = at_;
    while (bytes_.size() - at >= 4 && !may_be_record(at) && bytes_[at] == '\0' && bytes_[at + 1] == '\0') at += 2;
    if (bytes_.size() - begin >= 4 && bytes_.find_first_not_of('\0', begin) == std::string_view::npos)
      at_ = bytes_.size();
    else if (at != begin && may_be_record(at))
      at_ = at;
    if (at_ != begin)
      remarks_.add("gap of zeros between records is passed over", "gaps of zeros between records are passed over",
                   begin);
  }

  Expected<void> read_record() {
    if (bytes_.size() - at_ < kRecordHeader) return fail_here("the file ends within its header");
    const std::uint64_t length = 2 * std::uint64_t{big(bytes_, at_ + 4)};
    if (length > bytes_.size() - at_ - kRecordHeader) return fail_here("the file ends within it");
    const std::string_view content = bytes_.substr(at_ + kRecordHeader, length);
    if (auto done = read_content(content); !done) return done;
    at_ += kRecordHeader + length;
    return {};
  }

  Expected<void> read_content(std::string_view content) {
    if (content.size() < 4) return fail_here("it has no type");
    std::uint32_t number = little(content, 0);
    if (number == static_cast<std::uint32_t>(ShapeType::patches)) {
      remarks_.add("surface in space (multipatch) is left out", "surfaces in space (multipatches) are left out", at_);
      return {};
    }
    constexpr std::uint32_t kTen = 10;
    constexpr std::uint32_t kMostTens = 2;
    if (number / kTen <= kMostTens && number > kTen && number % kTen != 0) {
      has_heights_ = true;
      number %= kTen;
    }
    switch (static_cast<ShapeType>(number)) {
      case ShapeType::null: return {};
      case ShapeType::point: return read_point(content);
      case ShapeType::points: return read_points(content);
      case ShapeType::lines: return read_parts(content, false);
      case ShapeType::rings: return read_parts(content, true);
      default: return fail_here(fmt::format("there is no type {}", little(content, 0)));
    }
  }

  Expected<void> read_position(std::string_view content, std::size_t at) {
    const auto number = [&](std::size_t k) {
      return std::bit_cast<double>(bits_at<std::uint64_t>(content, at + 8 * k, std::endian::little));
    };
    job_.passed(content.data() + at);
    const Vec2 p{number(0), number(1)};
    for (std::size_t k = 0; k < 2; ++k) {
      const double x = number(k);
      if (const auto fault = seen_.fault_of(x))
        return fail_at(at_ + kRecordHeader + at + 8 * k, describe(*fault, x, seen_));
      seen_.add(x);
    }
    is_on_earth_ = is_on_earth_ && p.x >= -180.0 && p.x <= 180.0 && p.y >= -90.0 && p.y <= 90.0;
    shapes_.add(p);
    return {};
  }

  Expected<void> read_point(std::string_view content) {
    constexpr std::size_t kSize = 20;
    if (content.size() < kSize) return fail_here("it is too short for a point");
    if (auto done = read_position(content, 4); !done) return done;
    shapes_.end_points();
    return {};
  }

  Expected<void> read_points(std::string_view content) {
    constexpr std::size_t kFirst = 40;
    if (content.size() < kFirst) return fail_here("it is too short for a set of points");
    const std::uint64_t count = little(content, 36);
    if (16 * count > content.size() - kFirst) return fail_here(fmt::format("it is too short for {} points", count));
    for (std::size_t i = 0; i < count; ++i)
      if (auto done = read_position(content, kFirst + 16 * i); !done) return done;
    shapes_.end_points();
    return {};
  }

  Expected<void> read_parts(std::string_view content, bool are_rings) {
    constexpr std::size_t kFirst = 44;
    if (content.size() < kFirst) return fail_here("it is too short for lines");
    const std::uint64_t parts = little(content, 36);
    const std::uint64_t count = little(content, 40);
    if (4 * parts + 16 * count > content.size() - kFirst)
      return fail_here(fmt::format("it is too short for {} parts of {} points", parts, count));
    const std::size_t places = kFirst + 4 * parts;
    std::uint64_t begin = 0;
    for (std::uint64_t part = 0; part < parts; ++part) {
      const std::uint64_t end = part + 1 < parts ? little(content, kFirst + 4 * (part + 1)) : count;
      if (little(content, kFirst + 4 * part) != begin || end < begin || end > count)
        return fail_here(fmt::format("part {} does not follow the one before", part));
      for (; begin < end; ++begin)
        if (auto done = read_position(content, places + 16 * begin); !done) return done;
      if (are_rings) {
        shapes_.end_ring();
      } else {
        shapes_.end_line();
      }
    }
    return {};
  }

  std::string_view bytes_;
  const std::string& name_;
  ReadJob& job_;
  std::size_t at_ = 0;
  std::uint64_t record_ = 1;
  MapShapes shapes_;
  Magnitudes seen_;
  CountedRemarks remarks_;
  bool has_heights_ = false;
  bool is_on_earth_ = true;
};

/// The content of the .prj file beside the shapefile.
struct SystemFile {
  std::optional<SourceFile> source{};  ///< nothing: there is none that can be read
  std::string text{};                  ///< WKT of OGC or ESRI; empty: it names no system of the Earth
  std::string remark{};                ///< why coordinates are taken as they are; empty: no reason
};

Expected<SystemFile> read_system_beside(const std::filesystem::path& path) {
  SystemFile out;
  for (const char* extension : {".prj", ".PRJ"}) {
    std::filesystem::path beside = path;
    beside.replace_extension(extension);
    std::error_code error;
    if (out.source || !std::filesystem::exists(beside, error)) continue;
    // The longest coordinate systems take a few kilobytes.
    constexpr std::uint64_t kMostBytes = 1U << 20U;
    const auto text = read_regular_file(beside, {.most_bytes = kMostBytes});
    if (!text) {
      out.remark = text.error().message() + "; coordinates are taken as they are";
      continue;
    }
    out.remark.clear();
    out.source = SourceFile{beside, fingerprint_of(*text)};
    const std::string_view system = without_bom(*text);
    const std::size_t begin = system.find_first_not_of(" \t\r\n");
    if (begin == std::string_view::npos) {
      out.remark = beside.string() + ": the file is empty; coordinates are taken as they are";
      continue;
    }
    if (!system.contains('[') && !system.contains('('))
      return bad_input("this is not the well-known text of a coordinate system", beside.string(), 1, begin + 1);
    const bool is_local = lower_case(system.substr(begin, std::string_view("local_cs").size())) == "local_cs";
    if (!is_local) out.text = system.substr(begin);
  }
  return out;
}

Expected<LoadedFile> read_shapefile(std::string_view bytes, const std::string& name, const ReadRequest& request,
                                    const std::filesystem::path* path, ReadJob& job) {
  SystemFile system;
  // A system that the request names takes precedence.
  if (path != nullptr && request.system.empty()) {
    auto beside = read_system_beside(*path);
    if (!beside) return std::unexpected(beside.error());
    system = *std::move(beside);
  }
  ShapeFileReader reader(bytes, name, request, job);
  if (!system.text.empty())
    if (auto done = reader.name_system(system.text); !done)
      return bad_input(std::move(done.error().text), system.source->path.string(), 0, 0);
  auto file = std::move(reader).read(system.source.has_value() || !request.system.empty());
  if (!file) return file;
  if (system.source) file->sources.push_back(*std::move(system.source));
  if (!system.remark.empty()) file->warnings.push_back(std::move(system.remark));
  return file;
}

}  // namespace

Expected<std::string> check_shapefile(std::string_view bytes, const std::string& name,
                                      const std::filesystem::path& path, bool has_system) {
  constexpr std::size_t kLengthPlace = 24;  // in words of two bytes
  const std::uint64_t length =
      bytes.size() < kFileHeader ? std::uint64_t{kFileHeader} : std::uint64_t{2} * big(bytes, kLengthPlace);
  if (length > bytes.size())
    return bad_input(fmt::format("the file ends at byte {}, and its header tells of {}", bytes.size(), length), name,
                     0, 0);
  const auto has_beside = [&](const char* extension) {
    std::error_code error;
    return std::filesystem::exists(std::filesystem::path(path).replace_extension(extension), error);
  };
  if (!has_beside(".shx") && !has_beside(".SHX"))
    return bad_input("its attributes cannot be read without the .shx file that belongs beside it", name, 0, 0);
  if (has_system) return std::string();
  const auto system = read_system_beside(path);
  if (!system) return std::unexpected(system.error());
  if (!system->text.empty())
    if (const auto known = find_coordinate_system(system->text); !known)
      return bad_input(known.error().text, system->source->path.string(), 0, 0);
  return system->remark;
}

Format shapefile_format() {
  return {.descriptor =
              {.id = "shapefile", .name = "Shapefile", .extensions = {".shp"}, .can_read = true, .is_map = true},
          .match = match_shapefile,
          .read_map = read_shapefile,
          .may_look_foreign = true};
}

}  // namespace mes
