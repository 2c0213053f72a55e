// SPDX-License-Identifier: GPL-3.0-or-later
// Moves nodes to their equilibrium between edges and a given stiffness. Private to core/raster.
//
// Settled parts stay untouched: edges are placed again only beside chords that have moved, equations are solved only
// for nodes near a change, and windows of edges are checked only if any edge in them has changed.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/raster/internal/fitting/curvature.h"
#include "core/raster/internal/fitting/node_curve.h"
#include "core/raster/internal/fitting/residual_windows.h"
#include "core/raster/internal/fitting/run_fit.h"
#include "core/raster/internal/fitting/stiff_system.h"

namespace mes {

/// The position of an edge relative to the curve.
struct Placed {
  double t = 0.0;
  double offset = 0.0;  // distance from the curve to the edge
  double weight = 0.0;
  double jumps = 0.0;  // pixel borders, or diagonals, that the curve crosses for each pixel of its length
  std::uint32_t chord = 0;
};

/// A run, its edges, and cached state between rounds.
class Settling {
 public:
  /// Starts from nodes at the finest distance; `begin_evenly` selects some of them.
  Settling(std::vector<Vec2> fine, bool is_closed, double blur, std::span<const Edge> edges, const EdgeNoise& noise,
           const JobControl* job);
  /// Starts from a fitted run.
  Settling(Run run, std::span<const Edge> edges, const EdgeNoise& noise, const JobControl* job);

 protected:
  std::size_t chord_count() const { return run_.is_closed ? run_.nodes.size() : run_.nodes.size() - 1; }
  std::size_t next(std::size_t k) const { return k + 1 < run_.nodes.size() ? k + 1 : 0; }
  std::size_t cells_of(std::size_t chord) const;
  double cell_size() const { return length_ / static_cast<double>(cells_); }
  double apart(std::size_t chord) const { return cell_size() * static_cast<double>(cells_of(chord)); }
  /// The length of the shorter chord at a node.
  double least_apart(std::size_t k) const;
  /// Largest stiffness. For a closed run, nine tenths of its radius as a circle: it may still be an ellipse. On a
  /// nearly exact circle any sample could become an end of the axis.
  double stiffest() const { return run_.is_closed ? length_ / 7.0 : 2.0 * length_; }
  /// Limits the growth of the stiffness along the curve to the distance.
  void limit_growth(std::vector<double>& stiffness) const;
  /// Selects nodes `apart` cells apart.
  void begin_evenly(std::size_t apart);
  /// Places the edges beside changed chords; returns whether there were any.
  bool place();
  /// Makes one Gauss-Newton step, and repeats it `times` - 1 times for the residual: so bends shrink less, and only few
  /// more waves pass. Offsets are small, so all of this is linear. Inactive nodes stay.
  void step(int times);
  /// Fits at the current stiffness of the nodes.
  void settle();
  /// Fits again from all edges.
  void settle_all();
  /// Marks chords in windows whose mean exceeds the noise, and beside stray nodes, which restart.
  bool find_misfits();
  /// Whether a node is far from the starting curve, or NaN.
  bool is_astray(std::size_t node) const;
  /// Halves the node distance at the given chords, and beside them so that a chord and each of the next two differ in
  /// length by at most a factor of two.
  void remesh(std::vector<char> split, bool are_fine);
  /// The largest distance of an edge from its chord, pixels.
  double farthest();

  // Doubles do not distinguish stiffnesses beyond this many node distances.
  static constexpr double kMostNodes = 32.0;

  Run run_;
  std::vector<Vec2> fine_;  // nodes of the starting curve at the finest distance
  std::size_t cells_ = 0;   // length in finest distances
  std::span<const Edge> edges_;
  EdgeNoise noise_;
  const JobControl* job_;
  double length_ = 0.0;
  double blur_ = 0.0;                // in square pixels, for blurred edges
  std::vector<std::uint32_t> home_;  // by edge: its cell
  NodeCurve curve_;
  std::vector<char> is_stale_;  // by chord: it has changed since edges were placed beside it
  std::vector<char> misfits_;   // by chord: the residuals beside it exceed noise
  std::vector<Placed> placed_;
  CalmCurvature calm_;  // target; deviations cost, most at level nodes; empty: any change costs

 private:
  /// Squared distances of the edges beside a chord, as a quadratic form of the offsets of its two nodes.
  struct Sums {
    double here = 0.0;
    double both = 0.0;
    double there = 0.0;
    double right = 0.0;
    double next_right = 0.0;
  };
  /// Successive nodes, cyclic if the run is closed.
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
  /// Finds nodes near a change: nothing moves farther away than a multiple of the stiffness.
  std::vector<Stretch> find_active();
  void solve(const Stretch& stretch, int times);
  /// Marks the chords that change when a node moves.
  void make_stale(std::size_t node);
  /// Adds the penalty between the node after `before` and the next; `first` is the unknown of `before`.
  void add_penalty(StiffSystem& system, std::ptrdiff_t first, std::size_t before) const;
  /// Moves stray nodes back to their start; true if there were any.
  bool call_back();
  /// Finds isolated edges of single pixels that deviate from the curve.
  bool find_alone();

  std::vector<std::uint32_t> chord_of_;  // by cell
  bool is_remeshed_ = true;
  std::vector<char> was_stale_;    // by chord: edges were placed beside it again
  std::vector<double> solved_;     // by node: stiffness at its last move
  std::vector<char> is_active_;    // by node: it moves now
  std::vector<double> offsets_;    // offsets by node
  std::vector<char> has_changed_;  // by edge, since the last check of windows
  std::vector<Sums> sums_;
  std::vector<char> is_alone_;
  std::vector<Residual> residuals_;
  std::vector<ResidualSum> window_sums_;
  std::vector<double> reach_;
  StiffSystem system_;
};

/// Positions, in nodes, of edges given in the order of the curve.
std::vector<double> walked(std::span<const Vec2> nodes, bool is_closed, std::span<const Edge> edges);

}  // namespace mes
