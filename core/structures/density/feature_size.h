// SPDX-License-Identifier: GPL-3.0-or-later
// How dense the samples are: their distance to the axis against the distance of their neighbours.
#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "core/base/box_tree.h"
#include "core/base/change_set.h"
#include "core/graph/structure.h"
#include "core/structures/crust/one_step_crust.h"

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
///  3. Numbers that are there are finite and above 0 as long as squares of sizes are normal doubles, which they are for
///     sizes from 2^-511. Without an axis there are none.
///
/// Rows are those of the Delaunay sites and edges. Cost: rebuild O(n log n) typically; an update O(changed edges times
/// what their search meets), and now and then O(n log n), when much has changed since the trees were made.
/// Source: Amenta, Bern and Eppstein, "The crust and the beta-skeleton", 1998.
class FeatureSize final : public Structure {
 public:
  FeatureSize(Delaunay& delaunay, OneStepCrust& crust);

  bool has_size(SiteSlot site) const { return nearest_.has(site) && nearest_[site] != kNoSlot; }
  double size(SiteSlot site) const { return std::sqrt(squared_[site]); }
  /// The crust edge has an epsilon: both its ends have a size.
  bool has_epsilon(EdgeSlot edge) const;
  double epsilon(EdgeSlot edge) const;

  /// Sites that came, moved or went, or whose size differs from before.
  const ChangeSet<SiteSlot>& site_changes() const { return site_changes_; }
  /// Crust edges that changed, or whose epsilon may differ, and edges that changed.
  const ChangeSet<EdgeSlot>& edge_changes() const { return edge_changes_; }

  void rebuild(JobControl& job) override;
  bool update(JobControl& job) override;
  void clear_changes() override;
  std::size_t touched() const override { return site_changes_.size() + edge_changes_.size(); }
  StatList statistics() const override;

 private:
  /// An edge of the axis on the bisector of q and r: the points at height `low` to `high` over the middle of qr, on the
  /// left of q -> r.
  struct AxisLine {
    EdgeSlot edge{};
    std::uint32_t stamp = 0;  ///< of the edge when this was made
    Vec2 q{};
    Vec2 along{};  ///< unit vector from q to r
    double half = 0.0;
    double low = 0.0;
    double high = 0.0;

    double squared_distance(Vec2 p) const {
      const Vec2 u = p - q;
      const double aside = dot(u, along) - half;
      const double height = cross(along, u);
      const double rest = height - (height < low ? low : (height > high ? high : height));
      return aside * aside + rest * rest;
    }
    Box2 box() const;
  };
  struct Found {
    double squared = 0.0;
    EdgeSlot edge{};
  };

  bool is_axis(EdgeSlot edge) const { return delaunay_.edge(edge).is_alive() && !crust_.is_crust(edge); }
  AxisLine line_of(EdgeSlot edge) const;
  bool is_current(const AxisLine& line) const { return stamp_[line.edge] == line.stamp; }
  void make_line_tree();
  void make_ball_tree();
  Found search(Vec2 p, const AxisLine* guess) const;
  void attach(SiteSlot site, const Found& found);
  void detach(SiteSlot site);
  void search_anew(SiteSlot site);
  void follow_edge(EdgeSlot edge, bool is_alive);
  void shrink_balls_at(const AxisLine& line);
  void queue_search(SiteSlot site) {
    if (to_search_.insert(site)) searches_.push_back(site);
  }
  void finish_changes();

  Delaunay& delaunay_;
  OneStepCrust& crust_;
  Table<SiteSlot, double> squared_;  ///< of the size; infinite without one
  Table<SiteSlot, EdgeSlot> nearest_;
  // The sites of one nearest edge, as a list through the table of sites.
  Table<EdgeSlot, SiteSlot> first_site_;
  struct Links {
    SiteSlot before{};
    SiteSlot after{};
  };
  Table<SiteSlot, Links> links_;
  Table<EdgeSlot, std::uint32_t> stamp_;  ///< another one whenever the edge changes
  Table<EdgeSlot, std::uint8_t> is_line_;
  std::size_t line_count_ = 0;

  // What was there when the trees were made, and what came since. What is out of date stays in the trees and is passed
  // over.
  std::vector<AxisLine> lines_;
  std::vector<AxisLine> recent_lines_;
  BoxTree line_tree_;
  std::vector<SiteSlot> balls_;
  std::vector<SiteSlot> recent_balls_;
  BoxTree ball_tree_;
  /// Square of the size in `ball_tree_`; infinite in `recent_balls_`, which are looked at one by one; below 0: in neither.
  Table<SiteSlot, double> boxed_;

  ChangeRecorder<SiteSlot> site_recorder_;
  ChangeRecorder<EdgeSlot> edge_recorder_;
  ChangeSet<SiteSlot> site_changes_;
  ChangeSet<EdgeSlot> edge_changes_;
  SlotMarks<SiteSlot> to_search_;
  std::vector<SiteSlot> searches_;
};

}  // namespace mes
