// SPDX-License-Identifier: GPL-3.0-or-later
// Lloyd's relaxation: each sample moves to the centroid of its Voronoi cell, so that samples spread evenly.
//
// Source: S. P. Lloyd, Least squares quantization in PCM, IEEE Transactions on Information Theory 28 (1982); Q. Du, V.
// Faber, M. Gunzburger, Centroidal Voronoi tessellations, SIAM Review 41 (1999). Cells are clipped to the convex hull
// of the samples, and samples on the hull stay, so that the hull stays, too: an evolution sees only the present
// positions, and a hull or box that follows them would shrink or grow from step to step.
//
// A cell begins as the bounding box, and is cut by the bisectors between the sample and its Delaunay neighbours and by
// the edges of the hull, in coordinates relative to the sample. Samples at the same position stay together.
//
//   mesecina evolve shape.poff --with lloyd.cpp --evolution lloyd --steps 20 -o even.poff
#include <mesecina/experiment.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>
#include <vector>

using namespace mesecina;

namespace {

/// Keeps the part of a polygon where normal.x <= limit.
void cut(std::vector<Point>& polygon, Point normal, double limit) {
  const auto beyond = [&](Point p) { return p.x * normal.x + p.y * normal.y - limit; };
  std::vector<Point> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    const double at_a = beyond(a), at_b = beyond(b);
    if (at_a <= 0.0) kept.push_back(a);
    if ((at_a < 0.0 && at_b > 0.0) || (at_a > 0.0 && at_b < 0.0)) {
      const double way = at_a / (at_a - at_b);
      kept.push_back({a.x + way * (b.x - a.x), a.y + way * (b.y - a.y)});
    }
  }
  polygon = std::move(kept);
}

/// Of a polygon around 0.
Point centroid(const std::vector<Point>& polygon) {
  double area = 0.0;
  Point moment;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point a = polygon[i], b = polygon[(i + 1) % polygon.size()];
    const double twice = a.x * b.y - a.y * b.x;
    area += twice;
    moment = {moment.x + twice * (a.x + b.x), moment.y + twice * (a.y + b.y)};
  }
  return area > 0.0 ? Point{moment.x / (3.0 * area), moment.y / (3.0 * area)} : Point{};
}

std::vector<Point> relax(const MovingSamples& samples, std::span<const double> values) {
  std::vector<Point> next(samples.positions.begin(), samples.positions.end());
  Workbench bench(Catalogue::builtin(), {.keeps_history = false, .keeps_instances = false});
  const std::vector<SampleId> ids = bench.insert(samples.positions);
  bench.need({"delaunay"});
  bench.run();
  const auto place = bench.table("delaunay/sites").column("position").copy<Point>();
  const auto ends = bench.table("delaunay/edges").column("sites").copy<std::array<Row, 2>>();
  const auto beside = bench.table("delaunay/edges").column("faces").copy<std::array<Row, 2>>();
  const auto is_finite = bench.table("delaunay/faces").column("is_finite").copy<bool>();
  const std::vector<Row> edges = bench.table("delaunay/edges").live_rows();

  // The hull, counter-clockwise: outside is on the right of each pair.
  std::vector<std::array<Row, 2>> hull;
  std::vector<bool> is_on_hull(place.size(), false);
  for (const Row edge : edges) {
    const auto [left, right] = beside[edge];
    if (left == kNoRow) return next;  // All samples lie on a line.
    if (is_finite[left] && is_finite[right]) continue;
    const auto [a, b] = ends[edge];
    hull.push_back(is_finite[left] ? std::array{a, b} : std::array{b, a});
    is_on_hull[a] = is_on_hull[b] = true;
  }
  if (hull.empty()) return next;
  Point low = place[hull[0][0]], high = low;
  for (const auto& [a, b] : hull) {
    low = {std::min(low.x, place[a].x), std::min(low.y, place[a].y)};
    high = {std::max(high.x, place[a].x), std::max(high.y, place[a].y)};
  }

  // Cells of the sites inside the hull, in units of the box, so that no product can overflow.
  const double unit = std::max(high.x - low.x, high.y - low.y);
  const auto way = [unit](Point a, Point b) { return Point{(b.x - a.x) / unit, (b.y - a.y) / unit}; };
  std::vector<std::vector<Point>> cells(place.size());
  for (const Row row : bench.table("delaunay/sites").live_rows()) {
    const Point from = way(place[row], low), to = way(place[row], high);
    if (!is_on_hull[row]) cells[row] = {from, {to.x, from.y}, to, {from.x, to.y}};
  }
  for (const Row edge : edges)
    for (const std::size_t end : {0, 1}) {
      const Point other = way(place[ends[edge][end]], place[ends[edge][1 - end]]);
      cut(cells[ends[edge][end]], other, 0.5 * (other.x * other.x + other.y * other.y));
    }
  for (Row row = 0; row < cells.size(); ++row)
    for (const auto& [a, b] : hull) {
      if (cells[row].empty()) break;
      const Point along = way(place[a], place[b]), from = way(place[row], place[a]), normal{along.y, -along.x};
      cut(cells[row], normal, normal.x * from.x + normal.y * from.y);
    }

  const auto id = bench.table("samples/samples").column("id").copy<std::uint32_t>();
  const auto site_of = bench.table("delaunay/samples").column("site").copy<Row>();
  std::unordered_map<std::uint32_t, Row> site_of_id;
  for (const Row row : bench.table("samples/samples").live_rows()) site_of_id[id[row]] = site_of[row];
  for (std::size_t i = 0; i < next.size(); ++i) {
    const Row site = site_of_id[ids[i].value];
    if (is_on_hull[site]) continue;
    const Point move = centroid(cells[site]);
    next[i] = {next[i].x + values[0] * unit * move.x, next[i].y + values[0] * unit * move.y};
    // Sums that should be zero are only nearly so, and a document has no room for them beside its large numbers.
    for (double* x : {&next[i].x, &next[i].y})
      if (std::abs(*x) < 1e-18 * unit) *x = 0.0;
  }
  return next;
}

}  // namespace

MESECINA_EXPERIMENT(experiment) {
  experiment.add_evolution(
      {.id = "lloyd",
       .name = "Lloyd's relaxation",
       .description = "Each sample moves to the centroid of its Voronoi cell within the hull",
       .parameters = {{.id = "lloyd-way",
                       .description = "How far a sample moves to the centroid; above 1: beyond it",
                       .low = 0.0,
                       .high = 1.9,
                       .default_value = 1.0}}},
      relax);
}
