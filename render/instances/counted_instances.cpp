// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/instances/counted_instances.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/base/jobs/parallel.h"
#include "render/device/instance_layout.h"
#include "render/instances/circle_field.h"
#include "render/instances/disk_field.h"
#include "render/instances/stroke_field.h"

namespace mes::render {
namespace {

// Measured nanoseconds: for each row of pixels of a disk, with its rim; for a short stroke; for a circle of a hundred
// rows; and for each mask pixel, from sum to screen.
constexpr double kRowNs = 25.0;
constexpr double kStrokeNs = 60.0;
constexpr double kCircleNs = 2500.0;
/// A circle of a hundred rows takes a processor as long to paint as this many short strokes.
constexpr double kStrokesOfCircle = 10.0;
constexpr double kMaskPixelNs = 8.0;
constexpr double kUsualPixels = 2e6;  // pixels of a usual view

/// A preview merges instances from this number on.
constexpr std::size_t kMany = 20000;

double overlap(double center, double radius, int size) {
  return std::max(0.0, std::min(center + radius, static_cast<double>(size)) - std::max(center - radius, 0.0));
}

/// The coordinates of an instance in drawing space, and its multiplicity. Coordinates that a kind lacks are zero.
struct Placed {
  std::array<double, 4> at{};
  std::int32_t times = 1;
};

Placed placed(std::span<const double> instance) {
  Placed out;
  std::ranges::copy(instance, out.at.begin());
  return out;
}

PixelDisk disk_of(const std::array<double, 4>& at, const PixelFrame& frame) {
  const Vec2 center = frame(at[0], at[1]);
  return {center.x, center.y, at[2] * frame.scale, 1};
}

// For each kind: the conversion of instances to shapes of a field, and the initial state of the field.
struct DiskCounting {
  using Field = DiskField;
  static constexpr bool can_count(PrimitiveKind kind) { return kind == PrimitiveKind::disk; }
  static Field field(const PixelFrame& frame, const CountedLook& look) {
    return {frame.width, frame.height, look.opacity};
  }
  static std::optional<PixelDisk> shape(const Placed& disk, PrimitiveKind, const PixelFrame& frame,
                                        const CountedLook&) {
    if (disk.at[2] < 0.0) return std::nullopt;
    PixelDisk out = disk_of(disk.at, frame);
    out.times = disk.times;
    return out;
  }
  /// Merging pays off if at most this share of instances remains. Counting a disk takes far longer than merging it.
  static constexpr double kWorth = 0.9;
  static constexpr double kCoarsePx = 2.0;  ///< largest spacing of a coarse grid
};

struct StrokeCounting {
  using Field = StrokeField;
  static constexpr bool can_count(PrimitiveKind kind) {
    return kind == PrimitiveKind::segment || kind == PrimitiveKind::point;
  }
  static Field field(const PixelFrame& frame, const CountedLook& look) {
    return {frame.width, frame.height, look.opacity, look.half_width};
  }
  static std::optional<PixelStroke> shape(const Placed& stroke, PrimitiveKind kind, const PixelFrame& frame,
                                          const CountedLook& look) {
    const Vec2 from = frame(stroke.at[0], stroke.at[1]);
    const Vec2 to = kind == PrimitiveKind::segment ? frame(stroke.at[2], stroke.at[3]) : from;
    auto out = StrokeField::visible(from, to, frame.width, frame.height, look.half_width);
    if (out) out->times = stroke.times;
    return out;
  }
  static constexpr double kWorth = 0.5;
  static constexpr double kCoarsePx = 0.5;
};

struct CircleCounting {
  using Field = CircleField;
  static constexpr bool can_count(PrimitiveKind kind) { return kind == PrimitiveKind::circle; }
  static Field field(const PixelFrame& frame, const CountedLook& look) {
    return {frame.width, frame.height, look.opacity, look.half_width};
  }
  static std::optional<PixelDisk> shape(const Placed& circle, PrimitiveKind, const PixelFrame& frame,
                                        const CountedLook&) {
    if (circle.at[2] < 0.0) return std::nullopt;
    PixelDisk out = disk_of(circle.at, frame);
    out.times = circle.times;
    return out;
  }
  static constexpr double kWorth = 0.9;
  static constexpr double kCoarsePx = 0.5;
};

/// A grid of drawing space whose spacing is a power of two. Equal instances on it are merged.
class Grid {
 public:
  explicit Grid(int exponent) : cell_(std::ldexp(1.0, exponent)), lines_(std::ldexp(1.0, -exponent)) {}

  /// The nearest position on the grid, or the same position if doubles are no finer than the grid.
  Placed snapped(const Placed& instance) const {
    // Adding this number rounds to whole numbers.
    constexpr double kWhole = 0x1.8p52;
    Placed out = instance;
    for (double& x : out.at) {
      const double line = x * lines_;
      if (std::abs(line) < 0x1p50) x = ((line + kWhole) - kWhole) * cell_;
    }
    return out;
  }

  /// Appends instances on the grid, with equal ones merged.
  static void merge(std::span<const Placed> instances, std::vector<Placed>& out) {
    constexpr std::uint32_t kFree = ~std::uint32_t{0};
    const std::size_t slots = std::bit_ceil(2 * instances.size() + 1);
    const int shift = 64 - std::countr_zero(slots);
    std::vector<std::uint32_t> table(slots, kFree);
    for (const Placed& instance : instances) {
      std::size_t at = hash(instance) >> shift;
      while (table[at] != kFree && out[table[at]].at != instance.at) at = (at + 1) & (slots - 1);
      if (table[at] != kFree) {
        out[table[at]].times += instance.times;
      } else {
        table[at] = static_cast<std::uint32_t>(out.size());
        out.push_back(instance);
      }
    }
  }

 private:
  static std::uint64_t hash(const Placed& instance) {
    std::uint64_t out = 0;
    // Zeros of both signs are equal. The factor is 2^64 divided by the golden ratio.
    for (const double x : instance.at) {
      out = (out ^ std::bit_cast<std::uint64_t>(x + 0.0)) * 0x9E3779B97F4A7C15U;
      out ^= out >> 32U;
    }
    return out * 0x9E3779B97F4A7C15U;
  }

  double cell_;
  double lines_;
};

/// The spacing of a grid, at most `pixels` pixels, as an exponent of two.
int exponent_of(double pixels, double scale) {
  return std::ilogb(pixels / scale);
}

template <class Counting>
class Counted final : public CountedInstances {
  using Shape = typename Counting::Field::Shape;

 public:
  explicit Counted(Device& device) : device_(device) {}
  ~Counted() override { forget(); }

  TextureId mask() const override { return mask_; }
  std::span<const PixelRect> parts() const override { return parts_; }
  bool is_coarse() const override { return grid_.has_value() && look_.preview == Preview::coarse; }

  void show(InstanceBuffer& buffer, const PixelFrame& frame, const CountedLook& look) override {
    const bool is_new = !field_ || frame != frame_ || look != look_;
    try {
      if (buffer.have_changed()) forget_previews();
      const bool from_scratch = is_new || buffer.have_all_changed();
      if (from_scratch) {
        if (frame.width != frame_.width || frame.height != frame_.height) forget();
        if (look.opacity != look_.opacity || look.half_width != look_.half_width) field_.reset();
        frame_ = frame;
        look_ = look;
        count_all(buffer);
      } else {
        field_->remove(shapes_of(buffer.removed(), buffer.kind()));
        field_->add(shapes_of(buffer.added(), buffer.kind()));
      }
      buffer.forget_changes();
      upload(from_scratch);
    } catch (...) {
      forget();
      throw;
    }
  }

 private:
  /// A few instances that represent all; empty if they would not be few.
  struct Set {
    std::optional<int> exponent;  ///< spacing of the grid; none: not yet made
    std::vector<Placed> instances;
  };

  void forget() {
    if (mask_ != TextureId{}) device_.destroy_texture(mask_);
    mask_ = {};
    field_.reset();
    forget_previews();
    shapes_ = {};
  }
  void forget_previews() {
    fine_ = {};
    coarse_ = {};
  }

  std::optional<Shape> shape(const Placed& instance, PrimitiveKind kind) const {
    return Counting::shape(instance, kind, frame_, look_);
  }

  std::vector<Shape> shapes_of(std::span<const double> instances, PrimitiveKind kind) const {
    std::vector<Shape> out;
    const std::size_t doubles = layout_of(kind).doubles();
    for (std::size_t i = 0; i < instances.size(); i += doubles) {
      const Placed instance = placed(instances.subspan(i, doubles));
      if (const auto drawn = shape(grid_ ? grid_->snapped(instance) : instance, kind)) out.push_back(*drawn);
    }
    return out;
  }

  void count_all(const InstanceBuffer& buffer) {
    if (field_)
      field_->clear();
    else
      field_.emplace(Counting::field(frame_, look_));
    grid_.reset();
    const PrimitiveKind kind = buffer.kind();
    if (const Set* set = preview_of(buffer)) {
      grid_.emplace(*set->exponent);
      count(set->instances.size(), kind, [set](std::size_t i) { return set->instances[i]; });
      return;
    }
    const std::size_t doubles = layout_of(kind).doubles();
    const std::span<const double> all = buffer.kept();
    count(buffer.count(), kind, [all, doubles](std::size_t i) { return placed(all.subspan(i * doubles, doubles)); });
  }

  template <class Instance>
  void count(std::size_t count, PrimitiveKind kind, Instance instance) {
    if (shapes_.size() < count) shapes_.resize(count);
    // Each thread writes its shapes at the position of its instances; then they are compacted.
    std::vector<std::pair<std::size_t, std::size_t>> parts(chunk_count(count));
    parallel_for(count, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
      std::size_t next = begin;
      for (std::size_t i = begin; i < end; ++i)
        if (const auto drawn = shape(instance(i), kind)) shapes_[next++] = *drawn;
      parts[chunk] = {begin, next};
    });
    std::size_t drawn = 0;
    for (const auto& [begin, end] : parts) {
      if (drawn != begin) std::copy(&shapes_[begin], &shapes_[begin] + (end - begin), &shapes_[drawn]);
      drawn += end - begin;
    }
    field_->add(std::span<const Shape>(shapes_).first(drawn));
  }

  // Returns null if the original instances should be counted.
  const Set* preview_of(const InstanceBuffer& buffer) {
    if (look_.preview == Preview::none || buffer.count() < kMany) return nullptr;
    constexpr double kFinePx = 0.125;
    const bool is_coarse = look_.preview == Preview::coarse;
    const int exponent = exponent_of(is_coarse ? Counting::kCoarsePx : kFinePx, frame_.scale);
    Set& set = is_coarse ? coarse_[static_cast<unsigned>(exponent) & 1U] : fine_;
    if (set.exponent != exponent) {
      set.exponent = exponent;
      set.instances.clear();
      if (is_worth_merging(buffer, Grid(exponent))) set.instances = merged(buffer, Grid(exponent));
      if (!is_few(set.instances.size(), buffer.count())) set.instances = {};
    }
    return set.instances.empty() ? nullptr : &set;
  }

  static bool is_few(std::size_t merged, std::size_t of) {
    return static_cast<double>(merged) <= Counting::kWorth * static_cast<double>(of);
  }

  static std::vector<Placed> snapped(const InstanceBuffer& buffer, const Grid& grid, std::size_t begin,
                                     std::size_t end) {
    const std::size_t doubles = layout_of(buffer.kind()).doubles();
    std::vector<Placed> out;
    out.reserve(end - begin);
    for (std::size_t i = begin; i < end; ++i)
      out.push_back(grid.snapped(placed(buffer.kept().subspan(i * doubles, doubles))));
    return out;
  }

  // A sample of consecutive instances, usually neighbours, represents all.
  static bool is_worth_merging(const InstanceBuffer& buffer, const Grid& grid) {
    constexpr std::size_t kPart = 4096;
    const std::size_t begin = (buffer.count() - kPart) / 2;
    std::vector<Placed> out;
    Grid::merge(snapped(buffer, grid, begin, begin + kPart), out);
    return is_few(out.size(), kPart);
  }

  static std::vector<Placed> merged(const InstanceBuffer& buffer, const Grid& grid) {
    std::vector<std::vector<Placed>> parts(chunk_count(buffer.count()));
    parallel_for(buffer.count(), [&](std::size_t begin, std::size_t end, std::size_t chunk) {
      Grid::merge(snapped(buffer, grid, begin, end), parts[chunk]);
    });
    std::vector<Placed> all;
    for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
    std::vector<Placed> out;
    Grid::merge(all, out);
    return out;
  }

  void upload(bool everything) {
    const std::span<const RowRange> settled = field_->settle();
    if (mask_ == TextureId{}) {
      mask_ = device_.create_mask(frame_.width, frame_.height);
      everything = true;
    }
    parts_.clear();
    std::vector<RowRange> visible;  // only these are painted
    for (const FieldPart& part : field_->parts()) {
      parts_.push_back({part.left, part.rows.first, part.right - part.left, part.rows.end - part.rows.first});
      if (!visible.empty() && visible.back().end >= part.rows.first)
        visible.back().end = part.rows.end;
      else
        visible.push_back(part.rows);
    }
    for (const RowRange& range : everything ? std::span<const RowRange>(visible) : settled)
      device_.update_mask(mask_, range.first, field_->rows(range));
  }

  Device& device_;
  PixelFrame frame_;
  CountedLook look_;
  std::optional<Grid> grid_;  ///< grid of the counted instances; none: they have their exact positions
  Set fine_;
  std::array<Set, 2> coarse_;  ///< for even and odd exponents: zooming to and fro finds both ready
  std::optional<typename Counting::Field> field_;
  std::vector<Shape> shapes_;  ///< buffer for one pass
  TextureId mask_{};
  std::vector<PixelRect> parts_;
};

}  // namespace

std::unique_ptr<CountedInstances> CountedInstances::create(PrimitiveKind kind, Device& device) {
  if (DiskCounting::can_count(kind)) return std::make_unique<Counted<DiskCounting>>(device);
  if (StrokeCounting::can_count(kind)) return std::make_unique<Counted<StrokeCounting>>(device);
  if (CircleCounting::can_count(kind)) return std::make_unique<Counted<CircleCounting>>(device);
  return nullptr;
}

bool CountedInstances::is_cheaper(const InstanceBuffer& buffer, const PixelFrame& frame, const Device& device) {
  if (buffer.kept().empty()) return false;
  const auto workers = static_cast<double>(worker_count());
  // Painting and counting cost about the same for each pixel of a stroke. All tiles of a picture must be drawn in the
  // same way, so their size does not matter.
  if (StrokeCounting::can_count(buffer.kind()))
    return kStrokeNs * buffer.count() / workers + kMaskPixelNs * kUsualPixels <
           device.instance_cost_ns() * buffer.count();
  if (CircleCounting::can_count(buffer.kind()))
    return kCircleNs * buffer.count() / workers + kMaskPixelNs * kUsualPixels <
           kStrokesOfCircle * device.instance_cost_ns() * buffer.count();
  if (!DiskCounting::can_count(buffer.kind())) return false;
  struct Sums {
    double rows = 0.0;
    double pixels = 0.0;
    double visible = 0.0;
  };
  const std::size_t doubles = layout_of(PrimitiveKind::disk).doubles();
  const std::span<const double> all = buffer.kept();
  const std::size_t count = all.size() / doubles;
  std::vector<Sums> parts(chunk_count(count));
  parallel_for(count, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
    Sums own;
    for (std::size_t i = begin; i < end; ++i) {
      const Placed instance = placed(all.subspan(i * doubles, 3));
      if (instance.at[2] < 0.0) continue;
      const PixelDisk disk = disk_of(instance.at, frame);
      const double across = overlap(disk.x, disk.radius + 0.5, frame.width);
      const double up = across > 0.0 ? overlap(disk.y, disk.radius + 0.5, frame.height) : 0.0;
      own.rows += up;
      own.visible += up > 0.0 ? 1.0 : 0.0;
      own.pixels += 0.25 * std::numbers::pi * across * up;
    }
    parts[chunk] = own;
  });
  Sums sums;
  for (const Sums& part : parts) {
    sums.rows += part.rows;
    sums.pixels += part.pixels;
    sums.visible += part.visible;
  }
  const double mask = kMaskPixelNs * std::max(kUsualPixels, 1.0 * frame.width * frame.height);
  return kRowNs * sums.rows / workers + mask <
         device.pixel_cost_ns() * sums.pixels + device.instance_cost_ns() * sums.visible;
}

}  // namespace mes::render
