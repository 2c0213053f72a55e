// SPDX-License-Identifier: GPL-3.0-or-later
// The density of the samples: their distance to the axis against the distance of their neighbours.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "core/base/change_set.h"
#include "core/base/geometry/box_tree.h"
#include "core/base/geometry/sampling_epsilon.h"
#include "core/base/max_tree.h"
#include "core/graph/structure.h"
#include "core/structures/crust/one_step_crust.h"
#include "core/structures/density/axis_line.h"
#include "core/structures/density/curve_sampling.h"

namespace mes {

/// The limit of dense samples: with this epsilon, the tests' smooth shapes have the axis that the theorem promises.
inline constexpr double kDenseEpsilon = 0.25;

/// The local feature size of a point of a curve is its distance to the medial axis on both sides; samples are an
/// epsilon-sample if every point of the curve has one within epsilon times its feature size. Neither curve nor axis is
/// known, so both are estimated from the samples: the axis by the Voronoi edges of Delaunay edges that are not crust
/// (layer `all-medial-axis`), the curve by the crust. Where samples are dense the estimate is near the truth; elsewhere
/// the crust skips details that it does not see, and the estimate may be too good.
///
/// Guarantees:
///  1. `size(site)` is the distance to the nearest point of that axis: all of its edges, including rays and lines.
///  2. `epsilon(edge)` of a crust edge is half its length over the smaller size of its ends. The largest of all is the
///     epsilon that the samples achieve by this estimate.
///  3. At corners the ratio stays the same however short edges become, and where the curve ends or meets itself the
///     estimate says nothing. These sites are *exempt*: edges that end there do not count for the overall epsilon.
///  4. Where the curves of the samples are known, the overall epsilon is computed from them (CurveSampling), and no
///     note gives a second one.
///  5. All values are finite and above 0. Without an axis there are no values.
///
/// A corner is a sample at which the crust turns by more than two limits: twice the arc sine of `kDenseEpsilon`, which
/// half an edge over the distance to the axis reaches beside a corner however short the edge is, and four times the
/// turns at its two neighbours together, which a smooth curve with too few samples does not exceed.
///
/// Rows are those of the Delaunay sites and edges. Cost: rebuild O(n log n) typically, by walks along the curve
/// (cell_walk.h) or in a tree of all edges; an update O(changed edges times the rows that their search visits).
/// Source: Amenta, Bern and Eppstein, "The crust and the beta-skeleton", 1998.
class FeatureSize final : public Structure {
 public:
  FeatureSize(Delaunay& delaunay, OneStepCrust& crust);
  FeatureSize(Delaunay& delaunay, OneStepCrust& crust, CurveSampling& curves);

  /// True if the axis has an edge.
  bool has_axis() const { return line_count_ != 0; }
  /// The reason why there is no axis, as a sentence without a full stop; empty if there is one.
  std::string_view reason() const;
  bool has_size(SiteSlot site) const { return nearest_.has(site) && nearest_[site] != kNoSlot; }
  double size(SiteSlot site) const { return std::sqrt(squared_[site]) / unit_; }
  /// True if the crust edge has an epsilon, that is, if both its ends have a size.
  bool has_epsilon(EdgeSlot edge) const;
  double epsilon(EdgeSlot edge) const;
  /// True if the sample is exempt: a corner, or an end or junction of the crust. O(edges at it and its neighbours).
  bool is_exempt(SiteSlot site) const { return exemption_of(site) != Exemption::none; }
  /// The epsilon of these samples by this estimate, with the numbers of exempt samples at which curve edges end;
  /// nothing if no edge counts. Cost: as `sparsest_edge`.
  std::optional<SamplingEpsilon> estimated_epsilon() const;
  /// The edge with the largest epsilon among those that end at no exempt sample; ties go to the first by the positions
  /// of its ends; kNoSlot if none has one. O(1) once updates have begun, O(edges) before.
  EdgeSlot sparsest_edge() const;

  /// Sites that were added, moved or removed, or whose size differs from before.
  const ChangeSet<SiteSlot>& site_changes() const { return site_changes_; }
  /// Crust edges that changed or whose epsilon may differ, and other edges that changed.
  const ChangeSet<EdgeSlot>& edge_changes() const { return edge_changes_; }

  void rebuild(JobControl& job) override;
  bool update(JobControl& job) override;
  void get_ready_to_update(JobControl& job) override;
  void clear_changes() override;
  std::size_t touched() const override { return site_changes_.size() + edge_changes_.size(); }
  StatList statistics() const override;
  std::vector<TableColumns> table_columns() const override;
  void find(std::vector<Finding>& out) const override;

 private:
  struct Found {
    double squared = std::numeric_limits<double>::infinity();
    EdgeSlot edge{};
  };

  FeatureSize(Delaunay& delaunay, OneStepCrust& crust, std::vector<Structure*> inputs, const CurveSampling* curves);
  enum class Exemption : std::uint8_t { none, corner, end, junction, alone };
  /// How many samples have each exemption.
  using Exempt = std::array<std::size_t, 5>;
  Exemption exemption_of(SiteSlot site) const;
  Exempt count_exempt() const;
  double epsilon_or_none(EdgeSlot edge) const;
  bool ends_at_exempt(EdgeSlot edge) const;
  std::array<SiteSlot, 2> crust_neighbours(SiteSlot site) const;
  double turn_at(SiteSlot site) const;
  std::vector<EdgeSlot> edges_to_count_anew();
  void set_exemption(SiteSlot site, Exemption now);
  bool is_first(EdgeSlot a, EdgeSlot b) const;
  bool is_axis(EdgeSlot edge) const { return delaunay_.edge(edge).is_alive() && !crust_.is_crust(edge); }
  Vec2 place_of(SiteSlot site) const {
    const Vec2 at = delaunay_.site_position(site);
    return {at.x * unit_, at.y * unit_};
  }
  bool fits(SiteSlot site) const;
  void choose_unit();
  std::vector<AxisLine> all_lines() const;
  /// The nearest edge, or `best` if none is nearer than that.
  Found search(Vec2 p, Found best) const;
  void search_in_groups(std::span<const SiteSlot> sites);
  void attach(SiteSlot site, const Found& found);
  void detach(SiteSlot site);
  void search_anew(SiteSlot site);
  void add_line(const AxisLine& line);
  void remove_line(EdgeSlot edge);
  void make_line_tree(std::span<const AxisLine> lines);
  void add_ball(SiteSlot site);
  void remove_ball(SiteSlot site);
  void make_ball_tree();
  void shrink_balls_at(const AxisLine& line);
  void queue_search(SiteSlot site) {
    if (to_search_.insert(site)) searches_.push_back(site);
  }
  void finish_changes();

  static constexpr std::uint32_t kNowhere = 0xffffffffU;

  Delaunay& delaunay_;
  OneStepCrust& crust_;
  const CurveSampling* curves_;      ///< may be null
  double unit_ = 1.0;                ///< a power of two: squares of coordinates times it are normal doubles
  int exponent_ = 0;                 ///< exponent of the largest coordinate when it was chosen
  Table<SiteSlot, double> squared_;  ///< squared size in scaled units; infinite without one
  Table<SiteSlot, EdgeSlot> nearest_;
  std::size_t line_count_ = 0;
  BoxTree<AxisLine> lines_;                 ///< for updates and for searches in the tree; else empty
  Table<EdgeSlot, std::uint32_t> line_at_;  ///< index of the edge in the tree

  // Needed by updates alone. The sites with one nearest edge form a list through the table of sites:
  bool is_ready_ = false;
  Table<EdgeSlot, SiteSlot> first_site_;
  struct Links {
    SiteSlot before{};
    SiteSlot after{};
  };
  Table<SiteSlot, Links> links_;
  /// Disks about sites up to their nearest axis point, or larger, stored as points with a reach.
  struct Ball {
    Vec2 center{};
    SiteSlot site{};
  };
  BoxTree<Ball> balls_;
  Table<SiteSlot, std::uint32_t> ball_at_;
  Table<SiteSlot, double> reach_;  ///< squared reach in the tree
  MaxTree<EdgeSlot> epsilons_;
  Table<SiteSlot, Exemption> exemption_;
  Exempt exempt_{};

  ChangeRecorder<SiteSlot> site_recorder_;
  ChangeRecorder<EdgeSlot> edge_recorder_;
  ChangeSet<SiteSlot> site_changes_;
  ChangeSet<EdgeSlot> edge_changes_;
  SlotMarks<SiteSlot> to_search_;
  SlotMarks<EdgeSlot> counted_;
  std::vector<SiteSlot> searches_;
  std::vector<AxisLine> new_lines_;
};

}  // namespace mes
