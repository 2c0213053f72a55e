// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/filters/axis_filter.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <span>

#include "core/base/disjoint_sets.h"
#include "core/base/jobs/parallel.h"
#include "core/base/sum.h"

namespace mes {

AxisFilter::AxisFilter(std::string_view id, SettingsSource& settings, Delaunay& delaunay, OneStepCrust& crust,
                       Labels& labels, InnerBalls& balls, MedialAxis& axis, const Parameter& limit,
                       Structure* measure)
    : Structure(id, measure == nullptr
                        ? std::vector<Structure*>{&settings, &delaunay, &crust, &labels, &balls, &axis}
                        : std::vector<Structure*>{&settings, &delaunay, &crust, &labels, &balls, &axis, measure}),
      delaunay_(delaunay),
      crust_(crust),
      labels_(labels),
      balls_(balls),
      axis_(axis),
      settings_(settings),
      limit_(limit) {}

AxisFilter::Wish AxisFilter::wanted() const {
  const ComputationSettings& settings = settings_.current();
  return {settings[limit_], settings.is_on(Parameter::keep_topology), mode(settings)};
}

bool AxisFilter::is_removed(EdgeSlot edge) const {
  return is_edge(edge) && edge_flags_[edge] != kKept;
}

Vec2 AxisFilter::kept_end(EdgeSlot edge, int end) const {
  return is_cut(edge, end) ? cut_place(edge, end) : delaunay_.circumcenter(delaunay_.edge(edge).f[end]);
}

bool AxisFilter::removed_piece(AxisEndSlot row, Vec2& a, Vec2& b) const {
  const EdgeSlot edge(row.index() / 2);
  const auto end = static_cast<int>(row.index() % 2);
  if (!is_removed(edge)) return false;
  a = delaunay_.circumcenter(delaunay_.edge(edge).f[end]);
  if (!is_kept(edge)) {
    b = delaunay_.circumcenter(delaunay_.edge(edge).f[1 - end]);
    return end == 0;
  }
  if (!is_cut(edge, end)) return false;
  b = cut_place(edge, end);
  return true;
}

std::uint8_t AxisFilter::flags_of(EdgeSlot edge) const {
  if (!is_edge(edge)) return 0;
  if (wish_.keeps_topology) {
    const EdgeSlot level = pruning_.level_of(edge);
    return level == kNoSlot || reaches(level) ? kKept : 0;
  }
  return flags_where(reached(edge));
}

std::uint8_t AxisFilter::flags_where(const Reached& at) {
  if (!at.anywhere) return 0;
  return static_cast<std::uint8_t>(kKept | (at.at_end[0] ? 0U : kCut[0]) | (at.at_end[1] ? 0U : kCut[1]));
}

int AxisFilter::kept_edges_at(FaceSlot node) const {
  int count = 0;
  for_each_face_of(node, [&](FaceSlot face) {
    for (const EdgeSlot edge : delaunay_.face(face).e) count += edge != kNoSlot && is_kept(edge) ? 1 : 0;
  });
  return count;
}

// Every leaf that the limit leaves reaches it somewhere, since the leaf of the least value is the next to go.
void AxisFilter::cut_free_ends(EdgeSlot edge) {
  if (!is_kept(edge)) return;
  const Reached at = reached(edge);
  for (int end = 0; end < 2; ++end)
    if (!at.at_end[end] && kept_edges_at(balls_.ball(delaunay_.edge(edge).f[end])) == 1)
      edge_flags_[edge] = static_cast<std::uint8_t>(edge_flags_[edge] | kCut[end]);
}

std::uint8_t AxisFilter::flags_of(FaceSlot node) const {
  if (!delaunay_.face(node).is_alive() || !axis_.is_node(node)) return 0;
  bool is_end = false;
  bool has_kept = false;
  for_each_face_of(node, [&](FaceSlot face) {
    for (const EdgeSlot edge : delaunay_.face(face).e) {
      if (edge == kNoSlot || !is_kept(edge)) continue;
      has_kept = true;
      // Most edges are whole, and finding which of its ends this is costs a cache miss.
      is_end = is_end || !is_cut(edge) || !is_cut(edge, delaunay_.edge(edge).f[0] == face ? 0 : 1);
    }
  });
  if (is_end) return kKept;
  const bool stays =
      wish_.keeps_topology ? !has_kept && (pruning_.is_root(node) || pruning_.degree(node) == 0) : node_reaches(node);
  return stays ? kKept | kIsolated : 0;
}

void AxisFilter::prune(JobControl& job) {
  if (!wish_.keeps_topology) {
    pruning_.clear();
    return;
  }
  struct Ranked {
    double value;
    EdgeSlot edge;
  };
  std::vector<Ranked> order;
  for (const EdgeSlot edge : delaunay_.edge_slots())
    if (is_edge(edge)) order.push_back({0.0, edge});
  parallel_for(order.size(), [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t i = begin; i < end; ++i) order[i].value = value(order[i].edge);
  });
  job.checkpoint();
  // Nearly equal values are compared exactly, and equal ones by position, so that row numbers leave no trace.
  const auto place = [this](EdgeSlot edge) {
    const EdgeRow& row = delaunay_.edge(edge);
    const Vec2 a = delaunay_.site_position(row.v[0]);
    const Vec2 b = delaunay_.site_position(row.v[1]);
    return lexicographically_less(a, b) ? std::pair(a, b) : std::pair(b, a);
  };
  std::ranges::sort(order, [&](const Ranked& a, const Ranked& b) {
    if (std::abs(a.value - b.value) > 0x1p-48 * std::max(a.value, b.value)) return a.value < b.value;
    if (a.edge == b.edge) return false;
    if (const int sign = compare(a.edge, b.edge); sign != 0) return sign < 0;
    const auto at = place(a.edge);
    const auto other = place(b.edge);
    return at.first == other.first ? lexicographically_less(at.second, other.second)
                                   : lexicographically_less(at.first, other.first);
  });
  job.checkpoint();
  pruning_.begin(delaunay_.edge_rows(), delaunay_.face_rows());
  for (const Ranked& ranked : order) {
    const EdgeRow& row = delaunay_.edge(ranked.edge);
    pruning_.add(ranked.edge, balls_.ball(row.f[0]), balls_.ball(row.f[1]));
  }
  pruning_.run([this](FaceSlot a, FaceSlot b) {
    const double at_a = value(a);
    const double at_b = value(b);
    if (at_a != at_b) return at_a > at_b;
    const double size_a = delaunay_.circumradius(a);
    const double size_b = delaunay_.circumradius(b);
    if (size_a != size_b) return size_a > size_b;
    return lexicographically_less(delaunay_.circumcenter(a), delaunay_.circumcenter(b));
  });
}

void AxisFilter::reached_each(std::span<const EdgeSlot> edges, std::span<Reached> out) const {
  for (std::size_t i = 0; i < edges.size(); ++i) out[i] = reached(edges[i]);
}

// Decides a run of rows of a raw filter. Nodes at which a kept edge ends are kept; several edges, also of other
// threads, may mark the same node.
void AxisFilter::decide_edges(std::size_t begin, std::size_t end) {
  constexpr std::size_t kBatch = 512;
  std::array<EdgeSlot, kBatch> edges;
  std::array<Reached, kBatch> at;
  for (; begin < end; begin += kBatch) {
    std::size_t count = 0;
    for (const EdgeSlot edge : slots_between<EdgeSlot>(begin, std::min(begin + kBatch, end))) {
      edges[count] = edge;
      count += is_edge(edge) ? 1U : 0U;
    }
    reached_each(std::span(edges).first(count), std::span(at).first(count));
    for (std::size_t i = 0; i < count; ++i) {
      if (!at[i].anywhere) continue;
      edge_flags_[edges[i]] = flags_where(at[i]);
      for (int side = 0; side < 2; ++side)
        if (at[i].at_end[side])
          std::atomic_ref(node_flags_[balls_.ball(delaunay_.edge(edges[i]).f[side])])
              .store(kKept, std::memory_order_relaxed);
    }
  }
}

// Decides the nodes at which no kept edge ends, after all edges have been decided.
void AxisFilter::decide_nodes(std::size_t begin, std::size_t end) {
  constexpr std::size_t kBatch = 512;
  std::array<FaceSlot, kBatch> nodes;
  for (; begin < end; begin += kBatch) {
    std::size_t count = 0;
    for (const FaceSlot node : slots_between<FaceSlot>(begin, std::min(begin + kBatch, end))) {
      nodes[count] = node;
      count += (node_flags_[node] == 0) & labels_.is_inside(node) ? 1U : 0U;
    }
    constexpr std::size_t kAhead = 8;
    for (std::size_t i = 0; i < count; ++i) {
      if (i + kAhead < count) prefetch(delaunay_.faces().address(nodes[i + kAhead]));
      if (axis_.is_node(nodes[i]) && node_reaches(nodes[i])) node_flags_[nodes[i]] = kKept | kIsolated;
    }
  }
}

void AxisFilter::refresh_everything() {
  edge_flags_.assign(delaunay_.edge_rows(), 0);
  node_flags_.assign(delaunay_.face_rows(), 0);
  const auto for_all_edges = [this](auto decide) {
    parallel_for(edge_flags_.size(), [&](std::size_t begin, std::size_t end, std::size_t) { decide(begin, end); });
  };
  const auto for_all_nodes = [this](auto decide) {
    parallel_for(node_flags_.size(), [&](std::size_t begin, std::size_t end, std::size_t) { decide(begin, end); });
  };
  if (wish_.keeps_topology) {
    for_all_edges([this](std::size_t begin, std::size_t end) {
      for (const EdgeSlot edge : slots_between<EdgeSlot>(begin, end)) edge_flags_[edge] = flags_of(edge);
    });
    // The mark of one cut does not affect another one.
    for (const EdgeSlot edge : edge_flags_.rows()) cut_free_ends(edge);
    for_all_nodes([this](std::size_t begin, std::size_t end) {
      for (const FaceSlot node : slots_between<FaceSlot>(begin, end)) node_flags_[node] = flags_of(node);
    });
    return;
  }
  begin_all();
  for_all_edges([this](std::size_t begin, std::size_t end) { decide_edges(begin, end); });
  for_all_nodes([this](std::size_t begin, std::size_t end) { decide_nodes(begin, end); });
  end_all();
}

void AxisFilter::rebuild(JobControl& job) {
  clear_changes();
  wish_ = wanted();
  take(wish_);
  prune(job);
  refresh_everything();
}

// Notes rows whose values may differ, whatever the limit is.
void AxisFilter::note_inputs() {
  edge_recorder_.begin(delaunay_.edge_rows());
  node_recorder_.begin(delaunay_.face_rows());
  for (const EdgeSlot edge : labels_.edge_changes().removed) edge_recorder_.note(edge, true);
  for (const EdgeSlot edge : labels_.edge_changes().touched) {
    edge_recorder_.note(edge, true);
    for (const FaceSlot face : delaunay_.edge(edge).f)
      if (face != kNoSlot) node_recorder_.note(balls_.ball(face), true);
  }
  for (const FaceSlot face : balls_.changes().removed) node_recorder_.note(face, true);
  for (const FaceSlot face : balls_.changes().touched) {
    node_recorder_.note(face, true);
    node_recorder_.note(balls_.ball(face), true);
  }
}

void AxisFilter::finish_changes() {
  edge_recorder_.finish(edge_changes_, [this](EdgeSlot edge) { return delaunay_.edge(edge).is_alive(); });
  node_recorder_.finish(node_changes_, [this](FaceSlot face) { return delaunay_.face(face).is_alive(); });
  removed_changes_.clear();
  for (const auto& [from, to] : {std::pair(&edge_changes_.touched, &removed_changes_.touched),
                                 std::pair(&edge_changes_.removed, &removed_changes_.removed)})
    for (const EdgeSlot edge : *from)
      for (const std::size_t end : {0U, 1U}) to->push_back(AxisEndSlot(2 * std::size_t{edge.index()} + end));
}

bool AxisFilter::update(JobControl& job) {
  const Wish before = wish_;
  wish_ = wanted();
  if (wish_.mode != before.mode) return false;
  if (wish_ != before) take(wish_);
  const bool axis_changed = !labels_.edge_changes().is_empty() || !balls_.changes().is_empty();
  if (!axis_changed && wish_ == before) {
    clear_changes();
    return true;
  }
  note_inputs();
  edge_flags_.resize(delaunay_.edge_rows());
  node_flags_.resize(delaunay_.face_rows());
  if (!wish_.keeps_topology && wish_ == before) {
    finish_changes();
    for (const auto* edges : {&edge_changes_.removed, &edge_changes_.touched})
      for (const EdgeSlot edge : *edges) edge_flags_[edge] = flags_of(edge);
    for (const auto* nodes : {&node_changes_.removed, &node_changes_.touched})
      for (const FaceSlot node : *nodes) node_flags_[node] = flags_of(node);
    return true;
  }
  const Table<EdgeSlot, std::uint8_t> edges_before = edge_flags_;
  const Table<FaceSlot, std::uint8_t> nodes_before = node_flags_;
  if (axis_changed || wish_.keeps_topology != before.keeps_topology) prune(job);
  refresh_everything();
  // Another limit moves the cuts.
  const auto may_differ = [&](EdgeSlot edge) {
    return edge_flags_[edge] != edges_before[edge] ||
           (wish_.limit != before.limit && (edge_flags_[edge] & (kCut[0] | kCut[1])) != 0);
  };
  for (const EdgeSlot edge : edge_flags_.rows())
    if (may_differ(edge)) edge_recorder_.note(edge, true);
  for (const FaceSlot node : node_flags_.rows())
    if (node_flags_[node] != nodes_before[node]) node_recorder_.note(node, true);
  finish_changes();
  return true;
}

void AxisFilter::clear_changes() {
  edge_changes_.clear();
  node_changes_.clear();
  removed_changes_.clear();
}

StatList AxisFilter::statistics() const {
  DisjointSets<FaceSlot> joined(delaunay_.face_rows());
  Table<FaceSlot, std::uint32_t> degree(delaunay_.face_rows(), 0);
  std::int64_t edges = 0;
  std::int64_t cuts = 0;
  std::int64_t joins = 0;
  Sum kept;
  Sum whole;
  for (const EdgeSlot edge : delaunay_.edge_slots()) {
    if (!is_edge(edge)) continue;
    const double length = delaunay_.dual_length(edge);
    whole.add(length);
    if (!is_kept(edge)) continue;
    ++edges;
    const bool is_whole = !is_cut(edge, 0) && !is_cut(edge, 1);
    kept.add(is_whole ? length : distance(kept_end(edge, 0), kept_end(edge, 1)));
    FaceSlot ends[2]{};
    for (int end = 0; end < 2; ++end) {
      if (is_cut(edge, end)) {
        ++cuts;
        continue;
      }
      ends[end] = balls_.ball(delaunay_.edge(edge).f[end]);
      ++degree[ends[end]];
    }
    if (ends[0] == kNoSlot || ends[1] == kNoSlot) continue;
    const FaceSlot a = joined.root(ends[0]);
    const FaceSlot b = joined.root(ends[1]);
    if (a == b) continue;
    joined.join(a, b);
    ++joins;
  }
  // A cut is an end of its own. An edge that is cut at both ends is a component without a node.
  std::int64_t nodes = 0;
  std::int64_t isolated = 0;
  std::int64_t leaves = cuts;
  std::int64_t branch_points = 0;
  for (const FaceSlot node : node_flags_.rows()) {
    if (!is_kept(node)) continue;
    ++nodes;
    isolated += (node_flags_[node] & kIsolated) != 0 ? 1 : 0;
    leaves += degree[node] == 1 ? 1 : 0;
    branch_points += degree[node] >= 3 ? 1 : 0;
  }
  std::int64_t floating = 0;
  for (const EdgeSlot edge : edge_flags_.rows()) floating += is_cut(edge, 0) && is_cut(edge, 1) ? 1 : 0;
  const std::int64_t components = nodes - joins + floating;
  StatList out{{"limit", wish_.limit},
               {"keeps_topology", std::int64_t{wish_.keeps_topology ? 1 : 0}},
               {"nodes", nodes},
               {"edges", edges},
               {"cut_ends", cuts},
               {"components", components},
               {"cycles", edges - (nodes + cuts) + components},
               {"leaves", leaves},
               {"branch_points", branch_points},
               {"isolated", isolated},
               {"length", kept.value()},
               {"removed_length", std::max(0.0, whole.value() - kept.value())}};
  add_statistics(out);
  if (const std::string why = reason(); !why.empty()) out.push_back({"nothing_because", why});
  return out;
}

std::string AxisFilter::reason() const {
  if (delaunay_.dimension() < 2) return "fewer than three samples, or all of them on a line: there is no axis";
  bool has_nodes = false;
  for (const FaceSlot node : delaunay_.face_slots()) {
    if (!delaunay_.face(node).is_alive() || !axis_.is_node(node)) continue;
    if (is_kept(node)) return {};
    has_nodes = true;
  }
  return has_nodes ? "the limit is above every value" : "no triangle is inside: there is no axis";
}

}  // namespace mes
