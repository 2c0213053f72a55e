// SPDX-License-Identifier: GPL-3.0-or-later
// Nodes that move to where edges pull them, at a given stiffness. Private to core/raster.
//
// What has not changed since it came to rest is left alone: edges are placed again beside chords that have moved, equations
// are solved for nodes near to a change, and windows of edges are looked at where any edge has changed.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/raster/internal/curvature.h"
#include "core/raster/internal/node_curve.h"
#include "core/raster/internal/residual_windows.h"
#include "core/raster/internal/run_fit.h"
#include "core/raster/internal/stiff_system.h"

namespace mes {

/// An edge beside a curve of nodes.
struct Placed {
  double t = 0.0;
  double offset = 0.0;  // from the curve to the edge
  double weight = 0.0;
  double jumps = 0.0;  // pixel borders that the curve passes for each pixel of its length, or diagonals of them
  std::uint32_t chord = 0;
};

/// A run, its edges, and what is known of both from round to round.
class Settling {
 public:
  /// From nodes at the finest distance, of which `begin_evenly` takes some.
  Settling(std::vector<Vec2> fine, bool is_closed, double blur, std::span<const Edge> edges, const EdgeNoise& noise,
           const JobControl* job);
  /// From a run that was fitted.
  Settling(Run run, std::span<const Edge> edges, const EdgeNoise& noise, const JobControl* job);

 protected:
  std::size_t chord_count() const { return run_.is_closed ? run_.nodes.size() : run_.nodes.size() - 1; }
  std::size_t next(std::size_t k) const { return k + 1 < run_.nodes.size() ? k + 1 : 0; }
  std::size_t cells_of(std::size_t chord) const;
  double cell_size() const { return length_ / static_cast<double>(cells_); }
  double apart(std::size_t chord) const { return cell_size() * static_cast<double>(cells_of(chord)); }
  /// The length of the shorter chord at a node.
  double least_apart(std::size_t k) const;
  /// Of a closed run nine tenths of the radius that it would have as a circle: it may still be an ellipse. Were it a circle
  /// up to rounding, each of its samples could be an end of the axis.
  double stiffest() const { return run_.is_closed ? length_ / 7.0 : 2.0 * length_; }
  /// Stiffness grows by no more than the way.
  void limit_growth(std::vector<double>& stiffness) const;
  /// Nodes so many cells apart.
  void begin_evenly(std::size_t apart);
  /// Where the edges are beside the chords that have changed; whether any have.
  bool place();
  /// One step of Gauss and Newton; and so often again what it has left out: so a bend loses little of itself, and waves
  /// little more are let through. Offsets are small, so that all of it is linear. Nodes that are not active stay.
  void step(int times);
  /// The fit at the stiffness that the nodes have.
  void settle();
  /// Settles from all edges anew.
  void settle_all();
  /// Chords within windows whose mean is more than noise, and beside nodes that went astray, which begin again.
  bool find_misfits();
  /// Far from the curve that the fit starts from, or nowhere.
  bool is_astray(std::size_t node) const;
  /// Nodes half as far from each other where that is said, and beside it so that no two chords are followed by one of more
  /// than twice their length.
  void remesh(std::vector<char> split, bool are_fine);
  /// The largest distance of an edge from its chord, pixels.
  double farthest();

  // Doubles do not distinguish stiffnesses of more than so many distances between nodes.
  static constexpr double kMostNodes = 32.0;

  Run run_;
  std::vector<Vec2> fine_;  // nodes at the finest distance, of the curve that the fit starts from
  std::size_t cells_ = 0;   // finest distances
  std::span<const Edge> edges_;
  EdgeNoise noise_;
  const JobControl* job_;
  double length_ = 0.0;
  double blur_ = 0.0;                // square pixels, of edges that are blurred
  std::vector<std::uint32_t> home_;  // of edges: the cell beside which they are
  NodeCurve curve_;
  std::vector<char> is_stale_;  // of chords: they have changed since edges were placed beside them
  std::vector<char> misfits_;   // of chords: beside them is more than noise
  std::vector<Placed> placed_;
  CalmCurvature calm_;  // its changes cost nothing; others cost most where it is level; empty: no change is free

 private:
  /// Squares of what edges beside a chord are off by, as a form of the offsets of its two nodes.
  struct Sums {
    double here = 0.0;
    double both = 0.0;
    double there = 0.0;
    double right = 0.0;
    double next_right = 0.0;
  };
  /// Nodes in a row, around if the run is closed.
  struct Stretch {
    std::size_t first = 0;
    std::size_t count = 0;
  };

  void look() const {
    if (job_ != nullptr && job_->stop_requested()) throw Cancelled{};
  }
  std::uint32_t cell_at(double along) const {
    return static_cast<std::uint32_t>(std::min(static_cast<std::size_t>(along), cells_ - 1));
  }
  void begin();
  void note_chords();
  Placed beside(const Edge& edge, std::size_t at) const;
  /// Nodes near to what has changed: farther away than so many times the stiffness nothing moves.
  std::vector<Stretch> find_active();
  void solve(const Stretch& stretch, int times);
  /// The chords that bend otherwise when a node moves.
  void make_stale(std::size_t node);
  /// From the curvature at the node after `before` to that at the next, of unknowns that begin with `before` as `first`.
  void add_penalty(StiffSystem& system, std::ptrdiff_t first, std::size_t before) const;
  /// Moves nodes that went astray to where they began; true if there were any.
  bool call_back();
  /// Edges of single pixels that stand out from the curve or into it.
  bool find_alone();

  std::vector<std::uint32_t> chord_of_;  // of cells
  bool is_remeshed_ = true;
  std::vector<char> was_stale_;    // of chords: edges were placed beside them anew
  std::vector<double> solved_;     // the stiffness of nodes when they were moved last
  std::vector<char> is_active_;    // of nodes: they are moved
  std::vector<double> offsets_;    // of nodes
  std::vector<char> has_changed_;  // of edges, since windows were looked at
  std::vector<Sums> sums_;
  std::vector<char> is_alone_;
  std::vector<Residual> residuals_;
  std::vector<ResidualSum> window_sums_;
  std::vector<double> reach_;
  StiffSystem system_;
};

/// Where edges in the order of a curve are along it, in nodes.
std::vector<double> walked(std::span<const Vec2> nodes, bool is_closed, std::span<const Edge> edges);

}  // namespace mes
