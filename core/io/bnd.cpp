// SPDX-License-Identifier: GPL-3.0-or-later
// file    := i32 0xB3, i32 1, { QString name, QByteArray bundle }
// bundle  := i32 0xB2, i32 1, { QString layer, QByteArray state }      bottom layer first
// state   := i32 0xB1, i32 2, QColor, float point_size, float line_width, u8 active, QString colour_map, [ tail ]
// tail    := image name as a QString or as a C string, u8 rescale      since 2009, under the same version number
// QString := u32 bytes (all ones: null), UTF-16;  QByteArray := u32 bytes (all ones: null), bytes
// QColor  := u8 specification (1: RGB), u16 alpha, red, green, blue, padding
#include "core/io/bnd.h"

#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <optional>
#include <set>

#include "core/io/text/text_numbers.h"

namespace mes {
namespace {

constexpr std::uint32_t kFileToken = 0xB3;
constexpr std::uint32_t kBundleToken = 0xB2;
constexpr std::uint32_t kStateToken = 0xB1;
constexpr std::uint32_t kNull = 0xFFFFFFFF;
constexpr std::size_t kLongestText = 4096;
constexpr std::size_t kMostBndLayers = 1000;

struct Fault {
  std::string what;
  std::size_t byte = 0;
};
template <class T>
using Read = std::expected<T, Fault>;

/// Reads the bytes of a range in order and knows their position in the file.
class Stream {
 public:
  Stream(std::string_view bytes, std::size_t offset) : bytes_(bytes), offset_(offset) {}

  bool is_at_end() const { return at_ == bytes_.size(); }
  std::size_t rest() const { return bytes_.size() - at_; }
  std::unexpected<Fault> fail(std::string what) const {
    return std::unexpected(Fault{std::move(what), offset_ + at_});
  }

  Read<std::uint64_t> number(std::size_t bytes) {
    if (rest() < bytes) return fail("the file ends too early");
    std::uint64_t value = 0;
    for (const char c : bytes_.substr(at_, bytes)) value = value << 8U | static_cast<unsigned char>(c);
    at_ += bytes;
    return value;
  }

  /// A QByteArray as a stream of its own; null is empty.
  Read<Stream> block() {
    const auto length = number(4);
    if (!length) return std::unexpected(length.error());
    if (*length == kNull) return Stream({}, offset_ + at_);
    if (*length > rest()) return fail("a block is longer than the file");
    const Stream out(bytes_.substr(at_, *length), offset_ + at_);
    at_ += *length;
    return out;
  }

  /// A QString as UTF-8; null is empty.
  Read<std::string> text() {
    const auto length = number(4);
    if (!length) return std::unexpected(length.error());
    if (*length == kNull) return std::string();
    if (*length % 2 != 0 || *length > kLongestText || *length > rest()) return fail("the length of a text is wrong");
    std::string out;
    for (const std::size_t end = at_ + *length; at_ < end;) append(out, next_symbol(end));
    return out;
  }

  Read<void> token(std::uint32_t expected, std::uint32_t version, const char* what) {
    const auto found = number(4);
    if (!found) return std::unexpected(found.error());
    if (*found != expected) return fail(std::string("this is not ") + what);
    const auto of = number(4);
    if (!of) return std::unexpected(of.error());
    if (*of != version) return fail(fmt::format("version {} of {} is not known", *of, what));
    return {};
  }

 private:
  char32_t unit() {
    const auto high = static_cast<unsigned char>(bytes_[at_]);
    const auto low = static_cast<unsigned char>(bytes_[at_ + 1]);
    at_ += 2;
    return static_cast<char32_t>(high << 8U | low);
  }

  char32_t next_symbol(std::size_t end) {
    constexpr char32_t kReplacement = 0xFFFD;
    const char32_t first = unit();
    if (first < 0xD800 || first > 0xDFFF) return first;
    if (first > 0xDBFF || at_ == end) return kReplacement;
    const char32_t second = unit();
    if (second >= 0xDC00 && second <= 0xDFFF) return 0x10000 + ((first - 0xD800) << 10U) + (second - 0xDC00);
    at_ -= 2;
    return kReplacement;
  }

  static void append(std::string& out, char32_t symbol) {
    const auto put = [&out](char32_t byte) { out += static_cast<char>(static_cast<unsigned char>(byte)); };
    if (symbol < 0x80) {
      put(symbol);
    } else if (symbol < 0x800) {
      put(0xC0 | symbol >> 6U);
      put(0x80 | (symbol & 0x3FU));
    } else if (symbol < 0x10000) {
      put(0xE0 | symbol >> 12U);
      put(0x80 | (symbol >> 6U & 0x3FU));
      put(0x80 | (symbol & 0x3FU));
    } else {
      put(0xF0 | symbol >> 18U);
      put(0x80 | (symbol >> 12U & 0x3FU));
      put(0x80 | (symbol >> 6U & 0x3FU));
      put(0x80 | (symbol & 0x3FU));
    }
  }

  std::string_view bytes_;
  std::size_t offset_;
  std::size_t at_ = 0;
};

/// Most names map to our ids word by word; these are the exceptions.
struct Alias {
  std::string_view was;
  std::string_view id;
};
constexpr std::array<Alias, 13> kAliases{{{"local-crust", "curve"},
                                          {"a-medial-axis", "medial-axis"},
                                          {"a-onestep-medial-axis", "medial-axis"},
                                          {"full-medial-axis", "all-medial-axis"},
                                          {"a-inner-vertices", "a-inner-centers"},
                                          {"p-inner-poles", "p-inner-centers"},
                                          {"a-inner-ball-triangulation", "a-ball-triangulation"},
                                          {"p-inner-ball-triangulation", "p-ball-triangulation"},
                                          {"p-regular-triangulation", "polar-triangulation"},
                                          {"p-power-diagram", "polar-power-diagram"},
                                          {"a-v-crosssing-edges", "a-v-crossing-edges"},
                                          {"p-v-crosssing-edges", "p-v-crossing-edges"},
                                          {"christophes-moebius", "moebius-diagram"}}};

std::string layer_id_of(std::string_view name) {
  std::string out;
  for (const char c : name) {
    if (c == '\'') continue;
    const bool is_capital = c >= 'A' && c <= 'Z';
    out += c == ' ' ? '-' : is_capital ? static_cast<char>(c - 'A' + 'a') : c;
  }
  const auto alias = std::ranges::find(kAliases, std::string_view(out), &Alias::was);
  return alias == kAliases.end() ? out : std::string(alias->id);
}

/// Qt 4.6 and later write these as doubles unless configured otherwise.
Read<double> real(Stream& stream, std::size_t bytes) {
  const auto bits = stream.number(bytes);
  if (!bits) return std::unexpected(bits.error());
  const double value = bytes == 4 ? static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(*bits)))
                                  : std::bit_cast<double>(*bits);
  if (!std::isfinite(value)) return stream.fail("a size is not a number");
  return value;
}

Read<void> read_color(Stream& stream, LayerStyle& style) {
  const auto specification = stream.number(1);
  if (!specification) return std::unexpected(specification.error());
  if (*specification != 1) return stream.fail("a colour is not given as red, green and blue");
  std::array<std::uint64_t, 5> channels{};  // alpha, red, green, blue, padding
  for (std::uint64_t& channel : channels) {
    const auto value = stream.number(2);
    if (!value) return std::unexpected(value.error());
    channel = *value;
  }
  const auto byte = [&](std::size_t i) { return static_cast<std::uint8_t>((channels[i] + 128) / 257); };
  style.color = {byte(1), byte(2), byte(3)};
  constexpr double kFull = 65535.0;
  style.opacity = static_cast<double>(channels[0]) / kFull;
  return {};
}

/// The map's name, without the path and the extension of its file.
std::string map_name(std::string text) {
  if (const std::size_t slash = text.find_last_of("/\\"); slash != std::string::npos) text.erase(0, slash + 1);
  if (text.ends_with(".map")) text.resize(text.size() - 4);
  return text;
}

Read<LayerConfiguration::Entry> read_state(Stream stream, std::size_t bytes_of_real) {
  LayerConfiguration::Entry out;
  if (const auto good = stream.token(kStateToken, 2, "the state of a layer"); !good)
    return std::unexpected(good.error());
  if (const auto good = read_color(stream, out.style); !good) return std::unexpected(good.error());
  const auto point_size = real(stream, bytes_of_real);
  if (!point_size) return std::unexpected(point_size.error());
  const auto line_width = real(stream, bytes_of_real);
  if (!line_width) return std::unexpected(line_width.error());
  out.style.point_size_px = std::clamp(*point_size, 0.5, 64.0);
  out.style.line_width_px = std::clamp(*line_width, 0.1, 64.0);
  const auto active = stream.number(1);
  if (!active) return std::unexpected(active.error());
  if (*active > 1) return stream.fail("a layer is neither on nor off");
  out.visible = *active == 1;
  auto map = stream.text();
  if (!map) return std::unexpected(map.error());
  out.style.color_map = map_name(std::move(*map));
  if (stream.is_at_end()) return out;
  // The tail refers to pictures on old disks: it is skipped, but must be well-formed.
  if (const auto image = stream.block(); !image) return std::unexpected(image.error());
  if (const auto rescale = stream.number(1); !rescale) return std::unexpected(rescale.error());
  if (!stream.is_at_end()) return stream.fail("the state of a layer is too long");
  return out;
}

class BundleReader {
 public:
  explicit BundleReader(std::span<const KnownLayer> known) : known_(known) {}

  Read<LayerConfiguration> read(Stream stream) {
    LayerConfiguration out;
    if (const auto good = stream.token(kBundleToken, 1, "a bundle"); !good) return std::unexpected(good.error());
    bool has_all_balls = false;
    for (std::size_t count = 0; !stream.is_at_end(); ++count) {
      if (count == kMostBndLayers) return stream.fail("a bundle has too many layers");
      const auto name = stream.text();
      if (!name) return std::unexpected(name.error());
      const auto state = stream.block();
      if (!state) return std::unexpected(state.error());
      auto entry = read_state(*state, 4);
      if (!entry) {
        auto with_doubles = read_state(*state, 8);
        if (!with_doubles) return std::unexpected(entry.error());
        entry = std::move(with_doubles);
      }
      entry->layer = layer_id_of(*name);
      has_all_balls = has_all_balls || entry->layer == "a-regular-triangulation";
      add(out, std::move(*entry), *name);
    }
    if (!has_all_balls) tell_power_diagrams_apart(out);
    return out;
  }

  /// Names of layers that this program does not have.
  const std::set<std::string>& left_out() const { return left_out_; }

 private:
  void add(LayerConfiguration& to, LayerConfiguration::Entry entry, const std::string& name) {
    const auto layer = std::ranges::find(known_, std::string_view(entry.layer), &KnownLayer::id);
    if (layer == known_.end()) {
      left_out_.insert(name);
      return;
    }
    // The old program had neither option.
    entry.style.dashed = layer->style.dashed;
    entry.style.flat = layer->style.flat;
    // Two old layers can map to one of ours, which takes the style of the first one that was shown.
    const auto twin = std::ranges::find(to.layers, entry.layer, &LayerConfiguration::Entry::layer);
    if (twin != to.layers.end()) {
      if (twin->visible || !entry.visible) return;
      to.layers.erase(twin);
    }
    to.layers.push_back(std::move(entry));
  }

  // "A power diagram" meant that of all Voronoi balls in 2007, beside "A regular triangulation", and that of the inner
  // balls in 2009.
  void tell_power_diagrams_apart(LayerConfiguration& out) const {
    constexpr std::string_view kOfInnerBalls = "a-ball-power-diagram";
    if (std::ranges::find(known_, kOfInnerBalls, &KnownLayer::id) == known_.end()) return;
    for (LayerConfiguration::Entry& entry : out.layers)
      if (entry.layer == "a-power-diagram") entry.layer = kOfInnerBalls;
  }

  std::span<const KnownLayer> known_;
  std::set<std::string> left_out_;
};

Read<std::vector<Bundle>> read_file(Stream stream, BundleReader& reader) {
  std::vector<Bundle> out;
  if (const auto good = stream.token(kFileToken, 1, "a file of bundles"); !good) return std::unexpected(good.error());
  while (!stream.is_at_end()) {
    if (out.size() == kMostBundles) return stream.fail("there are too many bundles");
    auto name = stream.text();
    if (!name) return std::unexpected(name.error());
    const auto block = stream.block();
    if (!block) return std::unexpected(block.error());
    auto layers = reader.read(*block);
    if (!layers) return std::unexpected(layers.error());
    if (name->empty()) *name = fmt::format("Bundle {}", out.size() + 1);
    out.push_back({std::move(*name), std::move(*layers)});
  }
  return out;
}

std::string warning_of(const std::set<std::string>& left_out, const std::string& file) {
  std::string out = fmt::format("{}: {} {} not available here and left out: ", file, left_out.size(),
                                left_out.size() == 1 ? "layer is" : "layers are");
  constexpr std::size_t kMostNames = 3;
  std::size_t count = 0;
  for (const std::string& name : left_out) {
    if (count == kMostNames) {
      out += ", ...";
      break;
    }
    if (count++ != 0) out += ", ";
    out += in_quotes(name);
  }
  return out;
}

}  // namespace

bool looks_like_bnd(std::string_view bytes) {
  constexpr std::string_view kBegin("\0\0\0\xB3\0\0\0", 7);
  return bytes.starts_with(kBegin);
}

Expected<LoadedBundles> read_bnd(std::string_view bytes, const std::string& file, std::span<const KnownLayer> known) {
  BundleReader reader(known);
  auto bundles = read_file(Stream(bytes, 0), reader);
  if (!bundles)
    return std::unexpected(Error{ErrorCode::bad_input,
                                 fmt::format("{} (at byte {})", bundles.error().what, bundles.error().byte), file});
  LoadedBundles out{std::move(*bundles)};
  if (!reader.left_out().empty()) out.warnings.push_back(warning_of(reader.left_out(), file));
  return out;
}

}  // namespace mes
