// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/scene.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <glm/common.hpp>
#include <glm/packing.hpp>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

#include "core/base/assert.h"
#include "render/image/picture_file.h"
#include "render/look.h"

namespace mes::render {
namespace {

// Beyond this many pixels from the centre, lines, circles and arcs are placed with more bits. Single precision rounds
// to 1/128 of a pixel there. A smaller limit would use costlier programs in ordinary views; with a larger one lines
// would shake.
constexpr double kNearReach = 0x1p17;
// Up to this coordinate, doubles place the rim of a disk to a millionth of a pixel.
constexpr double kCountedReach = 0x1p33;
// At these limits the drawing is far smaller than a pixel, or a pixel far smaller than the spacing of doubles.
constexpr double kMinScale = 0x1p-70;
constexpr double kMaxScale = 0x1p80;
// In pixels: beyond any picture; single precision keeps such positions out of view.
constexpr double kFarCenter = 0x1p24;

constexpr std::uint32_t kAllInstances = std::uint32_t{1} << 31U;

// The number of colours of a map in its texture.
constexpr std::size_t kMapWidth = 256;

/// One coordinate of the view's centre in the forms for programs.
struct CenterParts {
  glm::vec3 pieces;
  glm::uvec2 words;
  glm::uvec2 low_words;
};

CenterParts split(double value, double low) {
  // Like in the vertex programs, the first piece has 21 bits and the second 16; here the third has all others.
  const glm::uvec2 words = glm::unpackDouble2x32(value);
  const double first = glm::packDouble2x32({0U, words.y});
  const double rest = glm::packDouble2x32({words.x & 0xffff0000U, words.y});
  return {.pieces = glm::vec3(first, rest - first, (value - rest) + low),
          .words = words,
          .low_words = glm::unpackDouble2x32(low)};
}

/// One coordinate of the camera's centre in a drawing frame: the sum of both members.
struct FrameCenter {
  double value;
  double low;  ///< the bits that `value` cannot hold
};

FrameCenter center_in(double center, double center_low, double origin, double scale, double limit) {
  const double high = center - origin;
  const double part = high - center;
  const double error = (center - (high - part)) + (-origin - part);
  const double scaled = high * scale;
  if (!(std::abs(scaled) < limit)) return {std::copysign(limit, high), 0.0};
  // Renormalised, so that the low part does not reach into the pieces of the high one.
  const double rest = (error + center_low) * scale;
  const double sum = scaled + rest;
  return {sum, rest - (sum - scaled)};
}

/// The view of a camera on the instances of a buffer.
struct Placement {
  PixelFrame frame;
  double reach;  ///< upper bound of the distance from the centre of the view, in pixels
};

Placement placement_of(const InstanceBuffer& buffer, const Camera& camera) {
  const DrawingFrame& frame = buffer.frame();
  const double wanted = 1.0 / camera.units_per_pixel() / frame.scale;
  const double scale = std::clamp(wanted, kMinScale, kMaxScale);
  // Even if the whole drawing is smaller than a pixel, its distance from the centre must be right in pixels: in parts
  // of a picture and panned views it is large in units of the drawing, and small in pixels.
  const double unit = frame.scale * std::min(1.0, wanted / kMinScale);
  const double limit = std::max(kDrawingLimit, kFarCenter / scale);
  const FrameCenter x = center_in(camera.center().x, camera.center_low().x, frame.origin.x, unit, limit);
  const FrameCenter y = center_in(camera.center().y, camera.center_low().y, frame.origin.y, unit, limit);
  const double center_size = std::max(std::abs(x.value), std::abs(y.value));
  return {.frame = {.center_x = x.value,
                    .center_low_x = x.low,
                    .center_y = y.value,
                    .center_low_y = y.low,
                    .scale = scale,
                    .width = camera.width(),
                    .height = camera.height()},
          .reach = (buffer.extent().coordinate + buffer.extent().radius + center_size) * scale};
}

/// The visible part of drawing space, and `margin` pixels around it.
Box2 shown_box(const PixelFrame& frame, double margin) {
  // Rims are at most a pixel and a half wide, single precision rounds by less, and some bits are for this sum.
  constexpr double kBits = 0x1p-48;
  const auto reach = [&](int size, double center) {
    return (0.5 * size + margin + 2.0) / frame.scale + kBits * std::abs(center);
  };
  const Vec2 center{frame.center_x, frame.center_y};
  const Vec2 half{reach(frame.width, center.x), reach(frame.height, center.y)};
  return {center - half, center + half};
}

/// Sets the uniforms that map scalars to colours.
void set_map(const ColorMap& map, const ScalarRange& range, float row, DrawUniforms& u) {
  constexpr int kBias = 1023;
  u.map_row = row;
  u.map_exponent = static_cast<float>(kBias);
  if (map.is_categorical) {
    u.map_low = {};
    u.map_factor = 1.0F;
    u.map_offset = 0.0F;
    u.map_categories = static_cast<float>(std::min(map.colors.size(), kMapWidth));
    return;
  }
  const bool is_known = !range.is_empty() && std::isfinite(range.low) && std::isfinite(range.high);
  const ScalarRange shown = is_known ? range : ScalarRange{0.0, 1.0};
  const double size = std::max(std::abs(shown.low), std::abs(shown.high));
  // Programs flush smaller scalars to zero.
  const int exponent = size > 0.0 ? std::max(std::ilogb(size), 1 - kBias) : 0;
  const double low = std::ldexp(shown.low, -exponent);
  const double width = std::ldexp(shown.high, -exponent) - low;
  u.map_low = split(low, 0.0).pieces;
  u.map_exponent = static_cast<float>(exponent + kBias);
  // A range of one value: scalars below it get the first colour, those above it the last.
  constexpr float kSteep = 1e30F;
  u.map_factor = width > 0.0 ? static_cast<float>(1.0 / width) : kSteep;
  u.map_offset = width > 0.0 ? 0.0F : 0.5F;
}

float pixels(double logical, double content_scale) {
  return static_cast<float>(logical * content_scale);
}

/// The number of quads along a circle: more of them cost vertices, fewer cost fragments between chord and rim. A small
/// circle is a square (0): by measurement, a square of 30 pixels costs as much as eight quads.
float arc_pieces(PrimitiveKind kind, const InstanceExtent& extent, double scale) {
  if (kind == PrimitiveKind::parabola) {
    // n chords leave a curve by 1 / n^2 of what one chord does.
    constexpr double kAllowedPx = 0.1;
    constexpr double kMost = 96.0;
    return static_cast<float>(
        std::clamp(std::ceil(std::sqrt(0.25 * extent.length * scale / kAllowedPx)), 1.0, kMost));
  }
  if (extent.radius * scale < 16.0) return 0.0F;
  // An arc deviates from its chords at most as much as a circle with its length.
  const double radius_px =
      (kind == PrimitiveKind::arc ? 0.5 / std::numbers::pi * extent.length : extent.radius) * scale;
  if (radius_px < 16.0) return 4.0F;
  if (radius_px < 60.0) return 8.0F;
  if (radius_px < 150.0) return 12.0F;
  return radius_px < 500.0 ? 20.0F : 32.0F;
}

// The look of counted instances, or nothing if only painting draws them correctly.
std::optional<CountedLook> counted_look(PrimitiveKind kind, const LayerStyle& style, double opacity,
                                        double content_scale, Preview preview) {
  // Matches `shown_half_width` and `stroke_alpha`, `soft_radius` and `soft_alpha` of shaders/uniforms.glsl.
  switch (kind) {
    case PrimitiveKind::disk: return CountedLook{.opacity = opacity};
    case PrimitiveKind::circle:
      // A saved picture has time to paint them.
      if (preview == Preview::none) return std::nullopt;
      [[fallthrough]];
    case PrimitiveKind::segment: {
      if (style.dashed) return std::nullopt;
      const double half = 0.5 * line_width_of(style) * content_scale;
      return CountedLook{.opacity = opacity * std::min(2.0 * half, 1.0), .half_width = std::max(half, 0.5)};
    }
    case PrimitiveKind::point: {
      const double r = 0.5 * point_size_of(style) * content_scale;
      return CountedLook{.opacity = opacity * std::min(3.0 * r * r, 1.0),
                         .half_width = std::sqrt(std::max(r * r - 1.0 / 12.0, 0.25))};
    }
    default: return std::nullopt;
  }
}

}  // namespace

/// The colours of the instances of one layer.
struct Scene::Look {
  LayerStyle style;
  bool ring = false;
  const ColorMap* map = nullptr;
  ScalarRange range{};
  float map_row = 0.0F;
  std::span<std::unique_ptr<CountedInstances>> counted{};  ///< storage of its counts, by kind
};

struct Scene::Pass {
  Camera camera;
  double content_scale;
  FramebufferId target;
  std::optional<TargetFormat> group;  // drawn into this target of the scene instead
  PixelRect area;
  std::uint32_t every = 1;  // for disks
  Preview preview = Preview::none;
};

Scene::Scene(Device& device) : device_(device) {}

Scene::~Scene() {
  for (const GroupTarget& group : groups_)
    if (group.id != FramebufferId{}) device_.destroy_framebuffer(group.id);
  if (map_texture_ != TextureId{}) device_.destroy_texture(map_texture_);
  clear_picture();
}

void Scene::apply(const FramePatch& patch) {
  frame_ = patch.frame;
  for (std::size_t i = 0; i < patch.layer_count; ++i) {
    const LayerPatch& changes = patch.layers[i];
    Layer& layer = layers_[changes.layer];
    for (const PrimitiveKind kind : kAllPrimitiveKinds) {
      InstanceBuffer& buffer = layer.kinds[static_cast<std::size_t>(kind)];
      if (!layer.is_used) buffer = InstanceBuffer(device_, kind);
      bytes_uploaded_ += buffer.apply(changes[kind], patch.frame, changes.has_scalars);
    }
    layer.is_used = true;
  }
}

void Scene::forget(VariantLayer layer) {
  if (Layer* const found = layers_.find(layer)) {
    for (InstanceBuffer& buffer : found->kinds) buffer.clear();
    for (auto& counted : found->counted) counted.reset();
  }
  if (auto* const mask = texts_.find(layer)) mask->reset();
}

void Scene::set_picture(VariantLayer layer, const Image& image) {
  clear_picture();
  const bool fits = std::max(image.width, image.height) <= device_.max_framebuffer_size();
  const Image smaller = fits ? Image{} : reduced(image, device_.max_framebuffer_size());
  const Image& shown = fits ? image : smaller;
  std::vector<std::uint8_t> premultiplied_rgba = shown.rgba;
  for (std::size_t i = 0; i < premultiplied_rgba.size(); i += 4) {
    const unsigned alpha = premultiplied_rgba[i + 3];
    for (std::size_t channel = i; channel < i + 3; ++channel)
      premultiplied_rgba[channel] = static_cast<std::uint8_t>((premultiplied_rgba[channel] * alpha + 127) / 255);
  }
  picture_ = device_.create_texture(shown.width, shown.height, premultiplied_rgba, /*smooth=*/true);
  picture_layer_ = layer;
  picture_aspect_ = static_cast<double>(image.height) / image.width;
}

void Scene::clear_picture() {
  if (picture_ != TextureId{}) device_.destroy_texture(picture_);
  picture_ = {};
  picture_layer_ = kNoLayer;
}

void Scene::set_overlay(std::uint32_t slot, const Overlay& overlay) {
  if (overlays_.size() <= slot) overlays_.resize(slot + std::size_t{1});
  OverlaySet& set = overlays_[slot];
  if (set.kind != overlay.kind || set.buffer.buffer() == BufferId{})
    set.buffer = InstanceBuffer(device_, overlay.kind);
  set.kind = overlay.kind;
  set.style = overlay.style;
  set.ring = overlay.ring;
  const std::size_t count = overlay.data.size() / stride_of(overlay.kind);
  bytes_uploaded_ += set.buffer.replace(static_cast<std::uint32_t>(count), overlay.data, frame_, false);
}

void Scene::clear_overlay(std::uint32_t slot) {
  if (slot < overlays_.size()) overlays_[slot].buffer.clear();
}

std::uint32_t Scene::instances(VariantLayer layer, PrimitiveKind kind) const {
  const Layer* const found = layers_.find(layer);
  return found == nullptr ? 0 : found->kinds[static_cast<std::size_t>(kind)].count();
}

std::uint32_t Scene::zero_length_segments(VariantLayer layer) const {
  const Layer* const found = layers_.find(layer);
  return found == nullptr ? 0 : found->kinds[static_cast<std::size_t>(PrimitiveKind::segment)].zero_length_count();
}

std::uint32_t Scene::painted_disks(const Camera& camera, VariantLayer layer, const LayerStyle& style) const {
  if (instances(layer, PrimitiveKind::disk) == 0) return 0;
  const InstanceBuffer& disks = layers_.find(layer)->kinds[static_cast<std::size_t>(PrimitiveKind::disk)];
  const bool may_be_counted =
      shown_map(layer, style).map == nullptr && placement_of(disks, camera).reach <= kCountedReach;
  return may_be_counted ? 0 : disks.count();
}

void Scene::set_color_maps(std::vector<ColorMap> maps) {
  maps_ = std::move(maps);
  if (map_texture_ != TextureId{}) device_.destroy_texture(map_texture_);
  map_texture_ = {};
}

// All maps are rows of one texture, created at the first use of a map.
TextureId Scene::map_texture() {
  if (map_texture_ != TextureId{}) return map_texture_;
  std::vector<std::uint8_t> rgba;
  rgba.reserve(4 * kMapWidth * maps_.size());
  for (const ColorMap& map : maps_) {
    for (std::size_t i = 0; i < kMapWidth; ++i) {
      const std::optional<Rgb> color = map.is_categorical
                                           ? map.color_of(static_cast<double>(i), {})
                                           : map.at(static_cast<double>(i) / static_cast<double>(kMapWidth - 1));
      rgba.insert(rgba.end(), {color->r, color->g, color->b, 255});
    }
  }
  map_texture_ =
      device_.create_texture(static_cast<int>(kMapWidth), static_cast<int>(maps_.size()), rgba, /*smooth=*/false);
  return map_texture_;
}

ScalarRange Scene::scalar_range(VariantLayer layer) const {
  ScalarRange out;
  if (const Layer* const found = layers_.find(layer))
    for (const InstanceBuffer& buffer : found->kinds) out.add(buffer.scalar_range());
  return out;
}

ShownMap Scene::shown_map(VariantLayer layer, const LayerStyle& style) const {
  const Layer* const found = layers_.find(layer);
  if (style.color_map.empty() || found == nullptr) return {};
  const auto has_scalars = [](const InstanceBuffer& buffer) { return buffer.scalars() != BufferId{}; };
  if (std::ranges::none_of(found->kinds, has_scalars)) return {};
  return chosen_map(maps_, style, scalar_range(layer));
}

bool Scene::Drawing::go_on(double ms) {
  constexpr double kShortMs = 4.0;  // more instances are drawn at a time below, and fewer above the other limit
  constexpr double kLongMs = 12.0;
  constexpr std::uint32_t kFewest = 64;
  const bool is_limited = ms < std::numeric_limits<double>::infinity();
  double spent = 0.0;
  while (next_ < steps_.size() && (spent == 0.0 || spent < ms)) {
    if (!is_limited) {
      static_cast<void>(steps_[next_](kAllInstances));
      ++next_;
      continue;
    }
    const auto begin = std::chrono::steady_clock::now();
    const bool is_done = steps_[next_](piece_);
    // A driver draws later, so the time is known only after this.
    device_->finish();
    const double took = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count();
    spent += std::max(took, 1e-6);
    if (is_done)
      ++next_;
    else if (took < kShortMs)
      piece_ = std::min(2 * piece_, kAllInstances);
    else if (took > kLongMs)
      piece_ = std::max(piece_ / 2, kFewest);
  }
  return next_ == steps_.size();
}

void Scene::draw(const Camera& camera, std::span<const LayerView> views, const DrawOptions& options) {
  begin(camera, views, options).go_on(std::numeric_limits<double>::infinity());
}

Scene::Drawing Scene::begin(const Camera& camera, std::span<const LayerView> views, const DrawOptions& options) {
  constexpr double kFirstPieceNs = 1e5;
  Drawing out;
  out.device_ = &device_;
  // The first piece is small, because nothing is known about the size of its instances.
  out.piece_ = static_cast<std::uint32_t>(std::clamp(kFirstPieceNs / std::max(device_.instance_cost_ns(), 1e-3), 64.0,
                                                     static_cast<double>(kAllInstances)));
  Steps& steps = out.steps_;
  draw_calls_ = 0;
  is_coarse_ = false;
  const double content_scale =
      std::isfinite(options.content_scale) ? std::clamp(options.content_scale, 0.01, 100.0) : 1.0;
  const Pass pass{.camera = camera,
                  .content_scale = content_scale,
                  .target = options.target,
                  .group = {},
                  .area = {options.left, options.bottom, camera.width(), camera.height()},
                  .preview = options.preview};
  const auto add_at_once = [&steps](auto step) {
    steps.push_back([step = std::move(step)](std::uint32_t) {
      step();
      return true;
    });
  };
  for (const LayerView& view : views) {
    if (view.layer == picture_layer_) add_at_once([this, pass, style = view.style] { draw_picture(pass, style); });
    if (view.texts) {
      add_at_once([this, pass, view] { draw_texts(pass, view); });
      continue;
    }
    Layer* const layer = layers_.find(view.layer);
    if (layer == nullptr || !layer->is_used) continue;
    Pass of_view = pass;
    of_view.every = std::max(1U, view.every);
    const ShownMap shown = shown_map(view.layer, view.style);
    Look look{.style = view.style, .map = shown.map, .range = shown.range, .counted = layer->counted};
    if (look.map != nullptr) look.map_row = static_cast<float>(look.map - maps_.data());
    draw_layer(steps, of_view, layer->kinds, look);
  }
  if (!options.overlays) return out;
  for (OverlaySet& set : overlays_) {
    if (set.buffer.count() > 0)
      draw_layer(steps, pass, std::span(&set.buffer, 1), {.style = set.style, .ring = set.ring});
  }
  return out;
}

void Scene::draw_picture(const Pass& pass, const LayerStyle& style) {
  const double opacity = static_cast<double>(premultiplied({}, style.opacity).a);
  if (picture_place_.width > 0.0 && std::isfinite(picture_place_.width) && opacity > 0.0) {
    const Camera& camera = pass.camera;
    const double scale = 1.0 / camera.units_per_pixel();
    const glm::dvec2 middle = scale * to_dvec2((picture_place_.center - camera.center()) - camera.center_low());
    const double half_width = 0.5 * picture_place_.width;
    const glm::dvec2 half = scale * glm::dvec2(half_width, half_width * picture_aspect_);
    // Cuts to slightly more than the view, so that the numbers are small at any zoom.
    const glm::dvec2 view = 0.5 * glm::dvec2(camera.width(), camera.height()) + 2.0;
    const glm::dvec2 low = glm::max(middle - half, -view);
    const glm::dvec2 high = glm::min(middle + half, view);
    // NaN fails this test, too.
    if (!(low.x < high.x && low.y < high.y)) return;
    const glm::dvec2 from = 0.5 * (low - middle) / half;
    const glm::dvec2 to = 0.5 * (high - middle) / half;
    device_.draw_picture({.target = pass.target,
                          .area = pass.area,
                          .texture = picture_,
                          .place = glm::vec4(glm::dvec4(low, high)),
                          .part = glm::vec4(0.5 + from.x, 0.5 - from.y, 0.5 + to.x, 0.5 - to.y),
                          .opacity = static_cast<float>(opacity)});
    ++draw_calls_;
  }
}

void Scene::draw_texts(const Pass& pass, const LayerView& view) {
  const PremultipliedColor color = premultiplied(view.style.color, view.style.opacity);
  if (color.a <= 0.0F || !view.texts->font || view.texts->texts.empty()) return;
  std::unique_ptr<TextMask>& mask = texts_[view.layer];
  if (!mask) mask = std::make_unique<TextMask>(device_);
  mask->show(view.texts, pass.camera, pass.content_scale);
  if (mask->parts().empty()) return;
  device_.paint_mask(pass.target, pass.area, mask->mask(), mask->parts(), color);
  ++draw_calls_;
}

void Scene::draw_layer(Steps& steps, const Pass& pass, std::span<InstanceBuffer> kinds, const Look& look) {
  const LayerStyle& style = look.style;
  const PremultipliedColor color = premultiplied(style.color, style.opacity);
  if (color.a <= 0.0F) return;
  bool is_empty = true;
  bool has_triangles = false;
  for (const InstanceBuffer& buffer : kinds) {
    if (buffer.count() == 0) continue;
    is_empty = false;
    has_triangles = has_triangles || buffer.kind() == PrimitiveKind::triangle;
  }
  if (is_empty) return;
  // An opaque group looks the same when drawn directly, except for triangles: their coverages add up at shared edges.
  const bool as_group = has_triangles || (style.flat && color.a < 1.0F);
  if (as_group && style.flat) {
    draw_group(steps, pass, kinds, look);
    return;
  }
  const auto draw_all = [&](bool triangles) {
    for (const PrimitiveKind kind : kDrawOrder) {
      for (InstanceBuffer& buffer : kinds) {
        if (buffer.kind() != kind || buffer.count() == 0 || (kind == PrimitiveKind::triangle) != triangles) continue;
        if (triangles) {
          draw_group(steps, pass, std::span(&buffer, 1), look);
        } else {
          draw_kind(steps, pass, buffer, look, color, Blend::over);
        }
      }
    }
  };
  draw_all(true);
  draw_all(false);
}

void Scene::draw_group(Steps& steps, const Pass& pass, std::span<InstanceBuffer> kinds, const Look& look) {
  // A single colour is applied at the end; several colours are drawn into the group.
  const bool has_colors = look.map != nullptr;
  constexpr PremultipliedColor kWhite(1.0F);
  const Pass inner{.camera = pass.camera,
                   .content_scale = pass.content_scale,
                   .target = {},
                   .group = has_colors ? TargetFormat::color : TargetFormat::coverage,
                   .area = {0, 0, pass.area.width, pass.area.height},
                   .every = pass.every,
                   .preview = pass.preview};
  steps.push_back([this, inner](std::uint32_t) {
    device_.clear(target_of(inner), inner.area, clear_color(std::nullopt));
    return true;
  });
  for (const PrimitiveKind kind : kDrawOrder) {
    for (InstanceBuffer& buffer : kinds) {
      if (buffer.kind() != kind || buffer.count() == 0) continue;
      const Blend blend = kind == PrimitiveKind::triangle ? Blend::add : Blend::over;
      draw_kind(steps, inner, buffer, look, has_colors ? premultiplied(look.style.color, 1.0) : kWhite, blend);
    }
  }
  const PremultipliedColor color = has_colors ? premultiplied(Rgb{255, 255, 255}, look.style.opacity)
                                              : premultiplied(look.style.color, look.style.opacity);
  steps.push_back([this, pass, inner, color](std::uint32_t) {
    device_.composite(pass.target, pass.area, target_of(inner), color);
    return true;
  });
}

FramebufferId Scene::target_of(const Pass& pass) {
  return pass.group ? group_target(*pass.group, pass.area.width, pass.area.height) : pass.target;
}

FramebufferId Scene::group_target(TargetFormat format, int width, int height) {
  GroupTarget& group = groups_[static_cast<std::size_t>(format)];
  if (group.id == FramebufferId{} || group.width < width || group.height < height) {
    if (group.id != FramebufferId{}) device_.destroy_framebuffer(group.id);
    group.id = {};
    group.width = std::max(group.width, width);
    group.height = std::max(group.height, height);
    group.id = device_.create_framebuffer({.width = group.width, .height = group.height, .format = format});
  }
  return group.id;
}

// Returns false if the instances must be painted.
bool Scene::draw_counted(Steps& steps, const Pass& pass, InstanceBuffer& buffer, const Look& look,
                         const PixelFrame& frame, const PremultipliedColor& color) {
  if (look.counted.empty()) return false;
  std::unique_ptr<CountedInstances>& counted = look.counted[static_cast<std::size_t>(buffer.kind())];
  std::optional<CountedLook> shown;
  if (look.map == nullptr)
    shown = counted_look(buffer.kind(), look.style, static_cast<double>(color.a), pass.content_scale, pass.preview);
  if (shown) shown->preview = pass.preview;
  if (!shown || !CountedInstances::is_cheaper(buffer, frame, device_)) {
    counted.reset();
    return false;
  }
  if (!counted) counted = CountedInstances::create(buffer.kind(), device_);
  steps.push_back([this, pass, &buffer, &counted = *counted, frame, look = *shown, color](std::uint32_t) {
    counted.show(buffer, frame, look);
    is_coarse_ = is_coarse_ || counted.is_coarse();
    // The mask already contains the opacity.
    device_.paint_mask(target_of(pass), pass.area, counted.mask(), counted.parts(), color / color.a);
    ++draw_calls_;
    return true;
  });
  return true;
}

void Scene::draw_kind(Steps& steps, const Pass& pass, InstanceBuffer& buffer, const Look& look,
                      const PremultipliedColor& color, Blend blend) {
  const LayerStyle& style = look.style;
  const Camera& camera = pass.camera;
  const Placement placement = placement_of(buffer, camera);
  if (placement.reach <= kCountedReach && draw_counted(steps, pass, buffer, look, placement.frame, color)) return;
  const CenterParts x = split(placement.frame.center_x, placement.frame.center_low_x);
  const CenterParts y = split(placement.frame.center_y, placement.frame.center_low_y);
  const bool is_point = buffer.kind() == PrimitiveKind::point;

  DrawCall call;
  call.area = pass.area;
  call.blend = blend;
  call.buffer = buffer.buffer();
  call.instances = buffer.count();
  if (buffer.kind() == PrimitiveKind::disk) call.every = pass.every;
  DrawUniforms& u = call.uniforms;
  u.center_1 = {x.pieces[0], y.pieces[0]};
  u.center_2 = {x.pieces[1], y.pieces[1]};
  u.center_3 = {x.pieces[2], y.pieces[2]};
  u.center_words = glm::uvec4(x.words, y.words);
  u.center_low_words = glm::uvec4(x.low_words, y.low_words);
  u.pixels_per_unit = static_cast<float>(placement.frame.scale);
  const float line_width = pixels(line_width_of(style), pass.content_scale);
  u.half_width_px = 0.5F * (is_point ? pixels(point_size_of(style), pass.content_scale) : line_width);
  u.ring_px = is_point && look.ring ? 0.5F * line_width : 0.0F;
  u.half_view_px = 0.5F * glm::vec2(camera.width(), camera.height());
  u.view_radius_px = std::hypot(u.half_view_px.x, u.half_view_px.y);
  u.color = color;
  const DashPattern dashes = dash_of(style);
  u.dash_px = pixels(dashes.dash, pass.content_scale);
  u.dash_period_px = pixels(dashes.period, pass.content_scale);
  u.arc_pieces = arc_pieces(buffer.kind(), buffer.extent(), placement.frame.scale);

  call.program.kind = buffer.kind();
  if (!is_point && placement.reach > kNearReach) call.program.reach = Reach::far;
  call.program.dashed = style.dashed && is_stroked(buffer.kind());
  if (look.map != nullptr && buffer.scalars() != BufferId{}) {
    call.program.mapped = true;
    call.scalars = buffer.scalars();
    call.maps = map_texture();
    set_map(*look.map, look.range, look.map_row, u);
  }
  // Thinning counts from the first instance on, whatever is in view.
  const Box2 everywhere = shown_box(placement.frame, std::numeric_limits<double>::infinity());
  const double margin = static_cast<double>(u.half_width_px) + static_cast<double>(u.ring_px);
  for (const BlockBoxes::Run run : buffer.runs(call.every > 1 ? everywhere : shown_box(placement.frame, margin))) {
    call.first = run.first;
    call.instances = run.count;
    steps.push_back([this, pass, rest = call](std::uint32_t most) mutable {
      rest.target = target_of(pass);
      DrawCall part = rest;
      part.instances = std::min(rest.instances, std::max(most - most % rest.every, rest.every));
      device_.draw(part);
      ++draw_calls_;
      rest.first += part.instances;
      rest.instances -= part.instances;
      return rest.instances == 0;
    });
  }
}

}  // namespace mes::render
