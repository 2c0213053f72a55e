// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/filters/axis_branches.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "core/base/disjoint_sets.h"
#include "core/base/sum.h"

namespace mes {
namespace {

/// An edge with a direction: from its end `EdgeRow::f[from]` to the other.
struct Step {
  EdgeSlot edge{};
  int from = 0;
};

class Tracer {
 public:
  Tracer(const AxisFilter& filter, const InnerBalls& balls, const LambdaAxis& lambda, const AngleAxis& angle)
      : filter_(filter),
        balls_(balls),
        lambda_(lambda),
        angle_(angle),
        delaunay_(filter.delaunay()),
        is_done_(delaunay_.edge_rows(), 0) {}

  std::vector<AxisBranch> run(double least) {
    trace_all();
    if (contract_shorter(least)) trace_all();
    return std::move(out_);
  }

 private:
  void trace_all() {
    // Start from every end of a branch first; what is left then is closed.
    for (const EdgeSlot edge : delaunay_.edge_slots())
      for (int end = 0; end < 2; ++end)
        if (is_open(edge) && end_of({edge, end}).kind != BranchEndKind::none) trace({edge, end});
    for (const EdgeSlot edge : delaunay_.edge_slots())
      if (is_open(edge)) trace({edge, 0});
    for (const FaceSlot node : delaunay_.face_slots())
      if (delaunay_.is_finite_face(node) && filter_.is_kept(node) && is_first_of_its_node(node) &&
          degree_of(node) == 0)
        add_point(node);
  }

  bool is_open(EdgeSlot edge) const { return filter_.is_kept(edge) && is_done_[edge] == 0; }
  FaceSlot node_of(const Step& step) const {
    const FaceSlot node = balls_.ball(delaunay_.edge(step.edge).f[step.from]);
    const auto at = first_of_.find(node);
    return at == first_of_.end() ? node : at->second;
  }
  bool is_first_of_its_node(FaceSlot node) const {
    const auto at = first_of_.find(node);
    return at == first_of_.end() || at->second == node;
  }

  /// Unites the ends of short branches, and leaves their edges out. Returns whether there were any.
  bool contract_shorter(double least) {
    if (!(least > 0.0)) return false;
    DisjointSets<FaceSlot> nodes;
    std::vector<FaceSlot> ends;
    is_done_.assign(delaunay_.edge_rows(), 0);
    for (const AxisBranch& branch : out_) {
      const bool is_cut = branch.from.kind == BranchEndKind::cut || branch.to.kind == BranchEndKind::cut;
      if (is_cut || branch.edges.empty() || branch.length > least * branch.radius_largest) continue;
      nodes.grow(delaunay_.face_rows());
      for (const EdgeSlot edge : branch.edges) {
        is_done_[edge] = 1;
        for (const int end : {0, 1}) ends.push_back(node_of({edge, end}));
        nodes.join(nodes.root(ends.back()), nodes.root(*(ends.end() - 2)));
      }
    }
    if (ends.empty()) return false;
    std::unordered_map<FaceSlot, FaceSlot> first_of_root;
    const auto order = [&](FaceSlot node) {
      const Vec2 place = delaunay_.circumcenter(node);
      return std::tuple(place.x, place.y, delaunay_.circumradius(node));
    };
    for (const FaceSlot node : ends) {
      FaceSlot& first = first_of_root.try_emplace(nodes.root(node), node).first->second;
      if (order(node) < order(first)) first = node;
    }
    for (const FaceSlot node : ends) {
      const FaceSlot first = first_of_root.at(nodes.root(node));
      if (!first_of_.try_emplace(node, first).second) continue;
      std::vector<Step>& ways = ways_[first];
      for (const Step& step : kept_around(node))
        if (is_done_[step.edge] == 0) ways.push_back(step);
    }
    out_.clear();
    return true;
  }

  /// Kept edges, leading away from a node, that end there and are not cut before it.
  std::vector<Step> kept_around(FaceSlot node) const {
    std::vector<Step> out;
    const auto add = [&](FaceSlot face) {
      for (const EdgeSlot edge : delaunay_.face(face).e) {
        if (edge == kNoSlot || !filter_.is_kept(edge)) continue;
        const Step step{edge, delaunay_.edge(edge).f[0] == face ? 0 : 1};
        if (!filter_.is_cut(edge, step.from)) out.push_back(step);
      }
    };
    if (const auto* group = balls_.group(node))
      std::ranges::for_each(*group, add);
    else
      add(node);
    return out;
  }

  /// The same, without contracted edges, at all nodes that are united with it.
  std::vector<Step> kept_at(FaceSlot node) const {
    const auto at = ways_.find(node);
    return at == ways_.end() ? kept_around(node) : at->second;
  }
  std::size_t degree_of(FaceSlot node) const {
    const auto at = ways_.find(node);
    return at == ways_.end() ? kept_around(node).size() : at->second.size();
  }

  /// The end of the branch where the step begins; `none` if the branch continues.
  AxisBranch::End end_of(const Step& step) const {
    if (filter_.is_cut(step.edge, step.from)) return {filter_.kept_end(step.edge, step.from), BranchEndKind::cut};
    const FaceSlot node = node_of(step);
    const std::size_t degree = degree_of(node);
    const auto kind =
        degree == 1 ? BranchEndKind::leaf : (degree == 2 ? BranchEndKind::none : BranchEndKind::junction);
    return {delaunay_.circumcenter(node), kind, kind == BranchEndKind::none ? FaceSlot() : node};
  }

  void trace(Step step) {
    AxisBranch branch;
    branch.from = end_of(step);
    const EdgeSlot first = step.edge;
    for (;;) {
      is_done_[step.edge] = 1;
      branch.edges.push_back(step.edge);
      const Step back{step.edge, 1 - step.from};
      branch.to = end_of(back);
      if (branch.to.kind != BranchEndKind::none) break;
      const std::vector<Step> ways = kept_at(node_of(back));
      step = ways[0].edge == step.edge ? ways[1] : ways[0];
      if (step.edge == first) break;
    }
    if (branch.from.kind == BranchEndKind::none)
      arrange_closed(branch);
    else
      arrange_open(branch);
    measure(branch);
    out_.push_back(std::move(branch));
  }

  /// The node between an edge of a branch and the one before it; before the first edge of a closed branch comes the last.
  Vec2 place_before(const AxisBranch& branch, std::size_t i) const {
    const std::size_t n = branch.edges.size();
    const EdgeSlot before = branch.edges[(i + n - 1) % n];
    const FaceSlot first = node_of({branch.edges[i], 0});
    const bool is_first = first == node_of({before, 0}) || first == node_of({before, 1});
    return delaunay_.circumcenter(is_first ? first : node_of({branch.edges[i], 1}));
  }

  /// The order of the ends depends on positions alone: the smaller comes first. If both are equal, as in a loop at a
  /// junction, the branch runs the way that reaches the smaller node first.
  void arrange_open(AxisBranch& branch) const {
    const auto order = [](const AxisBranch::End& end) { return std::tuple(end.place.x, end.place.y, end.kind); };
    bool is_backwards = order(branch.to) < order(branch.from);
    if (order(branch.to) == order(branch.from)) {
      const std::size_t n = branch.edges.size();
      for (std::size_t i = 1; i < n; ++i) {
        const Vec2 p = place_before(branch, i);
        const Vec2 q = place_before(branch, n - i);
        if (p == q) continue;
        is_backwards = lexicographically_less(q, p);
        break;
      }
    }
    if (!is_backwards) return;
    std::swap(branch.from, branch.to);
    std::ranges::reverse(branch.edges);
  }

  /// A possible start and direction of a closed branch.
  struct Start {
    std::size_t first = 0;
    bool is_backwards = false;
    std::size_t place_at(std::size_t step, std::size_t n) const {
      return is_backwards ? (first + n - step) % n : (first + step) % n;
    }
  };

  /// A closed branch was traced from an arbitrary edge in an arbitrary direction. Makes it begin at its smallest node
  /// and run towards the smaller of the two nodes next to it.
  void arrange_closed(AxisBranch& branch) const {
    const std::size_t n = branch.edges.size();
    std::vector<Vec2> places(n);
    for (std::size_t i = 0; i < n; ++i) places[i] = place_before(branch, i);
    const auto is_less = [&](const Start& a, const Start& b) {
      for (std::size_t step = 0; step < n; ++step) {
        const Vec2 p = places[a.place_at(step, n)];
        const Vec2 q = places[b.place_at(step, n)];
        if (p != q) return lexicographically_less(p, q);
      }
      return false;
    };
    Start best;
    for (std::size_t first = 0; first < n; ++first)
      for (const bool is_backwards : {false, true})
        if (const Start start{first, is_backwards}; is_less(start, best)) best = start;
    branch.from.place = branch.to.place = places[best.first];
    if (best.is_backwards) {
      std::ranges::reverse(branch.edges);
      best.first = (n - best.first) % n;
    }
    std::ranges::rotate(branch.edges, branch.edges.begin() + static_cast<std::ptrdiff_t>(best.first));
  }

  void add_point(FaceSlot node) {
    AxisBranch branch;
    branch.from.place = branch.to.place = delaunay_.circumcenter(node);
    branch.radius_least = branch.radius_mean = branch.radius_largest = delaunay_.circumradius(node);
    branch.lambda = lambda_.value(node);
    branch.angle = angle_.value(node);
    out_.push_back(std::move(branch));
  }

  // The balls of an edge touch its two samples: at height t over their middle the radius is the root of h^2 + t^2.
  // Heights of the ends are measured from the middle, so nothing depends on which end comes first.
  void measure(AxisBranch& branch) const {
    Sum length;
    Sum area;
    branch.radius_least = std::numeric_limits<double>::infinity();
    for (const EdgeSlot edge : branch.edges) {
      const EdgeRow& row = delaunay_.edge(edge);
      const Vec2 q = delaunay_.site_position(row.v[0]);
      const Vec2 r = delaunay_.site_position(row.v[1]);
      const double h = 0.5 * distance(q, r);
      const Vec2 middle{0.5 * q.x + 0.5 * r.x, 0.5 * q.y + 0.5 * r.y};
      const Vec2 up{-(r.y - q.y) / (2.0 * h), (r.x - q.x) / (2.0 * h)};
      double t[2] = {dot(filter_.kept_end(edge, 0) - middle, up), dot(filter_.kept_end(edge, 1) - middle, up)};
      if (t[0] > t[1]) std::swap(t[0], t[1]);
      const double whole = filter_.is_removed(edge) ? t[1] - t[0] : delaunay_.dual_length(edge);
      length.add(whole);
      const double low = std::hypot(h, t[0]);
      const double high = std::hypot(h, t[1]);
      branch.radius_least = std::min({branch.radius_least, low, high, t[0] <= 0.0 && t[1] >= 0.0 ? h : high});
      branch.radius_largest = std::max({branch.radius_largest, low, high});
      const auto integral = [h](double at) { return 0.5 * (at * std::hypot(h, at) + h * h * std::asinh(at / h)); };
      area.add(integral(t[1]) - integral(t[0]));
      branch.lambda = std::max(branch.lambda, lambda_.value(edge));
      branch.angle = std::max(branch.angle, angle_.largest(edge));
      for (const int end : {0, 1}) {
        if (filter_.is_cut(edge, end)) continue;
        const FaceSlot node = balls_.ball(row.f[end]);
        branch.lambda = std::max(branch.lambda, lambda_.value(node));
        branch.angle = std::max(branch.angle, angle_.value(node));
      }
    }
    branch.length = length.value();
    branch.radius_mean = branch.length > 0.0 ? area.value() / branch.length : branch.radius_least;
    branch.radius_mean = std::clamp(branch.radius_mean, branch.radius_least, branch.radius_largest);
  }

  const AxisFilter& filter_;
  const InnerBalls& balls_;
  const LambdaAxis& lambda_;
  const AngleAxis& angle_;
  const Delaunay& delaunay_;
  Table<EdgeSlot, std::uint8_t> is_done_;                 // or contracted
  std::unordered_map<FaceSlot, FaceSlot> first_of_;       // of nodes that are united: the one that stands for all
  std::unordered_map<FaceSlot, std::vector<Step>> ways_;  // from such nodes
  std::vector<AxisBranch> out_;
};

}  // namespace

namespace {

/// The point after the first one.
Vec2 second_place(const AxisFilter& filter, const AxisBranch& branch) {
  for (const EdgeSlot edge : branch.edges)
    for (const int end : {0, 1})
      if (const Vec2 place = filter.kept_end(edge, end); place != branch.from.place) return place;
  return branch.from.place;
}

}  // namespace

std::vector<AxisBranch> branches_of(const AxisFilter& filter, const InnerBalls& balls, const LambdaAxis& lambda,
                                    const AngleAxis& angle, double least) {
  std::vector<AxisBranch> out = Tracer(filter, balls, lambda, angle).run(least);
  std::ranges::sort(out, [&filter](const AxisBranch& a, const AxisBranch& b) {
    if (a.length != b.length) return a.length > b.length;
    if (a.from.place != b.from.place) return lexicographically_less(a.from.place, b.from.place);
    if (a.to.place != b.to.place) return lexicographically_less(a.to.place, b.to.place);
    if (a.radius_mean != b.radius_mean) return a.radius_mean < b.radius_mean;
    if (a.lambda != b.lambda) return a.lambda < b.lambda;
    if (a.angle != b.angle) return a.angle < b.angle;
    // Two ways around a symmetric hole.
    return lexicographically_less(second_place(filter, a), second_place(filter, b));
  });
  return out;
}

}  // namespace mes
