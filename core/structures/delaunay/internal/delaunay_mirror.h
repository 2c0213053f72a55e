// SPDX-License-Identifier: GPL-3.0-or-later
// The CGAL triangulation behind `Delaunay`, and how its faces are mirrored to table rows. Private to delaunay.cpp.
#pragma once

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <bit>
#include <vector>

#include "core/base/parallel.h"
#include "core/base/prefetch.h"
#include "core/kernel/kernels.h"
#include "core/structures/delaunay/delaunay.h"
#include "core/structures/delaunay/internal/delaunay_stitch.h"
#include "core/structures/delaunay/internal/insertion_order.h"
#include "core/structures/delaunay/internal/location_hints.h"

namespace mes {

/// Row of a CGAL vertex or face; new ones have none.
template <class Row>
struct RowTag {
  Row slot;
};

class Delaunay::MirrorBase {
 public:
  virtual ~MirrorBase() = default;
  virtual void clear() = 0;
  /// Triangulates the samples and fills the tables.
  virtual void build(std::vector<SampleSlot> samples, JobControl& job) = 0;
  // Local edits in dimension 2; false when the dimension drops and the tables must be rebuilt.
  virtual bool insert(SampleSlot sample, Vec2 position) = 0;
  virtual bool remove(SampleSlot sample) = 0;
  virtual bool move(SampleSlot sample, Vec2 position) = 0;
};

/// The central step is `mirror_zone`: given the CGAL faces that an edit changed, and the rows those faces and their
/// dead predecessors had, rewrite the rows. Rows of edges on the rim of the zone are kept, all others of the old zone
/// are given to the new inner edges, so an edit allocates nothing in the long run.
template <class Kernel>
class Delaunay::Mirror final : public Delaunay::MirrorBase {
  using Vertex = CGAL::Triangulation_vertex_base_with_info_2<RowTag<SiteSlot>, Kernel>;
  using Face = CGAL::Triangulation_face_base_with_info_2<RowTag<FaceSlot>, Kernel>;
  using Triangulation = CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertex, Face>>;
  using Point = typename Kernel::Point_2;
  using VertexHandle = typename Triangulation::Vertex_handle;
  using FaceHandle = typename Triangulation::Face_handle;

 public:
  explicit Mirror(Delaunay& owner) : d_(owner) {}

  void clear() override {
    triangulation_.clear();
    vertex_.clear();
    hints_.clear();
    last_face_ = FaceHandle();
  }

  void build(std::vector<SampleSlot> samples, JobControl& job) override {
    const std::size_t count = samples.size();
    vertex_.assign(count, VertexHandle());
    d_.site_position_.assign(count, Vec2{});
    d_.site_sample_.assign(count, kNoSlot);
    d_.site_face_.assign(count, kNoSlot);
    triangulate(std::move(samples), job);
    for (const SiteSlot site : slots_below<SiteSlot>(count))
      if (!d_.is_site(site)) d_.free_sites_.push_back(site);
    d_.site_count_ = count - d_.free_sites_.size();
    d_.dimension_ = triangulation_.dimension();
    if (d_.dimension_ == 2) {
      mirror_all();
    } else if (d_.dimension_ == 1) {
      mirror_chain();
    }
  }

  bool insert(SampleSlot sample, Vec2 p) override { return insert_at(sample, p, start_near(p), SiteSlot()); }

  bool remove(SampleSlot sample) override {
    const SiteSlot site = d_.site_of_sample_[sample];
    if (!d_.detach_sample(sample)) {
      d_.site_recorder_.note(site, true);
      return true;
    }
    return remove_site(site) && (release_site(site), true);
  }

  bool move(SampleSlot sample, Vec2 p) override {
    const SiteSlot site = d_.site_of_sample_[sample];
    const bool alone = d_.site_sample_[site] == sample && d_.next_duplicate_[sample] == kNoSlot;
    if (!alone) {
      d_.detach_sample(sample);
      d_.site_recorder_.note(site, true);
      return insert_at(sample, p, vertex_[site]->face(), SiteSlot());
    }
    if (move_in_star(site, p)) return true;
    d_.detach_sample(sample);
    if (!remove_site(site)) return false;
    return insert_at(sample, p, last_face_, site);
  }

 private:
  /// Samples that lie together. Their sites take rows of their own, from `first_site` on and as many as there are
  /// samples, so that parts can be made side by side. Duplicates leave rows free.
  struct Part {
    std::vector<SampleSlot> samples;
    SiteSlot first_site{0};
    Triangulation triangulation;
    SweepOrder before;  ///< of the cut that has this part on its far side
  };

  Vec2 position_of(SampleSlot sample) const { return d_.samples_.position(sample); }

  // Many samples are cut into parts, whose triangulations are made side by side and stitched. How many depends on the
  // number of samples alone, so that the result does not depend on the machine. Small parts stay in the caches, but
  // have more to be stitched: along a curve it is the larger share that changes.
  static std::size_t part_count(std::size_t samples) {
    constexpr std::size_t kMost = 8;
    constexpr std::size_t kLeastInPart = 20000;
    return std::min(kMost, std::bit_floor(std::max<std::size_t>(1, samples / kLeastInPart)));
  }

  void triangulate(std::vector<SampleSlot> samples, JobControl& job) {
    std::vector<Part> parts(part_count(samples.size()));
    parts.front().samples = std::move(samples);
    for (std::size_t step = parts.size() / 2; step != 0; step /= 2)
      run_tasks(parts.size() / (2 * step),
                [&](std::size_t i) { cut(parts[2 * step * i], parts[2 * step * i + step]); });
    run_tasks(parts.size(), [&](std::size_t i) { insert_all(parts[i], job); });
    for (std::size_t step = 1; step < parts.size(); step *= 2) {
      job.checkpoint();
      run_tasks(parts.size() / (2 * step),
                [&](std::size_t i) { join(parts[2 * step * i], parts[2 * step * i + step], job); });
    }
    triangulation_.swap(parts.front().triangulation);
  }

  void cut(Part& part, Part& far) {
    Halves halves = cut_in_two(part.samples, [this](SampleSlot sample) { return position_of(sample); });
    part.samples = std::move(halves.near);
    far.samples = std::move(halves.far);
    far.before = halves.before;
    far.first_site = SiteSlot(part.first_site.index() + part.samples.size());
  }

  void insert_all(Part& part, JobControl& job) {
    const auto order = insertion_order(part.samples, d_.samples_.extent(),
                                       [this](SampleSlot sample) { return position_of(sample); });
    FaceHandle hint;
    SiteSlot site = part.first_site;
    std::uint64_t done = 0;
    for (const Keyed<SampleSlot>& item : order) {
      if ((++done & 1023U) == 0) job.checkpoint(done, order.size());
      const Vec2 p = position_of(item.slot);
      const VertexHandle v = part.triangulation.insert(Point(p.x, p.y), hint);
      hint = v->face();
      if (v->info().slot == kNoSlot) {
        v->info().slot = site;
        vertex_[site] = v;
        d_.site_position_[site] = p;
        ++site;
      }
      d_.attach_sample(item.slot, v->info().slot);
    }
  }

  void join(Part& part, Part& far, JobControl& job) {
    if (part.triangulation.dimension() == 2 && far.triangulation.dimension() == 2) {
      DelaunayStitch<Triangulation>::run(part.triangulation, far.triangulation, far.before);
      return;
    }
    // What lies on a line has no sides to be stitched at: its sites are given vertices of the other triangulation.
    if (part.triangulation.dimension() < far.triangulation.dimension()) {
      part.triangulation.swap(far.triangulation);
      part.samples.swap(far.samples);
    }
    FaceHandle hint;
    std::uint64_t done = 0;
    for (const SampleSlot sample : far.samples) {
      if ((++done & 1023U) == 0) job.checkpoint(done, far.samples.size());
      const SiteSlot site = d_.site_of_sample_[sample];
      const Vec2 p = d_.site_position_[site];
      const VertexHandle v = part.triangulation.insert(Point(p.x, p.y), hint);
      v->info().slot = site;
      vertex_[site] = v;
      hint = v->face();
    }
    part.samples.insert(part.samples.end(), far.samples.begin(), far.samples.end());
  }

  static SiteSlot site_of(VertexHandle v) { return v->info().slot; }
  static FaceSlot row_of(FaceHandle f) { return f->info().slot; }
  void expect_row(FaceHandle f) const {
    if (row_of(f) != kNoSlot) prefetch(d_.face_.address(row_of(f)));
  }

  SiteSlot bind_new_site(VertexHandle v, Vec2 p) {
    const SiteSlot site = d_.new_site(p);
    if (!vertex_.has(site)) vertex_.resize(site.index() + std::size_t{1});
    vertex_[site] = v;
    return site;
  }

  void release_site(SiteSlot site) {
    d_.site_recorder_.note(site, true);
    d_.free_sites_.push_back(site);
    d_.site_face_[site] = kNoSlot;
    --d_.site_count_;
  }

  FaceHandle start_near(Vec2 p) {
    const auto position_of = [this](SiteSlot site) { return d_.site_position_[site]; };
    const auto is_alive = [this](SiteSlot site) { return d_.is_site(site); };
    if (hints_.is_stale(d_.site_rows())) hints_.build(d_.site_rows(), position_of, is_alive);
    const SiteSlot site = hints_.near(p, position_of, is_alive);
    return site == kNoSlot ? last_face_ : vertex_[site]->face();
  }

  // `reuse` is the row of a site that has just been taken out in order to be moved, or kNoSlot.
  bool insert_at(SampleSlot sample, Vec2 p, FaceHandle start, SiteSlot reuse) {
    const Point point(p.x, p.y);
    typename Triangulation::Locate_type type{};
    int index = 0;
    const FaceHandle where = triangulation_.locate(point, type, index, start);
    if (type == Triangulation::VERTEX) {
      const SiteSlot site = site_of(where->vertex(index));
      d_.attach_sample(sample, site);
      d_.site_recorder_.note(site, true);
      if (reuse != kNoSlot) release_site(reuse);
      last_face_ = where;
      return true;
    }
    const VertexHandle v = triangulation_.insert(point, type, where, index);
    if (reuse != kNoSlot) {
      v->info().slot = reuse;
      vertex_[reuse] = v;
      d_.site_position_[reuse] = p;
      d_.site_recorder_.note(reuse, true);
    } else {
      v->info().slot = bind_new_site(v, p);
      d_.site_recorder_.note(v->info().slot, false);
    }
    d_.attach_sample(sample, v->info().slot);
    // CGAL inserts by splitting one face and flipping: what changed is the star of the new vertex, and every face of
    // the old zone is in it.
    zone_.clear();
    old_rows_.clear();
    collect_star(v);
    for (const FaceHandle f : zone_)
      if (row_of(f) != kNoSlot) old_rows_.push_back(row_of(f));
    mirror_zone();
    last_face_ = v->face();
    return true;
  }

  // Takes the vertex out of the triangulation; the site's row stays with the caller.
  bool remove_site(SiteSlot site) {
    const VertexHandle v = vertex_[site];
    zone_.clear();
    old_rows_.clear();
    rim_.clear();
    auto face = triangulation_.incident_faces(v);
    const auto end = face;
    do {
      const FaceHandle f = face;
      const FaceHandle outer = f->neighbor(f->index(v));
      expect_row(f);
      expect_row(outer);
      rim_.push_back({outer, outer->index(f)});
      old_rows_.push_back(row_of(f));
      // Whatever CGAL makes of these faces counts as new; only faces outside the hole keep a row.
      f->info().slot = kNoSlot;
    } while (++face != end);
    triangulation_.remove(v);
    vertex_[site] = VertexHandle();
    if (triangulation_.dimension() != 2) return false;
    taken_rows_ = 0;
    for (const auto& [outer, i] : rim_) enter_hole(outer->neighbor(i));
    for (std::size_t next = 0; next < zone_.size(); ++next)
      for (int i = 0; i < 3; ++i) enter_hole(zone_[next]->neighbor(i));
    mirror_zone();
    last_face_ = zone_.front();
    return true;
  }

  void enter_hole(FaceHandle f) {
    if (row_of(f) != kNoSlot) return;
    f->info().slot = old_rows_[taken_rows_++];
    zone_.push_back(f);
  }

  // Moves a vertex within its star and restores the Delaunay property by flips. False, with nothing changed, when the
  // star would turn inside out or the vertex is on the hull.
  bool move_in_star(SiteSlot site, Vec2 p) {
    const VertexHandle v = vertex_[site];
    const Point target(p.x, p.y);
    const auto orientation = triangulation_.geom_traits().orientation_2_object();
    zone_.clear();
    collect_star(v);
    for (const FaceHandle f : zone_) {
      const int i = f->index(v);
      const VertexHandle a = f->vertex(next3(i));
      const VertexHandle b = f->vertex(prev3(i));
      if (triangulation_.is_infinite(a) || triangulation_.is_infinite(b)) return false;
      if (orientation(target, a->point(), b->point()) != CGAL::LEFT_TURN) return false;
    }
    v->set_point(target);
    d_.site_position_[site] = p;
    d_.site_recorder_.note(site, true);
    const std::uint32_t in_zone = d_.new_mark();
    suspects_.clear();
    for (const FaceHandle f : zone_) {
      d_.face_[row_of(f)].mark = in_zone;
      const int i = f->index(v);
      suspects_.push_back({f, i});
      suspects_.push_back({f, next3(i)});
    }
    // Lawson's flips. An entry may be stale after a flip; testing another edge instead does no harm, because a flip
    // puts all edges of both faces on the stack again.
    while (!suspects_.empty()) {
      const auto [f, i] = suspects_.back();
      suspects_.pop_back();
      const FaceHandle g = f->neighbor(i);
      if (triangulation_.is_infinite(f) || triangulation_.is_infinite(g)) continue;
      const VertexHandle across = g->vertex(g->index(f));
      if (triangulation_.side_of_oriented_circle(f, across->point(), true) != CGAL::ON_POSITIVE_SIDE) continue;
      triangulation_.flip(f, i);
      for (const FaceHandle h : {f, g}) {
        FaceRow& row = d_.face_[row_of(h)];
        if (row.mark != in_zone) zone_.push_back(h);
        row.mark = in_zone;
        for (int k = 0; k < 3; ++k) suspects_.push_back({h, k});
      }
    }
    old_rows_.clear();
    for (const FaceHandle f : zone_) old_rows_.push_back(row_of(f));
    mirror_zone();
    last_face_ = zone_.front();
    return true;
  }

  void collect_star(VertexHandle v) {
    auto face = triangulation_.incident_faces(v);
    const auto end = face;
    do {
      zone_.push_back(face);
      expect_row(face);
      expect_row(face->neighbor(face->index(v)));
    } while (++face != end);
  }

  // Rewrites the rows of `zone_`. Faces without a row get one; rows of `old_rows_` that no face of the zone holds
  // die.
  void mirror_zone() {
    d_.zone_faces_ += zone_.size();
    const std::uint32_t mark = d_.new_mark();
    old_edges_.clear();
    for (const FaceSlot row : old_rows_)
      for (const EdgeSlot e : d_.face_[row].e)
        if (e != kNoSlot) prefetch(d_.edge_.address(e));
    for (const FaceSlot row : old_rows_) {
      d_.note_face(row);
      for (const EdgeSlot e : d_.face_[row].e) {
        if (e == kNoSlot || d_.edge_[e].mark == mark) continue;
        d_.edge_[e].mark = mark;
        old_edges_.push_back(e);
      }
    }
    for (const FaceHandle f : zone_) {
      if (row_of(f) == kNoSlot || d_.face_[row_of(f)].mark == mark) {
        f->info().slot = new_face_row();
        d_.note_face(row_of(f));
      }
      d_.face_[row_of(f)].mark = mark;
    }
    for (const FaceSlot row : old_rows_) {
      if (d_.face_[row].mark == mark) continue;
      d_.face_[row] = FaceRow{};
      d_.free_faces_.push_back(row);
    }
    for (const FaceHandle f : zone_) write_corners(f);
    // Rim: the edge stays, what lies on our side of it is new.
    for (const FaceHandle f : zone_) {
      FaceRow& row = d_.face_[row_of(f)];
      for (int i = 0; i < 3; ++i) {
        const FaceHandle g = f->neighbor(i);
        row.n[i] = row_of(g);
        row.e[i] = kNoSlot;
        FaceRow& outer = d_.face_[row.n[i]];
        if (outer.mark == mark) continue;
        const int j = g->index(f);
        outer.n[j] = row_of(f);
        row.e[i] = outer.e[j];
        if (row.e[i] == kNoSlot) continue;
        d_.note_edge(row.e[i]);
        EdgeRow& edge = d_.edge_[row.e[i]];
        edge.mark = 0;
        edge.f[edge.v[0] == row.v[next3(i)] ? 0 : 1] = row_of(f);
      }
    }
    // New inner edges take the rows of dead ones.
    std::size_t spare = 0;
    const auto is_spare = [&](EdgeSlot e) { return d_.edge_[e].mark == mark; };
    for (const FaceHandle f : zone_) {
      const FaceSlot own = row_of(f);
      for (int i = 0; i < 3; ++i) {
        const FaceSlot other = d_.face_[own].n[i];
        if (own > other || d_.face_[other].mark != mark) continue;
        const SiteSlot a = d_.face_[own].v[next3(i)];
        const SiteSlot b = d_.face_[own].v[prev3(i)];
        if (a == kInfiniteSite || b == kInfiniteSite) continue;
        while (spare < old_edges_.size() && !is_spare(old_edges_[spare])) ++spare;
        const EdgeSlot e = spare < old_edges_.size() ? old_edges_[spare++] : new_edge_row();
        d_.note_edge(e);
        d_.edge_[e] = EdgeRow{{a, b}, {own, other}};
        d_.face_[own].e[i] = e;
        d_.face_[other].e[f->neighbor(i)->index(f)] = e;
      }
    }
    for (; spare < old_edges_.size(); ++spare) {
      const EdgeSlot e = old_edges_[spare];
      if (!is_spare(e)) continue;
      d_.note_edge(e);
      d_.edge_[e] = EdgeRow{};
      d_.free_edges_.push_back(e);
    }
  }

  void read_corners(FaceHandle f) {
    const FaceSlot slot = row_of(f);
    FaceRow& row = d_.face_[slot];
    for (int i = 0; i < 3; ++i) {
      const VertexHandle v = f->vertex(i);
      row.v[i] = triangulation_.is_infinite(v) ? kInfiniteSite : site_of(v);
    }
    d_.compute_circumcircle(slot);
  }

  void write_corners(FaceHandle f) {
    read_corners(f);
    for (const SiteSlot site : d_.face_[row_of(f)].v)
      if (site != kInfiniteSite) d_.site_face_[site] = row_of(f);
  }

  FaceSlot new_face_row() {
    if (!d_.free_faces_.empty()) {
      const FaceSlot row = d_.free_faces_.back();
      d_.free_faces_.pop_back();
      return row;
    }
    const FaceSlot row = d_.face_.next();
    d_.face_.emplace_back();
    return row;
  }

  EdgeSlot new_edge_row() {
    if (!d_.free_edges_.empty()) {
      const EdgeSlot row = d_.free_edges_.back();
      d_.free_edges_.pop_back();
      return row;
    }
    const EdgeSlot row = d_.edge_.next();
    d_.edge_.emplace_back();
    return row;
  }

  // The triangulation is only read here, and every row and every field of it is written by one thread.
  void mirror_all() {
    const std::size_t count = triangulation_.tds().number_of_faces();
    Table<FaceSlot, FaceHandle> handles;
    run_tasks(2, [&](std::size_t task) {
      if (task == 0) {
        handles.reserve(count);
        for (auto f = triangulation_.tds().faces_begin(); f != triangulation_.tds().faces_end(); ++f) {
          f->info().slot = handles.next();
          handles.push_back(f);
        }
      } else {
        d_.face_.resize(count);
        d_.edge_.resize(count / 2 * 3);  // more by those to infinity
      }
    });
    std::vector<std::size_t> first_edge(chunk_count(handles.size()) + 1, 0);
    parallel_for(handles.size(), [&](std::size_t begin, std::size_t end, std::size_t chunk) {
      std::size_t edges =
          0;  // not counted in place: the threads would take a cache line from each other all the time
      for (const FaceSlot face : slots_between<FaceSlot>(begin, end)) {
        const FaceHandle f = handles[face];
        read_corners(f);
        for (int i = 0; i < 3; ++i) {
          d_.face_[face].n[i] = row_of(f->neighbor(i));
          edges += owns_edge(face, i) ? 1U : 0U;
        }
      }
      first_edge[chunk + 1] = edges;
    });
    for (std::size_t chunk = 1; chunk < first_edge.size(); ++chunk) first_edge[chunk] += first_edge[chunk - 1];
    d_.edge_.resize(first_edge.back());
    parallel_for(handles.size(), [&](std::size_t begin, std::size_t end, std::size_t chunk) {
      EdgeSlot e(first_edge[chunk]);
      for (const FaceSlot face : slots_between<FaceSlot>(begin, end)) {
        FaceRow& row = d_.face_[face];
        for (int i = 0; i < 3; ++i) {
          if (!owns_edge(face, i)) continue;
          d_.edge_[e] = EdgeRow{{row.v[next3(i)], row.v[prev3(i)]}, {face, row.n[i]}};
          row.e[i] = e;
          FaceRow& other = d_.face_[row.n[i]];
          other.e[other.index_of_neighbour(face)] = e;
          ++e;
        }
      }
    });
    parallel_for(d_.site_rows(), [&](std::size_t begin, std::size_t end, std::size_t) {
      for (const SiteSlot site : slots_between<SiteSlot>(begin, end))
        if (d_.is_site(site)) d_.site_face_[site] = row_of(vertex_[site]->face());
    });
  }

  // Of the two faces at a finite edge, the one with the larger row makes the edge's row.
  bool owns_edge(FaceSlot face, int i) const {
    const FaceRow& row = d_.face_[face];
    return row.n[i] < face && row.v[next3(i)] != kInfiniteSite && row.v[prev3(i)] != kInfiniteSite;
  }

  // All sites on one line: edges between neighbours along it.
  void mirror_chain() {
    d_.line_edges_.assign(d_.site_rows(), {});
    for (auto e = triangulation_.finite_edges_begin(); e != triangulation_.finite_edges_end(); ++e) {
      const SiteSlot a = site_of(e->first->vertex(next3(e->second)));
      const SiteSlot b = site_of(e->first->vertex(prev3(e->second)));
      const EdgeSlot row = d_.edge_.next();
      d_.edge_.push_back(EdgeRow{{a, b}, {}});
      for (const SiteSlot site : {a, b}) {
        auto& both = d_.line_edges_[site];
        both[both[0] == kNoSlot ? 0 : 1] = row;
      }
    }
  }

  Delaunay& d_;
  Triangulation triangulation_;
  Table<SiteSlot, VertexHandle> vertex_;
  LocationHints hints_;
  FaceHandle last_face_;

  // Work space of one edit, kept to save allocations.
  std::vector<FaceHandle> zone_;
  std::vector<FaceSlot> old_rows_;
  std::vector<EdgeSlot> old_edges_;
  std::vector<std::pair<FaceHandle, int>> rim_;
  std::vector<std::pair<FaceHandle, int>> suspects_;
  std::size_t taken_rows_ = 0;
};

}  // namespace mes
