// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/scene.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include "core/base/assert.h"

namespace mes::render {
namespace {

// Beyond this many pixels from the centre lines, circles and arcs are placed with more bits. There single precision
// rounds to 1/128 of a pixel. Smaller: costlier programs at ordinary views; larger: lines begin to shake.
constexpr double kNearReach = 0x1p17;
// Scales at which the drawing is far below a pixel, or a pixel far below what doubles tell apart.
constexpr double kMinScale = 0x1p-70;
constexpr double kMaxScale = 0x1p80;

// Dash and gap in logical pixels, for a stroke of one pixel; they grow with wide strokes to stay recognisable.
constexpr double kDash = 5.0;
constexpr double kGap = 4.0;

/// Triangles first: those of a group have to be summed before anything else covers them.
constexpr std::array<PrimitiveKind, kPrimitiveKinds> kDrawOrder{
    PrimitiveKind::triangle, PrimitiveKind::disk,   PrimitiveKind::line, PrimitiveKind::ray,
    PrimitiveKind::segment,  PrimitiveKind::circle, PrimitiveKind::arc,  PrimitiveKind::point};

/// One coordinate of the view's centre in the forms programs want.
struct CenterParts {
  float first;
  float second;
  float third;
  std::array<std::uint32_t, 2> bits;
  std::array<std::uint32_t, 2> low_bits;
};

std::array<std::uint32_t, 2> words_of(double value) {
  const auto bits = std::bit_cast<std::uint64_t>(value);
  return {static_cast<std::uint32_t>(bits), static_cast<std::uint32_t>(bits >> 32U)};
}

CenterParts split(double value, double low) {
  // The same cuts as the vertex programs make: 21 bits, 16 bits, and here all the rest.
  const auto bits = std::bit_cast<std::uint64_t>(value);
  const double first = std::bit_cast<double>(bits & ~std::uint64_t{0xffffffff});
  const double rest = std::bit_cast<double>(bits & ~std::uint64_t{0xffff});
  return {.first = static_cast<float>(first),
          .second = static_cast<float>(rest - first),
          .third = static_cast<float>((value - rest) + low),
          .bits = words_of(value),
          .low_bits = words_of(low)};
}

/// The camera's centre in a drawing frame, one coordinate; the low part holds what the first cannot.
CenterParts center_in(double center, double center_low, double origin, double scale) {
  const double high = center - origin;
  const double part = high - center;
  const double error = (center - (high - part)) + (-origin - part);
  const double scaled = high * scale;
  if (!(std::abs(scaled) < kDrawingLimit)) return split(std::copysign(kDrawingLimit, high), 0.0);
  // Renormalised, so that the low part does not reach into the pieces of the high one.
  const double rest = (error + center_low) * scale;
  const double sum = scaled + rest;
  return split(sum, rest - (sum - scaled));
}

PremultipliedColor premultiplied(Rgb color, double opacity) {
  const double alpha = std::isfinite(opacity) ? std::clamp(opacity, 0.0, 1.0) : 1.0;
  const auto channel = [&](std::uint8_t value) { return static_cast<float>(value / 255.0 * alpha); };
  return {channel(color.r), channel(color.g), channel(color.b), static_cast<float>(alpha)};
}

float pixels(double logical, double content_scale, double low, double high) {
  const double size = std::isfinite(logical) ? std::clamp(logical, low, high) : low;
  return static_cast<float>(size * content_scale);
}

/// Quads along a circle: more cost vertices, fewer cost fragments between the chord and the rim. Small circles are a
/// square each (0): measured, a square of 30 pixels costs as much as eight quads.
float arc_pieces(PrimitiveKind kind, const InstanceExtent& extent, double scale) {
  if (extent.radius * scale < 16.0) return 0.0F;
  // An arc strays no farther from its chords than a circle as long as it.
  const double radius_px =
      (kind == PrimitiveKind::arc ? 0.5 / std::numbers::pi * extent.length : extent.radius) * scale;
  if (radius_px < 16.0) return 4.0F;
  if (radius_px < 60.0) return 8.0F;
  if (radius_px < 150.0) return 12.0F;
  return radius_px < 500.0 ? 20.0F : 32.0F;
}

}  // namespace

struct Scene::Pass {
  const Camera& camera;
  double content_scale;
  FramebufferId target;
  PixelRect area;
  std::uint32_t every = 1;  // of disks
};

Scene::Scene(Device& device) : device_(device) {}

Scene::~Scene() {
  if (group_ != FramebufferId{}) device_.destroy_framebuffer(group_);
}

void Scene::apply(const FramePatch& patch) {
  frame_ = patch.frame;
  for (std::size_t i = 0; i < patch.layer_count; ++i) {
    const LayerPatch& changes = patch.layers[i];
    while (layers_.size() <= changes.layer) {
      Layer& layer = layers_.emplace_back();
      for (const PrimitiveKind kind : kAllPrimitiveKinds) {
        layer.kinds[static_cast<std::size_t>(kind)] = InstanceBuffer(device_, kind);
      }
    }
    for (const PrimitiveKind kind : kAllPrimitiveKinds) {
      InstanceBuffer& buffer = layers_[changes.layer].kinds[static_cast<std::size_t>(kind)];
      bytes_uploaded_ += buffer.apply(changes[kind], patch.frame);
    }
  }
}

void Scene::forget(LayerIndex layer) {
  if (layer >= layers_.size()) return;
  for (InstanceBuffer& buffer : layers_[layer].kinds) buffer.clear();
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
  bytes_uploaded_ += set.buffer.replace(static_cast<std::uint32_t>(count), overlay.data, frame_);
}

void Scene::clear_overlay(std::uint32_t slot) {
  if (slot < overlays_.size()) overlays_[slot].buffer.clear();
}

std::uint32_t Scene::instances(LayerIndex layer, PrimitiveKind kind) const {
  return layer < layers_.size() ? layers_[layer].kinds[static_cast<std::size_t>(kind)].count() : 0;
}

void Scene::draw(const Camera& camera, std::span<const LayerView> views, const DrawOptions& options) {
  draw_calls_ = 0;
  const double content_scale =
      std::isfinite(options.content_scale) ? std::clamp(options.content_scale, 0.01, 100.0) : 1.0;
  const Pass pass{.camera = camera,
                  .content_scale = content_scale,
                  .target = options.target,
                  .area = {options.left, options.bottom, camera.width(), camera.height()}};
  for (const LayerView& view : views) {
    if (view.layer >= layers_.size()) continue;
    Pass of_view = pass;
    of_view.every = std::max(1U, view.every);
    draw_layer(of_view, layers_[view.layer].kinds, view.style, false);
  }
  if (!options.overlays) return;
  for (const OverlaySet& set : overlays_) {
    if (set.buffer.count() > 0) draw_layer(pass, std::span(&set.buffer, 1), set.style, set.ring);
  }
}

void Scene::draw_layer(const Pass& pass, std::span<const InstanceBuffer> kinds, const LayerStyle& style, bool ring) {
  const PremultipliedColor color = premultiplied(style.color, style.opacity);
  if (color[3] <= 0.0F) return;
  bool is_empty = true;
  bool has_triangles = false;
  for (const InstanceBuffer& buffer : kinds) {
    if (buffer.count() == 0) continue;
    is_empty = false;
    has_triangles = has_triangles || buffer.kind() == PrimitiveKind::triangle;
  }
  if (is_empty) return;
  // An opaque group looks the same drawn directly. Not so triangles: those that share an edge have to add up there.
  const bool as_group = has_triangles || (style.flat && color[3] < 1.0F);
  if (as_group && style.flat) {
    draw_group(pass, kinds, style, ring);
    return;
  }
  const auto draw_all = [&](bool triangles) {
    for (const PrimitiveKind kind : kDrawOrder) {
      for (const InstanceBuffer& buffer : kinds) {
        if (buffer.kind() != kind || buffer.count() == 0 || (kind == PrimitiveKind::triangle) != triangles) continue;
        if (triangles) {
          draw_group(pass, std::span(&buffer, 1), style, ring);
        } else {
          draw_kind(pass, buffer, style, ring, color, Blend::over);
        }
      }
    }
  };
  draw_all(true);
  draw_all(false);
}

void Scene::draw_group(const Pass& pass, std::span<const InstanceBuffer> kinds, const LayerStyle& style, bool ring) {
  const FramebufferId group = group_target(pass.area.width, pass.area.height);
  const Pass inner{.camera = pass.camera,
                   .content_scale = pass.content_scale,
                   .target = group,
                   .area = {0, 0, pass.area.width, pass.area.height},
                   .every = pass.every};
  device_.clear(group, inner.area, {});
  for (const PrimitiveKind kind : kDrawOrder) {
    for (const InstanceBuffer& buffer : kinds) {
      if (buffer.kind() != kind || buffer.count() == 0) continue;
      const Blend blend = kind == PrimitiveKind::triangle ? Blend::add : Blend::over;
      draw_kind(inner, buffer, style, ring, {1.0F, 1.0F, 1.0F, 1.0F}, blend);
    }
  }
  device_.composite(pass.target, pass.area, group, premultiplied(style.color, style.opacity));
}

FramebufferId Scene::group_target(int width, int height) {
  if (group_ == FramebufferId{} || group_width_ < width || group_height_ < height) {
    if (group_ != FramebufferId{}) device_.destroy_framebuffer(group_);
    group_ = {};
    group_width_ = std::max(group_width_, width);
    group_height_ = std::max(group_height_, height);
    group_ = device_.create_framebuffer(
        {.width = group_width_, .height = group_height_, .format = TargetFormat::coverage});
  }
  return group_;
}

void Scene::draw_kind(const Pass& pass, const InstanceBuffer& buffer, const LayerStyle& style, bool ring,
                      const PremultipliedColor& color, Blend blend) {
  const DrawingFrame& frame = buffer.frame();
  const Camera& camera = pass.camera;
  const CenterParts x = center_in(camera.center().x, camera.center_low().x, frame.origin.x, frame.scale);
  const CenterParts y = center_in(camera.center().y, camera.center_low().y, frame.origin.y, frame.scale);
  const double scale = std::clamp(1.0 / camera.units_per_pixel() / frame.scale, kMinScale, kMaxScale);
  const bool is_point = buffer.kind() == PrimitiveKind::point;

  DrawCall call;
  call.target = pass.target;
  call.area = pass.area;
  call.blend = blend;
  call.buffer = buffer.buffer();
  call.instances = buffer.count();
  if (buffer.kind() == PrimitiveKind::disk) call.every = pass.every;
  DrawUniforms& u = call.uniforms;
  u.center_1 = {x.first, y.first};
  u.center_2 = {x.second, y.second};
  u.center_3 = {x.third, y.third};
  u.center_bits = {x.bits[0], x.bits[1], y.bits[0], y.bits[1]};
  u.center_low_bits = {x.low_bits[0], x.low_bits[1], y.low_bits[0], y.low_bits[1]};
  u.pixels_per_unit = static_cast<float>(scale);
  const float line_width = pixels(style.line_width_px, pass.content_scale, 0.1, 64.0);
  u.half_width_px = 0.5F * (is_point ? pixels(style.point_size_px, pass.content_scale, 0.1, 256.0) : line_width);
  u.ring_px = is_point && ring ? 0.5F * line_width : 0.0F;
  u.half_view_px = {0.5F * static_cast<float>(camera.width()), 0.5F * static_cast<float>(camera.height())};
  u.view_radius_px = std::hypot(u.half_view_px[0], u.half_view_px[1]);
  u.color = color;
  const double width = std::max(1.0, style.line_width_px / 2.0);
  u.dash_px = static_cast<float>(kDash * width * pass.content_scale);
  u.dash_period_px = static_cast<float>((kDash + kGap) * width * pass.content_scale);
  u.arc_pieces = arc_pieces(buffer.kind(), buffer.extent(), scale);

  call.program.kind = buffer.kind();
  const double center_size = std::max(std::abs(x.first), std::abs(y.first));
  const double reach = (buffer.extent().coordinate + buffer.extent().radius + center_size) * scale;
  if (!is_point && reach > kNearReach) call.program.reach = Reach::far;
  call.program.dashed =
      style.dashed && (buffer.kind() == PrimitiveKind::segment || buffer.kind() == PrimitiveKind::ray ||
                       buffer.kind() == PrimitiveKind::line || is_ring(buffer.kind()));
  device_.draw(call);
  ++draw_calls_;
}

}  // namespace mes::render
