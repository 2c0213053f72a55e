// SPDX-License-Identifier: GPL-3.0-or-later
// The types of moebius_diagram.cpp: the power diagram in space, marks where the paraboloid cuts it, and the structure.
#pragma once

#include <mesecina/experiment.h>

#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Regular_triangulation_3.h>
#include <CGAL/Sqrt_extension.h>
#include <CGAL/Triangulation_cell_base_with_info_3.h>
#include <CGAL/Triangulation_vertex_base_with_info_3.h>

#include <algorithm>
#include <boost/multiprecision/gmp.hpp>
#include <cmath>
#include <map>
#include <stdexcept>
#include <tuple>

using namespace mesecina;

namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Number = Kernel::FT;
using Vector = Kernel::Vector_3;
using Flat = Kernel::Vector_2;
using Wide = boost::multiprecision::mpf_float_100;
constexpr Row kFar = kNoRow - 1;

struct Circle {
  Flat center;
  Number square;  // of the radius
};
/// On the boundary of a power face: 1 outside the paraboloid, -1 inside, and 0 at a vertex of the diagram.
struct Mark {
  int sign;
  Row vertex = kNoRow;
};
struct Corner {
  Vector at;
  Mark mark;
  std::array<std::vector<Mark>, 4> beside;  // along the power edges that end here
};
using Nodes =
    CGAL::Triangulation_vertex_base_with_info_3<Row, Kernel, CGAL::Regular_triangulation_vertex_base_3<Kernel>>;
using Corners =
    CGAL::Triangulation_cell_base_with_info_3<Corner, Kernel, CGAL::Regular_triangulation_cell_base_3<Kernel>>;
using Power = CGAL::Regular_triangulation_3<Kernel, CGAL::Triangulation_data_structure_3<Nodes, Corners>>;
using Node = Power::Vertex_handle;

enum Kind : std::uint8_t { arc = 0, segment = 1, ray = 2, line = 3 };
struct Edge {
  std::uint8_t kind;
  std::array<Row, 2> cells;
  Point center;
  double radius;
  Point from, to;
};
struct Event {
  Point position;
  double factor;
};

/// A point with a hundred digits, which tell short arcs from those that are nearly circles.
struct Precise {
  Wide x, y;
};

double rounded(const Number& n) {
  return CGAL::to_double(n.exact());
}
/// The squared quotient of a ball is the linear function constant_of - 2 vector_of * (x, y, z).
Vector vector_of(Node node) {
  return node->point().point() - CGAL::ORIGIN;
}
Number constant_of(Node node) {
  return vector_of(node).squared_length() - node->point().weight();
}

/// One of the points where the quotients of three balls are equal. Nothing is rounded before the root is taken.
Precise crossing(const std::array<Node, 3>& nodes, int side) {
  const auto vector = [&](std::size_t k) { return CGAL::exact(vector_of(nodes[k]) - vector_of(nodes[0])); };
  const auto height = [&](std::size_t k) { return CGAL::exact(constant_of(nodes[k]) - constant_of(nodes[0])); };
  const auto u = vector(1), v = vector(2), way = CGAL::cross_product(u, v);
  const auto base =
      (height(1) * CGAL::cross_product(v, way) + height(2) * CGAL::cross_product(way, u)) / (2 * (way * way));
  const auto square = [](const auto& w) -> Kernel::FT::ET { return w.x() * w.x() + w.y() * w.y(); };
  const Wide a(square(way)), b(base.x() * way.x() + base.y() * way.y() - way.z() / 2), c(square(base) - base.z());
  const Wide d = b * b - a * c, t = a == 0 ? Wide(-c / (2 * b)) : Wide((side * sqrt(d > 0 ? d : Wide(0)) - b) / a);
  return {Wide(base.x()) + t * Wide(way.x()), Wide(base.y()) + t * Wide(way.y())};
}

class MoebiusDiagram final : public Structure {
 public:
  void rebuild(const Inputs& inputs) override;
  std::vector<OwnTable> tables() const override {
    std::vector<OwnTable> out;
    out.emplace_back("edges", "Edges between cells")
        .column("kind", "0 arc or circle, 1 segment or short arc, 2 ray, 3 line", edges_, &Edge::kind)
        .column("cells", "The cells on both sides", edges_, &Edge::cells)
        .refers_to("moebius-diagram/cells")
        .column("center", "Centre of the circle", edges_, &Edge::center)
        .column("radius", "Radius of the circle", edges_, &Edge::radius)
        .column("from", "One end, or a point of a ray or a line; arcs are counter-clockwise", edges_, &Edge::from)
        .column("to", "The other end, or the direction of a ray or a line", edges_, &Edge::to);
    out.emplace_back("vertices", "Points that at least three cells have in common")
        .column("position", "Position", vertices_, &Event::position)
        .column("factor", "Factor at which the balls reach it", vertices_, &Event::factor);
    out.emplace_back("cells", "Where growing balls have reached their whole cells")
        .column("position", "Point of the cell that the ball reaches last, if there is one", cells_, &Event::position)
        .column("factor", "Factor at which it does, the vanishing date; infinite: never", cells_, &Event::factor);
    return out;
  }
  std::vector<Statistic> statistics() const override {
    return {
        {"moebius_cells", static_cast<std::int64_t>(cells_.size())},
        {"moebius_edges", static_cast<std::int64_t>(edges_.size())},
        {"moebius_vertices", static_cast<std::int64_t>(vertices_.size())},
        {"first_vanishing_date", cells_.empty() ? INFINITY : std::ranges::min(cells_, {}, &Event::factor).factor}};
  }

 private:
  void collect(const Inputs& inputs);
  void cross(const Power& power, Power::Cell_handle cell, int side);
  void trace(const Power& power, const Power::Edge& edge);
  double reach(Row row, Point at) {
    const Ball& ball = rounded_[row];
    Event& last = cells_[row];
    const double factor = std::hypot(at.x - ball.center.x, at.y - ball.center.y) / ball.radius;
    if (std::tie(factor, at.x, at.y) > std::tie(last.factor, last.position.x, last.position.y)) last = {at, factor};
    return factor;
  }
  Mark vertex(const std::array<Node, 3>& nodes, const Precise& precise) {
    const Point at{static_cast<double>(precise.x), static_cast<double>(precise.y)};
    const Wide x = precise.x - at.x, y = precise.y - at.y;
    const auto [found, is_new] = vertex_at_.try_emplace({at.x, at.y, static_cast<double>(x), static_cast<double>(y)},
                                                        static_cast<Row>(vertices_.size()));
    if (is_new) vertices_.push_back({at, 0.0}), precise_.push_back(precise);
    double& factor = vertices_[found->second].factor;
    for (const Node node : nodes) factor = std::max(factor, reach(node->info(), at));
    return {0, found->second};
  }

  std::vector<Circle> balls_;
  Number largest_;  // of the squares
  std::vector<Ball> rounded_;
  std::vector<Edge> edges_;
  std::vector<Event> vertices_, cells_;
  std::vector<Precise> precise_;
  std::map<std::array<double, 4>, Row> vertex_at_;
};

void MoebiusDiagram::collect(const Inputs& inputs) {
  const auto add = [this](Point at, const Number& square) { balls_.push_back({{at.x, at.y}, square}); };
  balls_.clear();
  const auto center = inputs.column<Point>("balls/balls/center");
  const auto radius = inputs.column<double>("balls/balls/radius");
  for (const Row row : inputs.live_rows("balls/balls"))
    if (radius[row] > 0.0) add(center[row], CGAL::square(Number(radius[row])));
  const auto ball = inputs.column<Row>("inner-balls/faces/ball");
  const auto inner = inputs.column<Point>("inner-balls/faces/center");
  const auto size = inputs.column<double>("inner-balls/faces/radius");
  // Decisions are several times faster if the reciprocal of a squared radius is a double.
  for (const Row face : balls_.empty() ? inputs.live_rows("inner-balls/faces") : std::vector<Row>())
    if (ball[face] == face) add(inner[face], 1 / Number(1.0 / (size[face] * size[face])));
  std::ranges::sort(balls_, [](const Circle& a, const Circle& b) {
    return a.center != b.center ? CGAL::compare_xy(CGAL::ORIGIN + a.center, CGAL::ORIGIN + b.center) < 0
                                : b.square < a.square;
  });
  balls_.erase(std::ranges::unique(balls_, {}, &Circle::center).begin(), balls_.end());
  if (balls_.size() > 2500)
    throw std::runtime_error("there are " + std::to_string(balls_.size()) + " balls, and more than 2500 are refused");
}

}  // namespace
