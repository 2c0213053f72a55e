// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/svg/svg_drawing.h"

#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <pugixml.hpp>
#include <utility>

#include "core/base/lower_case.h"
#include "core/curves/curve_bounds.h"
#include "core/io/svg/svg_clip_paths.h"
#include "core/io/svg/svg_context.h"
#include "core/io/svg/svg_geometry.h"
#include "core/io/svg/svg_shape_queue.h"
#include "core/io/svg/svg_style.h"
#include "core/io/svg/svg_values.h"
#include "core/io/text/ascii_text.h"
#include "core/io/text/text_numbers.h"
#include "core/io/xml/css_text.h"
#include "core/io/xml/xml_source.h"

namespace mes {
namespace {

constexpr std::size_t kMostElements = 1'000'000;
constexpr std::size_t kMostClipElements = 100'000;  // a clip path takes longer than a shape
constexpr std::size_t kMostSvgPieces = 4'000'000;   // or the file's number of bytes, if larger
constexpr std::size_t kDeepestElement = 200;

using pugi::xml_node;
using P = SvgProperty;

std::string_view prefix_of(std::string_view name) {
  const std::size_t colon = name.find(':');
  return colon == std::string_view::npos ? std::string_view{} : name.substr(0, colon);
}

bool is_left_out(std::string_view kind) {
  constexpr std::array<std::string_view, 5> kLeftOut{"text", "image", "foreignObject", "flowRoot", "video"};
  return is_one_of(kind, kLeftOut);
}

bool is_drawn(std::string_view kind) {
  constexpr std::array<std::string_view, 5> kGroups{"svg", "use", "g", "a", "switch"};
  return is_one_of(kind, kGroups) || is_left_out(kind) || is_svg_shape(kind);
}

/// Whether the conditions of an element hold: no extensions are supported, and the language is English.
bool is_chosen(xml_node node) {
  if (node.attribute("requiredExtensions")) return false;
  const pugi::xml_attribute languages = node.attribute("systemLanguage");
  if (!languages) return true;
  CssText rest(languages.value());
  for (; !rest.is_at_end(); rest.take(",")) {
    const std::string one = lower_case(css_trimmed(rest.up_to(",")));
    if (one == "en" || one.starts_with("en-")) return true;
  }
  return false;
}

/// Whether a colour is invisible.
bool is_clear(std::string_view color) {
  if (color == "none" || color == "transparent") return true;
  if (color.starts_with('#'))
    return (color.size() == 5 && color[4] == '0') || (color.size() == 9 && color.ends_with("00"));
  const std::string lower = lower_case(color.substr(0, 64));
  if ((!lower.starts_with("rgb") && !lower.starts_with("hsl")) || !lower.ends_with(')')) return false;
  const std::size_t slash = lower.rfind('/');
  const std::size_t comma = std::ranges::count(lower, ',') == 3 ? lower.rfind(',') : std::string::npos;
  const std::size_t before = slash != std::string::npos ? slash : comma;
  if (before == std::string::npos) return false;
  const auto alpha = svg_share(std::string_view(lower).substr(before + 1, lower.size() - before - 2));
  return alpha && *alpha <= 0.0;
}

bool is_left_to_others(std::string_view value) {
  return value.empty() || value == "inherit" || value == "unset";
}

/// The page in the unit of the coordinates that are read.
struct SvgPage {
  SvgViewport size{};
  std::string_view unit = "px";
  double pixels = 1.0;  ///< of 1/96 inch, in a unit
};

class DrawingReader {
 public:
  DrawingReader(std::string_view bytes, const std::string& name, ReadJob& job)
      : source_(bytes, name),
        job_(job),
        most_pieces_(std::max(kMostSvgPieces, bytes.size())),
        elements_(source_),
        queue_(source_, job, most_pieces_) {}

  Expected<SvgDrawing> read() {
    constexpr double kParsed = 0.2;  // share of the reading time
    job_.begin(source_.bytes(), kParsed);
    const auto parsed = source_.parse(job_, {"d", "points"});
    if (!parsed) return std::unexpected(parsed.error());
    job_.begin(source_.bytes());
    const xml_node root = *parsed;
    if (local_name(root.name()) != "svg") return refuse(place_of(root), "the root element is not svg");
    prefix_ = prefix_of(root.name());
    note_names(root);
    styles_.emplace(root, source_);
    clip_paths_.emplace(source_, names_, *styles_, elements_, job_.control());
    clip_paths_->set_most({kMostClipElements, most_pieces_});
    note_sheets_outside(root);
    if (auto done = read_root(root); !done) return std::unexpected(done.error());
    if (auto done = queue_.finish(); !done) return std::unexpected(done.error());
    if (auto good = check_bounds(root); !good) return std::unexpected(good.error());
    SvgDrawing out;
    out.curves.curves = queue_.take();
    out.unit = unit_;
    out.page = page_;
    out.warnings = source_.messages();
    return out;
  }

 private:
  std::unexpected<Error> refuse(std::size_t place, std::string text) const {
    return source_.refuse(place, std::move(text));
  }
  std::size_t place_of(xml_node node) const { return source_.place_of(node); }
  void remark(std::string one, std::string many, xml_node node) {
    elements_.remark(std::move(one), std::move(many), place_of(node));
  }
  void remark_hidden(xml_node node) { remark("hidden element is left out", "hidden elements are left out", node); }

  /// Avoids recursion because the depth has not been checked yet.
  void note_names(xml_node root) {
    for (xml_node node = root; node;) {
      if (const pugi::xml_attribute id = node.attribute("id")) names_.try_emplace(id.value(), node);
      if (const xml_node child = node.first_child()) {
        node = child;
        continue;
      }
      while (node && node != root && !node.next_sibling()) node = node.parent();
      node = !node || node == root ? xml_node() : node.next_sibling();
    }
  }

  void note_sheets_outside(xml_node root) {
    if (source_.bytes().substr(0, place_of(root)).find("<?xml-stylesheet") != std::string_view::npos)
      remark("style sheet of another file is not read", "style sheets of other files are not read", root);
  }

  Expected<void> check_bounds(xml_node node) const {
    if (elements_read_ + clip_paths_->spent().elements > kMostElements)
      return refuse(place_of(node), fmt::format("the drawing has more than {} elements, those that are used again "
                                                "counted each time",
                                                kMostElements));
    if (clip_paths_->spent().elements > kMostClipElements)
      return refuse(place_of(node),
                    fmt::format("the clip paths have more than {} elements, those that are used again "
                                "counted each time",
                                kMostClipElements));
    if (clip_paths_->spent().pieces > most_pieces_)
      return refuse(place_of(node),
                    fmt::format("the clip paths have more than {} pieces of curves, those that are used "
                                "again counted each time",
                                most_pieces_));
    if (styles_->has_given_up())
      return refuse(place_of(node), "the style sheets are too involved for so many elements");
    return {};
  }

  std::optional<double> length(xml_node node, const SvgStyle& style, P property, SvgAxis axis,
                               const SvgContext& context) {
    return elements_.length(node, style, property, axis, context.viewport);
  }
  Affine shift_of(xml_node node, const SvgStyle& style, const SvgContext& context) {
    return Affine::translation(length(node, style, P::x, SvgAxis::x, context).value_or(0.0),
                               length(node, style, P::y, SvgAxis::y, context).value_or(0.0));
  }

  /// Whether a paint is visible.
  bool is_paint(std::string_view value, bool& has_pattern) {
    has_pattern = false;
    const auto link = svg_link(value);
    if (!link) return !is_clear(value);
    const auto found = link->id.empty() ? names_.end() : names_.find(link->id);
    if (found == names_.end()) return !link->rest.empty() && !is_clear(link->rest);
    has_pattern = local_name(found->second.name()) == "pattern";
    return true;
  }

  static double share_of(std::string_view value, double inherited) {
    if (is_left_to_others(value)) return inherited;
    return svg_share(value).value_or(1.0);
  }

  void take_paints(xml_node node, const SvgStyle& style, SvgContext& context) {
    if (const std::string_view fill = style[P::fill]; !is_left_to_others(fill))
      context.has_fill = fill == "initial" || is_paint(fill, context.has_pattern);
    bool has_pattern = false;
    if (const std::string_view stroke = style[P::stroke]; !is_left_to_others(stroke))
      context.has_stroke = stroke != "initial" && is_paint(stroke, has_pattern);
    context.fill_opacity = share_of(style[P::fill_opacity], context.fill_opacity);
    context.stroke_opacity = share_of(style[P::stroke_opacity], context.stroke_opacity);
    if (const std::string_view width = style[P::stroke_width]; !is_left_to_others(width))
      context.stroke_width = length(node, style, P::stroke_width, SvgAxis::both, context).value_or(1.0);
    if (const std::string_view rule = style[P::fill_rule]; !is_left_to_others(rule))
      context.fills_even_odd = rule == "evenodd";
    for (const P marker : {P::marker_start, P::marker_mid, P::marker_end}) {
      if (is_left_to_others(style[marker])) continue;
      const auto link = svg_link(style[marker]);
      context.has_marker = link && names_.contains(link->id);
    }
  }

  /// The context within an element; nothing if the element is not displayed.
  std::optional<SvgContext> context_of(xml_node node, std::string_view kind, const SvgStyle& style,
                                       SvgContext context) {
    const std::string_view display = style[P::display];
    // `contents` removes the box of an element: a shape vanishes, a group keeps its children.
    const bool is_gone = display == "none" || (display == "contents" && (is_svg_shape(kind) || is_left_out(kind)));
    if (is_gone || svg_share(style[P::opacity]).value_or(1.0) <= 0.0) {
      remark_hidden(node);
      return std::nullopt;
    }
    const std::string_view visibility = style[P::visibility];
    if (visibility == "visible" || visibility == "initial") context.is_visible = true;
    if (visibility == "hidden" || visibility == "collapse") context.is_visible = false;
    take_paints(node, style, context);
    context.map = context.map * elements_.transform(node, style);
    if (is_measuring_) return context;
    const SvgContext around = context;
    context.clip = ClipRegion::common(
        context.clip, clip_paths_->of(node, style, context, [&] { return measured(node, kind, style, around); }));
    const std::string_view mask = style[P::mask];
    if (const auto link = svg_link(mask); link && (link->id.empty() || names_.contains(link->id)))
      remark("mask is not applied; what it hides is read", "masks are not applied; what they hide is read", node);
    return context;
  }

  /// The bounding box of what an element draws, in its own coordinates.
  Box2 measured(xml_node node, std::string_view kind, const SvgStyle& style, SvgContext context) {
    context.map = {};
    context.clip = {};
    const bool was_quiet = std::exchange(elements_.is_quiet, true);
    is_measuring_ = true;
    box_ = {};
    const auto path = path_;
    // Any error here occurs again when the content is read.
    static_cast<void>(read_content(node, kind, style, context));
    path_ = path;
    is_measuring_ = false;
    elements_.is_quiet = was_quiet;
    return box_;
  }

  /// The unit of width and height, if these attributes have the same and are what counts, else pixels.
  static SvgPage page_of(xml_node root, const SvgViewport& size) {
    SvgPage out{.size = size};
    const auto width = svg_paper_length(root.attribute("width").value());
    const auto height = svg_paper_length(root.attribute("height").value());
    const bool is_moved = !std::string_view(root.attribute("transform").value()).empty();
    if (!width || !height || width->unit != height->unit || is_moved) return out;
    if (width->pixels * width->value != size.width || height->pixels * height->value != size.height) return out;
    return {.size = {width->value, height->value}, .unit = width->unit, .pixels = width->pixels};
  }

  Expected<void> read_root(xml_node root) {
    SvgContext context;
    const SvgStyle style = styles_->of(root);
    const auto box = svg_view_box(root.attribute("viewBox").value());
    if (box) context.viewport = {(*box)[2], (*box)[3]};
    const SvgViewport size{length(root, style, P::width, SvgAxis::x, context).value_or(context.viewport.width),
                           length(root, style, P::height, SvgAxis::y, context).value_or(context.viewport.height)};
    const SvgPage page = page_of(root, size);
    unit_ = page.unit;
    if (page.size.width > 0.0 && page.size.height > 0.0) page_ = {page.size.width, page.size.height};
    clip_paths_->set_extent(std::max(page.size.width, page.size.height));
    const std::string_view overflow = style[P::overflow];
    if (size.width > 0.0 && size.height > 0.0 && overflow != "visible")
      queue_.set_page({{0.0, 0.0}, {page.size.width, page.size.height}});
    // Without a view box coordinates are in pixels. y points down in SVG.
    const double factor = box && size.width > 0.0 && size.height > 0.0 ? 1.0 : 1.0 / page.pixels;
    context.map = Affine{factor, 0.0, 0.0, -factor, 0.0, page.size.height};
    const auto inner = context_of(root, "svg", style, context);
    return inner ? read_viewport(root, *inner, box ? page.size : size) : Expected<void>{};
  }

  /// Reads the content of an `svg` or `symbol` of this size.
  Expected<void> read_viewport(xml_node node, SvgContext context, const SvgViewport& size) {
    const std::string_view text = node.attribute("viewBox").value();
    const auto box = svg_view_box(text);
    if (!text.empty() && !box) elements_.remark_ignored("viewBox", node, text);
    context.viewport = size;
    if (box && size.width > 0.0 && size.height > 0.0) {
      context.map = context.map * svg_fit(*box, size, node.attribute("preserveAspectRatio").value());
      context.viewport = {(*box)[2], (*box)[3]};
    }
    return read_children(node, context);
  }

  /// The same for one within the drawing, which clips its content.
  Expected<void> read_inner_viewport(xml_node node, const SvgStyle& style, SvgContext context,
                                     const SvgViewport& size) {
    const std::string_view overflow = style[P::overflow];
    const bool is_open = overflow.starts_with("visible") || overflow.starts_with("auto");
    if (!is_open && !is_measuring_ && size.width > 0.0 && size.height > 0.0)
      context.clip = ClipRegion::common(context.clip, clip_paths_->viewport(size, context.map));
    return read_viewport(node, context, size);
  }

  Expected<void> read_children(xml_node node, const SvgContext& context) {
    const bool is_switch = local_name(node.name()) == "switch";
    path_.push_back(node);
    for (const xml_node child : node.children()) {
      if (child.type() != pugi::node_element) continue;
      const bool is_taken =
          is_switch && prefix_of(child.name()) == prefix_ && is_drawn(local_name(child.name())) && is_chosen(child);
      if (is_switch && !is_taken) continue;
      if (auto done = read_element(child, context); !done) return done;
      if (is_taken) break;  // an element "switch" draws only its first valid child
    }
    path_.pop_back();
    return {};
  }

  Expected<void> read_element(xml_node node, const SvgContext& outer) {
    if (prefix_of(node.name()) != prefix_) return {};  // an element of another vocabulary
    ++elements_read_;
    if (auto good = check_bounds(node); !good) return good;
    if (path_.size() > kDeepestElement) return refuse(place_of(node), "elements are nested too deeply");
    const std::string_view kind = local_name(node.name());
    if (!is_drawn(kind)) return {};
    if (!is_chosen(node)) return {};
    const SvgStyle style = styles_->of(node);
    const auto context = context_of(node, kind, style, outer);
    return context ? read_content(node, kind, style, *context) : Expected<void>{};
  }

  Expected<void> read_content(xml_node node, std::string_view kind, const SvgStyle& style,
                              const SvgContext& context) {
    if (kind == "use") return read_use(node, style, context);
    if (is_svg_shape(kind)) return read_shape(node, kind, style, context);
    if (kind == "svg" && node.parent().type() == pugi::node_element) return read_nested_svg(node, style, context);
    if (is_left_out(kind)) {
      if (context.is_visible)
        remark(fmt::format("{} element is left out", kind), fmt::format("{} elements are left out", kind), node);
      else
        remark_hidden(node);
      return {};
    }
    return read_children(node, context);
  }

  Expected<void> read_nested_svg(xml_node node, const SvgStyle& style, SvgContext context) {
    context.map = context.map * shift_of(node, style, context);
    const SvgViewport size{length(node, style, P::width, SvgAxis::x, context).value_or(context.viewport.width),
                           length(node, style, P::height, SvgAxis::y, context).value_or(context.viewport.height)};
    return read_inner_viewport(node, style, context, size);
  }

  Expected<void> read_use(xml_node node, const SvgStyle& style, const SvgContext& context) {
    const std::string_view link = svg_link_of_use(node);
    const auto found = link.empty() ? names_.end() : names_.find(link);
    if (found == names_.end()) {
      remark("use element is left out, which refers to nothing here",
             "use elements are left out, which refer to nothing here", node);
      return {};
    }
    const xml_node target = found->second;
    if (target == node || std::ranges::find(path_, target) != path_.end()) {
      remark("use element is left out, which is part of what it refers to",
             "use elements are left out, which are part of what they refer to", node);
      return {};
    }
    SvgContext inner = context;
    inner.map = inner.map * shift_of(node, style, inner);
    path_.push_back(node);
    auto done = read_used(target, inner, node, style);
    path_.pop_back();
    return done;
  }

  Expected<void> read_used(xml_node target, const SvgContext& context, xml_node use, const SvgStyle& style_of_use) {
    const std::string_view kind = local_name(target.name());
    if ((kind != "symbol" && kind != "svg") || target.parent().type() != pugi::node_element)
      return read_element(target, context);
    const SvgStyle style = styles_->of(target);
    // A size in the `use` overrides that of the referenced element.
    const auto size = [&](P side, SvgAxis axis, double otherwise) {
      if (const auto here = length(use, style_of_use, side, axis, context)) return *here;
      return length(target, style, side, axis, context).value_or(otherwise);
    };
    const SvgViewport viewport{size(P::width, SvgAxis::x, context.viewport.width),
                               size(P::height, SvgAxis::y, context.viewport.height)};
    ++elements_read_;
    if (auto good = check_bounds(target); !good) return good;
    if (path_.size() > kDeepestElement) return refuse(place_of(target), "elements are nested too deeply");
    auto inner = context_of(target, kind, style, context);
    if (!inner) return {};
    inner->map = inner->map * shift_of(target, style, *inner);
    return read_inner_viewport(target, style, *inner, viewport);
  }

  Expected<void> read_shape(xml_node node, std::string_view kind, const SvgStyle& style, const SvgContext& context) {
    SvgShape shape{
        .node = node, .context = context, .geometry = elements_.shape(node, kind, style, context.viewport)};
    if (shape.geometry.data.empty() && shape.geometry.path.curves.empty()) return {};
    if (is_measuring_) return measure(shape);
    if (!context.is_visible) {
      remark_hidden(node);
      return {};
    }
    shape.context.has_fill = context.has_fill && kind != "line";
    if (!shape.context.is_filled() && !shape.context.is_stroked()) {
      remark("shape is left out, which is neither filled nor stroked",
             "shapes are left out, which are neither filled nor stroked", node);
      return {};
    }
    queue_.set_grid(clip_paths_->grid());
    return queue_.add(std::move(shape));
  }

  Expected<void> measure(SvgShape& shape) {
    shape.geometry.finish(job_.control());
    for (PlaneCurve& curve : shape.geometry.path.curves) curve.transform(shape.context.map);
    box_.add(bounds_of(shape.geometry.path.curves));
    return {};
  }

  XmlSource source_;
  ReadJob& job_;
  std::string_view prefix_;
  SvgNames names_;
  std::vector<xml_node> path_;  // path of elements to the current one, also through `use`
  std::size_t elements_read_ = 0;
  std::size_t most_pieces_;
  SvgElements elements_;
  std::optional<SvgStyles> styles_;
  std::optional<SvgClipPaths> clip_paths_;
  SvgShapeQueue queue_;
  bool is_measuring_ = false;
  std::string_view unit_ = "px";
  Vec2 page_{};
  Box2 box_;  // bounding box of the measured content
};

}  // namespace

bool looks_like_svg(std::string_view bytes) {
  return xml_root_name(bytes) == "svg";
}

Expected<SvgDrawing> read_svg_drawing(std::string_view bytes, const std::string& name, ReadJob& job) {
  return DrawingReader(without_bom(bytes), name, job).read();
}

}  // namespace mes
