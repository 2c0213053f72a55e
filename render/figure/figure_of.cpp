// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/figure/figure_of.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "core/base/assert.h"
#include "core/base/geometry/arc.h"
#include "core/base/geometry/parabola_arc.h"
#include "core/base/geometry/turn.h"
#include "render/figure/internal/chains.h"
#include "render/figure/internal/grid.h"
#include "render/figure/internal/visible_part.h"
#include "render/look.h"

namespace mes::figure {
namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();
// Margin beyond half a stroke's width: ends of cut strokes stay out of sight, even blurred ones.
constexpr double kBeyond = 1.0;

const LayerDescriptor& descriptor_of(const Drawing& drawing, VariantLayer layer) {
  return drawing.layers[layer.layer];
}

/// The range of the finite scalars of a layer.
render::ScalarRange scalar_range(const LayerMirror& mirror, VariantLayer layer) {
  render::ScalarRange out;
  for (const PrimitiveKind kind : kAllPrimitiveKinds) {
    const std::span<const double> instances = mirror.instances(layer, kind);
    const std::size_t stride = stride_of(kind);
    for (std::size_t at = stride; at <= instances.size(); at += stride) out.add(instances[at - 1]);
  }
  return out;
}

bool meet(const Box2& a, const Box2& b) {
  return a.low.x <= b.high.x && b.low.x <= a.high.x && a.low.y <= b.high.y && b.low.y <= a.high.y;
}

/// Cuts a convex polygon by a half-plane, and keeps the part with positive `height` (Sutherland and Hodgman, "Reentrant
/// polygon clipping", 1974).
template <class Height>
std::vector<Vec2> cut(const std::vector<Vec2>& corners, const Height& height) {
  std::vector<Vec2> out;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2 a = corners[i];
    const Vec2 b = corners[(i + 1) % corners.size()];
    const double above = height(a);
    const double next = height(b);
    if (above >= 0.0) out.push_back(a);
    if ((above < 0.0) != (next < 0.0)) out.push_back(a + above / (above - next) * (b - a));
  }
  return out;
}

/// Converts the instances of one layer to visible shapes.
class LayerBuilder {
 public:
  LayerBuilder(const Drawing& drawing, const Page& page, const Grid& grid, const render::LayerView& view)
      : drawing_(drawing),
        page_(page),
        grid_(grid),
        view_(view),
        style_(view.style),
        points_per_pixel_(kPointsPerPixel * drawing.scale),
        width_(points_per_pixel_ * render::line_width_of(view.style)) {
    const double beyond = 0.5 * width_ + kBeyond;
    box_.low = {-beyond, -beyond};
    box_.high = {page.width + beyond, page.height + beyond};
    diagonal_ = std::hypot(box_.width(), box_.height());
    shown_ = shown_map(drawing, view);
    if (style_.dashed) {
      const render::DashPattern dashes = render::dash_of(style_);
      period_ = points_per_pixel_ * dashes.period;
      dash_ = points_per_pixel_ * dashes.dash;
    }
  }

  FigureLayer layer(VariantLayer index) {
    const LayerDescriptor& descriptor = descriptor_of(drawing_, index);
    FigureLayer out{.id = std::string(descriptor.id), .title = std::string(descriptor.name), .line_width = width_};
    const double opacity = render::opacity_of(style_);
    if (opacity <= 0.0) return out;
    if (view_.texts) {
      add_texts(*view_.texts, out);
      return out;
    }
    // Same as in `Scene`: a flat layer is one group, and triangles always are.
    if (style_.flat && opacity < 1.0) {
      Group all{.opacity = opacity};
      for (const PrimitiveKind kind : render::kDrawOrder) add(index, kind, 1.0, all);
      keep(std::move(all), out);
      return out;
    }
    Group triangles{.opacity = opacity};
    add(index, PrimitiveKind::triangle, 1.0, triangles);
    keep(std::move(triangles), out);
    Group others;
    for (const PrimitiveKind kind : render::kDrawOrder)
      if (kind != PrimitiveKind::triangle) add(index, kind, opacity, others);
    keep(std::move(others), out);
    return out;
  }

 private:
  void add_texts(const render::LayerTexts& texts, FigureLayer& layer) const {
    if (!texts.font) return;
    const double size = points_per_pixel_ * texts.size;
    for (const render::PlacedText& each : texts.texts) {
      const Vec2 start = to_page(each.at.x, each.at.y) + points_per_pixel_ * texts.shift;
      if (!is_finite(start)) continue;
      layer.texts.push_back(
          {.start = grid_(start),
           .size = size,
           .width = kPointsPerPixel * render::text_width(*texts.font, size / kPointsPerPixel, each.text),
           .color = style_.color,
           .text = each.text,
           .opacity = render::opacity_of(style_)});
    }
  }

  void keep(Group group, FigureLayer& layer) const {
    if (group.runs.empty()) return;
    for (Run& run : group.runs)
      if (!run.is_filled && run.opacity >= 1.0 && run.dashes == Dashes{}) chain_segments(run.shapes, grid_);
    layer.groups.push_back(std::move(group));
  }

  Vec2 to_page(double x, double y) const {
    const Vec2 from_center = (Vec2{x, y} - page_.center) - page_.center_low;
    return {0.5 * page_.width + from_center.x / page_.units_per_point,
            0.5 * page_.height - from_center.y / page_.units_per_point};
  }

  void add(VariantLayer index, PrimitiveKind kind, double opacity, Group& group) {
    const std::span<const double> instances = drawing_.mirror.instances(index, kind);
    const std::size_t stride = stride_of(kind);
    for (std::size_t at = 0; at < instances.size(); at += stride) {
      const double* const v = instances.data() + at;
      color_ = style_.color;
      if (shown_.map != nullptr) color_ = shown_.map->color_of(v[stride - 1], shown_.range).value_or(style_.color);
      group_ = &group;
      opacity_ = opacity;
      add(kind, v);
    }
  }

  void add(PrimitiveKind kind, const double* v) {
    switch (kind) {
      case PrimitiveKind::point:
        disk(to_page(v[0], v[1]), 0.5 * points_per_pixel_ * render::point_size_of(style_));
        break;
      case PrimitiveKind::disk: disk(to_page(v[0], v[1]), v[2] / page_.units_per_point); break;
      case PrimitiveKind::circle: circle(to_page(v[0], v[1]), v[2] / page_.units_per_point); break;
      case PrimitiveKind::segment: {
        const Vec2 from = to_page(v[0], v[1]);
        straight(from, to_page(v[2], v[3]) - from, {0.0, 1.0});
        break;
      }
      // Page directions: only their angle matters, and no length of a document direction overflows.
      case PrimitiveKind::ray: straight(to_page(v[0], v[1]), direction(v[2], v[3]), {0.0, kEndless}); break;
      case PrimitiveKind::line: straight(to_page(v[0], v[1]), direction(v[2], v[3]), {-kEndless, kEndless}); break;
      case PrimitiveKind::triangle: triangle(v); break;
      case PrimitiveKind::arc: arc({{v[0], v[1]}, v[2], {v[3], v[4]}, {v[5], v[6]}}); break;
      case PrimitiveKind::parabola: parabola(v); break;
    }
  }

  static Vec2 direction(double dx, double dy) {
    const double size = std::max(std::abs(dx), std::abs(dy));
    const Vec2 scaled{dx / size, -dy / size};
    const double rest = length(scaled);
    return {scaled.x / rest, scaled.y / rest};
  }

  void put(Shape shape, const Dashes& dashes = {}) {
    const bool filled = is_filled(shape.kind);
    for (Vec2& p : shape.p) p = grid_(p);
    // Radius zero would make some viewers stop at the circle.
    const bool is_round =
        shape.kind == ShapeKind::disk || shape.kind == ShapeKind::circle || shape.kind == ShapeKind::arc;
    if (is_round) shape.radius = std::max(grid_(shape.radius), grid_.step());
    std::vector<Run>& runs = group_->runs;
    if (runs.empty() || runs.back().is_filled != filled || runs.back().color != color_ ||
        runs.back().opacity != opacity_ || runs.back().dashes != dashes)
      runs.push_back({color_, opacity_, filled, dashes, {}});
    runs.back().shapes.push_back(shape);
  }

  bool is_huge(double radius) const { return radius >= HugeCircle::kLeast * diagonal_; }

  void disk(Vec2 center, double radius) {
    if (!is_finite(center) || !std::isfinite(radius) || !ring_meets(box_, center, 0.0, radius)) return;
    if (!is_huge(radius)) {
      put({.kind = ShapeKind::disk, .p = {center}, .radius = radius});
    } else if (const auto part = HugeCircle(box_, center, radius).disk()) {
      put(*part);
    }
  }

  void circle(Vec2 center, double radius) {
    if (!is_finite(center) || !std::isfinite(radius) || !ring_meets(box_, center, radius, radius)) return;
    if (!is_huge(radius)) {
      put({.kind = ShapeKind::circle, .p = {center}, .radius = radius}, along_circle(radius, 0.0));
    } else if (const auto part = HugeCircle(box_, center, radius).rim()) {
      put(*part, along_circle(radius, angle(center, part->p[0])));
    }
  }

  void arc(const Arc& arc) {
    const Vec2 center = to_page(arc.center.x, arc.center.y);
    const double radius = arc.radius / page_.units_per_point;
    const double sweep = sweep_of(arc);
    if (arc.from == arc.to) {
      circle(center, radius);
      return;
    }
    if (!is_finite(center) || !std::isfinite(radius) || !ring_meets(box_, center, radius, radius)) return;
    const Vec2 from = to_page(arc.from.x, arc.from.y);
    const Vec2 to = to_page(arc.to.x, arc.to.y);
    if (is_huge(radius)) {
      for (const Shape& piece : HugeCircle(box_, center, radius).arc(from, to))
        put(piece, along_circle(radius, angle(center, piece.p[0])));
      return;
    }
    const Box2 bounds = bounding_box_of(arc);
    Box2 on_page;
    on_page.add(to_page(bounds.low.x, bounds.low.y));
    on_page.add(to_page(bounds.high.x, bounds.high.y));
    if (!meet(on_page, box_)) return;
    // Both ends fall on one point of the page: the arc is nearly nothing of the circle, or nearly all of it.
    if (grid_(from) == grid_(to)) {
      if (sweep > 0.5 * kTurn)
        put({.kind = ShapeKind::circle, .p = {center}, .radius = radius}, along_circle(radius, 0.0));
      else
        put({.kind = ShapeKind::segment, .p = {from, to}});
      return;
    }
    put({.kind = ShapeKind::arc, .p = {from, to, center}, .radius = radius, .sweep = sweep},
        along_circle(radius, angle(center, from)));
  }

  /// Angle on screen, counter-clockwise from the direction to the right, in [0, 2 pi).
  static double angle(Vec2 center, Vec2 p) {
    const double out = std::atan2(center.y - p.y, p.x - center.x);
    return out < 0.0 ? out + kTurn : out;
  }

  /// A whole number of periods fits around a circle, counted from its rightmost point.
  Dashes along_circle(double radius, double from) const {
    if (!style_.dashed) return {};
    const double around = kTurn * radius;
    const double period = around / std::max(1.0, std::floor(around / period_ + 0.5));
    const double dash = dash_ * (period / period_);
    return {dash, period - dash, std::fmod(from * radius + 0.5 * dash, period)};
  }

  /// Adds start + t * direction for the t in `within`.
  void straight(Vec2 start, Vec2 direction, Stretch within) {
    if (!is_finite(start) || !is_finite(direction)) return;
    Stretch seen = stretch_in(box_, start, direction, within);
    if (seen.is_empty()) return;
    Dashes dashes;
    if (style_.dashed) {
      dashes = {dash_, period_ - dash_, 0.5 * dash_};
      // Starts at the middle of a dash, so that all strokes of the layer share one pattern.
      const double step = period_ / std::max(length(direction), grid_.step());
      seen.low = std::max(std::floor(seen.low / step) * step, within.low);
    }
    const auto at = [&](double t, double end, Vec2 there) { return t == end ? there : start + t * direction; };
    put({.kind = ShapeKind::segment, .p = {at(seen.low, 0.0, start), at(seen.high, 1.0, start + direction)}}, dashes);
  }

  void parabola(const double* v) {
    const ParabolaArc arc{to_page(v[0], v[1]), to_page(v[2], v[3]), to_page(v[4], v[5])};
    if (!is_finite(arc.from) || !is_finite(arc.control) || !is_finite(arc.to)) return;
    parabola(arc, 0.0, 1.0, 0);
  }

  /// Adds the part of the arc from parameter `low` to `high`. Halves it if it is in view and reaches far beyond.
  void parabola(const ParabolaArc& arc, double low, double high, int halvings) {
    constexpr int kMostHalvings = 60;
    const ParabolaArc part = part_of(arc, low, high);
    const Box2 bounds = bounding_box_of(part);
    if (!meet(bounds, box_)) return;
    const Box2 near = box_near_page();
    if (!near.contains(bounds.low) || !near.contains(bounds.high)) {
      const double middle = 0.5 * (low + high);
      if (halvings == kMostHalvings) return;
      parabola(arc, low, middle, halvings + 1);
      parabola(arc, middle, high, halvings + 1);
      return;
    }
    Dashes dashes;
    if (style_.dashed)
      dashes = {dash_, period_ - dash_, std::fmod(length_of(part_of(arc, 0.0, low)) + 0.5 * dash_, period_)};
    // The curve leaves its chord by a quarter of this at most.
    const double bend = length((part.to - part.control) - (part.control - part.from));
    const bool is_straight = 0.25 * bend < 0.5 * grid_.step();
    put({.kind = is_straight ? ShapeKind::segment : ShapeKind::parabola, .p = {part.from, part.to, part.control}},
        dashes);
  }

  /// Coordinates in this box are of the page's size.
  Box2 box_near_page() const {
    return {box_.low - Vec2{diagonal_, diagonal_}, box_.high + Vec2{diagonal_, diagonal_}};
  }

  void triangle(const double* v) {
    std::vector<Vec2> corners{to_page(v[0], v[1]), to_page(v[2], v[3]), to_page(v[4], v[5])};
    Box2 bounds;
    for (const Vec2 corner : corners) {
      if (!is_finite(corner)) return;
      bounds.add(corner);
    }
    if (!meet(bounds, box_)) return;
    if (cross(corners[1] - corners[0], corners[2] - corners[0]) < 0.0) std::swap(corners[1], corners[2]);
    // Corners keep their positions while the numbers are of the page's size.
    const Box2 near = box_near_page();
    if (!near.contains(bounds.low) || !near.contains(bounds.high)) {
      corners = cut(corners, [&](Vec2 p) { return p.x - box_.low.x; });
      corners = cut(corners, [&](Vec2 p) { return box_.high.x - p.x; });
      corners = cut(corners, [&](Vec2 p) { return p.y - box_.low.y; });
      corners = cut(corners, [&](Vec2 p) { return box_.high.y - p.y; });
    }
    for (std::size_t i = 2; i < corners.size(); ++i)
      put({.kind = ShapeKind::triangle, .p = {corners[0], corners[i - 1], corners[i]}});
  }

  const Drawing& drawing_;
  const Page& page_;
  const Grid& grid_;
  const render::LayerView& view_;
  const LayerStyle& style_;
  double points_per_pixel_;
  double width_;
  Box2 box_;
  double diagonal_ = 1.0;
  double period_ = 0.0;
  double dash_ = 0.0;
  render::ShownMap shown_;
  Group* group_ = nullptr;
  Rgb color_;
  double opacity_ = 1.0;
};

std::optional<PlacedImage> placed(const Traced& traced, const LayerStyle& style, const Page& page) {
  const double opacity = render::opacity_of(style);
  if (traced.image == nullptr || !(traced.place.width > 0.0) || opacity <= 0.0) return std::nullopt;
  const double width = traced.place.width / page.units_per_point;
  const double height = width * traced.image->height / traced.image->width;
  const Vec2 from_center = (traced.place.center - page.center) - page.center_low;
  const Vec2 middle{0.5 * page.width + from_center.x / page.units_per_point,
                    0.5 * page.height - from_center.y / page.units_per_point};
  return PlacedImage{*traced.image, middle - Vec2{0.5 * width, 0.5 * height}, width, height, opacity};
}

Box2 around(Vec2 center, double reach) {
  return {center - Vec2{reach, reach}, center + Vec2{reach, reach}};
}

/// Bounds on the page, without the width of strokes.
Box2 bounds_of(const Shape& shape) {
  Box2 box;
  switch (shape.kind) {
    case ShapeKind::disk:
    case ShapeKind::circle: return around(shape.p[0], shape.radius);
    case ShapeKind::segment:
      box.add(shape.p[0]);
      box.add(shape.p[1]);
      return box;
    case ShapeKind::triangle:
      for (std::size_t i = 0; i < 3; ++i) box.add(shape.p[i]);
      return box;
    case ShapeKind::parabola: return bounding_box_of(ParabolaArc{shape.p[0], shape.p[2], shape.p[1]});
    case ShapeKind::arc: {
      // Mirrored, so that counter-clockwise has the meaning of `Arc`.
      const auto flipped = [](Vec2 p) { return Vec2{p.x, -p.y}; };
      const Box2 bounds =
          bounding_box_of(Arc{flipped(shape.p[2]), shape.radius, flipped(shape.p[0]), flipped(shape.p[1])});
      box.add(flipped(bounds.low));
      box.add(flipped(bounds.high));
      return box;
    }
    case ShapeKind::rim:
    case ShapeKind::curve:
      // The curve leaves the page at both ends, so its points bound the visible part.
      for (std::size_t i = 0; i < (shape.kind == ShapeKind::rim ? 6 : 4); ++i) box.add(shape.p[i]);
      return box;
  }
  return box;
}

/// Adds the largest area that any letters of the texts can cover.
void add(Box2& box, std::span<const Text> texts) {
  constexpr double kAscent = 0.8;
  constexpr double kDescent = 0.25;
  for (const Text& text : texts) {
    box.add(text.start - Vec2{0.0, kAscent * text.size});
    box.add(text.start + Vec2{text.width, kDescent * text.size});
  }
}

}  // namespace

Page page_of(const render::Camera& camera, double width) {
  const double points_per_pixel = width / camera.width();
  return {camera.center(), camera.center_low(), camera.units_per_pixel() / points_per_pixel, width,
          points_per_pixel * camera.height()};
}

Page page_of(const render::Camera& camera) {
  return page_of(camera, kPointsPerPixel * camera.width());
}

Page part_of(const Page& page, const Box2& part) {
  Page out = page;
  out.width = part.width();
  out.height = part.height();
  const Vec2 moved = part.center() - Vec2{0.5 * page.width, 0.5 * page.height};
  // The low part receives the shift, which has the page's size.
  out.center_low = out.center_low + page.units_per_point * Vec2{moved.x, -moved.y};
  return out;
}

render::ShownMap shown_map(const Drawing& drawing, const render::LayerView& view) {
  if (view.style.color_map.empty() || descriptor_of(drawing, view.layer).scalar.empty()) return {};
  return render::chosen_map(drawing.maps, view.style, scalar_range(drawing.mirror, view.layer));
}

Figure figure_of(const Drawing& drawing, const Page& page) {
  const int decimals = decimals_for(page.width, page.height);
  const Grid grid(decimals);
  Figure out{.width = page.width, .height = page.height, .decimals = decimals, .background = drawing.background};
  for (const render::LayerView& view : drawing.views) {
    MES_ASSERT(!drawing.layers.empty());
    FigureLayer layer = LayerBuilder(drawing, page, grid, view).layer(view.layer);
    if (view.layer == drawing.traced.layer) layer.image = placed(drawing.traced, view.style, page);
    out.layers.push_back(std::move(layer));
  }
  return out;
}

std::size_t shape_count(const FigureLayer& layer) {
  std::size_t out = 0;
  for (const Group& group : layer.groups)
    for (const Run& run : group.runs) out += run.shapes.size();
  return out;
}

std::size_t shape_count(const Figure& figure) {
  std::size_t out = 0;
  for (const FigureLayer& layer : figure.layers) out += shape_count(layer);
  return out;
}

Box2 ink_below_texts(const FigureLayer& layer) {
  Box2 box;
  if (layer.image) {
    box.add(layer.image->corner);
    box.add(layer.image->corner + Vec2{layer.image->width, layer.image->height});
  }
  for (const Group& group : layer.groups) {
    for (const Run& run : group.runs) {
      const double reach = run.is_filled ? 0.0 : 0.5 * layer.line_width;
      for (const Shape& shape : run.shapes) {
        const Box2 bounds = bounds_of(shape);
        box.add(bounds.low - Vec2{reach, reach});
        box.add(bounds.high + Vec2{reach, reach});
      }
    }
  }
  return box;
}

Box2 ink_box(const FigureLayer& layer) {
  Box2 box = ink_below_texts(layer);
  add(box, layer.texts);
  return box;
}

Box2 ink_box(const Figure& figure) {
  Box2 box;
  for (const FigureLayer& layer : figure.layers)
    if (const Box2 ink = ink_box(layer); !ink.is_empty()) box.add(ink);
  for (const Box& part : figure.legend.boxes) {
    box.add(part.corner);
    box.add(part.corner + Vec2{part.width, part.height});
  }
  add(box, figure.legend.texts);
  if (box.is_empty()) return box;
  const Vec2 size{figure.width, figure.height};
  const auto within = [](double value, double high) { return std::clamp(value, 0.0, high); };
  return {{within(box.low.x, size.x), within(box.low.y, size.y)},
          {within(box.high.x, size.x), within(box.high.y, size.y)}};
}

}  // namespace mes::figure
