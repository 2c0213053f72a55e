// SPDX-License-Identifier: GPL-3.0-or-later
// Trees that can be linked and cut, with a query for the best edge on the path between two of their vertices.
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/base/slot.h"

namespace mes {

/// A forest on numbered vertices, whose edges are rows of a table. `Better(a, b)` says that edge `a` is better than
/// edge `b`, and is a strict order on the edges of one tree.
///
/// Smallest use:
///     LinkCutForest<EdgeSlot, std::less<>> forest({});
///     forest.clear(3, 2);
///     forest.link(EdgeSlot(0), 0, 1);
///     forest.link(EdgeSlot(1), 1, 2);
///     const EdgeSlot best = forest.best_between(0, 2);
///
/// Cost: O(log n) per call, amortised; 20 bytes per vertex and 20 per edge. Threads: none, not even two queries at
/// once. Source: Sleator and Tarjan, "Self-adjusting binary search trees", 1985: every tree is cut into paths, each of
/// which is a splay tree in the order of the path. Vertices and edges are its nodes.
template <class Edge, class Better>
class LinkCutForest {
 public:
  using Vertex = std::uint32_t;

  explicit LinkCutForest(Better better) : better_(std::move(better)) {}

  /// Forgets everything.
  void clear(std::size_t vertices, std::size_t edges) {
    nodes_[0].assign(vertices, {});
    nodes_[1].assign(edges, {});
  }
  /// Makes room; new rows are not linked.
  void grow(std::size_t vertices, std::size_t edges) {
    if (vertices > nodes_[0].size()) nodes_[0].resize(vertices);
    if (edges > nodes_[1].size()) nodes_[1].resize(edges);
  }

  /// Like `link`, for a `child` that is not linked to anything above it and never was: builds a tree from its root down
  /// in O(1) per edge.
  void hang(Edge edge, Vertex parent, Vertex child) {
    const Node e = node_of(edge);
    at(e).best = edge;
    at(e).parent = node_of_vertex(parent);
    at(node_of_vertex(child)).parent = e;
  }
  /// Joins two trees by an edge that is in neither.
  void link(Edge edge, Vertex a, Vertex b) {
    const Node e = node_of(edge);
    at(e) = {};
    at(e).best = edge;
    make_root(node_of_vertex(a));
    at(node_of_vertex(a)).parent = e;
    access(node_of_vertex(b));
    at(e).parent = node_of_vertex(b);
  }
  /// Removes an edge between these two.
  void cut(Edge edge, Vertex a, Vertex b) {
    const Node e = node_of(edge);
    make_root(e);
    for (const Vertex end : {a, b}) {
      // The path from the edge to its end consists of these two.
      const Node v = node_of_vertex(end);
      access(v);
      at(at(v).child[0]).parent = kNone;
      at(v).child[0] = kNone;
      pull(v);
    }
    at(e) = {};
  }
  bool are_connected(Vertex a, Vertex b) {
    if (a == b) return true;
    access(node_of_vertex(a));
    access(node_of_vertex(b));
    return at(node_of_vertex(a)).parent != kNone;
  }
  /// The best edge on the path between two different vertices of one tree.
  Edge best_between(Vertex a, Vertex b) {
    make_root(node_of_vertex(a));
    access(node_of_vertex(b));
    return at(node_of_vertex(b)).best;
  }
  /// Linking an edge again clears its mark.
  void set_mark(Edge edge, bool is_marked) {
    access(node_of(edge));
    at(node_of(edge)).is_marked = is_marked;
    pull(node_of(edge));
  }
  /// True if an odd number of edges is marked on the path between two vertices of one tree.
  bool are_marks_odd(Vertex a, Vertex b) {
    make_root(node_of_vertex(a));
    access(node_of_vertex(b));
    return at(node_of_vertex(b)).has_odd_marks;
  }
  /// Must be called when the edge has become better or worse.
  void refresh(Edge edge) { access(node_of(edge)); }

 private:
  // The last bit tells an edge from a vertex.
  using Node = std::uint32_t;
  static constexpr Node kNone = 0xffffffffU;
  static Node node_of_vertex(Vertex vertex) { return vertex << 1U; }
  static Node node_of(Edge edge) { return (edge.index() << 1U) | 1U; }

  struct Body {
    Node parent = kNone;  // in the splay tree, or above its path
    std::array<Node, 2> child{kNone, kNone};
    Edge best;  // best edge of the splay tree from here down
    bool is_reversed = false;
    bool is_marked = false;      // the edge itself
    bool has_odd_marks = false;  // for the splay tree from here down
  };
  Body& at(Node node) { return nodes_[node & 1U][node >> 1U]; }

  bool is_top(Node node) {
    const Node parent = at(node).parent;
    return parent == kNone || (at(parent).child[0] != node && at(parent).child[1] != node);
  }
  void push_down(Body& body) {
    if (!body.is_reversed) return;
    body.is_reversed = false;
    std::swap(body.child[0], body.child[1]);
    for (const Node child : body.child)
      if (child != kNone) at(child).is_reversed = !at(child).is_reversed;
  }
  void pull(Node node) {
    Body& body = at(node);
    Edge best = (node & 1U) != 0 ? Edge(node >> 1U) : Edge();
    body.has_odd_marks = body.is_marked;
    for (const Node child : body.child) {
      if (child == kNone) continue;
      body.has_odd_marks = body.has_odd_marks != at(child).has_odd_marks;
      const Edge of_child = at(child).best;
      if (of_child == kNoSlot) continue;
      if (best == kNoSlot || better_(of_child, best)) best = of_child;
    }
    body.best = best;
  }
  void rotate(Node node) {
    const Node up = at(node).parent;
    const Node above = at(up).parent;
    const unsigned side = at(up).child[1] == node ? 1 : 0;
    const Node inner = at(node).child[1 - side];
    if (!is_top(up)) at(above).child[at(above).child[1] == up ? 1 : 0] = node;
    at(node).parent = above;
    at(node).child[1 - side] = up;
    at(up).parent = node;
    at(up).child[side] = inner;
    if (inner != kNone) at(inner).parent = up;
    pull(up);
  }
  void splay(Node node) {
    path_.assign(1, node);
    for (Node up = node; !is_top(up);) {
      up = at(up).parent;
      path_.push_back(up);
    }
    for (std::size_t i = path_.size(); i-- > 0;) push_down(at(path_[i]));
    while (!is_top(node)) {
      const Node up = at(node).parent;
      if (!is_top(up)) {
        const Node above = at(up).parent;
        const bool same_side = (at(up).child[1] == node) == (at(above).child[1] == up);
        rotate(same_side ? up : node);
      }
      rotate(node);
    }
    pull(node);
  }
  // Makes the node the top of the path from the root of its tree to itself.
  void access(Node node) {
    Node below = kNone;
    for (Node up = node; up != kNone; up = at(up).parent) {
      splay(up);
      at(up).child[1] = below;
      pull(up);
      below = up;
    }
    splay(node);
  }
  void make_root(Node node) {
    access(node);
    at(node).is_reversed = !at(node).is_reversed;
    push_down(at(node));
  }

  Better better_;
  std::array<std::vector<Body>, 2> nodes_;  // vertices, edges
  std::vector<Node> path_;
};

}  // namespace mes
