// SPDX-License-Identifier: GPL-3.0-or-later
// The CGAL triangulation behind `Delaunay`, edited and mirrored to table rows. Private to delaunay.cpp.
#pragma once

#include <algorithm>
#include <bit>
#include <vector>

#include "core/base/jobs/parallel.h"
#include "core/kernel/filtered_kernel.h"
#include "core/kernel/point_predicates.h"
#include "core/structures/delaunay/delaunay.h"
#include "core/structures/delaunay/internal/delaunay_rows.h"
#include "core/structures/delaunay/internal/delaunay_stitch.h"
#include "core/structures/delaunay/internal/insertion_order.h"
#include "core/structures/delaunay/internal/location_hints.h"

namespace mes {

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
  /// Moves samples that have a site to their positions in the document, as many as can be moved at once. Some of the
  /// others are taken out, and the rest stays where it is. False if the tables must be rebuilt.
  virtual bool move_together(const std::vector<SampleSlot>& samples, JobControl& job) = 0;
};

/// Edits the triangulation and updates the rows.
template <class Kernel>
class Delaunay::Mirror final : public Delaunay::MirrorBase, private Delaunay::Rows<Kernel> {
  using Base = Delaunay::Rows<Kernel>;
  using typename Base::FaceHandle;
  using typename Base::Triangulation;
  using typename Base::VertexHandle;
  using Point = typename Kernel::Point_2;
  using Base::d_;
  using Base::expect_row;
  using Base::old_rows_;
  using Base::row_of;
  using Base::site_of;
  using Base::triangulation_;
  using Base::vertex_;
  using Base::zone_;

 public:
  explicit Mirror(Delaunay& owner) : Base(owner) {}

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
      Base::mirror_all();
    } else if (d_.dimension_ == 1) {
      Base::mirror_chain();
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
    if (!is_alone(sample, site)) {
      d_.detach_sample(sample);
      d_.site_recorder_.note(site, true);
      return insert_at(sample, p, vertex_[site]->face(), SiteSlot());
    }
    if (move_in_star(site, p)) return true;
    d_.detach_sample(sample);
    if (!remove_site(site)) return false;
    return insert_at(sample, p, last_face_, site);
  }

  // Where no triangle turns over, sites may be moved all at once, and flips restore the Delaunay property. Inside a
  // group that moves as a whole nothing changes then; moved one by one, each site would be far from all its neighbours
  // for a while. A site at which a triangle would turn over is taken out first; the caller puts it back when the others
  // have arrived. The hull stays where it is, so triangles that all turn left cover its inside once.
  bool move_together(const std::vector<SampleSlot>& samples, JobControl& job) override {
    list_movers(samples);
    if (!take_out_what_turns_over(job)) return false;
    zone_.clear();
    suspects_.clear();
    const std::uint32_t in_zone = d_.new_mark();
    for (const Mover& mover : movers_) {
      if (mover.is_out) continue;
      const VertexHandle v = vertex_[mover.site];
      v->info().mover = kNoSlot;
      v->set_point(mover.target);
      d_.site_position_[mover.site] = {mover.target.x(), mover.target.y()};
      d_.site_recorder_.note(mover.site, true);
      auto face = triangulation_.incident_faces(v);
      const auto end = face;
      do {
        FaceRow& row = d_.face_[row_of(face)];
        if (row.mark == in_zone) continue;
        row.mark = in_zone;
        zone_.push_back(face);
        for (int k = 0; k < 3; ++k) suspects_.push_back({face, k});
      } while (++face != end);
    }
    if (zone_.empty()) return true;
    // Sliding along another part of the curve takes one flip for each sample passed.
    if (!flip_suspects(in_zone, 1000 + d_.face_.size() / 2)) return false;
    mirror_flipped_zone();
    return true;
  }

 private:
  struct Mover {
    SampleSlot sample;
    SiteSlot site;
    Point target;
    bool is_pending = true;  ///< its triangles have yet to be checked
    bool is_out = false;
  };

  /// Samples that lie together. Their sites have rows of their own, one per sample from `first_site` on, so that parts
  /// can be made in parallel. Duplicates leave rows free.
  struct Part {
    std::vector<SampleSlot> samples;
    SiteSlot first_site{0};
    Triangulation triangulation;
    SweepOrder before;  ///< order of the cut that has this part on its far side
  };

  Vec2 position_of(SampleSlot sample) const { return d_.samples_.position(sample); }

  // Many samples are cut into parts, whose triangulations are made in parallel and stitched. The number of parts
  // depends on the number of samples alone, so that the result does not depend on the machine. Small parts stay in the
  // caches, but need more stitching: along a curve, it changes most of the edges.
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
    auto order = insertion_order(part.samples, d_.samples_.extent(),
                                 [this](SampleSlot sample) { return position_of(sample); });
    leave_line_early(
        order, [this](const Keyed<SampleSlot>& item) { return position_of(item.slot); }, orientation, SweepOrder{});
    // This order is not that of the rows: scattered data is read and written apart from the triangulation, so that no
    // step waits for it.
    std::vector<Vec2> positions;
    positions.reserve(order.size());
    for (const Keyed<SampleSlot>& item : order) positions.push_back(position_of(item.slot));
    std::vector<SiteSlot> sites;
    sites.reserve(order.size());
    FaceHandle hint;
    SiteSlot site = part.first_site;
    for (const Vec2 p : positions) {
      if ((sites.size() & 1023U) == 1023U) job.checkpoint(sites.size(), order.size());
      const VertexHandle v = part.triangulation.insert(Point(p.x, p.y), hint);
      hint = v->face();
      if (v->info().slot == kNoSlot) {
        v->info().slot = site;
        vertex_[site] = v;
        d_.site_position_[site] = p;
        ++site;
      }
      sites.push_back(v->info().slot);
    }
    for (std::size_t i = 0; i < order.size(); ++i) d_.attach_sample(order[i].slot, sites[i]);
  }

  void join(Part& part, Part& far, JobControl& job) {
    if (part.triangulation.dimension() == 2 && far.triangulation.dimension() == 2) {
      DelaunayStitch<Triangulation>::run(part.triangulation, far.triangulation, far.before);
      return;
    }
    // A collinear part has no sides to be stitched at: its sites become vertices of the other triangulation.
    if (part.triangulation.dimension() < far.triangulation.dimension()) {
      part.triangulation.swap(far.triangulation);
      part.samples.swap(far.samples);
    }
    // The other part may be collinear as well. If it lies on another line, and the sites came in order along theirs, each
    // would take the edges of the one before.
    auto order =
        insertion_order(far.samples, d_.samples_.extent(), [this](SampleSlot sample) { return position_of(sample); });
    const std::size_t count = part.samples.size() + far.samples.size();
    const auto position = [&](std::size_t i) {
      const bool is_far = i >= part.samples.size();
      return position_of(is_far ? far.samples[i - part.samples.size()] : part.samples[i]);
    };
    if (part.triangulation.dimension() < 2 && count_on_line(count, position, orientation) == count)
      sort_along(order, far.before);
    FaceHandle hint;
    std::uint64_t done = 0;
    for (const Keyed<SampleSlot>& item : order) {
      if ((++done & 1023U) == 0) job.checkpoint(done, order.size());
      const SiteSlot site = d_.site_of_sample_[item.slot];
      const Vec2 p = d_.site_position_[site];
      const VertexHandle v = part.triangulation.insert(Point(p.x, p.y), hint);
      v->info().slot = site;
      vertex_[site] = v;
      hint = v->face();
    }
    part.samples.insert(part.samples.end(), far.samples.begin(), far.samples.end());
  }

  void sort_along(std::vector<Keyed<SampleSlot>>& order, SweepOrder before) const {
    std::ranges::stable_sort(order, [&](const Keyed<SampleSlot>& a, const Keyed<SampleSlot>& b) {
      return before(position_of(a.slot), position_of(b.slot));
    });
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

  // `reuse` is the row of a site that has just been taken out for a move, or kNoSlot.
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
    // CGAL inserts by splitting one face and flipping: the changed faces are the star of the new vertex, which contains
    // every face of the old zone.
    zone_.clear();
    old_rows_.clear();
    collect_star(v);
    for (const FaceHandle f : zone_)
      if (row_of(f) != kNoSlot) old_rows_.push_back(row_of(f));
    Base::mirror_zone();
    last_face_ = v->face();
    return true;
  }

  // Takes the vertex out of the triangulation; the caller keeps the site's row.
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
    Base::mirror_zone();
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
    flip_suspects(in_zone, ~std::size_t{0});
    mirror_flipped_zone();
    return true;
  }

  // Lawson's flips; flipped faces join the zone. An entry may be stale after a flip; testing another edge instead does
  // no harm, because a flip puts all edges of both faces on the stack again. False, with the work left undone, after
  // `most` flips.
  bool flip_suspects(std::uint32_t in_zone, std::size_t most) {
    std::size_t flips = 0;
    while (!suspects_.empty()) {
      const auto [f, i] = suspects_.back();
      suspects_.pop_back();
      const FaceHandle g = f->neighbor(i);
      if (triangulation_.is_infinite(f) || triangulation_.is_infinite(g)) continue;
      const VertexHandle across = g->vertex(g->index(f));
      if (triangulation_.side_of_oriented_circle(f, across->point(), true) != CGAL::ON_POSITIVE_SIDE) continue;
      if (++flips > most) return false;
      triangulation_.flip(f, i);
      for (const FaceHandle h : {f, g}) {
        FaceRow& row = d_.face_[row_of(h)];
        if (row.mark != in_zone) zone_.push_back(h);
        row.mark = in_zone;
        for (int k = 0; k < 3; ++k) suspects_.push_back({h, k});
      }
    }
    return true;
  }

  // After flips, the faces of the zone keep their rows.
  void mirror_flipped_zone() {
    old_rows_.clear();
    for (const FaceHandle f : zone_) old_rows_.push_back(row_of(f));
    Base::mirror_zone();
    last_face_ = zone_.front();
  }

  // Lists sites that have one sample and are not on the hull.
  void list_movers(const std::vector<SampleSlot>& samples) {
    movers_.clear();
    for (const SampleSlot sample : samples) {
      const SiteSlot site = d_.site_of_sample(sample);
      if (site == kNoSlot || !is_alone(sample, site)) continue;
      const Vec2 target = position_of(sample);
      if (d_.site_position_[site] == target || is_on_hull(vertex_[site])) continue;
      vertex_[site]->info().mover = movers_.next();
      movers_.push_back({sample, site, Point(target.x, target.y)});
    }
  }

  bool take_out_what_turns_over(JobControl& job) {
    std::vector<MoverSlot> pending(movers_.rows().begin(), movers_.rows().end());
    for (std::size_t next = 0; next < pending.size(); ++next) {
      if ((next & 255U) == 255U) job.checkpoint();
      const MoverSlot slot = pending[next];
      Mover& mover = movers_[slot];
      mover.is_pending = false;
      const VertexHandle v = vertex_[mover.site];
      if (!would_turn_over(v)) continue;
      auto other = triangulation_.incident_vertices(v);
      const auto end = other;
      do {
        const MoverSlot beside = other->info().mover;
        if (beside == kNoSlot || movers_[beside].is_pending) continue;
        movers_[beside].is_pending = true;
        pending.push_back(beside);
      } while (++other != end);
      mover.is_out = true;
      d_.detach_sample(mover.sample);
      if (!remove_site(mover.site) || d_.is_too_much()) return false;
      release_site(mover.site);
    }
    return true;
  }

  const Point& target_of(VertexHandle v) const {
    const MoverSlot mover = v->info().mover;
    return mover == kNoSlot ? v->point() : movers_[mover].target;
  }
  bool would_turn_over(VertexHandle v) const {
    const auto orientation = triangulation_.geom_traits().orientation_2_object();
    auto face = triangulation_.incident_faces(v);
    const auto end = face;
    do {
      if (orientation(target_of(face->vertex(0)), target_of(face->vertex(1)), target_of(face->vertex(2))) !=
          CGAL::LEFT_TURN)
        return true;
    } while (++face != end);
    return false;
  }
  bool is_on_hull(VertexHandle v) const {
    auto face = triangulation_.incident_faces(v);
    const auto end = face;
    do {
      if (triangulation_.is_infinite(face)) return true;
    } while (++face != end);
    return false;
  }
  bool is_alone(SampleSlot sample, SiteSlot site) const {
    return d_.site_sample_[site] == sample && d_.next_duplicate_[sample] == kNoSlot;
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

  LocationHints hints_;
  FaceHandle last_face_;

  // Work space of one edit, kept to save allocations.
  std::vector<std::pair<FaceHandle, int>> rim_;
  std::vector<std::pair<FaceHandle, int>> suspects_;
  Table<MoverSlot, Mover> movers_;
  std::size_t taken_rows_ = 0;
};

}  // namespace mes
