// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/axis_picture.h"

#include <algorithm>
#include <numeric>

#include "core/draw/primitives.h"

namespace mes::test {
namespace {

class Groups {
 public:
  explicit Groups(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), std::size_t{0}); }
  std::size_t of(std::size_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  /// Joins two sets; true if they were different.
  bool join(std::size_t a, std::size_t b) {
    a = of(a);
    b = of(b);
    parent_[a] = b;
    return a != b;
  }

 private:
  std::vector<std::size_t> parent_;
};

}  // namespace

std::vector<Vec2> AxisPicture::with_degree(std::size_t degree) const {
  std::vector<Vec2> out;
  for (const Node& node : nodes)
    if (std::min<std::size_t>(node.degree, 3) == degree) out.push_back(node.position);
  return out;
}

AxisPicture axis_picture(std::span<const double> segments, double merge_distance) {
  constexpr std::size_t kStride = stride_of(PrimitiveKind::segment);
  AxisPicture out;
  std::vector<Vec2> ends;
  for (std::size_t at = 0; at < segments.size(); at += kStride) {
    ends.push_back({segments[at], segments[at + 1]});
    ends.push_back({segments[at + 2], segments[at + 3]});
    out.length += distance(ends[ends.size() - 2], ends.back());
  }
  // Sorted by x, so that near ends are near in this order, too.
  std::vector<std::size_t> order(ends.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::sort(order, {}, [&](std::size_t i) { return ends[i].x; });
  Groups clusters(ends.size());
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t j = i + 1; j < order.size() && ends[order[j]].x - ends[order[i]].x <= merge_distance; ++j)
      if (distance(ends[order[i]], ends[order[j]]) <= merge_distance) clusters.join(order[i], order[j]);

  std::vector<std::size_t> node_of(ends.size());
  for (std::size_t i = 0; i < ends.size(); ++i) {
    if (clusters.of(i) != i) continue;
    node_of[i] = out.nodes.size();
    out.nodes.push_back({ends[i], 0});
  }
  Groups parts(out.nodes.size());
  out.components = out.nodes.size();
  for (std::size_t i = 0; i < ends.size(); i += 2) {
    const std::size_t a = node_of[clusters.of(i)];
    const std::size_t b = node_of[clusters.of(i + 1)];
    if (a == b) continue;
    ++out.edges;
    ++out.nodes[a].degree;
    ++out.nodes[b].degree;
    if (parts.join(a, b)) --out.components;
  }
  return out;
}

}  // namespace mes::test
