// SPDX-License-Identifier: GPL-3.0-or-later
// The difference between the exact axis of the polygon through the samples and the axis of the samples.
//
// The structure polygon-axis is that of polygon_axis.cpp, and medial-axis is that of the program. The one-sided
// Hausdorff distance from one axis to the other is the largest distance of its points from the other. It is measured at
// points that are at most 1/1000 of the diagonal apart, so it is too small by at most 1/2000 of the diagonal; chords of
// parabolas add their tolerance. Pieces of the polygon's axis below polygon-axis-angle are branches to its corners,
// which the samples do not have: they are not measured, but they count as near for the other direction.
//
//   mesecina shape.poff --with polygon_axis.cpp --with polygon_axis_difference.cpp
#include <mesecina/experiment.h>

#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

using namespace mesecina;

namespace {

namespace bg = boost::geometry;
using Place = bg::model::d2::point_xy<double>;
using Segment = bg::model::segment<Place>;

struct Part {
  Point from, to;
  double distance;
  bool is_of_polygon;
};

Point between(Point a, Point b, double t) {
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
}
double distance(Point p, Point a, Point b) {
  const double x = b.x - a.x, y = b.y - a.y, square = x * x + y * y;
  const double t = square > 0.0 ? std::clamp(((p.x - a.x) * x + (p.y - a.y) * y) / square, 0.0, 1.0) : 0.0;
  return std::hypot(a.x + t * x - p.x, a.y + t * y - p.y);
}

class PolygonAxisDifference final : public Structure {
 public:
  void rebuild(const Inputs& inputs) override {
    parts_.clear();
    double low = INFINITY, high = -INFINITY, left = INFINITY, right = -INFINITY;
    const auto place = inputs.column<Point>("delaunay/sites/position");
    for (const Row site : inputs.live_rows("delaunay/sites")) {
      low = std::min(low, place[site].y), high = std::max(high, place[site].y);
      left = std::min(left, place[site].x), right = std::max(right, place[site].x);
    }
    // A power of two brings all coordinates to at most 1, so that no square overflows.
    unit_ = std::ldexp(1.0, std::ilogb(std::max({1e-200, -low, high, -left, right})) + 1);
    step_ = std::hypot((right - left) / unit_, (high - low) / unit_) / 1000.0;
    const auto from = inputs.column<Point>("polygon-axis/pieces/from");
    const auto to = inputs.column<Point>("polygon-axis/pieces/to");
    const auto half_angle = inputs.column<double>("polygon-axis/pieces/half_angle");
    std::vector<Segment> all, shown, sampled;
    for (const Row row : inputs.live_rows("polygon-axis/pieces")) {
      all.push_back(segment(from[row], to[row]));
      if (half_angle[row] >= inputs.parameter("polygon-axis-angle")) shown.push_back(all.back());
    }
    const auto nodes = inputs.column<std::array<Row, 2>>("medial-axis/edges/nodes");
    const auto center = inputs.column<Point>("inner-balls/faces/center");
    for (const Row edge : inputs.live_rows("medial-axis/edges"))
      sampled.push_back(segment(center[nodes[edge][0]], center[nodes[edge][1]]));
    // Among equally near pieces, the same one is found whatever the order of rows is.
    for (std::vector<Segment>* pieces : {&all, &sampled})
      std::ranges::sort(*pieces, {}, [](const Segment& s) {
        return std::array{s.first.x(), s.first.y(), s.second.x(), s.second.y()};
      });
    to_samples_ = measure(inputs, shown, sampled, true);
    to_polygon_ = measure(inputs, sampled, all, false);
  }

  std::vector<OwnTable> tables() const override {
    std::vector<OwnTable> out;
    out.emplace_back("parts", "Parts of both axes")
        .column("from", "One end", parts_, &Part::from)
        .column("to", "The other end", parts_, &Part::to)
        .column("distance", "The larger distance of the two ends from the other axis", parts_, &Part::distance)
        .column("is_of_polygon", "The part is one of the axis of the polygon", parts_, &Part::is_of_polygon);
    return out;
  }
  std::vector<Statistic> statistics() const override {
    return {{"distance_from_polygon_axis_to_medial_axis", to_samples_},
            {"distance_from_medial_axis_to_polygon_axis", to_polygon_}};
  }

 private:
  /// The ends are in lexicographic order, so that rounding does not depend on the direction.
  Segment segment(Point a, Point b) const {
    if (b.x < a.x || (b.x == a.x && b.y < a.y)) std::swap(a, b);
    return {{a.x / unit_, a.y / unit_}, {b.x / unit_, b.y / unit_}};
  }
  static Point point(Place p) { return {p.x(), p.y()}; }

  /// Returns the one-sided Hausdorff distance. It is infinite if one of the axes is empty. O(log n) for a part.
  double measure(const Inputs& inputs, const std::vector<Segment>& axis, const std::vector<Segment>& other,
                 bool is_of_polygon) {
    if (axis.empty() || other.empty()) return INFINITY;
    const bg::index::rtree<Segment, bg::index::rstar<8>> tree(other);
    const auto distance_of = [&tree](Point p) {
      const Segment nearest = *tree.qbegin(bg::index::nearest(Place(p.x, p.y), 1));
      return distance(p, point(nearest.first), point(nearest.second));
    };
    double largest = 0.0;
    for (std::size_t k = 0; k < axis.size(); ++k) {
      if (k % 1000 == 0) inputs.checkpoint(k, axis.size());
      const Point from = point(axis[k].first), to = point(axis[k].second);
      const int count = static_cast<int>(std::hypot(to.x - from.x, to.y - from.y) / step_) + 1;
      Point before = from;
      double distance_before = distance_of(from);
      for (int i = 1; i <= count; ++i) {
        const Point at = between(from, to, static_cast<double>(i) / count);
        const double distance_at = distance_of(at), larger = std::max(distance_before, distance_at);
        parts_.push_back(
            {{unit_ * before.x, unit_ * before.y}, {unit_ * at.x, unit_ * at.y}, unit_ * larger, is_of_polygon});
        largest = std::max(largest, larger);
        before = at, distance_before = distance_at;
      }
    }
    return unit_ * largest;
  }

  std::vector<Part> parts_;
  double unit_ = 1.0, step_ = 1.0, to_samples_ = INFINITY, to_polygon_ = INFINITY;
};

}  // namespace

MESECINA_EXPERIMENT(experiment) {
  experiment.add_structure<PolygonAxisDifference>(
      {.id = "polygon-axis-difference",
       .inputs = {"delaunay", "inner-balls", "medial-axis", "polygon-axis"},
       .parameters = {"polygon-axis-angle"}});
  experiment.add_layer(
      {.id = "polygon-axis-difference",
       .name = "Polygon axis, difference",
       .description = "The axis of the polygon and the medial axis, coloured by how far the other one is",
       .rows = "polygon-axis-difference/parts",
       .kinds = {PrimitiveKind::segment},
       .scalar = "distance from the other axis",
       .line_width = 2.5,
       .color_map = "viridis",
       .is_visible_at_start = false},
      [](const Inputs& inputs) {
        const auto from = inputs.column<Point>("polygon-axis-difference/parts/from");
        const auto to = inputs.column<Point>("polygon-axis-difference/parts/to");
        const auto distance = inputs.column<double>("polygon-axis-difference/parts/distance");
        return [=](Row row, Drawn& out) { out.segment(from[row], to[row], distance[row]); };
      });
}
