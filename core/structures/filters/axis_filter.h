// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the one-step axis on which a measure reaches a limit: the common base of lambda and object angle.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/base/change_set.h"
#include "core/structures/axis/medial_axis.h"
#include "core/structures/filters/axis_pruning.h"
#include "core/structures/inputs/settings_source.h"

namespace mes {

/// A piece at one end of an axis edge: row 2 e + i at the end `EdgeRow::f[i]` of edge e.
using AxisEndSlot = Slot<struct AxisEndTag>;

/// Guarantees:
///  1. *Raw* (parameter `keep-topology` off): an edge of positive length is kept if its measure reaches the limit, a
///     node if its own does or if a kept edge ends at it. So the kept part is closed.
///  2. *Topology preserving*: of the edges outside the raw part, only those that can be pruned from the ends inwards
///     are removed (axis_pruning.h). Every limit leaves as many components and cycles as the whole axis has.
///  3. A measure that varies along an edge may *cut* it: the edge is kept up to a point between its ends. Where the
///     topology is preserved only free ends are cut.
///  4. Values are finite doubles, for all inputs. Each filter defines how it decides that a value reaches the limit.
///
/// Rows are those of the Delaunay edges and faces. Cost: rebuild O(n), an edit O(changed rows) where raw; O(n log n)
/// each where the topology is preserved. A change of the limit alone is O(n) and reports which rows differ.
class AxisFilter : public Structure {
 public:
  const Delaunay& delaunay() const { return delaunay_; }

  bool is_kept(EdgeSlot edge) const { return (edge_flags_[edge] & kKept) != 0; }
  /// True if a kept edge ends before its end `EdgeRow::f[end]`.
  bool is_cut(EdgeSlot edge, int end) const { return (edge_flags_[edge] & kCut[end]) != 0; }
  /// True for an edge of the axis of which some part is missing.
  bool is_removed(EdgeSlot edge) const;
  /// True if the node, which is a face of `MedialAxis::is_node`, is kept.
  bool is_kept(FaceSlot node) const { return node_flags_[node] != 0; }
  /// The end of the kept part of a kept edge: the node, or the cut.
  Vec2 kept_end(EdgeSlot edge, int end) const;
  /// True if that row has a removed piece; `a` and `b` are then its ends.
  bool removed_piece(AxisEndSlot row, Vec2& a, Vec2& b) const;

  /// Value of an edge of the axis: the largest on it, except for an angle that is a mean.
  virtual double value(EdgeSlot edge) const = 0;
  /// Value of a node of the axis.
  virtual double value(FaceSlot node) const = 0;
  /// The value in words, e.g. "object angle 31.2 degrees".
  virtual std::string spoken(double value) const = 0;
  /// The name of the measure as the name of a column, in snake case.
  virtual std::string_view measure() const = 0;

  const ChangeSet<EdgeSlot>& edge_changes() const { return edge_changes_; }
  const ChangeSet<FaceSlot>& node_changes() const { return node_changes_; }
  const ChangeSet<AxisEndSlot>& removed_changes() const { return removed_changes_; }

  void rebuild(JobControl& job) override;
  bool update(JobControl& job) override;
  void clear_changes() override;
  std::size_t touched() const override { return edge_changes_.size() + node_changes_.size(); }
  std::vector<std::string_view> parameters() const override { return {limit_.id, Parameter::keep_topology.id}; }
  StatList statistics() const override;
  std::vector<TableColumns> table_columns() const override;
  void explain(ElementKind kind, RowNumber row, Explanation& out) const override;
  /// The reason why nothing is kept, as one sentence without a full stop; empty if something is.
  std::string reason() const;

 protected:
  /// The settings that the filter uses.
  struct Wish {
    double limit = 0.0;
    bool keeps_topology = false;
    int mode = 0;  ///< mode of the measure; another mode is another measure
    friend bool operator==(const Wish&, const Wish&) = default;
  };

  /// `measure`: a further structure that values are taken from.
  AxisFilter(std::string_view id, SettingsSource& settings, Delaunay& delaunay, OneStepCrust& crust, Labels& labels,
             InnerBalls& balls, MedialAxis& axis, const Parameter& limit, Structure* measure = nullptr);

  const Wish& wish() const { return wish_; }
  virtual int mode(const ComputationSettings&) const { return 0; }
  /// Called when there is a new wish, before anything is decided by it.
  virtual void take(const Wish&) {}
  /// True if the value of an edge reaches the limit.
  virtual bool reaches(EdgeSlot edge) const = 0;
  /// The parts of an edge where the value reaches the limit.
  struct Reached {
    bool anywhere = false;
    bool at_end[2] = {true, true};  ///< for an edge that reaches it anywhere
  };
  virtual Reached reached(EdgeSlot edge) const { return {reaches(edge), {true, true}}; }
  /// The same for many edges of the axis, written to `out`. Where all edges and nodes are decided, `begin_all` is
  /// called before and `end_all` after, so that work that several of them share can be done once.
  virtual void reached_each(std::span<const EdgeSlot> edges, std::span<Reached> out) const;
  virtual void begin_all() {}
  virtual void end_all() {}
  /// The point of the edge where the value begins to reach the limit.
  virtual Vec2 cut_place(EdgeSlot, int /*end*/) const { return {}; }
  /// True if the node's own value reaches the limit, whatever the edges do.
  virtual bool node_reaches(FaceSlot node) const = 0;
  /// Order of the values of two edges: -1, 0 or 1.
  virtual int compare(EdgeSlot a, EdgeSlot b) const = 0;
  /// Adds further counters, about all values.
  virtual void add_statistics(StatList& out) const = 0;

  bool is_edge(EdgeSlot edge) const {
    // Axis edges follow no pattern among the rows, so no branch depends on it.
    return delaunay_.edge(edge).is_alive() && (axis_.is_axis_edge(edge) & !axis_.is_zero_length(edge));
  }
  template <class Visit>
  void for_each_face_of(FaceSlot node, Visit visit) const;

  Delaunay& delaunay_;
  OneStepCrust& crust_;
  Labels& labels_;
  InnerBalls& balls_;
  MedialAxis& axis_;

 private:
  static constexpr std::uint8_t kKept = 1;
  static constexpr std::uint8_t kCut[2] = {2, 4};
  static constexpr std::uint8_t kIsolated = 2;  // the node is kept, and no kept edge ends there

  bool is_cut(EdgeSlot edge) const { return (edge_flags_[edge] & (kCut[0] | kCut[1])) != 0; }
  Wish wanted() const;
  void prune(JobControl& job);
  static std::uint8_t flags_where(const Reached& at);
  std::uint8_t flags_of(EdgeSlot edge) const;
  void cut_free_ends(EdgeSlot edge);
  std::uint8_t flags_of(FaceSlot face) const;
  int kept_edges_at(FaceSlot node) const;
  void note(EdgeSlot edge, bool was_alive);
  void note_inputs();
  void refresh_everything();
  void decide_edges(std::size_t begin, std::size_t end);
  void decide_nodes(std::size_t begin, std::size_t end);
  void finish_changes();

  SettingsSource& settings_;
  Parameter limit_;
  Wish wish_;
  AxisPruning pruning_;
  Table<EdgeSlot, std::uint8_t> edge_flags_;
  Table<FaceSlot, std::uint8_t> node_flags_;
  ChangeRecorder<EdgeSlot> edge_recorder_;
  ChangeRecorder<FaceSlot> node_recorder_;
  ChangeSet<EdgeSlot> edge_changes_;
  ChangeSet<FaceSlot> node_changes_;
  ChangeSet<AxisEndSlot> removed_changes_;
};

template <class Visit>
void AxisFilter::for_each_face_of(FaceSlot node, Visit visit) const {
  if (const auto* group = balls_.group(node)) {
    for (const FaceSlot face : *group) visit(face);
  } else {
    visit(node);
  }
}

}  // namespace mes
