// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/outline/outline_axis.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <span>
#include <string>
#include <tuple>
#include <utility>

#include "core/base/geometry/parabola_arc.h"
#include "core/base/jobs/parallel.h"
#include "core/graph/explain.h"
#include "core/structures/outline/internal/near_feature.h"
#include "core/structures/outline/internal/outline_parts.h"
#include "core/structures/outline/internal/segment_voronoi.h"
#include "core/structures/outline/outline_sides.h"

namespace mes {

/// The points equally far from a focus and a line: foot + x along + (x^2 + h^2) / (2 h) up, where h is the distance of
/// the focus.
struct OutlineAxis::Parabola {
  Vec2 foot{};
  Vec2 along{};
  Vec2 up{};
  double h = 0.0;
  double first = 0.0;  ///< x of the first node
  double last = 0.0;

  double radius(double x) const { return 0.5 * (x * (x / h) + h); }
  Vec2 at(double x) const { return foot + x * along + radius(x) * up; }
};

OutlineAxis::OutlineAxis(CurveSourceInput& source, Samples& samples, Contours& contours)
    : Structure("outline-axis", {&source, &samples, &contours}),
      source_(source),
      samples_(samples),
      contours_(contours) {}

std::optional<OutlineAxis::Parabola> OutlineAxis::parabola(OutlineEdgeSlot slot) const {
  const OutlineEdge& edge = graph_.edges[slot];
  const OutlineFeature* focus = &graph_.features[edge.features[0]];
  const OutlineFeature* side = &graph_.features[edge.features[1]];
  if (!focus->is_point()) std::swap(focus, side);
  if (!focus->is_point() || side->is_point() || focus->center || side->center) return std::nullopt;
  const Vec2 line = side->to - side->from;
  const Vec2 along = (1.0 / length(line)) * line;
  const double height = cross(along, focus->from - side->from);
  const Vec2 up = height < 0.0 ? -perpendicular(along) : perpendicular(along);
  const Vec2 foot = focus->from - std::abs(height) * up;
  const Vec2 first = graph_.nodes[edge.nodes[0]].center;
  const Vec2 last = graph_.nodes[edge.nodes[1]].center;
  Parabola out{foot, along, up, std::abs(height), dot(along, first - foot), dot(along, last - foot)};
  // Rounding leaves nothing of an arc whose focus nearly lies on the line: it is a ray.
  const double size = std::max(std::abs(out.first), std::abs(out.last));
  if (!(out.h > 0x1p-30 * size)) return std::nullopt;
  return out;
}

bool OutlineAxis::is_parabola(OutlineEdgeSlot edge) const {
  return parabola(edge).has_value();
}

std::optional<Vec2> OutlineAxis::control(OutlineEdgeSlot edge) const {
  const std::optional<Parabola> arc = parabola(edge);
  if (!arc) return control_beside_curve(edge);
  const double height = 0.5 * (arc->first * (arc->last / arc->h) + arc->h);
  return arc->foot + (0.5 * arc->first + 0.5 * arc->last) * arc->along + height * arc->up;
}

// The tangents at both ends meet in the control point. A tangent is at right angles to the difference of the gradients of
// both distances, which are equal along the edge.
std::optional<Vec2> OutlineAxis::control_beside_curve(OutlineEdgeSlot slot) const {
  const OutlineEdge& edge = graph_.edges[slot];
  const OutlineFeature& one = graph_.features[edge.features[0]];
  const OutlineFeature& other = graph_.features[edge.features[1]];
  if (!one.center && !other.center) return std::nullopt;
  const Vec2 origin = graph_.nodes[edge.nodes[0]].center;
  const Vec2 end = graph_.nodes[edge.nodes[1]].center - origin;
  const std::array near{NearFeature::of(one, origin), NearFeature::of(other, origin)};
  // The edge stays on one side of each feature, and leaves a cusp between two circles.
  const Vec2 wide = graph_.nodes[edge.nodes[0]].radius > graph_.nodes[edge.nodes[1]].radius ? Vec2{} : end;
  const auto tangent_at = [&](Vec2 place) {
    std::array<Vec2, 2> gradients{};
    for (std::size_t i = 0; i < 2; ++i) gradients[i] = near[i].gradient(place, near[i].signed_distance(wide) < 0.0);
    if (gradients[0] == Vec2{} || gradients[1] == Vec2{}) return Vec2{};
    return perpendicular(gradients[0] - gradients[1]);
  };
  const Vec2 first = tangent_at({});
  const Vec2 last = tangent_at(end);
  const double area = cross(first, last);
  constexpr double kStraight = 1e-6;
  if (!(std::abs(area) > kStraight * length(first) * length(last))) return std::nullopt;
  const Vec2 control = (cross(end, last) / area) * first;
  if (!(dot(control, end) > 0.0 && dot(end - control, end) > 0.0)) return std::nullopt;
  return origin + control;
}

void OutlineAxis::add_pieces(OutlineEdgeSlot slot) {
  const OutlineEdge& edge = graph_.edges[slot];
  const OutlineNode& last = graph_.nodes[edge.nodes[1]];
  OutlineNode at = graph_.nodes[edge.nodes[0]];
  const auto go_to = [&](const OutlineNode& next) {
    pieces_.push_back({at.center, next.center, at.radius, next.radius, slot});
    at = next;
  };
  if (const std::optional<Vec2> curve = control_beside_curve(slot)) {
    const NearFeature near = NearFeature::of(graph_.features[edge.features[0]], at.center);
    const Vec2 origin = at.center;
    const std::vector<Vec2> corners = corners_of(ParabolaArc{at.center, *curve, last.center});
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) go_to({corners[i], near.distance(corners[i] - origin)});
  } else if (const std::optional<Parabola> arc = parabola(slot)) {
    for_each_slope_between(arc->first / arc->h, arc->last / arc->h, [&](double slope) {
      const double x = arc->h * slope;
      go_to({arc->at(x), arc->radius(x)});
    });
  }
  go_to(last);
}

namespace {

/// Appends the part of another graph from `begin` to `end`.
void append(OutlineGraph& out, const OutlineGraph& from, const OutlineGraphPart& begin, const OutlineGraphPart& end) {
  const OutlineGraphPart at = end_of(out);
  const auto moved = [](auto slot, std::size_t before, std::size_t now) {
    return decltype(slot)(slot.index() - before + now);
  };
  const auto part = [](const auto& table, std::size_t first, std::size_t last) {
    return std::span(table.values()).subspan(first, last - first);
  };
  for (const OutlineFeature& feature : part(from.features, begin.features, end.features))
    out.features.push_back(feature);
  for (const OutlineNode& node : part(from.nodes, begin.nodes, end.nodes)) out.nodes.push_back(node);
  for (OutlineEdge edge : part(from.edges, begin.edges, end.edges)) {
    for (OutlineNodeSlot& node : edge.nodes) node = moved(node, begin.nodes, at.nodes);
    for (OutlineFeatureSlot& feature : edge.features) feature = moved(feature, begin.features, at.features);
    edge.region = edge.region - begin.regions + at.regions;
    out.edges.push_back(edge);
  }
  out.regions += end.regions - begin.regions;
}

bool has_arcs(std::span<const OutlineSide> sides) {
  return std::ranges::any_of(sides, [](const OutlineSide& side) { return side.center.has_value(); });
}

}  // namespace

void OutlineAxis::rebuild(JobControl& job) {
  const OutlineGraph graph_before = std::exchange(graph_, {});
  const std::vector<Part> parts_before = std::exchange(parts_, {});
  pieces_ = {};
  const double tolerance_before = std::exchange(tolerance_, 0.0);
  OutlineSides sides;
  if (const auto& source = source_.current()) {
    const std::vector<PlaneCurve>& curves = source->curves->curves;
    const double tolerance = outline_tolerance(curves);
    sides.add(curves, tolerance, job);
    if (!std::ranges::all_of(curves, &PlaneCurve::is_polyline)) tolerance_ = tolerance;
  } else {
    for (std::size_t i = 0; i < contours_.row_count(); ++i) {
      const ContourSlot row(i);
      if (!contours_.has_link(row)) continue;
      const auto [from, to] = contours_.link(row);
      sides.add(samples_.position(from), samples_.position(to), contours_.is_closed(contours_.contour(row)));
    }
  }
  job.checkpoint();
  std::vector<Part> parts;
  for (std::vector<OutlineSide>& part : independent_parts(sides.take(job))) parts.push_back({std::move(part)});
  const auto key = [](const Part& part) {
    const OutlineSide& side = part.sides.front();
    return std::tie(side.from.x, side.from.y, side.to.x, side.to.y);
  };
  const auto known = [&](const Part& part) {
    const auto at = std::ranges::lower_bound(parts_before, key(part), {}, key);
    const bool is_same = at != parts_before.end() && at->sides == part.sides;
    return is_same && (tolerance_ == tolerance_before || !has_arcs(part.sides)) ? &*at : nullptr;
  };
  std::vector<std::size_t> unknown;
  std::size_t sides_left = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (known(parts[i]) != nullptr) continue;
    unknown.push_back(i);
    sides_left += parts[i].sides.size();
  }
  std::vector<OutlineGraph> computed(parts.size());
  std::atomic<std::size_t> sides_done = 0;
  run_tasks(unknown.size(), [&](std::size_t k) {
    const std::vector<OutlineSide>& own = parts[unknown[k]].sides;
    computed[unknown[k]] = inner_voronoi(own, tolerance_, job, unknown.size() == 1);
    job.checkpoint(sides_done += own.size(), sides_left);
  });
  for (std::size_t i = 0; i < parts.size(); ++i) {
    Part& part = parts[i];
    part.begin = end_of(graph_);
    if (const Part* const same = known(part))
      append(graph_, graph_before, same->begin, same->end);
    else
      append(graph_, computed[i], {}, end_of(computed[i]));
    part.end = end_of(graph_);
  }
  parts_ = std::move(parts);
  graph_.crossings = sides.crossings();
  for (const OutlineEdgeSlot edge : graph_.edges.rows()) add_pieces(edge);
}

bool OutlineAxis::update(JobControl&) {
  return source_.touched() == 0 && (source_.current() || contours_.touched() == 0);
}

StatList OutlineAxis::statistics() const {
  const auto parabolas =
      std::ranges::count_if(graph_.edges.rows(), [this](OutlineEdgeSlot edge) { return is_parabola(edge); });
  StatList out{{"edges", static_cast<std::int64_t>(graph_.edges.size())},
               {"parabolas", static_cast<std::int64_t>(parabolas)},
               {"nodes", static_cast<std::int64_t>(graph_.nodes.size())},
               {"regions", static_cast<std::int64_t>(graph_.regions)},
               {"crossings", static_cast<std::int64_t>(graph_.crossings)}};
  if (tolerance_ != 0.0) out.push_back({"tolerance", tolerance_});
  if (graph_.regions == 0) out.push_back({"nothing_because", std::string("no closed contour encloses anything")});
  return out;
}

void OutlineAxis::explain(ElementKind kind, RowNumber row, Explanation& out) const {
  const OutlineEdgeSlot slot(row);
  if (kind != ElementKind::axis_piece || !graph_.edges.has(slot)) return;
  const OutlineEdge& edge = graph_.edges[slot];
  const OutlineNode& first = graph_.nodes[edge.nodes[0]];
  const OutlineNode& last = graph_.nodes[edge.nodes[1]];
  ProvenanceShapes itself;
  const std::optional<Vec2> arc = control(slot);
  if (arc)
    itself.parabola({first.center, *arc, last.center});
  else
    itself.segment(first.center, last.center);
  out.say_itself("Edge of the axis of the outline",
                 std::string(is_parabola(slot) ? ", an arc of a parabola"
                             : arc             ? ", curved"
                                               : ", straight") +
                     ", radius " + number_text(first.radius) + " to " + number_text(last.radius),
                 itself);
  ProvenanceShapes sides;
  ProvenanceShapes vertices;
  for (const OutlineFeatureSlot i : edge.features) {
    const OutlineFeature& feature = graph_.features[i];
    if (feature.is_point())
      vertices.point(feature.from);
    else
      sides.segment(feature.from, feature.to);
  }
  out.say_any(ProvenanceRole::origin, "side of the outline is nearest", "sides of the outline are nearest", sides);
  out.say_any(ProvenanceRole::origin, "vertex of the outline is nearest", "vertices of the outline are nearest",
              vertices);
  ProvenanceShapes balls;
  balls.circle({first.center, first.radius});
  balls.circle({last.center, last.radius});
  out.say(ProvenanceRole::product, "largest disks about its ends that hold nothing of the outline", balls);
}

}  // namespace mes
