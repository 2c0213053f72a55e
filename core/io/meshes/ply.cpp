// SPDX-License-Identifier: GPL-3.0-or-later
// PLY of Stanford, seen from above or in the common plane of the vertices, as text and in both binary orders: the
// elements vertex (x, y, z), face (vertex_indices) and edge (vertex1, vertex2).
#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <optional>

#include "core/io/format_spec.h"
#include "core/io/meshes/vertex_graph.h"
#include "core/io/text/line_words.h"
#include "core/io/text/written_decimals.h"

namespace mes {
namespace {

enum class PlyType : std::uint8_t { i8, u8, i16, u16, i32, u32, f32, f64 };

std::optional<PlyType> ply_type_named(std::string_view word) {
  using Entry = std::pair<std::string_view, PlyType>;
  constexpr std::array<Entry, 16> kTypes{{{"char", PlyType::i8},
                                          {"int8", PlyType::i8},
                                          {"uchar", PlyType::u8},
                                          {"uint8", PlyType::u8},
                                          {"short", PlyType::i16},
                                          {"int16", PlyType::i16},
                                          {"ushort", PlyType::u16},
                                          {"uint16", PlyType::u16},
                                          {"int", PlyType::i32},
                                          {"int32", PlyType::i32},
                                          {"uint", PlyType::u32},
                                          {"uint32", PlyType::u32},
                                          {"float", PlyType::f32},
                                          {"float32", PlyType::f32},
                                          {"double", PlyType::f64},
                                          {"float64", PlyType::f64}}};
  const auto found = std::ranges::find(kTypes, word, &Entry::first);
  return found == kTypes.end() ? std::nullopt : std::optional(found->second);
}

struct Property {
  std::string name;
  PlyType type = PlyType::f32;
  std::optional<PlyType> count_type{};  // type of the length of a list
};

struct Element {
  std::string name;
  std::uint64_t count = 0;
  std::vector<Property> properties{};

  std::optional<std::size_t> index_of(std::string_view name_wanted) const {
    const auto found = std::ranges::find(properties, name_wanted, &Property::name);
    if (found == properties.end()) return std::nullopt;
    return static_cast<std::size_t>(found - properties.begin());
  }
};

enum class Encoding : std::uint8_t { text, little, big };

struct PlyHeader {
  Encoding encoding = Encoding::text;
  std::vector<Element> elements{};
};

std::unexpected<Error> expected_word(const LineWords& lines, std::size_t i, std::string_view what) {
  if (i >= lines.count()) return lines.refuse(i, fmt::format("expected {}, found the end of the line", what));
  return lines.refuse(i, fmt::format("expected {}, found {}", what, in_quotes(lines.word(i))));
}

Expected<Property> read_property(const LineWords& lines) {
  Property out;
  std::size_t at = 1;
  if (lines.word(at) == "list") {
    out.count_type = ply_type_named(lines.word(2));
    if (!out.count_type || *out.count_type == PlyType::f32 || *out.count_type == PlyType::f64)
      return expected_word(lines, 2, "a type of whole numbers");
    at = 3;
  }
  const auto type = ply_type_named(lines.word(at));
  if (!type) return expected_word(lines, at, "a type such as float");
  if (lines.count() <= at + 1) return expected_word(lines, at + 1, "the name of a property");
  out.type = *type;
  out.name = lines.word(at + 1);
  return out;
}

/// Leaves `lines` at "end_header".
Expected<PlyHeader> read_header(LineWords& lines) {
  PlyHeader out;
  if (!lines.next() || lines.word(0) != "ply") return expected_word(lines, 0, "ply");
  const auto is_remark = [&] { return lines.word(0) == "comment" || lines.word(0) == "obj_info"; };
  bool has_more = lines.next();
  while (has_more && is_remark()) has_more = lines.next();
  if (!has_more || lines.word(0) != "format") return expected_word(lines, 0, "the format");
  if (lines.word(1) == "binary_little_endian") {
    out.encoding = Encoding::little;
  } else if (lines.word(1) == "binary_big_endian") {
    out.encoding = Encoding::big;
  } else if (lines.word(1) != "ascii") {
    return expected_word(lines, 1, "ascii, binary_little_endian or binary_big_endian");
  }
  while (lines.next()) {
    const std::string_view word = lines.word(0);
    if (word == "end_header") return out;
    if (is_remark()) continue;
    if (word == "element") {
      if (lines.count() < 2) return expected_word(lines, 1, "the name of an element");
      const auto count = lines.whole(2, "the number of elements");
      if (!count) return std::unexpected(count.error());
      out.elements.push_back({std::string(lines.word(1)), *count});
      continue;
    }
    if (word != "property") return expected_word(lines, 0, "element, property or end_header");
    if (out.elements.empty()) return lines.refuse(0, "a property without an element");
    auto property = read_property(lines);
    if (!property) return std::unexpected(property.error());
    out.elements.back().properties.push_back(*std::move(property));
  }
  return lines.refuse(0, "the header has no end");
}

/// Reads the values of the body in order.
class Values {
 public:
  Values(LineWords& lines, Encoding encoding, const std::string& name, std::size_t size, ReadJob& job)
      : lines_(lines), encoding_(encoding), name_(name), job_(job), bytes_(lines.rest()), size_(size) {
    if (encoding_ == Encoding::text) word_ = lines_.count();
  }

  /// Sets the current element, for messages. Throws `Cancelled`.
  void set_place(std::string_view element, std::uint64_t index) {
    element_ = element;
    index_ = index;
    fault_.reset();
    begin_ = size_ - bytes_.size();
    if (encoding_ != Encoding::text) job_.passed(bytes_.data());
  }

  /// Refuses only a missing value or one that is not a number.
  Expected<double> next(PlyType type) {
    if (encoding_ == Encoding::text) return next_word();
    constexpr std::array<std::size_t, 8> kSizes{1, 1, 2, 2, 4, 4, 4, 8};
    const std::size_t size = kSizes[static_cast<std::size_t>(type)];
    if (bytes_.size() < size) return refuse(fmt::format("the file ends within {} {}", printable(element_), index_));
    const std::string_view value = bytes_.substr(0, size);
    bytes_.remove_prefix(size);
    switch (type) {
      case PlyType::i8: return static_cast<double>(static_cast<std::int8_t>(value[0]));
      case PlyType::u8: return static_cast<double>(static_cast<std::uint8_t>(value[0]));
      case PlyType::i16: return static_cast<double>(static_cast<std::int16_t>(bits<std::uint16_t>(value)));
      case PlyType::u16: return static_cast<double>(bits<std::uint16_t>(value));
      case PlyType::i32: return static_cast<double>(static_cast<std::int32_t>(bits<std::uint32_t>(value)));
      case PlyType::u32: return static_cast<double>(bits<std::uint32_t>(value));
      case PlyType::f32: return static_cast<double>(std::bit_cast<float>(bits<std::uint32_t>(value)));
      case PlyType::f64: return std::bit_cast<double>(bits<std::uint64_t>(value));
    }
    return 0.0;
  }

  /// The largest rounding error of a coordinate in text.
  double rounding() const { return decimals_.rounding(); }
  /// Call after all elements: a remark if more text follows.
  std::optional<std::string> remark_on_rest() {
    if (encoding_ != Encoding::text || (word_ >= lines_.count() && !next_line())) return std::nullopt;
    return lines_.remark(word_, "everything after the announced elements is ignored");
  }

  /// Error at the last value read in text, at the next value in bytes.
  std::unexpected<Error> refuse(std::string text) const { return refuse_at(size_ - bytes_.size(), std::move(text)); }
  /// Error at the beginning of the element in bytes.
  std::unexpected<Error> refuse_value(const std::string& text) const {
    return refuse_at(begin_, fmt::format("{} {}: {}", printable(element_), index_, text));
  }
  /// The same; in text, a value that is not finite is refused at its own position, quoted as written.
  std::unexpected<Error> refuse_value(double value, const std::string& text) const {
    return !std::isfinite(value) && fault_ ? std::unexpected(*fault_) : refuse_value(text);
  }

 private:
  std::unexpected<Error> refuse_at(std::size_t place, std::string text) const {
    if (encoding_ == Encoding::text) return lines_.refuse(word_ == 0 ? 0 : word_ - 1, std::move(text));
    return bad_input(fmt::format("at byte {}: {}", place, text), name_, 0, 0);
  }

  bool next_line() {
    word_ = 0;
    return lines_.next();
  }

  Expected<double> next_word() {
    while (word_ >= lines_.count()) {
      if (!next_line())
        return lines_.refuse(0, fmt::format("the file ends within {} {}", printable(element_), index_));
    }
    // The meaning of the number decides later whether it may be infinite.
    const std::string_view word = lines_.word(word_++);
    const auto value = parse_number(word);
    decimals_.add({&word, 1});
    if (value) return *value;
    if (value.error() == NumberFault::not_a_number) return refuse(describe(value.error(), word));
    if (!fault_) fault_ = refuse_value(describe(value.error(), word)).error();
    return std::nan("");
  }

  template <class Bits>
  Bits bits(std::string_view value) const {
    Bits out = 0;
    std::memcpy(&out, value.data(), sizeof out);
    const bool is_native = (std::endian::native == std::endian::little) == (encoding_ == Encoding::little);
    return is_native ? out : std::byteswap(out);
  }

  LineWords& lines_;
  Encoding encoding_;
  const std::string& name_;
  ReadJob& job_;
  std::string_view bytes_;
  std::size_t size_;
  std::size_t word_ = 0;
  std::string_view element_;
  std::uint64_t index_ = 0;
  VertexDecimals decimals_;
  std::size_t begin_ = 0;         // start of the element in bytes
  std::optional<Error> fault_{};  // the first value of the element that is not finite, quoted as written
};

class PlyReader {
 public:
  PlyReader(std::string_view bytes, const std::string& name, ReadJob& job)
      : lines_(bytes, name, &job), size_(bytes.size()), name_(name), job_(job) {}

  Expected<LoadedFile> read() {
    const auto header = read_header(lines_);
    if (!header) return std::unexpected(header.error());
    Values values(lines_, header->encoding, name_, size_, job_);
    for (const Element& element : header->elements) {
      if (element.properties.empty()) continue;
      auto done = element.name == "vertex" ? read_vertices(element, values)
                  : element.name == "face" ? read_faces(element, values)
                  : element.name == "edge" ? read_edges(element, values)
                                           : skip(element, values);
      if (!done) return std::unexpected(done.error());
    }
    if (const auto rest = values.remark_on_rest()) remarks_.push_back(*rest);
    if (std::string text = graph_.leave_heights_out(values.rounding()); !text.empty()) remark(std::move(text));
    auto file = std::move(graph_).load(name_, job_);
    if (file) file->warnings.insert(file->warnings.end(), remarks_.begin(), remarks_.end());
    return file;
  }

 private:
  void remark(std::string text) { remarks_.push_back(Error{ErrorCode::bad_input, std::move(text), name_}.message()); }

  /// Number of values of a property; reads and checks the length of a list.
  Expected<std::size_t> length_of(const Property& property, Values& values) {
    if (!property.count_type) return 1;
    const auto count = values.next(*property.count_type);
    if (!count) return std::unexpected(count.error());
    if (!(*count >= 0.0 && *count <= static_cast<double>(kMostVertices) && *count == std::floor(*count)))
      return values.refuse_value("a list has no such length");
    return static_cast<std::size_t>(*count);
  }

  /// Calls `use(index of the property, value)` for each value of one element.
  template <class Use>
  Expected<void> read_row(const Element& element, Values& values, Use use) {
    for (std::size_t p = 0; p < element.properties.size(); ++p) {
      const Property& property = element.properties[p];
      const auto length = length_of(property, values);
      if (!length) return std::unexpected(length.error());
      for (std::size_t i = 0; i < *length; ++i) {
        const auto value = values.next(property.type);
        if (!value) return std::unexpected(value.error());
        use(p, *value);
      }
    }
    return {};
  }

  Expected<void> read_vertices(const Element& element, Values& values) {
    const auto x = element.index_of("x");
    const auto y = element.index_of("y");
    const auto z = element.index_of("z");
    if (!x || !y) return values.refuse("vertices have no x and y");
    if (element.count > kMostVertices) return values.refuse("these are too many vertices");
    for (std::uint64_t i = 0; i < element.count; ++i) {
      values.set_place(element.name, i);
      Vec2 position;
      double height = 0.0;
      auto done = read_row(element, values, [&](std::size_t property, double value) {
        if (property == *x) position.x = value;
        if (property == *y) position.y = value;
        if (property == z) height = value;
      });
      if (!done) return done;
      for (const double value : {position.x, position.y}) {
        if (const auto fault = seen_.fault_of(value))
          return values.refuse_value(value, describe(*fault, value, seen_));
        seen_.add(value);
      }
      if (z)
        graph_.add_vertex(position, height);
      else
        graph_.add_vertex(position);
    }
    return {};
  }

  Expected<std::uint32_t> vertex(double value, const Values& values) const {
    if (value >= 0.0 && value < static_cast<double>(graph_.vertex_count()) && value == std::floor(value))
      return static_cast<std::uint32_t>(value);
    return values.refuse_value(value, fmt::format("there is no vertex {} before it", value));
  }

  Expected<void> read_faces(const Element& element, Values& values) {
    auto corners = element.index_of("vertex_indices");
    if (!corners) corners = element.index_of("vertex_index");
    if (!corners) return skip(element, values);
    std::vector<double> numbers;
    std::vector<std::uint32_t> face;
    for (std::uint64_t i = 0; i < element.count; ++i) {
      values.set_place(element.name, i);
      numbers.clear();
      auto done = read_row(element, values, [&](std::size_t property, double value) {
        if (property == *corners) numbers.push_back(value);
      });
      if (!done) return done;
      face.clear();
      for (const double number : numbers) {
        const auto corner = vertex(number, values);
        if (!corner) return std::unexpected(corner.error());
        face.push_back(*corner);
      }
      if (face.size() == 2) graph_.add_segment(face[0], face[1]);
      if (face.size() > 2) graph_.add_face(face);
    }
    return {};
  }

  Expected<void> read_edges(const Element& element, Values& values) {
    const auto first = element.index_of("vertex1");
    const auto second = element.index_of("vertex2");
    if (!first || !second) return skip(element, values);
    for (std::uint64_t i = 0; i < element.count; ++i) {
      values.set_place(element.name, i);
      double from = -1.0;
      double to = -1.0;
      auto done = read_row(element, values, [&](std::size_t property, double value) {
        if (property == *first) from = value;
        if (property == *second) to = value;
      });
      if (!done) return done;
      const auto a = vertex(from, values);
      if (!a) return std::unexpected(a.error());
      const auto b = vertex(to, values);
      if (!b) return std::unexpected(b.error());
      graph_.add_segment(*a, *b);
    }
    return {};
  }

  Expected<void> skip(const Element& element, Values& values) {
    if (element.count != 0)
      remark(fmt::format("{} {} {} left out", element.count, element.count == 1 ? "element" : "elements",
                         in_quotes(element.name) + (element.count == 1 ? " is" : " are")));
    for (std::uint64_t i = 0; i < element.count; ++i) {
      values.set_place(element.name, i);
      if (auto done = read_row(element, values, [](std::size_t, double) {}); !done) return done;
    }
    return {};
  }

  LineWords lines_;
  std::size_t size_;
  const std::string& name_;
  ReadJob& job_;
  VertexGraph graph_;
  Magnitudes seen_;
  std::vector<std::string> remarks_;
};

Match match_ply(std::string_view bytes) {
  const bool is_ply = bytes.starts_with("ply\n") || bytes.starts_with("ply\r");
  return is_ply ? Match::surely : Match::no;
}

Expected<LoadedFile> read_ply(std::string_view bytes, const std::string& name, ReadJob& job) {
  return PlyReader(bytes, name, job).read();
}

}  // namespace

Format ply_format() {
  return {.descriptor = {.id = "ply", .name = "PLY, from above", .extensions = {".ply"}, .can_read = true},
          .match = match_ply,
          .read = read_ply,
          .may_look_foreign = true};
}

}  // namespace mes
