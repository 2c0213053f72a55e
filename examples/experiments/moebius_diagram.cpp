// SPDX-License-Identifier: GPL-3.0-or-later
// The Moebius diagram of balls: in the cell of a ball, the distance from its centre divided by its radius is smallest.
//
// If all balls grow by a common factor, this quotient is the factor at which a ball reaches a point. A ball vanishes in
// the union of all when it has reached its whole cell, and the scale axis transform leaves out balls that vanish early
// (J. Giesen, B. Miklos, M. Pauly, C. Wormser, The scale axis transform, SoCG 2009). Two cells meet along circles of
// Apollonius, or along lines if their radii are equal. Squared quotients are linear functions of x, y and
// z = x^2 + y^2, so the diagram is a power diagram in space, cut by a paraboloid (J.-D. Boissonnat, C. Wormser,
// M. Yvinec, Curved Voronoi diagrams, 2006). The signs of rational numbers decide where power edges cross it, also for
// degenerate balls. Coordinates and dates are rounded, and vertices that agree in thirty digits are one.
//
// The balls are those of the document, or else the inner balls of its samples with rounded centres and radii. Balls of
// radius zero are left out, and so are smaller balls with the same centre. More than 2500 balls are refused.
//
// Cost: 0.5 s for 1000 random balls, 1 s for 1000 inner balls, and 5 s for 1000 own balls that are nearly symmetric.
//
//   mesecina balls.wpoff --with moebius_diagram.cpp
// mesecina-flags: -DNDEBUG -Wno-maybe-uninitialized -lmpfr -lgmp
#include "moebius_diagram.h"

namespace {

void MoebiusDiagram::rebuild(const Inputs& inputs) {
  edges_.clear();
  vertices_.clear();
  cells_.clear();
  rounded_.clear();
  precise_.clear();
  vertex_at_.clear();
  collect(inputs);
  if (balls_.empty()) return;
  std::vector<std::pair<Kernel::Weighted_point_3, Row>> sites;
  const auto add = [&sites](const Flat& p, const Number& z, const Number& constant, Row row) {
    sites.push_back({{{p.x(), p.y(), z}, p * p + z * z - constant}, row});
    CGAL::exact(sites.back().first);  // makes intervals as short as possible
  };
  largest_ = std::ranges::max(balls_, {}, &Circle::square).square;
  const bool is_alone = std::ranges::count(balls_, largest_, &Circle::square) == 1;
  for (const auto& [c, square] : balls_) {
    add(c / square, -1 / (2 * square), c * c / square, static_cast<Row>(cells_.size()));
    rounded_.push_back({{rounded(c.x()), rounded(c.y())}, std::sqrt(rounded(square))});
    cells_.push_back({rounded_.back().center, is_alone && square == largest_ ? INFINITY : 0.0});
  }
  // Three functions that exceed the first one everywhere make the triangulation three-dimensional.
  const auto& [c, square] = balls_[0];
  for (const auto& [x, y] : {std::pair(0, 0), {1, 0}, {0, 1}})
    add((c + Flat(x, y)) / square, -1 / square, (c * c + x + y + 1) / square, kNoRow);
  const Power power(sites.begin(), sites.end());
  for (const auto cell : power.finite_cell_handles()) {
    const Vector at = power.dual(cell) - CGAL::ORIGIN;
    Mark mark{CGAL::sign(at.x() * at.x() + at.y() * at.y() - at.z())};
    const auto node = [&cell](int k) { return cell->vertex(k % 4); };
    for (int k = 0; mark.sign == 0 && k < 4; ++k)
      mark = vertex({node(k), node(k + 1), node(k + 2)}, {Wide(at.x().exact()), Wide(at.y().exact())});
    cell->info() = {at, mark, {}};
  }
  inputs.checkpoint(1, 3);
  for (const auto cell : power.finite_cell_handles())
    for (int side = 0; side < 4; ++side) cross(power, cell, side);
  inputs.checkpoint(2, 3);
  for (const auto& edge : power.finite_edges()) trace(power, edge);
  for (std::size_t k = 0; k < cells_.size(); ++k)
    if (std::isinf(cells_[k].factor)) cells_[k].position = rounded_[k].center;
}

/// Marks the power edge that leaves a cell through a side. It is a segment or a ray.
void MoebiusDiagram::cross(const Power& power, Power::Cell_handle cell, int side) {
  const auto other = cell->neighbor(side);
  const bool is_ray = power.is_infinite(other);
  const Vector from = cell->info().at, to = is_ray ? from : other->info().at;
  if (!is_ray && (other < cell || from == to)) return;
  const auto node = [&](int k) { return cell->vertex(Power::vertex_triple_index(side, k)); };
  const std::array<Node, 3> nodes{node(2), node(1), node(0)};
  const Vector base = vector_of(nodes[0]),
               way = CGAL::cross_product(vector_of(nodes[1]) - base, vector_of(nodes[2]) - base);
  // At the point from + t * way, x^2 + y^2 - z is a t^2 + 2 b t + c.
  const auto slope_at = [&way](const Vector& at) -> Number {
    return at.x() * way.x() + at.y() * way.y() - way.z() / 2;
  };
  const Number a = way.x() * way.x() + way.y() * way.y(), b = slope_at(from),
               c = from.x() * from.x() + from.y() * from.y() - from.z();
  const int slope = CGAL::sign(b), last = CGAL::sign(is_ray && !CGAL::is_zero(a) ? a : slope_at(to));
  const auto first_of = [](int sign, int next) { return sign != 0 ? sign : next != 0 ? next : 1; };
  const int begin = first_of(cell->info().mark.sign, slope),
            end = is_ray ? last : first_of(other->info().mark.sign, -last);
  std::vector<Mark> marks{{begin}};
  const auto add = [&](int root, int sign) {
    marks.push_back(vertex(nodes, crossing(nodes, root)));
    marks.push_back({sign});
  };
  const int roots = begin + end == 2 && slope < 0 && last > 0 ? int(CGAL::sign(b * b - a * c)) : -1;
  if (begin != end) add(end, end);
  if (roots >= 0) add(-1, 1 - 2 * roots);
  if (roots > 0) add(1, 1);
  cell->info().beside[side] = marks;
  other->info().beside[power.mirror_index(cell, side)].assign(marks.rbegin(), marks.rend());
}

/// Adds the edges between two cells: the parts of a circle or a line in the power face of both balls.
void MoebiusDiagram::trace(const Power& power, const Power::Edge& edge) {
  Node p = edge.first->vertex(edge.second), q = edge.first->vertex(edge.third);
  if (p->info() == kNoRow || q->info() == kNoRow) return;
  if (std::tie(balls_[p->info()].square, p->info()) > std::tie(balls_[q->info()].square, q->info())) std::swap(p, q);
  const Row i = p->info(), j = q->info();
  const auto& [a, square] = balls_[i];
  const auto& [b, other] = balls_[j];
  const bool is_line = square == other;
  // Marks around the face, and the balls beside it.
  std::vector<Mark> marks;
  std::vector<Node> around;
  auto cell = edge.first;
  do {
    const int next = Power::next_around_edge(cell->index(p), cell->index(q));
    const Node third = cell->vertex(6 - cell->index(p) - cell->index(q) - next);
    if (!power.is_infinite(cell)) marks.push_back(cell->info().mark);
    std::ranges::copy(cell->info().beside[next], std::back_inserter(marks));
    if (!power.is_infinite(third))
      around.push_back(third);
    else if (is_line && square == largest_)
      marks.insert(marks.end(), {{0, kFar}, {-1}, {0, kFar}});  // the parabola of a line is infinite
    cell = cell->neighbor(next);
  } while (cell != edge.first);
  const auto is_zero = [](const Mark& mark) { return mark.sign == 0; };
  const auto both = [&](const Mark& one, const Mark& two) { return is_zero(one) && is_zero(two); };
  marks.erase(std::ranges::unique(marks, both).begin(), marks.end());
  if (marks.size() > 1 && both(marks.front(), marks.back())) marks.pop_back();
  // An edge begins where the boundary of the face leaves the paraboloid, and ends where it comes back.
  std::vector<std::pair<Row, bool>> stops;
  bool is_cut = false, is_outside = true;
  for (std::size_t k = 0, count = marks.size(); k < count; ++k) {
    const int last = marks[(k + count - 1) % count].sign, next = marks[(k + 1) % count].sign;
    is_outside = is_outside && last >= 0;
    if (!is_zero(marks[k])) continue;
    is_cut = is_cut || last * next < 0;
    if (last > 0 || next > 0) stops.emplace_back(marks[k].vertex, next > 0);
  }
  if (!is_cut && (is_line || !is_outside)) return;
  Edge out{arc, {i, j}, {}, 0.0, {}, {}};
  if (!is_line) {
    const Number difference = other - square;
    const Flat m = (other * a - square * b) / difference;
    const Vector lifted(m.x(), m.y(), 2 * (m * m) - (other * (a * a) - square * (b * b)) / difference);
    // A circle that is not cut lies in the face if its centre does.
    const auto is_beyond = [&](Node node) {
      return constant_of(node) - constant_of(p) < 2 * (vector_of(node) - vector_of(p)) * lifted;
    };
    if (!is_cut && std::ranges::any_of(around, is_beyond)) return;
    out.center = {rounded(m.x()), rounded(m.y())};
    out.radius = std::sqrt(rounded(square * other * (a - b).squared_length() / (difference * difference)));
    if (stops.empty()) stops.emplace_back(kNoRow, true);
  }
  const Ball &u = rounded_[i], &v = rounded_[j];
  const Point along{u.center.y - v.center.y, v.center.x - u.center.x};
  const auto position = [&](Row row) {
    return row == kNoRow ? Point{out.center.x + out.radius, out.center.y} : vertices_[row].position;
  };
  const std::size_t count = edges_.size();
  for (std::size_t k = 0; k < stops.size(); ++k) {
    const Row from = stops[k].first, to = stops[(k + 1) % stops.size()].first;
    const bool is_far = from == kFar || to == kFar;
    if (!stops[k].second || (is_cut && from == to && !is_far)) continue;
    out.kind = !is_line ? arc : !is_far ? segment : from == to ? line : ray;
    if (is_far) cells_[i].factor = cells_[j].factor = INFINITY;
    out.from = out.kind == line ? Point{(u.center.x + v.center.x) / 2, (u.center.y + v.center.y) / 2}
                                : position(from == kFar ? to : from);
    out.to = to == kFar ? along : from == kFar ? Point{-along.x, -along.y} : position(to);
    if (out.kind == arc && from != kNoRow) {
      // Rounding may exchange the ends of an arc that is much shorter than its radius, or of its complement.
      const Wide x = precise_[to].x - precise_[from].x, y = precise_[to].y - precise_[from].y;
      const Wide turn = x * (out.center.y - precise_[from].y) - y * (out.center.x - precise_[from].x);
      if (turn > 0 && x * x + y * y < 1e-14 * out.radius * out.radius) out.kind = segment;
      if (turn <= 0 && x * x + y * y < 1e-28 * out.radius * out.radius) out.to = out.from;
    }
    edges_.push_back(out);
  }
  if (is_line || edges_.size() == count) return;
  // The point of the circle that is farthest from both balls, if it belongs to an edge.
  const Flat way = a - b;
  const auto t = CGAL::Sqrt_extension<Number, Number, CGAL::Tag_true, CGAL::Tag_true>(square, 1, square * other) /
                 (other - square);
  const auto x = way.x() * t + a.x(), y = way.y() * t + a.y(), z = x * x + y * y;
  for (const Node node : around) {
    const Vector d = 2 * (vector_of(node) - vector_of(p));
    if (CGAL::sign(d.x() * x + d.y() * y + d.z() * z + (constant_of(p) - constant_of(node))) > 0) return;
  }
  const double factor = u.radius * (u.radius + v.radius) / rounded(other - square);
  for (const Row row : {i, j})
    reach(row, {u.center.x + factor * (u.center.x - v.center.x), u.center.y + factor * (u.center.y - v.center.y)});
}

}  // namespace

MESECINA_EXPERIMENT(experiment) {
  experiment.add_structure<MoebiusDiagram>({.id = "moebius-diagram", .inputs = {"balls", "inner-balls"}});
  experiment.add_layer(
      {.id = "moebius-diagram",
       .name = "Moebius diagram",
       .description = "Edges between the cells of balls that grow by a common factor",
       .rows = "moebius-diagram/edges",
       .kinds = {PrimitiveKind::arc, PrimitiveKind::segment, PrimitiveKind::ray, PrimitiveKind::line},
       .color = {0.1, 0.5, 0.4}},
      [](const Inputs& inputs) {
        const auto kind = inputs.column<std::uint8_t>("moebius-diagram/edges/kind");
        const auto center = inputs.column<Point>("moebius-diagram/edges/center");
        const auto radius = inputs.column<double>("moebius-diagram/edges/radius");
        const auto from = inputs.column<Point>("moebius-diagram/edges/from");
        const auto to = inputs.column<Point>("moebius-diagram/edges/to");
        return [=](Row row, Drawn& out) {
          if (kind[row] == arc) out.arc({center[row], radius[row]}, from[row], to[row]);
          if (kind[row] == segment) out.segment(from[row], to[row]);
          if (kind[row] == ray) out.ray(from[row], to[row]);
          if (kind[row] == line) out.line(from[row], to[row]);
        };
      });
  for (const bool is_vertex : {true, false})
    experiment.add_layer({.id = is_vertex ? "moebius-vertices" : "moebius-vanishing",
                          .name = is_vertex ? "Moebius vertices" : "Vanishing points",
                          .description = is_vertex ? "Points that growing balls reach three at a time"
                                                   : "Points where growing balls have reached their whole cells",
                          .rows = is_vertex ? "moebius-diagram/vertices" : "moebius-diagram/cells",
                          .kinds = {PrimitiveKind::point},
                          .scalar = "factor of the radii",
                          .color_map = "viridis"},
                         [is_vertex](const Inputs& inputs) {
                           const std::string table =
                               is_vertex ? "moebius-diagram/vertices/" : "moebius-diagram/cells/";
                           const auto at = inputs.column<Point>(table + "position");
                           const auto factor = inputs.column<double>(table + "factor");
                           return [=](Row row, Drawn& out) {
                             if (std::isfinite(factor[row])) out.point(at[row], factor[row]);
                           };
                         });
}
