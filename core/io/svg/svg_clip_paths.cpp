// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/svg/svg_clip_paths.h"

#include <fmt/core.h>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>

#include "core/curves/curve_bounds.h"
#include "core/io/svg/svg_shapes.h"

namespace mes {
namespace {

using P = SvgProperty;

/// The value of an inherited property, from the element or its nearest ancestor that has one; empty for none.
std::string_view inherited(SvgStyles& styles, pugi::xml_node node, SvgProperty property) {
  for (; node.type() == pugi::node_element; node = node.parent()) {
    const SvgStyle style = styles.of(node);
    const std::string_view value = style[property];
    if (value == "initial") return {};
    if (!value.empty() && value != "inherit" && value != "unset") return value;
  }
  return {};
}

}  // namespace

void SvgClipPaths::set_extent(double extent) {
  if (grid_ == 0.0 && extent > 0.0) grid_ = clip_grid(extent);
}

bool SvgClipPaths::is_within_bounds() const {
  return spent_.elements <= most_.elements && spent_.pieces <= most_.pieces;
}

void SvgClipPaths::remark_not_applied(pugi::xml_node node, std::string_view why) {
  elements_.remark(fmt::format("clip path is not applied, {}", why),
                   fmt::format("clip paths are not applied, {}", why), source_.place_of(node));
}

ClipRegion SvgClipPaths::of(pugi::xml_node node, const SvgStyle& style, const SvgContext& context,
                            const std::function<Box2()>& box) {
  const std::string_view value = style[P::clip_path];
  if (value.empty() || value == "none" || value == "initial" || value == "unset" || value == "inherit") return {};
  const auto link = svg_link(value);
  if (!link) {
    remark_not_applied(node, "which is not that of an element");
    return {};
  }
  const auto found = names_.find(link->id);
  if (link->id.empty() || found == names_.end() || local_name(found->second.name()) != "clipPath") {
    remark_not_applied(node, "which is not in this file");
    return {};
  }
  if (std::ranges::find(around_, found->second) != around_.end()) {
    remark_not_applied(node, "which refers to itself");
    return {};
  }
  // A region knows the curves of all others that cut it.
  constexpr std::size_t kLongestChain = 32;
  if (around_.size() == kLongestChain) {
    remark_not_applied(node, "which is at the end of a chain of more than 32");
    return {};
  }
  auto region = region_of(found->second, context, box);
  if (!region) {
    remark_not_applied(node, "whose coordinates or box leave no room for it");
    return {};
  }
  return *std::move(region);
}

std::optional<ClipRegion> SvgClipPaths::region_of(pugi::xml_node clip_path, const SvgContext& context,
                                                  const std::function<Box2()>& box) {
  const SvgStyle style = styles_.of(clip_path);
  SvgContext inner;
  inner.viewport = context.viewport;
  inner.map = context.map * elements_.transform(clip_path, style);
  if (std::string_view(clip_path.attribute("clipPathUnits").value()) == "objectBoundingBox") {
    const Box2 around = box();
    if (!(around.width() > 0.0) || !(around.height() > 0.0)) return std::nullopt;
    inner.map = inner.map * Affine::translation(around.low.x, around.low.y) *
                Affine::scaling(around.width(), around.height());
    inner.viewport = {1.0, 1.0};
  }
  const auto known = std::ranges::find_if(
      known_, [&](const Known& one) { return one.clip_path == clip_path && one.map == inner.map; });
  if (known != known_.end()) return known->region;
  inner.is_visible = inherited(styles_, clip_path, P::visibility) != "hidden" &&
                     inherited(styles_, clip_path, P::visibility) != "collapse";
  inner.clips_even_odd = inherited(styles_, clip_path, P::clip_rule) == "evenodd";
  around_.push_back(clip_path);
  std::vector<ClipRegion> parts;
  const auto children = clip_path.children();
  inner.companions = static_cast<std::size_t>(std::distance(children.begin(), children.end())) - 1;
  for (const pugi::xml_node child : children)
    if (child.type() == pugi::node_element && is_within_bounds()) add_child(child, inner, parts, 0);
  if (grid_ == 0.0) set_extent(1.0);
  ClipRegion region = parts.empty() ? ClipRegion::of({}, FillRule::nonzero, grid_) : ClipRegion::united(parts, grid_);
  SvgContext outer = context;
  region = ClipRegion::common(region, of(clip_path, style, outer, box));
  around_.pop_back();
  constexpr std::size_t kMostKnown = 64;
  if (known_.size() == kMostKnown) known_.erase(known_.begin(), known_.begin() + kMostKnown / 2);
  known_.push_back({clip_path, inner.map, region});
  return region;
}

void SvgClipPaths::add_child(pugi::xml_node node, SvgContext context, std::vector<ClipRegion>& to, int depth) {
  constexpr int kDeepest = 8;
  ++spent_.elements;
  if (job_ != nullptr && job_->stop_requested()) throw Cancelled{};
  const std::string_view kind = local_name(node.name());
  if (kind == "text") {
    elements_.remark("text element in a clip path is left out", "text elements in clip paths are left out",
                     source_.place_of(node));
    return;
  }
  if (kind != "use" && !is_svg_shape(kind)) return;
  const SvgStyle style = styles_.of(node);
  if (style[P::display] == "none") return;
  const std::string_view visibility = style[P::visibility];
  if (visibility == "visible" || visibility == "initial") context.is_visible = true;
  if (visibility == "hidden" || visibility == "collapse") context.is_visible = false;
  const std::string_view rule = style[P::clip_rule];
  if (rule == "evenodd") context.clips_even_odd = true;
  if (rule == "nonzero" || rule == "initial") context.clips_even_odd = false;
  context.map = context.map * elements_.transform(node, style);
  std::vector<ClipRegion> parts;
  Box2 bounds;
  if (kind == "use") {
    const auto found = names_.find(svg_link_of_use(node));
    if (found == names_.end() || depth == kDeepest) return;
    SvgContext inner = context;
    const Vec2 shift{elements_.length(node, style, P::x, SvgAxis::x, context.viewport).value_or(0.0),
                     elements_.length(node, style, P::y, SvgAxis::y, context.viewport).value_or(0.0)};
    inner.map = inner.map * Affine::translation(shift.x, shift.y);
    const std::string_view target = local_name(found->second.name());
    if (target == "use" || !(is_svg_shape(target) || target == "text")) return;  // SVG allows no other target
    add_child(found->second, inner, parts, depth + 1);
  } else if (context.is_visible) {
    SvgGeometry shape = elements_.shape(node, kind, style, context.viewport);
    shape.finish(job_);
    bounds = bounds_of(shape.path.curves);
    const FillRule fill = context.clips_even_odd ? FillRule::even_odd : FillRule::nonzero;
    if (auto region = region_of_curves(std::move(shape.path.curves), context.map, fill, context.companions))
      parts.push_back(*std::move(region));
    else
      elements_.remark("shape in a clip path is left out, which is too large or crosses itself too often",
                       "shapes in clip paths are left out, which are too large or cross themselves too often",
                       source_.place_of(node));
  }
  if (parts.empty()) return;
  const ClipRegion own = of(node, style, context, [&] { return bounds; });
  to.push_back(ClipRegion::common(parts.front(), own));
}

std::optional<ClipRegion> SvgClipPaths::region_of_curves(std::vector<PlaneCurve> curves, const Affine& map,
                                                         FillRule rule, std::size_t companions) {
  for (PlaneCurve& curve : curves) {
    curve.transform(map);
    spent_.pieces += curve.piece_count();
  }
  if (grid_ == 0.0) {
    const Box2 box = bounds_of(curves);
    if (!box.is_empty())
      set_extent(std::max({std::abs(box.low.x), std::abs(box.low.y), std::abs(box.high.x), std::abs(box.high.y)}));
  }
  if (grid_ == 0.0) set_extent(1.0);
  if (!ClipRegion::fits(curves, grid_)) return std::nullopt;
  return ClipRegion::of(curves, rule, grid_, companions);
}

ClipRegion SvgClipPaths::viewport(const SvgViewport& size, const Affine& map) {
  if (!viewport_.is_plane() && viewport_map_ == map && viewport_size_.width == size.width &&
      viewport_size_.height == size.height)
    return viewport_;
  auto rect = svg_rect({}, {size.width, size.height}, {});
  if (!rect) return {};
  auto region = region_of_curves({*std::move(rect)}, map, FillRule::nonzero);
  if (!region) return {};
  viewport_ = *region;
  viewport_map_ = map;
  viewport_size_ = size;
  return viewport_;
}

}  // namespace mes
