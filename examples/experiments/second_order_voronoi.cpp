// SPDX-License-Identifier: GPL-3.0-or-later
// The Voronoi diagram of order two: in each cell, the same two samples are nearest.
//
// The cell of {a, b} has an inner point exactly if a and b share a Voronoi edge of positive length, so each cell
// belongs to a Delaunay edge (M. I. Shamos, D. Hoey, Closest-point problems, FOCS 1975; D. T. Lee, On k-nearest
// neighbor Voronoi diagrams in the plane, IEEE Transactions on Computers 31, 1982). Where v is nearest, the second
// nearest sample is the nearest one of all others. So the edges in the Voronoi cell of v are those of the Voronoi
// diagram without v, and this has changed only there: the samples around v are triangulated as if v were deleted.
// Vertices are the circumcentres of Delaunay triangles and of the triangles that fill such a hole. All decisions are
// exact predicates; coordinates of vertices are rounded. Edges of length zero, which cocircular samples have, are left
// out.
//
// Cost: O(k log k) for a sample with k neighbours as a rule, and O(k^2) at worst.
//
//   mesecina shape.poff --with second_order_voronoi.cpp
#include <mesecina/experiment.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

using namespace mesecina;

namespace {

struct Edge {
  Point from, to;            // the other end, or the direction of a ray or a line
  std::uint8_t kind;         // 0 segment, 1 ray, 2 line
  Row nearest;               // the sample that both cells have in common
  std::array<Row, 2> other;  // the second nearest samples on both sides
};

bool is_before(Point a, Point b) {
  return a.x < b.x || (a.x == b.x && a.y < b.y);
}

/// Computes with more digits than the result has, so that triangles of one circle have the same centre as a rule. A
/// power of two keeps squares in the range of doubles.
Point circumcenter(std::array<Point, 3> corners) {
  std::ranges::sort(corners, is_before);
  const auto& [a, b, c] = corners;
  const int scale = std::ilogb(std::max({std::abs(b.x - a.x), std::abs(b.y - a.y), std::abs(c.x - a.x),  //
                                         std::abs(c.y - a.y)}));
  const auto difference = [scale](long double to, long double from) { return std::ldexp(to - from, -scale); };
  const long double ux = difference(b.x, a.x), uy = difference(b.y, a.y);
  const long double vx = difference(c.x, a.x), vy = difference(c.y, a.y);
  const long double u = ux * ux + uy * uy, v = vx * vx + vy * vy, area = 2 * (ux * vy - uy * vx);
  return {static_cast<double>(a.x + std::ldexp((u * vy - v * uy) / area, scale)),
          static_cast<double>(a.y + std::ldexp((v * ux - u * vx) / area, scale))};
}

struct View {
  explicit View(const Inputs& inputs)
      : place(inputs.column<Point>("delaunay/sites/position")),
        face(inputs.column<Row>("delaunay/sites/face")),
        corners(inputs.column<std::array<Row, 3>>("delaunay/faces/sites")),
        neighbors(inputs.column<std::array<Row, 3>>("delaunay/faces/faces")),
        sides(inputs.column<std::array<Row, 3>>("delaunay/faces/edges")),
        is_finite(inputs.column<bool>("delaunay/faces/is_finite")) {}

  InputColumn<Point> place;
  InputColumn<Row> face;
  InputColumn<std::array<Row, 3>> corners, neighbors, sides;
  InputColumn<bool> is_finite;
};

class SecondOrderVoronoi final : public Structure {
 public:
  void rebuild(const Inputs& inputs) override;
  std::vector<OwnTable> tables() const override {
    std::vector<OwnTable> out;
    out.emplace_back("edges", "Edges of the diagram")
        .column("from", "One end", edges_, &Edge::from)
        .column("to", "The other end of a segment, or the direction of a ray or a line", edges_, &Edge::to)
        .column("kind", "0 segment, 1 ray, 2 line", edges_, &Edge::kind)
        .column("nearest", "The sample that is nearest on the edge", edges_, &Edge::nearest)
        .refers_to("delaunay/sites")
        .column("second", "The two samples that are second on the edge", edges_, &Edge::other)
        .refers_to("delaunay/sites");
    out.emplace_back("cells", "Cells, each of the two ends of a Delaunay edge")
        .rows_of("delaunay/edges")
        .column("degree", "Number of edges around the cell; 0: the cell has no inner point", degree_);
    return out;
  }
  std::vector<Statistic> statistics() const override {
    return {{"second_order_cells", cells_},
            {"second_order_edges", static_cast<std::int64_t>(edges_.size())},
            {"second_order_unbounded_edges",
             std::ranges::count_if(edges_, [](const Edge& edge) { return edge.kind != 0; })}};
  }

 private:
  enum Kind : std::uint8_t { segment = 0, ray = 1, line = 2 };
  void look_around(const View& view, Row site);
  void fill_hole(const View& view, Row site);
  void cross_line(const Inputs& inputs);
  void add(Kind kind, Point from, Point to, Row site, std::size_t i, std::size_t j) {
    edges_.push_back({from, to, kind, site, {around_[i], around_[j]}});
    for (const std::size_t k : {i, j}) cells_ += degree_[spokes_[k]]++ == 0 ? 1 : 0;
  }

  std::vector<Edge> edges_;
  std::vector<std::uint32_t> degree_;
  std::int64_t cells_ = 0;
  // The samples around the present one, counter-clockwise, and its Delaunay edges to them. On the hull they begin and
  // end with the neighbours on the hull.
  std::vector<Row> around_, spokes_;
  bool is_on_hull_ = false;
};

void SecondOrderVoronoi::rebuild(const Inputs& inputs) {
  const View view(inputs);
  edges_.clear();
  degree_.assign(inputs.rows("delaunay/edges"), 0);
  cells_ = 0;
  const std::vector<Row> sites = inputs.live_rows("delaunay/sites");
  if (!sites.empty() && view.face[sites[0]] == kNoRow) return cross_line(inputs);
  for (std::size_t k = 0; k < sites.size(); ++k) {
    if (k % 1000 == 0) inputs.checkpoint(k, sites.size());
    look_around(view, sites[k]);
    fill_hole(view, sites[k]);
  }
}

/// Samples on a line have bands as cells: the neighbours of a sample are second on the line in the middle of them.
void SecondOrderVoronoi::cross_line(const Inputs& inputs) {
  const auto place = inputs.column<Point>("delaunay/sites/position");
  const auto ends = inputs.column<std::array<Row, 2>>("delaunay/edges/sites");
  std::vector<std::vector<Row>> spokes(inputs.rows("delaunay/sites"));
  const std::vector<Row> edges = inputs.live_rows("delaunay/edges");
  for (const Row edge : edges)
    for (const Row end : ends[edge]) spokes[end].push_back(edge);
  for (Row site = 0; site < spokes.size(); ++site) {
    if (spokes[site].size() < 2) continue;
    around_.clear();
    spokes_ = spokes[site];
    for (const Row edge : spokes_) around_.push_back(ends[edge][0] == site ? ends[edge][1] : ends[edge][0]);
    const auto [a, b] = std::minmax({place[around_[0]], place[around_[1]]}, is_before);
    add(line, {a.x + 0.5 * (b.x - a.x), a.y + 0.5 * (b.y - a.y)}, {a.y - b.y, b.x - a.x}, site, 0, 1);
  }
  cells_ = static_cast<std::int64_t>(edges.size());
}

void SecondOrderVoronoi::look_around(const View& view, Row site) {
  around_.clear();
  spokes_.clear();
  is_on_hull_ = false;
  std::size_t begin = 0;
  const Row first = view.face[site];
  Row face = first;
  do {
    const std::array<Row, 3> corners = view.corners[face];
    const std::size_t at = static_cast<std::size_t>(std::ranges::find(corners, site) - corners.begin());
    // The next corner is infinite if the edge to it is none.
    const Row spoke = view.sides[face][(at + 2) % 3];
    if (spoke == kNoRow) {
      is_on_hull_ = true;
      begin = around_.size();
    } else {
      around_.push_back(corners[(at + 1) % 3]);
      spokes_.push_back(spoke);
    }
    face = view.neighbors[face][(at + 1) % 3];
  } while (face != first);
  for (std::vector<Row>* rows : {&around_, &spokes_})
    std::ranges::rotate(*rows, rows->begin() + static_cast<std::ptrdiff_t>(begin));
}

void SecondOrderVoronoi::fill_hole(const View& view, Row site) {
  const auto place = [&](std::size_t i) { return view.place[around_[i]]; };
  // A part of the hole lies left of the chain from i to j and of the way back. Beyond the edge from j to i lies the
  // triangle with a certain third corner and centre, or nothing if a ray begins here.
  struct Part {
    std::size_t i, j;
    bool is_at_hull;
    Point beyond, center;
  };
  std::vector<Part> parts;
  const auto open = [&](std::size_t i, std::size_t j, bool is_at_hull, Point beyond, Point center) {
    parts.push_back({i, j, is_at_hull, beyond, center});
  };
  const std::size_t count = around_.size();
  if (is_on_hull_) {
    std::vector<std::size_t> hull;
    for (std::size_t i = 0; i < count; ++i) {
      while (hull.size() > 1 && orientation(place(hull[hull.size() - 2]), place(hull.back()), place(i)) > 0)
        hull.pop_back();
      hull.push_back(i);
    }
    for (std::size_t k = 0; k + 1 < hull.size(); ++k) open(hull[k], hull[k + 1], true, {}, {});
  } else {
    open(0, count - 1, false, view.place[site], circumcenter({view.place[site], place(count - 1), place(0)}));
  }
  while (!parts.empty()) {
    const auto [i, j, is_at_hull, beyond, outer] = parts.back();
    parts.pop_back();
    const Point a = place(i), b = place(j);
    Point center;
    if (i + 1 == j) {
      // The edge from i to j is one of the rim. Beyond it lies the Delaunay triangle with the site.
      center = circumcenter({view.place[site], a, b});
      if (!is_at_hull && side_of_circle(a, b, view.place[site], beyond) == 0) continue;
    } else {
      std::size_t apex = 0;
      for (std::size_t k = i + 1; k < j; ++k)
        if (orientation(b, a, place(k)) > 0 && (apex == 0 || side_of_circle(b, a, place(apex), place(k)) > 0))
          apex = k;
      center = circumcenter({a, b, place(apex)});
      open(i, apex, false, b, center);
      open(apex, j, false, a, center);
      if (!is_at_hull && side_of_circle(b, a, place(apex), beyond) == 0) continue;
    }
    if (is_at_hull)
      add(ray, center, {a.y - b.y, b.x - a.x}, site, i, j);
    else
      add(segment, std::min(center, outer, is_before), std::max(center, outer, is_before), site, i, j);
  }
}

}  // namespace

MESECINA_EXPERIMENT(experiment) {
  experiment.add_structure<SecondOrderVoronoi>({.id = "second-order-voronoi", .inputs = {"delaunay"}});
  experiment.add_layer({.id = "second-order-voronoi",
                        .name = "Second-order Voronoi",
                        .description = "Edges between the places where different pairs of samples are nearest",
                        .rows = "second-order-voronoi/edges",
                        .kinds = {PrimitiveKind::segment, PrimitiveKind::ray, PrimitiveKind::line},
                        .color = {0.45, 0.2, 0.65},
                        .line_width = 1.0},
                       [](const Inputs& inputs) {
                         const auto from = inputs.column<Point>("second-order-voronoi/edges/from");
                         const auto to = inputs.column<Point>("second-order-voronoi/edges/to");
                         const auto kind = inputs.column<std::uint8_t>("second-order-voronoi/edges/kind");
                         return [=](Row row, Drawn& out) {
                           if (kind[row] == 0) out.segment(from[row], to[row]);
                           if (kind[row] == 1) out.ray(from[row], to[row]);
                           if (kind[row] == 2) out.line(from[row], to[row]);
                         };
                       });
}
