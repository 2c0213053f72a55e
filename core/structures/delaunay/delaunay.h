// SPDX-License-Identifier: GPL-3.0-or-later
// Delaunay triangulation and Voronoi diagram of the samples, as plain tables.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/base/change_set.h"
#include "core/base/geometry/vec2.h"
#include "core/base/jobs/prefetch.h"
#include "core/graph/structure.h"
#include "core/structures/inputs/samples.h"

namespace mes {

using SiteSlot = Slot<struct SiteTag>;
using FaceSlot = Slot<struct FaceTag>;
using EdgeSlot = Slot<struct EdgeTag>;

/// Stands for the vertex at infinity in `FaceRow::v`.
inline constexpr SiteSlot kInfiniteSite{0xfffffffeU};

/// A triangle, or the outside of a hull edge when one corner is `kInfiniteSite`. Corners run counter-clockwise;
/// neighbour and edge `i` lie opposite corner `i`. Edges to infinity have no row (kNoSlot). An edit reads some twenty
/// rows that are in no cache, so a row is one cache line with everything about the face in it.
struct alignas(64) FaceRow {
  SiteSlot v[3]{};
  FaceSlot n[3]{};
  EdgeSlot e[3]{};
  std::uint32_t mark = 0;  ///< work space of `Delaunay`
  Vec2 center{};           ///< circumcentre, the Voronoi vertex dual to the face
  double radius = 0.0;     ///< circumradius

  bool is_alive() const { return v[0] != kNoSlot; }
  bool is_infinite() const { return v[0] == kInfiniteSite || v[1] == kInfiniteSite || v[2] == kInfiniteSite; }
  /// Two faces have at most one edge in common.
  int index_of_neighbour(FaceSlot face) const { return n[0] == face ? 0 : (n[1] == face ? 1 : 2); }
  int index_of_edge(EdgeSlot edge) const { return e[0] == edge ? 0 : (e[1] == edge ? 1 : 2); }
  int index_of_site(SiteSlot site) const { return v[0] == site ? 0 : (v[1] == site ? 1 : 2); }
};
static_assert(sizeof(FaceRow) == 64 && alignof(FaceRow) == 64);

constexpr int next3(int i) {
  return i == 2 ? 0 : i + 1;
}
constexpr int prev3(int i) {
  return i == 0 ? 2 : i - 1;
}

/// A finite Delaunay edge from `v[0]` to `v[1]`; face `f[0]` lies to its left, `f[1]` to its right. When all samples
/// are collinear there are no faces (kNoSlot) and the edges join consecutive sites.
struct EdgeRow {
  SiteSlot v[2]{};
  FaceSlot f[2]{};
  std::uint32_t mark = 0;  ///< work space of `Delaunay`
  bool is_alive() const { return v[0] != kNoSlot; }
};
static_assert(sizeof(EdgeRow) == 20);

/// Guarantees:
///  1. A *site* is a distinct sample position. Samples at one position share a site; it lives until the last is gone.
///  2. The tables are the Delaunay triangulation decided by exact predicates; among cocircular sites the diagonals are
///     those of a perturbation by lexicographic order. So the triangulation is a function of the sites, whatever the
///     history; no decision depends on these diagonals.
///  3. Circumcentres are doubles for drawing; no decision may use them. A centre beyond the range of doubles is not
///     finite.
///
/// Cost: rebuild O(n log n), on two cores two thirds of the time of CGAL's triangulation alone on one; update O(changed
/// faces) after an expected O(1) location; many samples moved in one step are moved at once.
/// Threads: a rebuild borrows other cores; many samples are cut into parts, which are triangulated in parallel and
/// stitched. How: CGAL holds the triangulation; each of its faces stores the row that mirrors it. After an edit only
/// the faces around it are read again, and rows that die there are reused for those born there. Source: CGAL's
/// Delaunay_triangulation_2; flips after Lawson 1977; stitching after Guibas and Stolfi 1985.
class Delaunay final : public Structure {
 public:
  explicit Delaunay(Samples& samples);
  ~Delaunay() override;

  /// -1: no site, 0: one, 1: collinear, 2: faces exist.
  int dimension() const { return dimension_; }

  // Sites.
  std::size_t site_rows() const { return site_position_.size(); }
  /// All rows, including dead ones.
  SlotRange<SiteSlot> site_slots() const { return site_position_.rows(); }
  std::size_t site_count() const { return site_count_; }
  bool is_site(SiteSlot site) const { return site_sample_.has(site) && site_sample_[site] != kNoSlot; }
  Vec2 site_position(SiteSlot site) const { return site_position_[site]; }
  const Table<SiteSlot, Vec2>& site_positions() const { return site_position_; }
  /// One of the site's samples; `next_duplicate` gives the others, then kNoSlot.
  SampleSlot site_sample(SiteSlot site) const { return site_sample_[site]; }
  SampleSlot next_duplicate(SampleSlot sample) const { return next_duplicate_[sample]; }
  SiteSlot site_of_sample(SampleSlot sample) const {
    return site_of_sample_.has(sample) ? site_of_sample_[sample] : kNoSlot;
  }
  /// Some face at the site; kNoSlot below dimension 2.
  FaceSlot site_face(SiteSlot site) const { return site_face_[site]; }

  // Faces.
  std::size_t face_rows() const { return face_.size(); }
  SlotRange<FaceSlot> face_slots() const { return face_.rows(); }
  const Table<FaceSlot, FaceRow>& faces() const { return face_; }
  const FaceRow& face(FaceSlot face) const { return face_[face]; }
  bool is_finite_face(FaceSlot face) const { return face_[face].is_alive() && !face_[face].is_infinite(); }
  /// Length of the Voronoi edge between the two finite faces at an edge. Computed from differences of samples, which
  /// are exact far from the origin where circumcentres are not.
  double dual_length(EdgeSlot edge) const;
  /// Voronoi vertex dual to a finite face.
  Vec2 circumcenter(FaceSlot face) const { return face_[face].center; }
  double circumradius(FaceSlot face) const { return face_[face].radius; }

  // Edges.
  std::size_t edge_rows() const { return edge_.size(); }
  SlotRange<EdgeSlot> edge_slots() const { return edge_.rows(); }
  const Table<EdgeSlot, EdgeRow>& edges() const { return edge_; }
  const EdgeRow& edge(EdgeSlot edge) const { return edge_[edge]; }
  /// For passes over all edges: prefetches a face at an edge that comes soon. Edge rows follow the order of their first
  /// faces; the second face may be anywhere before the first.
  void expect_faces_after(EdgeSlot edge) const {
    const EdgeSlot soon(edge.index() + std::size_t{16});
    if (edge_.has(soon) && edge_[soon].f[1] != kNoSlot) prefetch(face_.address(edge_[soon].f[1]));
  }
  /// Corner of `face` opposite `edge`.
  SiteSlot apex(FaceSlot face, EdgeSlot edge) const { return face_[face].v[face_[face].index_of_edge(edge)]; }

  const ChangeSet<SiteSlot>& site_changes() const { return site_changes_; }
  const ChangeSet<FaceSlot>& face_changes() const { return face_changes_; }
  const ChangeSet<EdgeSlot>& edge_changes() const { return edge_changes_; }
  /// Earlier contents of the rows in `edge_changes`: the ends, or kNoSlot where the row was free. In the order of
  /// `touched` and `removed`; `f` is not set.
  const std::vector<EdgeRow>& touched_edges_before() const { return touched_edges_before_; }
  const std::vector<EdgeRow>& removed_edges_before() const { return removed_edges_before_; }

  /// Calls `visit(edge, other_site, left_face)` for each finite edge at a site, counter-clockwise when it has faces;
  /// `left_face` lies to the left of the edge seen from the site.
  template <class Visit>
  void for_each_edge_at(SiteSlot site, Visit visit) const;

  void rebuild(JobControl& job) override;
  bool update(JobControl& job) override;
  void clear_changes() override;
  std::size_t touched() const override { return face_changes_.size() + edge_changes_.size(); }
  StatList statistics() const override;
  std::vector<TableColumns> table_columns() const override;
  std::string_view kernel() const override { return "EPICK"; }
  void explain(ElementKind kind, RowNumber row, Explanation& out) const override;
  void explain_insertion(Vec2 at, Explanation& out) const override;

 private:
  template <class Kernel>
  class Rows;
  template <class Kernel>
  class Mirror;
  class MirrorBase;

  void clear_tables();
  // Notes for the change sets. A row may be noted twice in a run of several edits; the first note counts.
  void note_face(FaceSlot face) { noted_faces_.push_back({face, face_[face].is_alive()}); }
  void note_edge(EdgeSlot edge) { noted_edges_.push_back({edge, edge_[edge]}); }
  std::uint32_t new_mark();
  void finish_face_changes();
  void finish_edge_changes();
  /// True if the edits of this run have together touched so much that a rebuild is cheaper: sites removed one by one
  /// from the end of a stroke, for example, each have a star as large as the remaining part.
  bool is_too_much() const { return zone_faces_ > 1000 + face_.size(); }
  void compute_circumcircle(FaceSlot face);
  SiteSlot new_site(Vec2 position);
  void attach_sample(SampleSlot sample, SiteSlot site);
  /// Takes the sample from its site; true if the site has none left.
  bool detach_sample(SampleSlot sample);

  Samples& samples_;
  std::unique_ptr<MirrorBase> mirror_;
  int dimension_ = -1;
  std::size_t site_count_ = 0;

  Table<SiteSlot, Vec2> site_position_;
  Table<SiteSlot, SampleSlot> site_sample_;
  Table<SiteSlot, FaceSlot> site_face_;
  std::vector<SiteSlot> free_sites_;
  Table<SampleSlot, SiteSlot> site_of_sample_;
  Table<SampleSlot, SampleSlot> next_duplicate_;
  Table<FaceSlot, FaceRow> face_;
  std::vector<FaceSlot> free_faces_;
  Table<EdgeSlot, EdgeRow> edge_;
  std::vector<EdgeSlot> free_edges_;
  Table<SiteSlot, std::array<EdgeSlot, 2>> line_edges_;  // only in dimension 1

  ChangeRecorder<SiteSlot> site_recorder_;
  struct NotedFace {
    FaceSlot face;
    bool was_alive;
  };
  struct NotedEdge {
    EdgeSlot edge;
    EdgeRow before;
  };
  std::vector<NotedFace> noted_faces_;
  std::vector<NotedEdge> noted_edges_;
  std::uint32_t last_mark_ = 0;
  std::size_t zone_faces_ = 0;  ///< faces rewritten in this run
  std::vector<EdgeRow> touched_edges_before_;
  std::vector<EdgeRow> removed_edges_before_;
  ChangeSet<SiteSlot> site_changes_;
  ChangeSet<FaceSlot> face_changes_;
  ChangeSet<EdgeSlot> edge_changes_;
};

template <class Visit>
void Delaunay::for_each_edge_at(SiteSlot site, Visit visit) const {
  if (dimension_ < 2) {
    if (dimension_ < 1) return;
    for (const EdgeSlot edge : line_edges_[site])
      if (edge != kNoSlot) visit(edge, edge_[edge].v[edge_[edge].v[0] == site ? 1 : 0], FaceSlot());
    return;
  }
  const FaceSlot start = site_face_[site];
  FaceSlot at = start;
  do {
    const FaceRow& row = face_[at];
    const int i = row.index_of_site(site);
    const EdgeSlot edge = row.e[prev3(i)];
    if (edge != kNoSlot) visit(edge, row.v[next3(i)], at);
    at = row.n[next3(i)];
  } while (at != start);
}

}  // namespace mes
