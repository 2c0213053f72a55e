// SPDX-License-Identifier: GPL-3.0-or-later
// The one-step crust: which Delaunay edges reconstruct the curve.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/base/change_set.h"
#include "core/graph/structure.h"
#include "core/kernel/edge_predicates.h"
#include "core/structures/delaunay/delaunay.h"
#include "core/structures/inputs/shared_borders.h"

namespace mes {

/// Guarantees:
///  1. An edge is crust exactly when some circle through its ends, centred on its dual Voronoi edge, is empty of both
///     ends of that Voronoi edge: the two opposite angles sum to at most 90 degrees, ties included, hull edges
///     included.
///  2. The decision is exact for the given doubles and does not depend on how cocircular sites were triangulated.
///  3. Collinear sites: every edge is crust.
///  4. An edge between two samples that share a border (core/structures/inputs/shared_borders.h) is *shared*, and one
///     along a seam there is crust, whatever the angles. Labels change across *walls*: unshared crust edges.
///
/// Rows are those of the Delaunay edges and sites. Cost: 3n exact-sign tests, some 10 ns each; an update tests only the
/// changed edges. Source: Gold and Snoeyink, "A one-step crust and skeleton extraction algorithm", 2001.
class OneStepCrust final : public Structure {
 public:
  /// For samples without contours: nothing is shared.
  explicit OneStepCrust(Delaunay& delaunay);
  OneStepCrust(Delaunay& delaunay, SharedBorders& borders);

  bool is_crust(EdgeSlot edge) const { return (flags_[edge] & kCrust) != 0; }
  bool is_shared(EdgeSlot edge) const { return (flags_[edge] & kShared) != 0; }
  bool is_wall(EdgeSlot edge) const { return (flags_[edge] & (kCrust | kShared)) == kCrust; }
  /// True if the dual Voronoi edge has length exactly zero.
  bool is_cocircular(EdgeSlot edge) const { return (flags_[edge] & kCocircular) != 0; }
  /// Bit i: the face's edge i is a wall. Edges to infinity never are.
  std::uint8_t wall_bits_of_face(FaceSlot face) const { return face_bits_[face]; }
  /// Number of crust edges at a site.
  int degree(SiteSlot site) const { return degree_[site]; }
  /// Number of walls at a site.
  int wall_degree(SiteSlot site) const {
    return degree_[site] - (shared_degree_.empty() ? 0 : static_cast<int>(shared_degree_[site]));
  }
  /// True if the site has an odd number of walls.
  bool is_odd(SiteSlot site) const { return (wall_degree(site) & 1) != 0; }
  std::size_t odd_count() const { return odd_count_; }
  /// Sites without a crust edge, where there is a crust.
  std::size_t lone_count() const { return joined_count_ == 0 ? 0 : delaunay_.site_count() - joined_count_; }
  std::size_t cocircular_count() const { return cocircular_count_; }
  /// Corners for the predicates, in the orientation of the edge's row.
  EdgeCorners corners(EdgeSlot edge) const;
  /// cos(alpha + beta), in [-1, 1]; 1 for collinear sites.
  double confidence(EdgeSlot edge) const;

  /// Live sites whose degree, or number of walls, differs from before.
  const std::vector<SiteSlot>& degree_changes() const { return degree_changes_; }
  /// Sites that changed or have a new degree.
  const ChangeSet<SiteSlot>& site_changes() const { return site_changes_; }

  void rebuild(JobControl& job) override;
  bool update(JobControl& job) override;
  void clear_changes() override {
    site_changes_.clear();
    degree_changes_.clear();
  }
  std::size_t touched() const override { return delaunay_.edge_changes().size(); }
  StatList statistics() const override;
  std::vector<TableColumns> table_columns() const override;
  std::string_view kernel() const override { return "doubles with a proved bound, intervals, integers"; }
  void find(std::vector<Finding>& out) const override;
  void explain(ElementKind kind, RowNumber row, Explanation& out) const override;
  void explain_insertion(Vec2 at, Explanation& out) const override;

 private:
  static constexpr std::uint8_t kCrust = 1;
  static constexpr std::uint8_t kCocircular = 2;
  static constexpr std::uint8_t kShared = 4;

  std::uint8_t flags_for(EdgeSlot edge, FilterCounts& counts) const;
  void classify(EdgeSlot edge);
  bool has_borders() const { return borders_ != nullptr && !borders_->is_empty(); }
  bool has_duplicates() const { return borders_ != nullptr && delaunay_.site_count() != borders_->samples().count(); }
  /// `kShared` for a shared border, `kCrust` along a seam, or 0.
  std::uint8_t flags_of_contours(EdgeSlot edge) const;
  bool shares_what_it_should() const;
  /// Adds these numbers of crust edges, and of shared ones among them.
  void add_to_degrees(SiteSlot site, int crust, int shared);

  Delaunay& delaunay_;
  SharedBorders* borders_ = nullptr;
  Table<EdgeSlot, std::uint8_t> flags_;
  Table<FaceSlot, std::uint8_t> face_bits_;
  Table<SiteSlot, std::uint8_t> degree_;
  Table<SiteSlot, std::uint8_t> shared_degree_;  ///< number of shared crust edges; empty if there are none
  std::size_t odd_count_ = 0;
  std::size_t joined_count_ = 0;  // sites with a crust edge
  bool had_duplicates_ = false;   ///< several samples at one position, at the last check
  std::size_t cocircular_count_ = 0;
  FilterCounts counts_;
  ChangeRecorder<SiteSlot> site_recorder_;
  ChangeSet<SiteSlot> site_changes_;
  std::vector<SiteSlot> degree_changes_;
  struct DegreeBefore {
    SiteSlot site;
    std::uint8_t degree;
    std::uint8_t wall_degree;
  };
  std::vector<DegreeBefore> degrees_before_;
  SlotMarks<SiteSlot> degree_marks_;
};

}  // namespace mes
