// SPDX-License-Identifier: GPL-3.0-or-later
// Mirrors the faces of a CGAL triangulation to the rows of `Delaunay`. Private to delaunay.cpp.
#pragma once

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

#include "core/base/jobs/keep_memory.h"
#include "core/base/jobs/parallel.h"
#include "core/base/jobs/prefetch.h"
#include "core/kernel/circumcircle.h"
#include "core/structures/delaunay/delaunay.h"

namespace mes {

/// Sets the circumcircle of a face with these corners; does nothing if one of them is at infinity.
inline void set_circumcircle(FaceRow& row, const Vec2 (&corner)[3]) {
  if (row.is_infinite()) return;
  // Beginning at the smallest corner makes the doubles independent of the triangle's history.
  int first = lexicographically_less(corner[1], corner[0]) ? 1 : 0;
  if (lexicographically_less(corner[2], corner[first])) first = 2;
  const Circle circle = circumcircle(corner[first], corner[next3(first)], corner[prev3(first)]);
  row.center = circle.center;
  row.radius = circle.radius;
}

/// Row of a CGAL face; new ones have none.
struct MirroredFace {
  FaceSlot slot;
};

/// A site that is moved together with others.
using MoverSlot = Slot<struct MoverTag>;

/// Row of a CGAL vertex; new ones have none.
struct MirroredVertex {
  SiteSlot slot;
  MoverSlot mover;  ///< set while it is moved together with others
};

/// The central step is `mirror_zone`: given the CGAL faces that an edit changed, and the rows of those faces and of
/// their dead predecessors, it rewrites the rows. Rows of edges on the rim of the zone are kept; all others of the old
/// zone are given to the new inner edges, so edits allocate nothing in the long run.
template <class Kernel>
class Delaunay::Rows {
 protected:
  using Vertex = CGAL::Triangulation_vertex_base_with_info_2<MirroredVertex, Kernel>;
  using Face = CGAL::Triangulation_face_base_with_info_2<MirroredFace, Kernel>;
  using Triangulation = CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertex, Face>>;
  using VertexHandle = typename Triangulation::Vertex_handle;
  using FaceHandle = typename Triangulation::Face_handle;
  using FaceIterator = typename Triangulation::Triangulation_data_structure::Face_iterator;

  explicit Rows(Delaunay& owner) : d_(owner) {}

  static SiteSlot site_of(VertexHandle v) { return v->info().slot; }
  static FaceSlot row_of(FaceHandle f) { return f->info().slot; }
  void expect_row(FaceHandle f) const {
    if (row_of(f) != kNoSlot) prefetch(d_.face_.address(row_of(f)));
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
    // Rim: the edge stays, its inner side is new.
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

  // Each row and each of its fields is written by one thread.
  void mirror_all() {
    const std::size_t count = triangulation_.tds().number_of_faces();
    // Faces lie in the triangulation in the order of their rows. `starts` holds the first face of each chunk.
    std::vector<FaceIterator> starts;
    const auto number_faces = [&] {
      starts.reserve(chunk_count(count));
      FaceSlot row(0);
      for (auto f = triangulation_.tds().faces_begin(); f != triangulation_.tds().faces_end(); ++f, ++row) {
        if (row.index() == first_of_chunk(count, starts.size())) starts.push_back(f);
        f->info().slot = row;
      }
    };
    const auto read_chunk = [&starts, end = triangulation_.tds().faces_end()](std::size_t, std::size_t chunk) {
      FaceIterator ahead = starts[chunk];
      for (int i = 0; i < kFacesAhead && ahead != end; ++i) ++ahead;
      return [f = starts[chunk], ahead, end]() mutable {
        if (ahead != end) expect_topology_of(ahead++);
        return topology_of(f++);
      };
    };
    const auto read_placed_chunk = [&starts](std::size_t, std::size_t chunk) {
      return [f = starts[chunk]]() mutable { return placed_topology_of(f++); };
    };
    if (!d_.forgoes_updates()) {
      make_room(count, number_faces);
      find_faces_of_sites();
      make_edges(fill_faces(read_placed_chunk));
      return;
    }
    // No edit will use the triangulation again. It is larger than the rows, so it is freed before they are made.
    number_faces();
    find_faces_of_sites();
    vertex_ = {};
    std::vector<Topology> kept(count);
    parallel_for(count, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
      auto next = read_chunk(begin, chunk);
      for (std::size_t i = begin; i < end; ++i) kept[i] = next();
    });
    triangulation_.clear();
    give_freed_memory_back();
    d_.face_.resize(count);
    const std::vector<std::size_t> first_edge = fill_faces([&kept](std::size_t begin, std::size_t) {
      return [at = kept.begin() + static_cast<std::ptrdiff_t>(begin)]() mutable { return *at++; };
    });
    std::vector<Topology>().swap(kept);  // assigning {} would keep the memory
    make_edges(first_edge);
  }

  // Makes room for the rows while another core runs `task`. The system clears each page at the first write, which takes
  // several times as long as filling it; all cores share this work.
  template <class Task>
  void make_room(std::size_t faces, Task task) {
    constexpr std::size_t kFacesAtOnce = std::size_t{1} << 15U;
    const std::size_t edges = faces / 2 * 3;  // includes those to infinity
    const std::size_t pieces = faces / kFacesAtOnce;
    d_.face_.reserve(faces);
    d_.edge_.reserve(edges);
    run_tasks(pieces + 1, [&](std::size_t i) {
      if (i == 0) return task();
      touch_pages(d_.face_, faces * (i - 1) / pieces, faces * i / pieces);
      touch_pages(d_.edge_, edges * (i - 1) / pieces, edges * i / pieces);
    });
    d_.face_.resize(faces);
    d_.edge_.resize(edges);
  }

  // Writes to the pages of rows that do not exist yet.
  template <class Row, class Value>
  static void touch_pages(const Table<Row, Value>& table, std::size_t begin, std::size_t end) {
    constexpr std::size_t kPage = 4096;
    auto* at = static_cast<volatile char*>(const_cast<void*>(static_cast<const void*>(table.address(Row(begin)))));
    const std::size_t bytes = (end - begin) * sizeof(Value);
    for (std::size_t i = 0; i < bytes; i += kPage) at[i] = 0;
  }

  /// Corners and neighbours of a face in a triangulation, as rows.
  struct Topology {
    SiteSlot v[3]{};
    FaceSlot n[3]{};
  };
  static SiteSlot corner_of(VertexHandle v) { return v->info().slot == kNoSlot ? kInfiniteSite : v->info().slot; }
  static void expect_topology_of(FaceHandle f) {
    for (int i = 0; i < 3; ++i) {
      prefetch(&f->vertex(i)->info());
      prefetch(&f->neighbor(i)->info());
    }
  }
  static constexpr int kFacesAhead = 8;
  static Topology topology_of(FaceHandle f) {
    Topology out;
    for (int i = 0; i < 3; ++i) {
      out.v[i] = corner_of(f->vertex(i));
      out.n[i] = row_of(f->neighbor(i));
    }
    return out;
  }

  /// Adds the positions of the corners, which lie beside their rows; the corner at infinity has none.
  struct PlacedTopology : Topology {
    Vec2 position[3]{};
  };
  static PlacedTopology placed_topology_of(FaceHandle f) {
    PlacedTopology out{topology_of(f)};
    for (int i = 0; i < 3; ++i)
      if (out.v[i] != kInfiniteSite) out.position[i] = {f->vertex(i)->point().x(), f->vertex(i)->point().y()};
    return out;
  }

  // `reader(first, chunk)` returns a function that yields the topology of one face after the other, with or without
  // positions. Returns the first row of the edges that each chunk makes, and the number of edges.
  template <class Reader>
  std::vector<std::size_t> fill_faces(Reader reader) {
    const std::size_t count = d_.face_.size();
    std::vector<std::size_t> first_edge(chunk_count(count) + 1, 0);
    parallel_for(count, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
      auto next = reader(begin, chunk);
      // A local count, since counting in place would make threads take a cache line from each other all the time.
      std::size_t edges = 0;
      for (const FaceSlot face : slots_between<FaceSlot>(begin, end)) {
        FaceRow& row = d_.face_[face];
        const auto topology = next();
        std::ranges::copy(topology.v, row.v);
        std::ranges::copy(topology.n, row.n);
        if constexpr (requires { topology.position; }) {
          set_circumcircle(row, topology.position);
        } else {
          d_.compute_circumcircle(face);
        }
        for (int i = 0; i < 3; ++i) edges += owns_edge(face, i) ? 1U : 0U;
      }
      first_edge[chunk + 1] = edges;
    });
    for (std::size_t chunk = 1; chunk < first_edge.size(); ++chunk) first_edge[chunk] += first_edge[chunk - 1];
    return first_edge;
  }

  void make_edges(const std::vector<std::size_t>& first_edge) {
    d_.edge_.resize(first_edge.back());
    parallel_for(d_.face_.size(), [&](std::size_t begin, std::size_t end, std::size_t chunk) {
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
  }

  void find_faces_of_sites() {
    parallel_for(d_.site_rows(), [&](std::size_t begin, std::size_t end, std::size_t) {
      for (const SiteSlot site : slots_between<SiteSlot>(begin, end))
        if (d_.is_site(site)) d_.site_face_[site] = row_of(vertex_[site]->face());
    });
  }

  // The face with the larger row makes the row of a finite edge.
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

  // State of one edit, kept to save allocations.
  std::vector<FaceHandle> zone_;
  std::vector<FaceSlot> old_rows_;

 private:
  std::vector<EdgeSlot> old_edges_;
};

}  // namespace mes
