// SPDX-License-Identifier: GPL-3.0-or-later
// WKB, well-known binary (OGC 06-103r4, section 8, with the curves of SQL/MM), and EWKB of PostGIS: the bytes, or one
// geometry a line in hexadecimal digits. Heights and measures are left out. The code of a reference system is that of
// all positions; without one they are coordinates of the plane.
#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <optional>

#include "core/base/geometry/coordinate_range.h"
#include "core/io/format_spec.h"
#include "core/io/maps/map_features.h"
#include "core/io/maps/map_shapes.h"
#include "core/io/text/line_end.h"
#include "core/io/text/text_numbers.h"

namespace mes {
namespace {

constexpr int kDeepestWkb = 64;
constexpr std::size_t kGeometryHeader = 5;  // byte order and type

enum class WkbType : std::uint32_t {
  point = 1,
  line = 2,
  polygon = 3,
  points = 4,
  lines = 5,
  polygons = 6,
  collection = 7,
  arcs = 8,
  compound = 9,
  curve_polygon = 10,
  curves = 11,
  surfaces = 12,
  polyhedron = 15,
  triangles = 16,
  triangle = 17,
};

/// The meaning of the bytes of a type.
struct WkbKind {
  WkbType type = WkbType::point;
  std::size_t numbers = 2;  ///< numbers of a position
  bool has_system = false;
};

std::optional<WkbKind> kind_of(std::uint32_t code) {
  constexpr std::uint32_t kHeights = 0x80000000;
  constexpr std::uint32_t kMeasures = 0x40000000;
  constexpr std::uint32_t kSystem = 0x20000000;
  WkbKind out{.has_system = (code & kSystem) != 0};
  if ((code & kHeights) != 0) ++out.numbers;
  if ((code & kMeasures) != 0) ++out.numbers;
  const std::uint32_t number = code & ~(kHeights | kMeasures | kSystem);
  constexpr std::uint32_t kThousand = 1000;
  constexpr std::uint32_t kBoth = 3;
  constexpr std::array<std::size_t, 4> kMore{0, 1, 1, 2};
  const std::uint32_t type = number % kThousand;
  constexpr std::uint32_t kNoTypes[]{0, 13, 14};  // abstract types
  if (number / kThousand > kBoth || type > static_cast<std::uint32_t>(WkbType::triangle) ||
      std::ranges::find(kNoTypes, type) != std::end(kNoTypes))
    return std::nullopt;
  out.type = static_cast<WkbType>(type);
  out.numbers = std::max(out.numbers, 2 + kMore[number / kThousand]);
  return out;
}

/// Reads geometries from bytes.
class WkbReader {
 public:
  WkbReader(const std::string& name, const ReadRequest& request, ReadJob& job)
      : name_(name), job_(job), shapes_(request) {}

  /// Reads one geometry and everything after it. `line` is its line in text, 0 for bytes.
  Expected<void> read(std::string_view bytes, std::uint64_t line) {
    bytes_ = bytes;
    line_ = line;
    for (at_ = 0; at_ < bytes_.size();)
      if (auto done = read_geometry(0); !done) return done;
    return {};
  }

  Expected<LoadedFile> load() && {
    auto file = std::move(shapes_).load(name_, job_);
    if (file && has_heights_)
      file->warnings.push_back(Error{ErrorCode::bad_input, "heights and measures are left out", name_}.message());
    return file;
  }

 private:
  std::unexpected<Error> fail(const std::string& text) const {
    return bad_input(fmt::format("at byte {}{}: {}", at_, line_ == 0 ? "" : " of the geometry", text), name_, line_,
                     line_ == 0 ? 0 : 1);
  }
  std::unexpected<Error> ends_early() const { return fail("the bytes end within a geometry"); }

  template <class Bits>
  Bits take() {
    Bits out = 0;
    std::memcpy(&out, bytes_.data() + at_, sizeof out);
    at_ += sizeof out;
    const bool is_native = is_little_ == (std::endian::native == std::endian::little);
    return is_native ? out : std::byteswap(out);
  }
  std::size_t left() const { return bytes_.size() - at_; }

  Expected<WkbKind> read_header() {
    if (left() < kGeometryHeader) return ends_early();
    const auto order = static_cast<unsigned char>(bytes_[at_]);
    if (order > 1) return fail(fmt::format("there is no order of bytes {}", order));
    ++at_;
    is_little_ = order == 1;
    const std::uint32_t code = take<std::uint32_t>();
    const auto kind = kind_of(code);
    if (!kind) return fail(fmt::format("there is no type {}", code));
    if (kind->has_system) {
      if (left() < 4) return ends_early();
      if (auto done = shapes_.name_srid(take<std::uint32_t>()); !done) return fail(done.error().text);
    }
    has_heights_ = has_heights_ || kind->numbers > 2;
    return *kind;
  }

  /// Reads a count of things that take at least `least` bytes each.
  Expected<std::uint32_t> read_count(std::size_t least) {
    if (left() < 4) return ends_early();
    const std::uint32_t count = take<std::uint32_t>();
    if (count > left() / least) return fail(fmt::format("it is too short for {} parts", count));
    return count;
  }

  /// Nothing for an empty point, whose coordinates are NaN.
  Expected<std::optional<Vec2>> read_position(const WkbKind& kind, bool may_be_empty = false) {
    if (left() < 8 * kind.numbers) return ends_early();
    job_.checkpoint();
    const std::size_t place = at_;
    const double x = std::bit_cast<double>(take<std::uint64_t>());
    const double y = std::bit_cast<double>(take<std::uint64_t>());
    at_ += 8 * (kind.numbers - 2);
    if (may_be_empty && x != x && y != y) return std::nullopt;
    for (const double number : {x, y}) {
      if (const auto fault = seen_.fault_of(number)) {
        at_ = place;
        return fail(describe(*fault, number, seen_));
      }
      seen_.add(number);
    }
    return Vec2{x, y};
  }

  Expected<void> read_positions(const WkbKind& kind) {
    const auto count = read_count(8 * kind.numbers);
    if (!count) return std::unexpected(count.error());
    for (std::uint32_t i = 0; i < *count; ++i) {
      const auto position = read_position(kind);
      if (!position) return std::unexpected(position.error());
      if (i != 0 || shapes_.length() == 0 || shapes_.last() != **position) shapes_.add(**position);
    }
    return {};
  }

  Expected<void> read_arcs(const WkbKind& kind) {
    const auto count = read_count(8 * kind.numbers);
    if (!count) return std::unexpected(count.error());
    if (*count != 0 && (*count == 1 || *count % 2 == 0))
      return fail(fmt::format("arcs have three positions, or two more for each other, not {}", *count));
    std::optional<Vec2> through;
    for (std::uint32_t i = 0; i < *count; ++i) {
      const auto position = read_position(kind);
      if (!position) return std::unexpected(position.error());
      if (i == 0) {
        if (shapes_.length() == 0 || shapes_.last() != **position) shapes_.add(**position);
      } else if (i % 2 == 1) {
        through = **position;
      } else {
        shapes_.add_arc(*through, **position);
      }
    }
    return {};
  }

  /// Reads a line, arcs or several of these, without ending the curve.
  Expected<void> read_curve(int depth) {
    const auto kind = read_header();
    if (!kind) return std::unexpected(kind.error());
    return read_curve(*kind, depth);
  }
  Expected<void> read_curve(const WkbKind& kind, int depth) {
    if (kind.type == WkbType::line) return read_positions(kind);
    if (kind.type == WkbType::arcs) return read_arcs(kind);
    if (kind.type != WkbType::compound || depth > kDeepestWkb) return fail("this is no curve");
    const auto count = read_count(kGeometryHeader + 4);
    if (!count) return std::unexpected(count.error());
    for (std::uint32_t i = 0; i < *count; ++i)
      if (auto done = read_curve(depth + 1); !done) return done;
    return {};
  }

  Expected<void> read_rings(const WkbKind& kind) {
    const auto count = read_count(4);
    if (!count) return std::unexpected(count.error());
    shapes_.begin_polygon();
    for (std::uint32_t i = 0; i < *count; ++i) {
      if (auto done = read_positions(kind); !done) return done;
      shapes_.end_ring();
    }
    return {};
  }

  Expected<void> read_geometry(int depth) {
    if (depth > kDeepestWkb) return fail("collections are nested too deeply");
    const auto kind = read_header();
    if (!kind) return std::unexpected(kind.error());
    switch (kind->type) {
      case WkbType::point: {
        const auto position = read_position(*kind, true);
        if (!position) return std::unexpected(position.error());
        if (*position) shapes_.add(**position);
        shapes_.end_points();
        return {};
      }
      case WkbType::line:
      case WkbType::arcs:
      case WkbType::compound: {
        auto done = read_curve(*kind, depth);
        shapes_.end_line();
        return done;
      }
      case WkbType::polygon:
      case WkbType::triangle: return read_rings(*kind);
      case WkbType::curve_polygon:
        shapes_.begin_polygon();
        return read_parts([&]() -> Expected<void> {
          auto done = read_curve(depth + 1);
          shapes_.end_ring();
          return done;
        });
      default: return read_parts([&] { return read_geometry(depth + 1); });
    }
  }

  template <class Read>
  Expected<void> read_parts(Read read_part) {
    const auto count = read_count(kGeometryHeader + 4);
    if (!count) return std::unexpected(count.error());
    for (std::uint32_t i = 0; i < *count; ++i)
      if (Expected<void> done = read_part(); !done) return done;
    return {};
  }

  const std::string& name_;
  ReadJob& job_;
  std::string_view bytes_;
  std::uint64_t line_ = 0;
  std::size_t at_ = 0;
  bool is_little_ = true;
  MapShapes shapes_;
  Magnitudes seen_;
  bool has_heights_ = false;
};

int digit_of(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

/// The digits of a line, without blanks, quotes and the prefixes of databases.
std::string_view hex_digits_of(std::string_view line) {
  constexpr std::string_view kAround = " \t\v\f\"'";
  line.remove_prefix(std::min(line.find_first_not_of(kAround), line.size()));
  line = line.substr(0, line.find_last_not_of(kAround) + 1);
  for (const std::string_view prefix : {"\\\\x", "\\x", "0x", "0X"})
    if (line.starts_with(prefix)) return line.substr(prefix.size());
  return line;
}

/// Whether there is a valid header at the beginning, with room for the announced content.
bool begins_geometry(std::string_view bytes, std::size_t size) {
  if (bytes.size() < kGeometryHeader || static_cast<unsigned char>(bytes[0]) > 1) return false;
  std::uint32_t code = 0;
  std::memcpy(&code, bytes.data() + 1, sizeof code);
  const bool is_little = bytes[0] == 1;
  if (is_little != (std::endian::native == std::endian::little)) code = std::byteswap(code);
  const auto kind = kind_of(code);
  if (!kind) return false;
  const std::size_t head = kGeometryHeader + (kind->has_system ? 4 : 0);
  return size >= head + (kind->type == WkbType::point ? 8 * kind->numbers : 4);
}

std::string_view without_blank_lines(std::string_view bytes) {
  bytes = without_bom(bytes);
  bytes.remove_prefix(std::min(bytes.find_first_not_of(" \t\r\n"), bytes.size()));
  return bytes;
}

Match match_wkb(std::string_view bytes) {
  return begins_geometry(bytes, bytes.size()) || is_hexadecimal_wkb(without_blank_lines(bytes)) ? Match::surely
                                                                                                : Match::no;
}

Expected<LoadedFile> read_wkb(std::string_view bytes, const std::string& name, const ReadRequest& request,
                              const std::filesystem::path*, ReadJob& job) {
  WkbReader reader(name, request, job);
  if (begins_geometry(bytes, bytes.size())) {
    if (auto done = reader.read(bytes, 0); !done) return std::unexpected(done.error());
    return std::move(reader).load();
  }
  std::string geometry;
  std::string_view rest = without_bom(bytes);
  for (std::uint64_t number = 1; !rest.empty(); ++number) {
    job.passed(rest.data());
    const std::size_t end = end_of_line(rest);
    const std::string_view line = rest.substr(0, end);
    rest.remove_prefix(std::min(end + (rest.substr(end).starts_with("\r\n") ? 2 : 1), rest.size()));
    const std::string_view digits = hex_digits_of(line);
    if (digits.empty()) continue;
    geometry.clear();
    for (std::size_t i = 0; i < digits.size(); i += 2) {
      const std::size_t wrong = digit_of(digits[i]) < 0 ? i : i + 1;
      const auto column = static_cast<std::uint64_t>(digits.data() + wrong - line.data()) + 1;
      if (wrong == digits.size()) return bad_input("the line ends within a byte", name, number, column);
      if (digit_of(digits[wrong]) < 0)
        return bad_input(fmt::format("expected a hexadecimal digit, found {}", in_quotes(digits.substr(wrong, 1))),
                         name, number, column);
      geometry += static_cast<char>(16 * digit_of(digits[i]) + digit_of(digits[i + 1]));
    }
    if (auto done = reader.read(geometry, number); !done) return std::unexpected(done.error());
  }
  return std::move(reader).load();
}

}  // namespace

bool is_hexadecimal_wkb(std::string_view text) {
  const std::string_view digits = hex_digits_of(text.substr(0, end_of_line(text)));
  if (digits.size() < 2 * kGeometryHeader || digits.size() % 2 != 0 ||
      !std::ranges::all_of(digits, [](char c) { return digit_of(c) >= 0; }))
    return false;
  std::string head;
  for (std::size_t i = 0; i < kGeometryHeader; ++i)
    head += static_cast<char>(16 * digit_of(digits[2 * i]) + digit_of(digits[2 * i + 1]));
  return begins_geometry(head, digits.size() / 2);
}

Format wkb_format() {
  return {.descriptor = {.id = "wkb",
                         .name = "WKB, well-known binary, also in hexadecimal digits",
                         .extensions = {".wkb"},
                         .can_read = true,
                         .is_map = true},
          .match = match_wkb,
          .read_map = read_wkb,
          .may_look_foreign = true};
}

}  // namespace mes
