// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/svg_drawing.h"

#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <pugixml.hpp>
#include <unordered_map>
#include <utility>

#include "core/base/parallel.h"
#include "core/io/svg_path.h"
#include "core/io/svg_shapes.h"
#include "core/io/svg_values.h"
#include "core/io/text_numbers.h"
#include "core/io/xml_source.h"

namespace mes {
namespace {

constexpr std::size_t kMostElements = 1'000'000;
constexpr std::size_t kMostPieces = 4'000'000;  // or as many as the file has bytes
constexpr std::size_t kDeepest = 200;

using pugi::xml_node;

/// What an element has from those around it.
struct Context {
  Affine map;
  SvgViewport viewport;
  bool is_visible = true;
  bool is_filled = true;
  bool is_stroked = false;
  bool has_class = false;
};

template <std::size_t N>
bool is_one_of(std::string_view word, const std::array<std::string_view, N>& words) {
  return std::ranges::find(words, word) != words.end();
}

std::string_view prefix_of(std::string_view name) {
  const std::size_t colon = name.find(':');
  return colon == std::string_view::npos ? std::string_view{} : name.substr(0, colon);
}

class DrawingReader {
 public:
  DrawingReader(std::string_view bytes, const std::string& name, ReadJob& job)
      : source_(bytes, name), job_(job), most_pieces_(std::max(kMostPieces, bytes.size())) {}

  Expected<SvgDrawing> read() {
    constexpr double kParsed = 0.2;  // of the time that reading takes
    job_.begin(source_.bytes(), kParsed);
    const auto parsed = source_.parse(job_, {"d", "points"});
    if (!parsed) return std::unexpected(parsed.error());
    job_.begin(source_.bytes());
    const xml_node root = *parsed;
    if (local_name(root.name()) != "svg") return refuse(place_of(root), "the root element is not svg");
    prefix_ = prefix_of(root.name());
    note_names(root);
    if (auto done = read_root(root); !done) return std::unexpected(done.error());
    if (auto done = finish_shapes(); !done) return std::unexpected(done.error());
    out_.warnings = source_.messages();
    return std::move(out_);
  }

 private:
  std::unexpected<Error> refuse(std::size_t place, std::string text) const {
    return source_.refuse(place, std::move(text));
  }
  std::size_t place_of(xml_node node) const { return source_.place_of(node); }
  void remark(std::string one, std::string many, std::size_t place) {
    source_.remarks.add(std::move(one), std::move(many), place);
  }
  void remark_ignored(std::string_view attribute, xml_node node, std::string_view value, std::size_t within = 0) {
    remark(fmt::format("value of {} is ignored, which is none", attribute),
           fmt::format("values of {} are ignored, which are none", attribute), source_.place_of(node, value, within));
  }

  /// Elements by their id; the first counts. Without recursion, for it comes before depth is checked.
  void note_names(xml_node root) {
    for (xml_node node = root; node;) {
      if (const pugi::xml_attribute id = node.attribute("id")) by_id_.try_emplace(id.value(), node);
      if (node.type() == pugi::node_element && local_name(node.name()) == "style") has_style_sheet_ = true;
      if (const xml_node child = node.first_child()) {
        node = child;
        continue;
      }
      while (node && node != root && !node.next_sibling()) node = node.parent();
      node = !node || node == root ? xml_node() : node.next_sibling();
    }
  }

  std::optional<double> length(xml_node node, const char* attribute, SvgAxis axis, const Context& context) {
    const std::string_view text = node.attribute(attribute).value();
    if (text.empty() || text == "auto") return std::nullopt;
    const auto value = svg_length(text, axis, context.viewport);
    if (!value) remark_ignored(attribute, node, text);
    return value;
  }
  double length_or_zero(xml_node node, const char* attribute, SvgAxis axis, const Context& context) {
    return length(node, attribute, axis, context).value_or(0.0);
  }

  /// An attribute, or the declaration in `style` that outweighs it.
  static std::string_view property(xml_node node, const char* name) {
    const std::string_view declared = svg_declared(node.attribute("style").value(), name);
    return declared.empty() ? std::string_view(node.attribute(name).value()) : declared;
  }

  /// The context within an element; nothing for one that is not displayed.
  std::optional<Context> context_of(xml_node node, Context context) {
    if (property(node, "display") == "none") return std::nullopt;
    const std::string_view visibility = property(node, "visibility");
    if (visibility == "visible") context.is_visible = true;
    if (visibility == "hidden" || visibility == "collapse") context.is_visible = false;
    const std::string_view fill = property(node, "fill");
    if (!fill.empty() && fill != "inherit") context.is_filled = fill != "none";
    const std::string_view stroke = property(node, "stroke");
    if (!stroke.empty() && stroke != "inherit") context.is_stroked = stroke != "none";
    context.has_class = context.has_class || node.attribute("class");
    const std::string_view transform = node.attribute("transform").value();
    if (!transform.empty()) {
      if (const auto map = svg_transform(transform)) {
        context.map = context.map * *map;
      } else {
        remark_ignored("transform", node, transform);
      }
    }
    return context;
  }

  Expected<void> read_root(xml_node root) {
    Context context{.map = {}, .viewport = {}};
    const auto box = svg_view_box(root.attribute("viewBox").value());
    if (box) context.viewport = {(*box)[2], (*box)[3]};
    const SvgViewport size{length(root, "width", SvgAxis::x, context).value_or(context.viewport.width),
                           length(root, "height", SvgAxis::y, context).value_or(context.viewport.height)};
    // y points down in SVG.
    context.map = Affine{1.0, 0.0, 0.0, -1.0, 0.0, size.height};
    return read_viewport(root, context, size);
  }

  /// The content of an `svg` or `symbol` that is so large.
  Expected<void> read_viewport(xml_node node, Context context, const SvgViewport& size) {
    const std::string_view text = node.attribute("viewBox").value();
    const auto box = svg_view_box(text);
    if (!text.empty() && !box) remark_ignored("viewBox", node, text);
    context.viewport = size;
    if (box && size.width > 0.0 && size.height > 0.0) {
      context.map = context.map * svg_fit(*box, size, node.attribute("preserveAspectRatio").value());
      context.viewport = {(*box)[2], (*box)[3]};
    }
    const auto inner = context_of(node, context);
    return inner ? read_children(node, *inner) : Expected<void>{};
  }

  Expected<void> read_children(xml_node node, const Context& context) {
    path_.push_back(node);
    for (const xml_node child : node.children()) {
      if (child.type() != pugi::node_element) continue;
      if (auto done = read_element(child, context); !done) return done;
      // Of the alternatives of a `switch` the first one is taken.
      if (local_name(node.name()) == "switch" && !child.attribute("requiredExtensions")) break;
    }
    path_.pop_back();
    return {};
  }

  Expected<void> read_element(xml_node node, const Context& outer) {
    if (prefix_of(node.name()) != prefix_) return {};  // of another vocabulary
    if (++elements_ > kMostElements)
      return refuse(place_of(node), fmt::format("the drawing has more than {} elements, those that are used again "
                                                "counted each time",
                                                kMostElements));
    if (path_.size() > kDeepest) return refuse(place_of(node), "elements are nested too deeply");
    const std::string_view kind = local_name(node.name());
    if (kind == "svg") return read_nested_svg(node, outer);
    if (kind == "use") return read_use(node, outer);
    if (kind == "g" || kind == "a" || kind == "switch") {
      const auto context = context_of(node, outer);
      return context ? read_children(node, *context) : Expected<void>{};
    }
    constexpr std::array<std::string_view, 5> kLeftOut{"text", "image", "foreignObject", "flowRoot", "video"};
    if (is_one_of(kind, kLeftOut)) {
      const auto context = context_of(node, outer);
      if (context && context->is_visible)
        remark(fmt::format("{} element is left out", kind), fmt::format("{} elements are left out", kind),
               place_of(node));
      return {};
    }
    return read_shape(node, kind, outer);
  }

  Expected<void> read_nested_svg(xml_node node, Context context) {
    context.map = context.map * Affine::translation(length_or_zero(node, "x", SvgAxis::x, context),
                                                    length_or_zero(node, "y", SvgAxis::y, context));
    const SvgViewport size{length(node, "width", SvgAxis::x, context).value_or(context.viewport.width),
                           length(node, "height", SvgAxis::y, context).value_or(context.viewport.height)};
    return read_viewport(node, context, size);
  }

  Expected<void> read_use(xml_node node, const Context& outer) {
    const auto context = context_of(node, outer);
    if (!context) return {};
    const pugi::xml_attribute plain = node.attribute("href");
    const std::string_view link = plain ? plain.value() : node.attribute("xlink:href").value();
    const auto found = link.starts_with('#') ? by_id_.find(link.substr(1)) : by_id_.end();
    if (found == by_id_.end()) {
      remark("use element is left out, which refers to nothing here",
             "use elements are left out, which refer to nothing here", place_of(node));
      return {};
    }
    const xml_node target = found->second;
    if (target == node || std::ranges::find(path_, target) != path_.end()) {
      remark("use element is left out, which is part of what it refers to",
             "use elements are left out, which are part of what they refer to", place_of(node));
      return {};
    }
    Context inner = *context;
    inner.map = inner.map * Affine::translation(length_or_zero(node, "x", SvgAxis::x, inner),
                                                length_or_zero(node, "y", SvgAxis::y, inner));
    path_.push_back(node);
    auto done = read_used(target, inner, node);
    path_.pop_back();
    return done;
  }

  Expected<void> read_used(xml_node target, const Context& context, xml_node use) {
    const std::string_view kind = local_name(target.name());
    if (kind != "symbol" && kind != "svg") return read_element(target, context);
    // A size in the `use` outweighs that of what it refers to.
    const auto size = [&](const char* side, SvgAxis axis, double otherwise) {
      if (const auto here = length(use, side, axis, context)) return *here;
      return length(target, side, axis, context).value_or(otherwise);
    };
    const SvgViewport viewport{size("width", SvgAxis::x, context.viewport.width),
                               size("height", SvgAxis::y, context.viewport.height)};
    if (path_.size() > kDeepest) return refuse(place_of(target), "elements are nested too deeply");
    Context inner = context;
    inner.map = inner.map * Affine::translation(length_or_zero(target, "x", SvgAxis::x, context),
                                                length_or_zero(target, "y", SvgAxis::y, context));
    return read_viewport(target, inner, viewport);
  }

  Expected<void> read_shape(xml_node node, std::string_view kind, const Context& outer) {
    constexpr std::array<std::string_view, 7> kShapes{"path", "rect",     "circle", "ellipse",
                                                      "line", "polyline", "polygon"};
    if (!is_one_of(kind, kShapes)) return {};
    const auto context = context_of(node, outer);
    if (!context || !context->is_visible) return {};
    Shape shape{.node = node, .context = *context};
    const bool is_list = kind == "polyline" || kind == "polygon";
    if (kind == "path" || is_list) {
      shape.data = source_.value(node, kind == "path" ? "d" : "points");
      shape.kind = kind == "path"       ? Shape::Kind::path
                   : kind == "polyline" ? Shape::Kind::polyline
                                        : Shape::Kind::polygon;
    } else if (auto curve = simple_shape(node, kind, *context)) {
      shape.path.curves.push_back(*std::move(curve));
    }
    return begin_shape(std::move(shape));
  }

  std::optional<PlaneCurve> simple_shape(xml_node node, std::string_view kind, const Context& context) {
    const auto x = [&](const char* attribute) { return length_or_zero(node, attribute, SvgAxis::x, context); };
    const auto y = [&](const char* attribute) { return length_or_zero(node, attribute, SvgAxis::y, context); };
    if (kind == "line") {
      PlaneCurve curve({x("x1"), y("y1")});
      curve.line_to({x("x2"), y("y2")});
      return curve;
    }
    if (kind == "circle") {
      const double radius = length_or_zero(node, "r", SvgAxis::both, context);
      return svg_ellipse({x("cx"), y("cy")}, {radius, radius});
    }
    const auto rx = length(node, "rx", SvgAxis::x, context);
    const auto ry = length(node, "ry", SvgAxis::y, context);
    const Vec2 radii{rx ? *rx : ry.value_or(0.0), ry ? *ry : rx.value_or(0.0)};
    if (kind == "ellipse") return svg_ellipse({x("cx"), y("cy")}, radii);
    return svg_rect({x("x"), y("y")}, {x("width"), y("height")}, radii);
  }

  void remark_fault(xml_node node, std::string_view value, std::size_t within) {
    remark("list of coordinates is read up to a fault", "lists of coordinates are read up to a fault",
           source_.place_of(node, value, within));
  }

  /// What a path or a basic shape becomes.
  struct Shape {
    enum class Kind : std::uint8_t { path, polyline, polygon, other };

    xml_node node;
    Context context;
    Kind kind = Kind::other;
    std::string_view data{};  // of all kinds but `other`, still to be read
    SvgPath path{};
  };

  /// Shapes wait until there is work for several threads. With `use`, they may be far more than the file has bytes.
  Expected<void> begin_shape(Shape shape) {
    constexpr std::size_t kMostBytes = std::size_t{1} << 22U;
    constexpr std::size_t kMostShapes = 4096;
    waiting_bytes_ += shape.data.size();
    waiting_.push_back(std::move(shape));
    if (waiting_bytes_ < kMostBytes && waiting_.size() < kMostShapes) return {};
    return finish_shapes();
  }

  Expected<void> finish_shapes() {
    constexpr std::size_t kBytesEach = std::size_t{1} << 16U;
    std::vector<std::size_t> ends;  // of runs of shapes, each with some work
    std::size_t bytes = 0;
    for (std::size_t i = 0; i < waiting_.size(); ++i) {
      bytes += waiting_[i].data.size();
      if (bytes < kBytesEach && i + 1 < waiting_.size()) continue;
      ends.push_back(i + 1);
      bytes = 0;
    }
    run_tasks(ends.size(), [&](std::size_t run) {
      for (std::size_t i = run == 0 ? 0 : ends[run - 1]; i < ends[run]; ++i) finish(waiting_[i]);
    });
    for (Shape& shape : waiting_) {
      if (shape.path.fault) remark_fault(shape.node, shape.data, *shape.path.fault);
      for (PlaneCurve& curve : shape.path.curves) {
        pieces_ += curve.piece_count();
        if (pieces_ > most_pieces_)
          return refuse(place_of(shape.node),
                        fmt::format("the drawing has more than {} pieces of curves", most_pieces_));
        out_.curves.curves.push_back(std::move(curve));
      }
    }
    if (!waiting_.empty()) {
      const Shape& last = waiting_.back();
      job_.passed(source_.bytes().data() + source_.place_of(last.node, last.data, last.data.size()));
    }
    waiting_.clear();
    waiting_bytes_ = 0;
    return {};
  }

  /// Any thread.
  void finish(Shape& shape) const {
    if (shape.kind == Shape::Kind::path) shape.path = read_svg_path(shape.data, job_.control());
    if (shape.kind == Shape::Kind::polyline || shape.kind == Shape::Kind::polygon)
      shape.path = read_svg_points(shape.data, shape.kind == Shape::Kind::polygon, job_.control());
    for (PlaneCurve& curve : shape.path.curves) {
      close_what_looks_closed(curve, shape.context);
      curve.transform(shape.context.map);
      curve.name = shape.node.attribute("id").value();
    }
  }

  /// Filling closes what is open, and what misses its start by the rounding of coordinates is meant to be closed.
  void close_what_looks_closed(PlaneCurve& curve, const Context& context) const {
    if (curve.is_closed() || curve.piece_count() < 2) return;
    const bool knows_style = !(has_style_sheet_ && context.has_class);
    const bool is_area = knows_style && context.is_filled && !context.is_stroked;
    if (is_area) return curve.close();
    double around = 0.0;
    curve.for_each_piece([&](const Piece& piece) { around += distance(piece.from(), piece.to()); });
    constexpr double kRounding = 1e-4;
    if (distance(curve.start(), curve.end()) <= kRounding * around) curve.close();
  }

  XmlSource source_;
  ReadJob& job_;
  std::string_view prefix_;
  std::unordered_map<std::string_view, xml_node> by_id_;
  std::vector<xml_node> path_;  // elements around the present one, through `use` too
  bool has_style_sheet_ = false;
  std::size_t elements_ = 0;
  std::size_t pieces_ = 0;
  std::size_t most_pieces_;
  std::vector<Shape> waiting_;
  std::size_t waiting_bytes_ = 0;
  SvgDrawing out_;
};

}  // namespace

bool looks_like_svg(std::string_view bytes) {
  return xml_root_name(bytes) == "svg";
}

Expected<SvgDrawing> read_svg_drawing(std::string_view bytes, const std::string& name, ReadJob& job) {
  return DrawingReader(without_bom(bytes), name, job).read();
}

}  // namespace mes
