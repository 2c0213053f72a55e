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

namespace mes {

/// What it guarantees:
///  1. An edge is crust exactly when some circle through its ends, centred on its dual Voronoi edge, is empty of both
///     ends of that Voronoi edge: the two opposite angles sum to at most 90 degrees, ties included, hull edges
///     included.
///  2. The decision is exact for the given doubles and does not depend on how cocircular sites were triangulated.
///  3. Collinear sites: every edge is crust.
///
/// Rows are those of the Delaunay edges and sites. Cost: 3n exact-sign tests, some 10 ns each; updates cost the
/// changed edges only. Source: Gold and Snoeyink, "A one-step crust and skeleton extraction algorithm", 2001.
class OneStepCrust final : public Structure {
 public:
  explicit OneStepCrust(Delaunay& delaunay);

  bool is_crust(EdgeSlot edge) const { return (flags_[edge] & kCrust) != 0; }
  /// The dual Voronoi edge has length exactly zero.
  bool is_cocircular(EdgeSlot edge) const { return (flags_[edge] & kCocircular) != 0; }
  /// Bit i: the face's edge i is crust. Edges to infinity never are.
  std::uint8_t crust_bits_of_face(FaceSlot face) const { return face_bits_[face]; }
  /// Number of crust edges at a site.
  int degree(SiteSlot site) const { return degree_[site]; }
  bool is_odd(SiteSlot site) const { return (degree_[site] & 1U) != 0; }
  std::size_t odd_count() const { return odd_count_; }
  std::size_t cocircular_count() const { return cocircular_count_; }
  /// Corners for the predicates, in the orientation of the edge's row.
  EdgeCorners corners(EdgeSlot edge) const;
  /// cos(alpha + beta), in [-1, 1]; 1 for collinear sites.
  double confidence(EdgeSlot edge) const;

  /// Live sites whose degree differs from before.
  const std::vector<SiteSlot>& degree_changes() const { return degree_changes_; }
  /// Sites that changed themselves or have a new degree.
  const ChangeSet<SiteSlot>& site_changes() const { return site_changes_; }

  void rebuild(JobControl& job) override;
  bool update(JobControl& job) override;
  void clear_changes() override {
    site_changes_.clear();
    degree_changes_.clear();
  }
  std::size_t touched() const override { return delaunay_.edge_changes().size(); }
  StatList statistics() const override;
  std::string_view kernel() const override { return "doubles with a proved bound, intervals, integers"; }
  void find(std::vector<Finding>& out) const override;
  void explain(ElementKind kind, RowNumber row, Explanation& out) const override;

 private:
  static constexpr std::uint8_t kCrust = 1;
  static constexpr std::uint8_t kCocircular = 2;

  std::uint8_t flags_for(EdgeSlot edge, FilterCounts& counts) const;
  void classify(EdgeSlot edge);
  void add_to_degree(SiteSlot site, int change);

  Delaunay& delaunay_;
  Table<EdgeSlot, std::uint8_t> flags_;
  Table<FaceSlot, std::uint8_t> face_bits_;
  Table<SiteSlot, std::uint8_t> degree_;
  std::size_t odd_count_ = 0;
  std::size_t cocircular_count_ = 0;
  FilterCounts counts_;
  ChangeRecorder<SiteSlot> site_recorder_;
  ChangeSet<SiteSlot> site_changes_;
  std::vector<SiteSlot> degree_changes_;
  struct DegreeBefore {
    SiteSlot site;
    std::uint8_t degree;
  };
  std::vector<DegreeBefore> degrees_before_;
  SlotMarks<SiteSlot> degree_marks_;
};

}  // namespace mes
