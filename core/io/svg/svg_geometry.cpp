// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/svg/svg_geometry.h"

#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <utility>

#include "core/io/svg/svg_shapes.h"

namespace mes {
namespace {

std::string_view property_name(SvgProperty property) {
  switch (property) {
    case SvgProperty::x: return "x";
    case SvgProperty::y: return "y";
    case SvgProperty::width: return "width";
    case SvgProperty::height: return "height";
    case SvgProperty::cx: return "cx";
    case SvgProperty::cy: return "cy";
    case SvgProperty::r: return "r";
    case SvgProperty::rx: return "rx";
    case SvgProperty::ry: return "ry";
    case SvgProperty::stroke_width: return "stroke-width";
    default: return "a length";
  }
}

}  // namespace

bool is_svg_shape(std::string_view kind) {
  constexpr std::array<std::string_view, 7> kShapes{"path", "rect",     "circle", "ellipse",
                                                    "line", "polyline", "polygon"};
  return std::ranges::find(kShapes, kind) != kShapes.end();
}

void SvgGeometry::finish(const JobControl* job) {
  if (kind == Kind::path) path = read_svg_path(data, job);
  if (kind == Kind::polyline || kind == Kind::polygon) path = read_svg_points(data, kind == Kind::polygon, job);
}

void SvgElements::remark_ignored(std::string_view attribute, pugi::xml_node node, std::string_view value) {
  remark(fmt::format("value of {} is not understood, and is ignored", attribute),
         fmt::format("values of {} are not understood, and are ignored", attribute),
         source_.place_of(node, value, 0));
}

std::optional<double> SvgElements::length_of(pugi::xml_node node, std::string_view name, std::string_view text,
                                             SvgAxis axis, const SvgViewport& viewport) {
  if (text.empty() || text == "auto") return std::nullopt;
  const auto value = svg_length(text, axis, viewport);
  if (!value) remark_ignored(name, node, text);
  return value;
}

std::optional<double> SvgElements::length(pugi::xml_node node, const SvgStyle& style, SvgProperty property,
                                          SvgAxis axis, const SvgViewport& viewport) {
  return length_of(node, property_name(property), style[property], axis, viewport);
}

Affine SvgElements::transform(pugi::xml_node node, const SvgStyle& style) {
  const std::string_view text = style[SvgProperty::transform];
  if (text.empty()) return {};
  const auto map = svg_transform(text);
  if (!map) {
    remark_ignored("transform", node, text);
    return {};
  }
  const std::string_view origin = style[SvgProperty::transform_origin];
  if (origin.empty()) return *map;
  // Only two lengths are supported; percentages and words refer to boxes that are unknown here.
  SvgText rest(origin);
  const auto pixels = [&rest]() -> std::optional<double> {
    rest.skip_blanks();
    const auto value = rest.number();
    const std::string_view unit = rest.word();
    return unit.empty() || unit == "px" ? value : std::nullopt;
  };
  const auto x = pixels();
  const auto y = pixels();
  if (!x || !y || !rest.is_at_end()) {
    remark_ignored("transform-origin", node, origin);
    return *map;
  }
  return Affine::translation(*x, *y) * *map * Affine::translation(-*x, -*y);
}

SvgGeometry SvgElements::shape(pugi::xml_node node, std::string_view kind, const SvgStyle& style,
                               const SvgViewport& viewport) {
  SvgGeometry out;
  if (kind == "path" || kind == "polyline" || kind == "polygon") {
    out.data = source_.value(node, kind == "path" ? "d" : "points");
    out.kind = kind == "path"       ? SvgGeometry::Kind::path
               : kind == "polyline" ? SvgGeometry::Kind::polyline
                                    : SvgGeometry::Kind::polygon;
  } else if (auto curve = simple_shape(node, kind, style, viewport)) {
    out.path.curves.push_back(*std::move(curve));
  }
  return out;
}

std::optional<PlaneCurve> SvgElements::simple_shape(pugi::xml_node node, std::string_view kind, const SvgStyle& style,
                                                    const SvgViewport& viewport) {
  using P = SvgProperty;
  const auto given = [&](P property, SvgAxis axis) { return length(node, style, property, axis, viewport); };
  const auto x = [&](P property) { return given(property, SvgAxis::x).value_or(0.0); };
  const auto y = [&](P property) { return given(property, SvgAxis::y).value_or(0.0); };
  if (kind == "line") {
    const auto end = [&](const char* name, SvgAxis axis) {
      return length_of(node, name, node.attribute(name).value(), axis, viewport).value_or(0.0);
    };
    PlaneCurve curve({end("x1", SvgAxis::x), end("y1", SvgAxis::y)});
    curve.line_to({end("x2", SvgAxis::x), end("y2", SvgAxis::y)});
    return curve;
  }
  if (kind == "circle") {
    const double radius = given(P::r, SvgAxis::both).value_or(0.0);
    return svg_ellipse({x(P::cx), y(P::cy)}, {radius, radius});
  }
  const auto rx = given(P::rx, SvgAxis::x);
  const auto ry = given(P::ry, SvgAxis::y);
  const Vec2 radii{rx ? *rx : ry.value_or(0.0), ry ? *ry : rx.value_or(0.0)};
  if (kind == "ellipse") return svg_ellipse({x(P::cx), y(P::cy)}, radii);
  return svg_rect({x(P::x), y(P::y)}, {x(P::width), y(P::height)}, radii);
}

}  // namespace mes
