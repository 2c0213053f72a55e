// SPDX-License-Identifier: GPL-3.0-or-later
// A workbench that shows every layer and is checked after each edit.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <memory>
#include <set>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "core/builtins/builtins.h"
#include "core/workbench/workbench.h"
#include "tests/support/layer_contents.h"
#include "tests/support/state_of_graph.h"

namespace mes::test {

/// Every layer of the registry.
std::vector<LayerIndex> all_layers();

/// Guarantees: after each edit the graph has run completely, every structure and layer is up to date, and both
/// a plain buffer and a `LayerMirror`, which refuse malformed patches, have taken the patch; otherwise the test fails.
///
/// Smallest use:
///     TestBench bench(points);
///     bench.insert({{1.0, 2.0}});
///     CHECK(bench.count("one-step-crust", "crust_edges") == 12);
class TestBench {
 public:
  TestBench();
  explicit TestBench(const std::vector<Vec2>& positions);

  /// Shows only these layers from now on.
  void show(std::initializer_list<std::string_view> layers);
  void show(std::span<const LayerIndex> layers);
  void choose(const ComputationSettings& settings);
  void replace(const std::vector<Vec2>& positions);
  void insert(const std::vector<Vec2>& positions);
  void remove(const std::vector<SampleId>& ids);
  void move(SampleId id, Vec2 to) { move(std::vector{std::pair{id, to}}); }
  void move(const std::vector<std::pair<SampleId, Vec2>>& targets);
  /// Replaces the document: these samples and balls, all new.
  void load(const SampleData& data);
  void insert_balls(const std::vector<Disk>& disks);
  void remove_balls(const std::vector<BallId>& ids);
  void change_ball(BallId id, const Disk& to);
  void undo();
  void redo();
  std::size_t steps_done() const { return bench_.history().position(); }

  const Document& document() const { return bench_.document(); }
  const Graph& graph() const { return bench_.graph(); }
  const FramePatch& patch() const { return bench_.patch(); }
  const LayerContents& contents() const { return contents_; }
  const LayerMirror& mirror() const { return bench_.mirror(); }
  GeometryState state() const { return state_of(graph()); }
  template <class T>
  const T& get() const {
    return bench_.get<T>();
  }

  /// Live ids by increasing age.
  std::vector<SampleId> ids() const;
  std::vector<Vec2> positions() const;
  std::vector<BallId> ball_ids() const;
  std::vector<Disk> balls() const;

  /// A counter, or a measure, from the statistics.
  std::int64_t count(std::string_view structure, std::string_view key) const;
  double measure(std::string_view structure, std::string_view key) const;
  /// Instances of a layer, `stride_of(kind)` doubles each.
  std::span<const double> instances(std::string_view layer, PrimitiveKind kind) const;

  /// The elements at a point in the layers, top first; up to `reach` away.
  Provenance ask(Vec2 at, double reach, const std::vector<std::string_view>& layers);
  /// Asks any question; sets its ticket.
  Provenance ask(ProvenanceQuestion question);

  /// Empty if the rows are sound and everything equals a fresh graph of the same samples and balls, given in reverse
  /// order; otherwise the first difference.
  std::string trouble() const;

 private:
  void edit(const Expected<void>& done);
  void run();
  void check(const Expected<void>& done);

  Workbench bench_{builtins()};
  LayerContents contents_;
};

/// A bench for the results in `state` and the drawn axis. It has no unions of balls: in exact arithmetic they take most
/// of the time, and other tests compare them.
struct ComparedBench : TestBench {
  ComparedBench();
  explicit ComparedBench(const std::vector<Vec2>& positions);
};

/// A crust edge by the positions of its ends, the lexicographically smaller one first.
using PlaceEdge = std::pair<std::pair<double, double>, std::pair<double, double>>;
PlaceEdge place_edge(Vec2 a, Vec2 b);
std::set<PlaceEdge> crust_edges(const Graph& graph);

}  // namespace mes::test
