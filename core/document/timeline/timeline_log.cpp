// SPDX-License-Identifier: GPL-3.0-or-later
// Encodes timeline entries as bytes: integers in groups of seven bits, doubles as their bits, lists with their length
// first. The bytes never leave the program; files have their own format (core/io/session/session.h).
#include <algorithm>
#include <array>
#include <bit>
#include <concepts>
#include <cstring>
#include <utility>

#include "core/base/assert.h"
#include "core/document/timeline/timeline.h"

namespace mes {
namespace {

constexpr std::size_t kSmallestChunk = 256;
constexpr std::size_t kUsualChunk = std::size_t{64} * 1024;

/// Both directions visit the same fields in the same order: `Packer` appends each field, `Unpacker` fills it in.
template <class T, class Wanted>
concept Some = std::same_as<std::remove_const_t<T>, Wanted>;

template <class Archive, class T>
void pass(Archive& archive, T& value);

class Packer {
 public:
  /// A null pointer only counts the bytes.
  explicit Packer(std::byte* to = nullptr) : to_(to) {}
  std::size_t size() const { return size_; }

  void number(std::uint64_t value) {
    for (; value >= 0x80U; value >>= 7U) put(static_cast<std::uint8_t>(value | 0x80U));
    put(static_cast<std::uint8_t>(value));
  }
  void field(std::uint64_t value) { number(value); }
  void field(std::uint32_t value) { number(value); }
  void field(std::uint8_t value) { number(value); }
  void field(bool value) { number(value ? 1 : 0); }
  void field(double value) { put(&value, sizeof value); }
  void field(const std::string& value) {
    number(value.size());
    put(value.data(), value.size());
  }
  template <class T>
  void field(const std::vector<T>& values) {
    number(values.size());
    for (const T& value : values) pass(*this, value);
  }
  template <class T>
  void field(const std::optional<T>& value) {
    field(value.has_value());
    if (value) pass(*this, *value);
  }
  /// A value that is mostly the default takes one byte.
  template <class T>
  bool differs(const T& value, const T& usual) {
    field(value != usual);
    return value != usual;
  }

 private:
  void put(std::uint8_t byte) { put(&byte, 1); }
  void put(const void* bytes, std::size_t count) {
    if (to_ != nullptr && count != 0) std::memcpy(to_ + size_, bytes, count);
    size_ += count;
  }
  std::byte* to_;
  std::size_t size_ = 0;
};

class Unpacker {
 public:
  explicit Unpacker(std::span<const std::byte> bytes) : rest_(bytes) {}

  std::uint64_t number() {
    std::uint64_t out = 0;
    for (unsigned shift = 0;; shift += 7) {
      const auto group = std::to_integer<std::uint64_t>(take(1).front());
      out |= (group & 0x7fU) << shift;
      if (group < 0x80U) return out;
    }
  }
  void field(std::uint64_t& value) { value = number(); }
  void field(std::uint32_t& value) { value = static_cast<std::uint32_t>(number()); }
  void field(std::uint8_t& value) { value = static_cast<std::uint8_t>(number()); }
  void field(bool& value) { value = number() != 0; }
  void field(double& value) { std::memcpy(&value, take(sizeof value).data(), sizeof value); }
  void field(std::string& value) {
    const auto bytes = take(number());
    value.assign(reinterpret_cast<const char*>(bytes.data()), bytes.size());
  }
  template <class T>
  void field(std::vector<T>& values) {
    values.resize(number());
    for (T& value : values) pass(*this, value);
  }
  template <class T>
  void field(std::optional<T>& value) {
    if (number() == 0) return value.reset();
    pass(*this, value.emplace());
  }
  template <class T>
  bool differs(T& value, const T& usual) {
    if (number() != 0) return true;
    value = usual;
    return false;
  }

 private:
  std::span<const std::byte> take(std::size_t count) {
    MES_ASSERT(count <= rest_.size());
    const auto out = rest_.first(count);
    rest_ = rest_.subspan(count);
    return out;
  }
  std::span<const std::byte> rest_;
};

template <class Archive, class... Fields>
void fields(Archive& archive, Fields&... of) {
  (pass(archive, of), ...);
}

void each(auto& archive, Some<Vec2> auto& p) {
  fields(archive, p.x, p.y);
}
void each(auto& archive, Some<Disk> auto& disk) {
  fields(archive, disk.center, disk.radius);
}
void each(auto& archive, Some<Box2> auto& box) {
  fields(archive, box.low, box.high);
}
void each(auto& archive, Some<SampleData::Contour> auto& contour) {
  fields(archive, contour.closed, contour.points);
}
void each(auto& archive, Some<LayerStyle> auto& style) {
  if (!archive.differs(style, LayerStyle{})) return;
  fields(archive, style.color, style.opacity, style.point_size_px, style.line_width_px, style.dashed, style.flat,
         style.color_map, style.range_locked, style.range_low, style.range_high, style.thin_when_dense);
}
void each(auto& archive, Some<LayerConfiguration::Entry> auto& entry) {
  fields(archive, entry.layer, entry.visible, entry.style);
}
void each(auto& archive, Some<BackgroundImage> auto& image) {
  fields(archive, image.file, image.center, image.width, image.is_upright);
}
void each(auto& archive, Some<Rgb> auto& color) {
  fields(archive, color.r, color.g, color.b);
}
void each(auto& archive, Some<Anchor> auto& anchor) {
  fields(archive, anchor.at, anchor.samples, anchor.balls);
  if (!anchor.balls.empty()) fields(archive, anchor.along, anchor.scale);
}
void each(auto& archive, Some<HighlightedElement> auto& element) {
  auto kind = static_cast<std::uint8_t>(element.kind);
  auto role = static_cast<std::uint8_t>(element.role);
  fields(archive, kind, role, element.radius);
  if constexpr (!std::is_const_v<std::remove_reference_t<decltype(element)>>) {
    element.kind = static_cast<PrimitiveKind>(kind);
    element.role = static_cast<ProvenanceRole>(role);
  }
}
void each(auto& archive, Some<Annotation> auto& annotation) {
  auto kind = static_cast<std::uint8_t>(annotation.kind);
  fields(archive, kind, annotation.text, annotation.anchors, annotation.shift, annotation.letters, annotation.color,
         annotation.elements);
  if constexpr (!std::is_const_v<std::remove_reference_t<decltype(annotation)>>)
    annotation.kind = static_cast<AnnotationKind>(kind);
}
void each(auto& archive, Some<EllipticArc> auto& arc) {
  fields(archive, arc.center, arc.u, arc.v, arc.start, arc.sweep);
}
void each(Packer& archive, const PlaneCurve& curve) {
  std::vector<std::uint8_t> kinds;
  for (const PieceKind kind : curve.kinds()) kinds.push_back(static_cast<std::uint8_t>(kind));
  const bool is_closed = curve.is_closed();
  fields(archive, curve.points(), kinds, curve.arcs(), is_closed, curve.name);
}
PlaneCurve curve_from(Unpacker& archive) {
  std::vector<Vec2> points;
  std::vector<std::uint8_t> numbers;
  std::vector<EllipticArc> arcs;
  bool is_closed = false;
  std::string name;
  fields(archive, points, numbers, arcs, is_closed, name);
  std::vector<PieceKind> kinds;
  for (const std::uint8_t number : numbers) kinds.push_back(static_cast<PieceKind>(number));
  auto curve = PlaneCurve::of_parts(std::move(points), std::move(kinds), std::move(arcs), is_closed);
  MES_ASSERT(curve);
  curve->name = std::move(name);
  return *std::move(curve);
}
void each(Packer& archive, const CurveSet& curves) {
  archive.number(curves.curves.size());
  for (const PlaneCurve& curve : curves.curves) each(archive, curve);
  archive.field(curves.points);
}
void each(Unpacker& archive, CurveSet& curves) {
  const std::uint64_t count = archive.number();
  curves.curves.reserve(count);
  for (std::uint64_t i = 0; i < count; ++i) curves.curves.push_back(curve_from(archive));
  archive.field(curves.points);
}
void each(auto& archive, Some<SamplingRequest> auto& request) {
  auto rule = static_cast<std::uint8_t>(request.rule);
  std::uint64_t count = request.count;
  std::uint64_t least_each = request.least_each;
  std::uint64_t most = request.most;
  fields(archive, rule, request.spacing, count, least_each, request.share, request.turn, request.epsilon,
         request.corner_angle, request.corner_radius, request.jitter, request.seed, most);
  if constexpr (!std::is_const_v<std::remove_reference_t<decltype(request)>>) {
    request.rule = static_cast<SamplingRule>(rule);
    request.count = count;
    request.least_each = least_each;
    request.most = most;
  }
}
void each(auto& archive, Some<SourceEdit> auto& edit) {
  bool has_own = edit.curves != nullptr;
  fields(archive, edit.has_curves, has_own, edit.sampling, edit.first, edit.count);
  if (!has_own) return;
  if constexpr (std::is_const_v<std::remove_reference_t<decltype(edit)>>) {
    each(archive, *edit.curves);
  } else {
    auto curves = std::make_shared<CurveSet>();
    each(archive, *curves);
    edit.curves = std::move(curves);
  }
}
void each(auto& archive, Some<TimelineEdit> auto& edit) {
  fields(archive, edit.name, edit.continues, edit.replaces, edit.is_state, edit.removed, edit.moved, edit.inserted,
         edit.removed_balls, edit.changed_balls, edit.inserted_balls, edit.curve, edit.annotations, edit.source);
}
void each(auto& archive, Some<GestureBegun> auto& begun) {
  fields(archive, begun.name);
}
void each(auto& /*archive*/, Some<GestureEnded> auto& /*ended*/) {}
void each(auto& /*archive*/, Some<Undone> auto& /*undone*/) {}
void each(auto& /*archive*/, Some<Redone> auto& /*redone*/) {}
void each(auto& archive, Some<LayersChanged> auto& change) {
  auto role = static_cast<std::uint8_t>(change.role);
  fields(archive, role, change.changed, change.order, change.image, change.name, change.back);
  if constexpr (!std::is_const_v<std::remove_reference_t<decltype(change)>>)
    change.role = static_cast<LayersChanged::Role>(role);
}
void each(auto& archive, Some<ParameterValues::Entry> auto& entry) {
  fields(archive, entry.id, entry.value, entry.default_value, entry.is_of_document);
}
void each(Packer& archive, const ParameterValues& values) {
  const std::vector<ParameterValues::Entry> entries = values.changed();  // equal values give equal bytes
  fields(archive, entries);
}
void each(Unpacker& archive, ParameterValues& values) {
  std::vector<ParameterValues::Entry> entries;
  fields(archive, entries);
  values = ParameterValues(std::move(entries));
}
void each(auto& archive, Some<SettingsChanged> auto& change) {
  if (!archive.differs(change.settings, ComputationSettings{})) return;
  auto precision = static_cast<std::uint8_t>(change.settings.precision);
  fields(archive, precision);
  if constexpr (!std::is_const_v<std::remove_reference_t<decltype(change)>>)
    change.settings.precision = static_cast<Precision>(precision);
  fields(archive, change.settings.values);
}
void each(auto& archive, Some<ViewChanged> auto& change) {
  fields(archive, change.visible);
}
void each(auto& archive, Some<Captioned> auto& caption) {
  fields(archive, caption.text, caption.seconds);
}

template <class Archive, class First, class Second>
void each(Archive& archive, std::pair<First, Second>& pair) {
  fields(archive, pair.first, pair.second);
}
template <class Archive, class First, class Second>
void each(Archive& archive, const std::pair<First, Second>& pair) {
  fields(archive, pair.first, pair.second);
}

template <class Archive, class T>
void pass(Archive& archive, T& value) {
  if constexpr (requires { archive.field(value); })
    archive.field(value);
  else
    each(archive, value);
}

void pack(Packer& packer, const TimelineEntry& entry) {
  packer.number(entry.index());
  std::visit([&packer](const auto& kind) { pass(packer, kind); }, entry);
}

std::size_t packed_size(const TimelineEntry& entry) {
  Packer packer;
  pack(packer, entry);
  return packer.size();
}

std::vector<std::byte> chunk_for(std::size_t bytes, std::size_t last_chunk) {
  std::vector<std::byte> out;
  out.reserve(std::max(bytes, std::clamp(2 * last_chunk, kSmallestChunk, kUsualChunk)));
  return out;
}

template <std::size_t Kind = 0>
TimelineEntry unpacked(std::uint64_t kind, Unpacker& from) {
  if constexpr (Kind < std::variant_size_v<TimelineEntry>) {
    if (kind != Kind) return unpacked<Kind + 1>(kind, from);
    TimelineEntry out(std::in_place_index<Kind>);
    pass(from, std::get<Kind>(out));
    return out;
  }
  MES_ASSERT(kind < std::variant_size_v<TimelineEntry>);
  return {};
}

}  // namespace

void TimelineLog::make_place(std::size_t bytes) {
  const bool fits = !chunks_.empty() && chunks_.back().capacity() - chunks_.back().size() >= bytes;
  if (!fits) chunks_.push_back(chunk_for(bytes, chunks_.empty() ? 0 : chunks_.back().capacity()));
  const Place place{static_cast<std::uint32_t>(chunks_.size() - 1),
                    static_cast<std::uint32_t>(chunks_.back().size())};
  places_.push_back(place);
  chunks_.back().resize(place.offset + bytes);  // capacity is already reserved
}

std::span<const std::byte> TimelineLog::bytes(std::size_t i) const {
  const Place place = places_[i];
  const std::span<const std::byte> chunk = chunks_[place.chunk];
  const bool is_last = i + 1 == places_.size() || places_[i + 1].chunk != place.chunk;
  const std::size_t end = is_last ? chunk.size() : places_[i + 1].offset;
  return chunk.subspan(place.offset, end - place.offset);
}

void TimelineLog::push_back(const TimelineEntry& entry) {
  make_place(packed_size(entry));
  Packer packer(chunks_.back().data() + places_.back().offset);
  pack(packer, entry);
}

void TimelineLog::pop_back() {
  MES_ASSERT(!empty());
  const Place place = places_.back();
  places_.pop_back();
  // A later chunk is empty: it was made for an entry whose record could not be stored.
  chunks_.resize(place.chunk + std::size_t{1});
  chunks_.back().resize(place.offset);
  if (chunks_.back().empty()) chunks_.pop_back();
}

void TimelineLog::replace_back(const TimelineEntry& entry) {
  MES_ASSERT(!empty());
  const Place before = places_.back();
  std::vector<std::byte> chunk = chunk_for(packed_size(entry), 0);
  chunk.resize(packed_size(entry));
  Packer packer(chunk.data());
  pack(packer, entry);
  chunks_.push_back(std::move(chunk));
  // Nothing below throws.
  chunks_[before.chunk].resize(before.offset);
  std::erase_if(chunks_, [](const auto& some) { return some.empty(); });
  places_.back() = {static_cast<std::uint32_t>(chunks_.size() - 1), 0};
}

void TimelineLog::erase(std::size_t i) {
  if (i + 1 == size()) return pop_back();
  TimelineLog out = *this;
  while (out.size() > i) out.pop_back();
  for (std::size_t k = i + 1; k < size(); ++k) out.push_back((*this)[k]);
  *this = std::move(out);
}

TimelineEntry TimelineLog::operator[](std::size_t i) const {
  MES_ASSERT(i < size());
  Unpacker from(bytes(i));
  const std::uint64_t kind = from.number();
  return unpacked(kind, from);
}

std::vector<TimelineEntry> TimelineLog::between(std::size_t begin, std::size_t end) const {
  std::vector<TimelineEntry> out;
  out.reserve(end - begin);
  for (std::size_t i = begin; i < end; ++i) out.push_back((*this)[i]);
  return out;
}

bool operator==(const TimelineLog& a, const TimelineLog& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i)
    if (!std::ranges::equal(a.bytes(i), b.bytes(i))) return false;
  return true;
}

}  // namespace mes
