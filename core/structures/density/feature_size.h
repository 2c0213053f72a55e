// SPDX-License-Identifier: GPL-3.0-or-later
// How dense the samples are: their distance to the axis against the distance of their neighbours.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "core/base/box_tree.h"
#include "core/base/change_set.h"
#include "core/base/max_tree.h"
#include "core/graph/structure.h"
#include "core/structures/crust/one_step_crust.h"
#include "core/structures/density/axis_line.h"
#include "core/structures/density/curve_sampling.h"

namespace mes {

/// What counts as dense: the tests' samples of smooth shapes with this epsilon have the axis that the theorem promises.
inline constexpr double kDenseEpsilon = 0.25;

/// The local feature size of a point of a curve is its distance to the medial axis on both sides; samples are an
/// epsilon-sample if every point of the curve has one within epsilon times its feature size. Neither curve nor axis are
/// known, so both are estimated from the samples: the axis by the Voronoi edges of Delaunay edges that are not crust
/// (layer `all-medial-axis`), the curve by the crust. Where samples are dense the estimate is near the truth; where they
/// are not, the crust skips what it does not see, and the estimate may be too good.
///
/// What it guarantees:
///  1. `size(site)` is the distance to the nearest point of that axis: all of its edges, with rays and lines.
///  2. `epsilon(edge)` of a crust edge is half its length over the smaller size of its ends. The largest of all is what
///     the samples achieve by this estimate.
///  3. At corners the ratio stays as it is however short edges become, and where the curve ends or meets itself the
///     estimate says nothing: these sites are *exempt*, and edges that end there do not count for the epsilon of all.
///  4. Where the curves of the samples are known, the epsilon of all is that by these (CurveSampling), and no note says
///     another one.
///  5. Numbers that are there are finite and above 0. Without an axis there are none.
///
/// A corner is a sample at which the crust turns by more than twice the arc sine of `kDenseEpsilon`, which half an edge over
/// the distance to the axis beside a corner comes to however short the edge is, and by more than four times as much as at
/// its two neighbours together, which a smooth curve with too few samples does not.
///
/// Rows are those of the Delaunay sites and edges. Cost: rebuild O(n log n) typically, by walks along the curve
/// (cell_walk.h) or in a tree of all edges; an update O(changed edges times what their search meets).
/// Source: Amenta, Bern and Eppstein, "The crust and the beta-skeleton", 1998.
class FeatureSize final : public Structure {
 public:
  FeatureSize(Delaunay& delaunay, OneStepCrust& crust);
  FeatureSize(Delaunay& delaunay, OneStepCrust& crust, CurveSampling& curves);

  /// There is an edge of the axis.
  bool has_axis() const { return line_count_ != 0; }
  /// Why there is none, as a sentence without a full stop; empty if there is one.
  std::string_view reason() const;
  bool has_size(SiteSlot site) const { return nearest_.has(site) && nearest_[site] != kNoSlot; }
  double size(SiteSlot site) const { return std::sqrt(squared_[site]) / unit_; }
  /// The crust edge has an epsilon: both its ends have a size.
  bool has_epsilon(EdgeSlot edge) const;
  double epsilon(EdgeSlot edge) const;
  /// The sample is exempt: a corner, or an end or junction of the crust. O(edges at it and its neighbours).
  bool is_exempt(SiteSlot site) const;
  /// The edge with the largest epsilon of those that end at no exempt sample; of several the first by the places of its
  /// ends; kNoSlot if none has one. O(1) once updates have begun, before O(edges).
  EdgeSlot sparsest_edge() const;

  /// Sites that came, moved or went, or whose size differs from before.
  const ChangeSet<SiteSlot>& site_changes() const { return site_changes_; }
  /// Crust edges that changed, or whose epsilon may differ, and edges that changed.
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
  double epsilon_or_none(EdgeSlot edge) const;
  bool ends_at_exempt(EdgeSlot edge) const;
  std::array<SiteSlot, 2> crust_neighbours(SiteSlot site) const;
  double turn_at(SiteSlot site) const;
  std::vector<EdgeSlot> edges_to_count_anew();
  bool is_first(EdgeSlot a, EdgeSlot b) const;
  bool is_axis(EdgeSlot edge) const { return delaunay_.edge(edge).is_alive() && !crust_.is_crust(edge); }
  Vec2 place_of(SiteSlot site) const {
    const Vec2 at = delaunay_.site_position(site);
    return {at.x * unit_, at.y * unit_};
  }
  bool fits(SiteSlot site) const;
  void choose_unit();
  std::vector<AxisLine> all_lines() const;
  Found search(Vec2 p) const;
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
  double unit_ = 1.0;                ///< a power of two: squares of what is multiplied by it are normal doubles
  int exponent_ = 0;                 ///< of the largest coordinate when it was chosen
  Table<SiteSlot, double> squared_;  ///< of the size in scaled units; infinite without one
  Table<SiteSlot, EdgeSlot> nearest_;
  std::size_t line_count_ = 0;
  BoxTree<AxisLine> lines_;                 ///< for updates, and for what is searched in it; else empty
  Table<EdgeSlot, std::uint32_t> line_at_;  ///< its place in the tree

  // What updates alone need. The sites of one nearest edge, as a list through the table of sites:
  bool is_ready_ = false;
  Table<EdgeSlot, SiteSlot> first_site_;
  struct Links {
    SiteSlot before{};
    SiteSlot after{};
  };
  Table<SiteSlot, Links> links_;
  /// Disks about sites up to their nearest point, or larger ones, as points with a reach.
  struct Ball {
    Vec2 center{};
    SiteSlot site{};
  };
  BoxTree<Ball> balls_;
  Table<SiteSlot, std::uint32_t> ball_at_;
  Table<SiteSlot, double> reach_;  ///< in the tree, squared
  MaxTree<EdgeSlot> epsilons_;

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
