// SPDX-License-Identifier: GPL-3.0-or-later
// WKT, well-known text (OGC 06-103r4, section 7, with the curves of ISO 19125-2 and SQL/MM): any number of geometries
// in sequence, optionally separated by line breaks, commas or semicolons. Heights and measures (Z, M) are left out. A
// code before a geometry, as `SRID=25832;` (the notation of PostGIS), is that of the coordinate system of all;
// otherwise positions are coordinates of the plane.
#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <cstdint>
#include <optional>
#include <utility>

#include "core/base/lower_case.h"
#include "core/io/format_spec.h"
#include "core/io/maps/map_features.h"
#include "core/io/maps/map_shapes.h"
#include "core/io/text/ascii_text.h"
#include "core/io/text/text_numbers.h"

namespace mes {
namespace {

constexpr int kDeepestWkt = 64;

enum class WktShape : std::uint8_t { point, line, ring, curve, curved_ring, surface, any };

/// `depth` is the number of parentheses around the list of positions.
struct WktType {
  std::string_view name;
  int depth;
  WktShape shape;
};
constexpr std::array<WktType, 15> kWktTypes{{{"point", 0, WktShape::point},
                                             {"multipoint", 0, WktShape::point},
                                             {"linestring", 0, WktShape::line},
                                             {"multilinestring", 1, WktShape::line},
                                             {"polygon", 1, WktShape::ring},
                                             {"multipolygon", 2, WktShape::ring},
                                             {"triangle", 1, WktShape::ring},
                                             {"tin", 2, WktShape::ring},
                                             {"polyhedralsurface", 2, WktShape::ring},
                                             {"circularstring", 0, WktShape::curve},
                                             {"compoundcurve", 0, WktShape::curve},
                                             {"multicurve", 1, WktShape::curve},
                                             {"curvepolygon", 1, WktShape::curved_ring},
                                             {"multisurface", 1, WktShape::surface},
                                             {"geometrycollection", 0, WktShape::any}}};

/// Iterates over parentheses, commas and words.
class Words {
 public:
  explicit Words(std::string_view text) : text_(text) { skip_blanks(); }

  bool is_at_end() const { return at_ == text_.size(); }
  /// The next sign, or 0 at the end.
  char sign() const { return is_at_end() ? '\0' : text_[at_]; }
  bool take(char sign_wanted) {
    if (sign() != sign_wanted || is_at_end()) return false;
    ++at_;
    skip_blanks();
    return true;
  }
  /// The text up to the next blank or sign; empty at a sign and at the end.
  std::string_view word() const {
    const std::string_view rest = text_.substr(at_);
    const auto end = std::ranges::find_if(
        rest, [](char c) { return is_blank(c) || c == '(' || c == ')' || c == ',' || c == ';' || c == '='; });
    return rest.substr(0, static_cast<std::size_t>(end - rest.begin()));
  }
  void skip_word() {
    at_ += word().size();
    skip_blanks();
  }
  std::size_t place() const { return at_; }
  std::size_t end_of_line() const { return std::min(text_.find_first_of("\r\n", at_), text_.size()); }
  /// Goes to a place unless it lies behind, and past blanks.
  void go_past(std::size_t place) {
    at_ = std::max(at_, place);
    skip_blanks();
  }

 private:
  void skip_blanks() {
    while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
  }
  std::string_view text_;
  std::size_t at_ = 0;
};

bool is_srid(std::string_view word) {
  return lower_case(word.substr(0, 5)) == "srid";
}

const WktType* wkt_type_named(std::string_view word) {
  constexpr std::size_t kLongest = 32;
  std::string name = lower_case(word.substr(0, kLongest));
  const auto find = [](std::string_view wanted) {
    const auto found = std::ranges::find(kWktTypes, wanted, &WktType::name);
    return found == kWktTypes.end() ? nullptr : &*found;
  };
  if (const WktType* found = find(name)) return found;
  // "POINTZ" is also a valid spelling.
  for (int i = 0; i < 2 && (name.ends_with('z') || name.ends_with('m')); ++i) name.pop_back();
  return find(name);
}

class WktReader {
 public:
  WktReader(std::string_view text, const std::string& name, const ReadRequest& request, ReadJob& job)
      : text_(text), name_(name), job_(job), words_(text), shapes_(request) {}

  Expected<LoadedFile> read() {
    while (!words_.is_at_end()) {
      if (auto done = read_reference_system(); !done) return std::unexpected(done.error());
      if (auto done = read_geometry(0); !done) return std::unexpected(done.error());
      while (words_.take(';') || words_.take(',')) continue;
    }
    auto file = std::move(shapes_).load(name_, job_);
    if (file && first_height_)
      file->warnings.push_back(bad("heights and measures are left out", *first_height_).error().message());
    return file;
  }

 private:
  std::unexpected<Error> bad(std::string text, std::size_t place) const {
    std::uint64_t line = 1;
    std::size_t start = 0;
    for (std::size_t i = 0; i < place; ++i) {
      const bool is_pair = text_[i] == '\r' && i + 1 < text_.size() && text_[i + 1] == '\n';
      if ((text_[i] != '\n' && text_[i] != '\r') || is_pair) continue;
      ++line;
      start = i + 1;
    }
    return bad_input(std::move(text), name_, line, place - start + 1);
  }

  std::unexpected<Error> unexpected_here(std::string_view wanted) const {
    if (words_.is_at_end()) return bad(fmt::format("expected {}, found the end", wanted), words_.place());
    const std::string_view word = words_.word();
    const char sign = words_.sign();
    return bad(
        fmt::format("expected {}, found {}", wanted, in_quotes(word.empty() ? std::string_view(&sign, 1) : word)),
        words_.place());
  }

  Expected<void> read_reference_system() {
    if (!is_srid(words_.word())) return {};
    words_.skip_word();
    if (!words_.take('=')) return unexpected_here("\"=\" after SRID");
    const std::size_t place = words_.place();
    const auto number = parse_count(words_.word());
    if (!number) return unexpected_here("the number of a reference system");
    words_.skip_word();
    if (!words_.take(';')) return unexpected_here("\";\" after the reference system");
    if (auto done = shapes_.name_srid(*number); !done) return bad(done.error().text, place);
    return {};
  }

  Expected<void> read_geometry(int depth) {
    const WktType* const type = wkt_type_named(words_.word());
    if (type == nullptr) return unexpected_here("a geometry such as POLYGON");
    if (depth > kDeepestWkt) return bad("collections are nested too deeply", words_.place());
    if (type->shape == WktShape::curve && type->depth == 0) {
      if (auto done = read_curve(); !done) return done;
      shapes_.end_line();
      return {};
    }
    skip_type();
    switch (type->shape) {
      case WktShape::curve: return read_list([&] { return read_whole_curve(false); });
      case WktShape::curved_ring: shapes_.begin_polygon(); return read_list([&] { return read_whole_curve(true); });
      case WktShape::surface: return read_list([&] { return read_surface(depth + 1); });
      case WktShape::any: return read_list([&] { return read_geometry(depth + 1); });
      default: return read_lists(*type, type->depth);
    }
  }

  /// Skips the name and the letters of its dimensions.
  void skip_type() {
    words_.skip_word();
    for (std::string word = word_in_lower_case(); word == "z" || word == "m" || word == "zm";
         word = word_in_lower_case())
      words_.skip_word();
  }

  Expected<void> read_whole_curve(bool is_ring) {
    if (auto done = read_curve(); !done) return done;
    if (is_ring)
      shapes_.end_ring();
    else
      shapes_.end_line();
    return {};
  }

  /// Reads a polygon of a set, with or without its name.
  Expected<void> read_surface(int depth) {
    constexpr WktType kPolygon{"polygon", 1, WktShape::ring};
    return words_.sign() == '(' ? read_lists(kPolygon, kPolygon.depth) : read_geometry(depth);
  }

  /// Reads a line (with or without its name), arcs, or several of these in sequence.
  Expected<void> read_curve() {
    const std::string_view name = words_.word();
    if (name.empty()) return read_list([&] { return read_position(); });
    const WktType* const type = wkt_type_named(name);
    const std::string_view kind = type == nullptr ? std::string_view{} : type->name;
    if (kind != "linestring" && kind != "circularstring" && kind != "compoundcurve")
      return unexpected_here("a curve such as CIRCULARSTRING");
    skip_type();
    if (kind == "linestring") return read_list([&] { return read_position(); });
    if (kind == "circularstring") return read_arcs();
    joins_ = true;
    auto done = read_list([&]() -> Expected<void> {
      const WktType* const part = wkt_type_named(words_.word());
      if (part != nullptr && part->name == "compoundcurve")
        return unexpected_here("a line or CIRCULARSTRING, which are parts of a COMPOUNDCURVE,");
      return read_curve();
    });
    joins_ = false;
    return done;
  }

  /// Reads arcs, each through one position to another.
  Expected<void> read_arcs() {
    std::optional<Vec2> through;
    const std::size_t before = shapes_.length();
    const std::size_t place = words_.place();
    bool is_first = true;
    auto done = read_list([&]() -> Expected<void> {
      if (std::exchange(is_first, false)) return read_position();
      const auto position = parse_position();
      if (!position) return std::unexpected(position.error());
      if (!through) {
        through = *position;
      } else {
        shapes_.add_arc(*std::exchange(through, std::nullopt), *position);
      }
      return {};
    });
    if (!done) return done;
    const bool is_single = !is_first && !through && shapes_.length() == before + 1 && before == 0;
    if (through || is_single)
      return bad("a CIRCULARSTRING has three positions, or two more for each other arc", place);
    return {};
  }

  std::string word_in_lower_case() const {
    constexpr std::size_t kLongest = 8;
    return lower_case(words_.word().substr(0, kLongest));
  }

  /// "EMPTY", or a list of elements in parentheses, separated by commas.
  template <class ReadElement>
  Expected<void> read_list(ReadElement read_element) {
    if (word_in_lower_case() == "empty") {
      words_.skip_word();
      return {};
    }
    if (!words_.take('(')) return unexpected_here("\"(\" or EMPTY");
    do {
      if (Expected<void> done = read_element(); !done) return done;
    } while (words_.take(','));
    if (!words_.take(')')) return unexpected_here("\",\" or \")\"");
    return {};
  }

  Expected<void> read_lists(const WktType& type, int depth) {
    if (depth == 1 && type.shape == WktShape::ring) shapes_.begin_polygon();
    if (depth > 0) return read_list([&] { return read_lists(type, depth - 1); });
    auto done = read_list([&] { return type.shape == WktShape::point ? read_point() : read_position(); });
    if (!done) return done;
    switch (type.shape) {
      case WktShape::line: shapes_.end_line(); break;
      case WktShape::ring: shapes_.end_ring(); break;
      default: shapes_.end_points(); break;
    }
    return {};
  }

  /// Points of a MULTIPOINT may have parentheses, and may be EMPTY.
  Expected<void> read_point() {
    if (words_.sign() == '(' || word_in_lower_case() == "empty") return read_list([&] { return read_position(); });
    return read_position();
  }

  /// The first position of a curve part is the end of the previous part.
  Expected<void> read_position() {
    const auto position = parse_position();
    if (!position) return std::unexpected(position.error());
    if (shapes_.length() == 0 || shapes_.last() != *position || !joins_) shapes_.add(*position);
    return {};
  }

  Expected<Vec2> parse_position() {
    job_.passed(text_.data() + words_.place());
    std::array<double, 2> numbers{};
    for (double& number : numbers) {
      if (words_.word().empty()) return unexpected_here("a number");
      auto value = coordinates_.read(words_.word());
      if (!value) return bad(std::move(value.error()), words_.place());
      number = *value;
      words_.skip_word();
    }
    constexpr int kMost = 2;
    for (int i = 0; i < kMost && !words_.word().empty(); ++i) {
      // A measure may be missing ("nan").
      const auto value = parse_number(words_.word());
      if (!value && value.error() == NumberFault::not_a_number) return unexpected_here("a number");
      if (!first_height_) first_height_ = words_.place();
      words_.skip_word();
    }
    return Vec2{numbers[0], numbers[1]};
  }

  std::string_view text_;
  const std::string& name_;
  ReadJob& job_;
  Words words_;
  MapShapes shapes_;
  CoordinateReader coordinates_;
  std::optional<std::size_t> first_height_;
  bool joins_ = false;  // the parts of a curve share their ends
};

Match match_wkt(std::string_view bytes) {
  return begins_wkt(without_bom(bytes)) ? Match::surely : Match::no;
}

Expected<LoadedFile> read_wkt(std::string_view bytes, const std::string& name, const ReadRequest& request,
                              const std::filesystem::path*, ReadJob& job) {
  return WktReader(without_bom(bytes), name, request, job).read();
}

/// Passes a code such as `SRID=25832;`, and returns whether there is a valid one.
bool skip_srid(Words& words) {
  if (!is_srid(words.word())) return false;
  words.skip_word();
  if (!words.take('=')) return false;
  const bool is_valid = parse_count(words.word()).has_value();
  words.skip_word();
  return words.take(';') && is_valid;
}

/// Passes a geometry, or the rest of the line if there is none.
void skip_geometry(Words& words) {
  const auto is_at = [&](std::string_view wanted) { return lower_case(words.word().substr(0, 6)) == wanted; };
  const std::size_t end_of_line = words.end_of_line();
  const bool is_known = wkt_type_named(words.word()) != nullptr;
  if (is_known) words.skip_word();
  while (is_at("z") || is_at("m") || is_at("zm")) words.skip_word();
  if (is_known && is_at("empty")) return words.skip_word();
  if (!is_known || words.sign() != '(') return words.go_past(end_of_line);
  std::size_t depth = 0;
  do {
    if (words.take('(')) {
      ++depth;
    } else if (words.take(')')) {
      --depth;
    } else if (!words.word().empty()) {
      words.skip_word();
    } else {
      words.take(words.sign());
    }
  } while (depth > 0 && !words.is_at_end());
}

}  // namespace

bool begins_wkt(std::string_view text) {
  Words words(text);
  if (is_srid(words.word())) {
    words.skip_word();
    return words.sign() == '=';
  }
  if (words.is_at_end() || !is_letter(words.sign()) || wkt_type_named(words.word()) == nullptr) return false;
  words.skip_word();
  const std::string next = lower_case(words.word().substr(0, 6));
  return words.sign() == '(' || next == "empty" || next == "z" || next == "m" || next == "zm";
}

std::string_view srid_of_wkt(std::string_view text) {
  Words words(text);
  return skip_srid(words) ? text.substr(0, words.place()) : std::string_view();
}

std::vector<MapFeature> wkt_features(std::string_view bytes) {
  const std::string_view text = without_bom(bytes);
  Words words(text);
  std::vector<MapFeature> out;
  std::string_view code;             // the first of the file
  std::vector<std::size_t> without;  // indices of features without a code of their own
  while (!words.is_at_end()) {
    const std::size_t begin = words.place();
    const bool has_code = skip_srid(words);
    if (has_code && code.empty()) code = text.substr(begin, words.place() - begin);
    if (words.place() == begin) without.push_back(out.size());
    skip_geometry(words);
    MapFeature& feature = out.emplace_back();
    feature.text = text.substr(begin, words.place() - begin);
    while (words.take(';') || words.take(',')) continue;
  }
  for (const std::size_t i : without) out[i].text.insert(0, code);
  return out;
}

Format wkt_format() {
  return {.descriptor =
              {.id = "wkt", .name = "WKT, well-known text", .extensions = {".wkt"}, .can_read = true, .is_map = true},
          .match = match_wkt,
          .read_map = read_wkt};
}

}  // namespace mes
