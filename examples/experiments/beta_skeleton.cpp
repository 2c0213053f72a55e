// SPDX-License-Identifier: GPL-3.0-or-later
// The lune-based beta-skeleton for beta from 1 to 4: the Gabriel graph at 1, the relative neighbourhood graph at 2.
//
// Source: D. G. Kirkpatrick, J. D. Radke, A framework for computational morphology, Computational Geometry, 1985.
// Samples p and q are joined if their open lune has no sample: the common part of two disks of radius beta |pq| / 2, of
// which one touches p from the side of q, the other touches q from the side of p. A sample r lies in the first disk
// exactly if |r - p|^2 < beta (q - p).(r - p). The sign of the difference is computed exactly.
//
// The lune has the diametral disk in it, so edges of the skeleton are Delaunay edges. For beta > 1 the witness of a
// rejected edge can lie far from its two triangles. All points r of the lune lie in the disk |r - p|^2 + |r - q|^2 <=
// beta |pq|^2, as p and q do, and the Delaunay edges between the samples of a disk connect them (shrink the disk until
// it touches any two). So a search that begins at p and q and stays in that disk finds every witness. For beta < 1 the
// skeleton has edges that are not Delaunay, so it is left out.
//
//   mesecina shape.poff --with beta_skeleton.cpp
#include <mesecina/experiment.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

using namespace mesecina;

namespace {

/// A sum of doubles without rounding: parts that do not overlap, by increasing magnitude (J. R. Shewchuk, Adaptive
/// precision floating-point arithmetic and fast robust geometric predicates, 1997).
class ExactSum {
 public:
  void add(double x) {
    std::size_t kept = 0;
    for (const double part : parts_) {
      const double sum = x + part, virtual_part = sum - x;
      const double rest = (x - (sum - virtual_part)) + (part - virtual_part);
      if (rest != 0.0) parts_[kept++] = rest;
      x = sum;
    }
    parts_.resize(kept);
    if (x != 0.0) parts_.push_back(x);
  }
  void add_product(double factor, double a, double b) {
    for (const double part : {a * b, std::fma(a, b, -(a * b))}) {
      add(factor * part);
      add(std::fma(factor, part, -(factor * part)));
    }
  }
  bool is_positive() const { return !parts_.empty() && parts_.back() > 0.0; }

 private:
  std::vector<double> parts_;
};

/// True if r lies inside the disk of the lune of p and q that touches p.
bool is_in_disk(Point p, Point q, Point r, double beta) {
  const double vx = r.x - p.x, vy = r.y - p.y;
  const double along_x = (q.x - p.x) * vx, along_y = (q.y - p.y) * vy;
  const double estimate = beta * (along_x + along_y) - (vx * vx + vy * vy);
  // Six roundings lie on the longest way to the estimate. Below the second bound, underflow adds to them.
  const double bound = 1e-15 * (beta * (std::abs(along_x) + std::abs(along_y)) + vx * vx + vy * vy);
  if (bound > 1e-280 && std::abs(estimate) > bound) return estimate > 0.0;
  // Coordinates near 1 keep all products within the range of doubles. The points differ, so not all are zero.
  double largest = 0.0;
  for (const double x : {p.x, p.y, q.x, q.y, r.x, r.y}) largest = std::max(largest, std::abs(x));
  const double scale = std::ldexp(1.0, -std::ilogb(largest));
  ExactSum sum;
  for (const auto& [a, b, c] : {std::array{p.x, q.x, r.x}, std::array{p.y, q.y, r.y}}) {
    const double at_p = scale * a, at_q = scale * b, at_r = scale * c;
    sum.add_product(beta, at_q, at_r);
    sum.add_product(-beta, at_q, at_p);
    sum.add_product(-beta, at_p, at_r);
    sum.add_product(beta, at_p, at_p);
    sum.add_product(-1.0, at_r, at_r);
    sum.add_product(2.0, at_r, at_p);
    sum.add_product(-1.0, at_p, at_p);
  }
  return sum.is_positive();
}

class BetaSkeleton final : public Structure {
 public:
  void rebuild(const Inputs& inputs) override {
    const View view{inputs};
    for (auto* rows : {&watched_, &watchers_}) rows->clear();
    is_edge_.clear(), touched_.clear(), removed_.clear();
    watches_ = 0;
    make_room(inputs);
    for (const Row edge : inputs.live_rows("delaunay/edges")) {
      if (edge % 1024 == 0) inputs.checkpoint(edge, is_edge_.size());
      decide(view, edge);
    }
  }

  // An answer depends on the two faces of the edge and on the faces around the sites that the edge watches.
  bool update(const Inputs& inputs) override {
    if (watches_ >= kMostWatches) return false;
    const View view{inputs};
    make_room(inputs);
    const RowChanges changes = inputs.changes("delaunay/edges"), of_sites = inputs.changes("delaunay/sites");
    removed_.assign(changes.removed.begin(), changes.removed.end());
    touched_.assign(changes.touched.begin(), changes.touched.end());
    touched_.insert(touched_.end(), removed_.begin(), removed_.end());
    queue_.assign(of_sites.removed.begin(), of_sites.removed.end());
    const Table edges = inputs.table("delaunay/edges"), faces = inputs.table("delaunay/faces");
    for (const Row face : inputs.changes("delaunay/faces").touched)
      if (faces.is_alive(face) && view.is_finite[face])
        for (const Row site : view.corners[face]) queue_.push_back(site);
    drop_repeated(queue_);
    for (const Row site : queue_) touched_.insert(touched_.end(), watchers_[site].begin(), watchers_[site].end());
    drop_repeated(touched_);
    for (const Row edge : touched_) {
      forget(edge);
      if (edges.is_alive(edge)) decide(view, edge);
    }
    return true;
  }

  std::vector<OwnTable> tables() const override {
    std::vector<OwnTable> out;
    out.emplace_back("edges", "Which edges are in the beta-skeleton")
        .rows_of("delaunay/edges")
        .changes(touched_, removed_)
        .flag("is_skeleton", "No sample lies inside the lune", is_edge_);
    return out;
  }

  std::vector<Statistic> statistics() const override {
    return {{"beta_skeleton_edges", std::int64_t{std::ranges::count(is_edge_, 1)}},
            {"edges_with_far_witness", std::int64_t{std::ranges::count(watched_, 1U, &std::vector<Row>::size)}}};
  }

 private:
  static constexpr std::size_t kMostWatches = 5'000'000;  // The next update after it computes everything.
  using Pair = std::array<Row, 2>;
  using Triple = std::array<Row, 3>;
  struct View {
    const Inputs& inputs;
    double beta = inputs.parameter("beta-skeleton-beta");
    InputColumn<Pair> ends = inputs.column<Pair>("delaunay/edges/sites");
    InputColumn<Pair> beside = inputs.column<Pair>("delaunay/edges/faces");
    InputColumn<Triple> corners = inputs.column<Triple>("delaunay/faces/sites");
    InputColumn<Triple> neighbours = inputs.column<Triple>("delaunay/faces/faces");
    InputColumn<bool> is_finite = inputs.column<bool>("delaunay/faces/is_finite");
    InputColumn<Point> place = inputs.column<Point>("delaunay/sites/position");
    InputColumn<Row> face_at = inputs.column<Row>("delaunay/sites/face");

    bool is_in_lune(Row a, Row b, Row site) const {
      return is_in_disk(place[a], place[b], place[site], beta) && is_in_disk(place[b], place[a], place[site], beta);
    }
  };

  static void drop_repeated(std::vector<Row>& rows) {
    std::ranges::sort(rows);
    rows.erase(std::ranges::unique(rows).begin(), rows.end());
  }
  void make_room(const Inputs& inputs) {
    watched_.resize(inputs.rows("delaunay/edges"));
    watchers_.resize(inputs.rows("delaunay/sites"));
    seen_.resize(watchers_.size(), 0);
    is_edge_.resize(watched_.size(), 0);
  }

  void decide(const View& view, Row edge) {
    const auto [a, b] = view.ends[edge];
    bool is_corner_in_lune = false;
    for (const Row face : view.beside[edge]) {
      if (face == kNoRow || !view.is_finite[face]) continue;
      for (const Row corner : view.corners[face])
        is_corner_in_lune = is_corner_in_lune || (corner != a && corner != b && view.is_in_lune(a, b, corner));
    }
    if (!is_corner_in_lune && (view.beta == 1.0 || search(view, edge))) is_edge_[edge] = 1;
  }

  /// True if no sample lies in the lune. The edge then watches all sites of the search, else the one in the lune.
  bool search(const View& view, Row edge) {
    const auto [a, b] = view.ends[edge];
    const Point p = view.place[a], q = view.place[b];
    // Wider than the disk by more than any rounding. It only guides the search.
    const auto square = [](Point r, Point s) { return (r.x - s.x) * (r.x - s.x) + (r.y - s.y) * (r.y - s.y); };
    const double reach = (1.0 + 1e-9) * view.beta * square(p, q) + 1e-300;
    queue_ = {a, b};
    seen_[a] = seen_[b] = ++round_;
    for (std::size_t i = 0; i < queue_.size(); ++i) {
      const Row site = queue_[i], first = view.face_at[site];
      for (Row face = first; face != kNoRow;) {
        const std::array<Row, 3> corners = view.corners[face];
        for (const Row corner : corners) {
          if (!view.is_finite[face] || seen_[corner] == round_) continue;
          seen_[corner] = round_;
          if (square(p, view.place[corner]) + square(q, view.place[corner]) > reach) continue;
          if (view.is_in_lune(a, b, corner)) {
            watch(edge, corner);
            return false;
          }
          queue_.push_back(corner);
        }
        const std::size_t at = static_cast<std::size_t>(std::ranges::find(corners, site) - corners.begin());
        const Row next = view.neighbours[face][(at + 1) % 3];
        face = next == first ? kNoRow : next;
      }
    }
    watches_ += queue_.size();
    for (const Row site : queue_)
      if (watches_ < kMostWatches) watch(edge, site);
    return true;
  }

  void watch(Row edge, Row site) { watched_[edge].push_back(site), watchers_[site].push_back(edge); }
  void forget(Row edge) {
    for (const Row site : watched_[edge]) std::erase(watchers_[site], edge);
    watched_[edge].clear();
    is_edge_[edge] = 0;
  }

  std::vector<std::uint8_t> is_edge_;
  std::vector<std::vector<Row>> watched_;   // by edge: sites
  std::vector<std::vector<Row>> watchers_;  // by site: edges
  std::vector<std::uint32_t> seen_;         // by site: the search that has seen it
  std::uint32_t round_ = 0;
  std::size_t watches_ = 0;  // since everything was computed
  std::vector<Row> queue_, touched_, removed_;
};

}  // namespace

MESECINA_EXPERIMENT(experiment) {
  experiment.add_parameter({.id = "beta-skeleton-beta",
                            .description = "Size of the lunes: 1 Gabriel graph, 2 relative neighbourhood graph",
                            .low = 1.0,
                            .high = 4.0,
                            .default_value = 2.0});
  experiment.add_structure<BetaSkeleton>(
      {.id = "beta-skeleton", .inputs = {"delaunay"}, .parameters = {"beta-skeleton-beta"}});
  experiment.add_layer({.id = "beta-skeleton",
                        .name = "Beta-skeleton",
                        .description = "Delaunay edges whose lune has no sample inside",
                        .rows = "beta-skeleton/edges",
                        .follows = {"delaunay/edges"},
                        .kinds = {PrimitiveKind::segment},
                        .color = {0.1, 0.45, 0.75}},
                       [](const Inputs& inputs) {
                         const auto is_edge = inputs.column<bool>("beta-skeleton/edges/is_skeleton");
                         const auto ends = inputs.column<std::array<Row, 2>>("delaunay/edges/sites");
                         const auto place = inputs.column<Point>("delaunay/sites/position");
                         return [=](Row edge, Drawn& out) {
                           if (is_edge[edge]) out.segment(place[ends[edge][0]], place[ends[edge][1]]);
                         };
                       });
}
