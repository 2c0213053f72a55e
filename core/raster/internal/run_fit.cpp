// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/raster/internal/run_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <utility>

#include "core/raster/internal/residual_windows.h"
#include "core/raster/internal/stiff_system.h"

namespace mes {
namespace {

// Beyond so many distances of nodes a stiffness is no longer told from a larger one in doubles.
constexpr double kMostNodes = 32.0;
constexpr std::size_t kLeastChordsClosed = 16;
constexpr std::size_t kLeastChordsOpen = 5;
constexpr double kCoarsest = 16.0;  // pixels between nodes
constexpr int kTimes = 3;           // the curve, and twice what it has left out

double size_of(Vec2 v) {
  return std::sqrt(dot(v, v));  // pixels neither overflow nor vanish
}

/// What lies between two nodes: the parabola that is nearest to the circle with their mean curvature.
struct Chord {
  Vec2 from{};
  Vec2 along{};  // of length one
  double size = 0.0;
  double bulge = 0.0;  // the tangent of a quarter of the turn, to the left
  double bend = 0.0;   // curvature at both ends
  double next_bend = 0.0;

  /// How far the curve lies to the left of the chord.
  double beside(double t) const { return -2.0 * t * (1.0 - t) * size * bulge; }
  Vec2 at(double t) const { return from + (t * size) * along + beside(t) * perpendicular(along); }
};

/// A curve of nodes.
class Frame {
 public:
  Frame() = default;
  Frame(std::span<const Vec2> nodes, bool is_closed)
      : is_closed_(is_closed), chords_(is_closed ? nodes.size() : nodes.size() - 1), bends_(nodes.size()) {
    renew(nodes, 0, nodes.size());
  }

  /// After so many nodes in a row have moved, around if it is closed.
  void renew(std::span<const Vec2> nodes, std::size_t first, std::size_t moved) {
    const auto each = [&](std::size_t before, std::size_t after, std::size_t size, auto use) {
      const std::size_t all = moved + before + after;
      if (!is_closed_) {
        for (std::size_t k = first - std::min(first, before); k < std::min(first + moved + after, size); ++k) use(k);
      } else {
        std::size_t k = (first + size - before % size) % size;
        for (std::size_t i = 0; i < std::min(all, size); ++i, k = k + 1 < size ? k + 1 : 0) use(k);
      }
    };
    const std::size_t count = nodes.size();
    each(1, 0, chords_.size(), [&](std::size_t k) {
      Chord& chord = chords_[k];
      const Vec2 along = nodes[k + 1 < count ? k + 1 : 0] - nodes[k];
      chord.from = nodes[k];
      chord.size = size_of(along);
      chord.along = chord.size > 0.0 ? (1.0 / chord.size) * along : Vec2{};
    });
    each(1, 1, count, [&](std::size_t k) {
      if (!is_closed_ && (k == 0 || k + 1 == count)) return;
      const Chord& in = before(k);
      const Chord& on = chords_[k];
      // Of the circle through the node and its neighbours.
      const double across = size_of(in.size * in.along + on.size * on.along);
      bends_[k] = across > 0.0 ? 2.0 * cross(in.along, on.along) / across : 0.0;
    });
    if (!is_closed_) {
      bends_.front() = bends_[1];
      bends_.back() = bends_[count - 2];
    }
    each(3, 3, chords_.size(), [&](std::size_t k) {
      Chord& chord = chords_[k];
      chord.bend = bends_[k];
      chord.next_bend = bends_[k + 1 < count ? k + 1 : 0];
      const double sine = std::clamp(0.25 * (chord.bend + chord.next_bend) * chord.size, -1.0, 1.0);
      constexpr double kMostBulge = 0.4;
      chord.bulge = std::clamp(sine / (1.0 + std::sqrt(1.0 - sine * sine)), -kMostBulge, kMostBulge);
    });
  }

  const std::vector<Chord>& chords() const { return chords_; }
  double curvature(std::size_t k) const { return bends_[k]; }
  /// Of the circle through the node and its neighbours; at both ends of an open curve of the chord.
  Vec2 normal(std::size_t k) const {
    if (!is_closed_ && k == 0) return perpendicular(chords_.front().along);
    if (!is_closed_ && k == chords_.size()) return perpendicular(chords_.back().along);
    const Vec2 along = chords_[k].size * before(k).along + before(k).size * chords_[k].along;
    return (1.0 / std::max(size_of(along), 1e-12)) * perpendicular(along);
  }

 private:
  const Chord& before(std::size_t k) const { return chords_[k > 0 ? k - 1 : chords_.size() - 1]; }

  bool is_closed_ = false;
  std::vector<Chord> chords_;
  std::vector<double> bends_;  // curvature at the nodes, to the left
};

/// An edge beside a frame.
struct Placed {
  double t = 0.0;
  double offset = 0.0;  // from the curve to the edge
  double weight = 0.0;
  double jumps = 0.0;  // pixel borders that the curve passes for each pixel of its length, or diagonals of them
  std::uint32_t chord = 0;
};

double length_of(std::span<const Vec2> nodes, bool is_closed) {
  double out = 0.0;
  for (std::size_t k = 1; k < nodes.size(); ++k) out += size_of(nodes[k] - nodes[k - 1]);
  return is_closed ? out + size_of(nodes.front() - nodes.back()) : out;
}

/// Where edges in the order of a curve are along it, in nodes.
std::vector<double> walked(std::span<const Vec2> nodes, bool is_closed, std::span<const Edge> edges) {
  std::vector<double> out;
  if (edges.empty()) return out;
  out.reserve(edges.size());
  const std::size_t chords = is_closed ? nodes.size() : nodes.size() - 1;
  const auto next = [&](std::size_t k) { return k + 1 < nodes.size() ? k + 1 : 0; };
  const auto to_first = [&](Vec2 q) { return dot(q - edges.front().at, q - edges.front().at); };
  std::size_t chord = 0;
  if (is_closed) chord = static_cast<std::size_t>(std::ranges::min_element(nodes, {}, to_first) - nodes.begin());
  // The next edge is about a share of a chord farther.
  const double share = static_cast<double>(chords) / static_cast<double>(edges.size());
  const int most = static_cast<int>(std::ceil(share)) + 3;
  for (const Edge& edge : edges) {
    bool was_forward = false;
    double passed = 0.0;
    double square = 0.0;
    for (int steps = most;; --steps) {
      const Vec2 along = nodes[next(chord)] - nodes[chord];
      square = dot(along, along);
      passed = square > 0.0 ? dot(edge.at - nodes[chord], along) : 0.5;
      if (steps <= 0) break;
      if (passed > square && (is_closed || chord + 1 < chords)) {
        chord = chord + 1 < chords ? chord + 1 : 0;
        was_forward = true;
      } else if (passed < 0.0 && !was_forward && (is_closed || chord > 0)) {
        chord = chord > 0 ? chord - 1 : chords - 1;
      } else {
        break;
      }
    }
    out.push_back(static_cast<double>(chord) + std::clamp(square > 0.0 ? passed / square : passed, 0.0, 1.0));
  }
  return out;
}

class Fit {
 public:
  /// To nodes that are as near to each other as they may be.
  Fit(std::vector<Vec2> fine, bool is_closed, double blur, std::span<const Edge> edges, const EdgeNoise& noise,
      const JobControl* job)
      : fine_(std::move(fine)), edges_(edges), noise_(noise), job_(job), blur_(blur), is_alone_(edges.size(), 0) {
    run_.is_closed = is_closed;
    cells_ = is_closed ? fine_.size() : fine_.size() - 1;
    length_ = length_of(fine_, is_closed);
    for (const double along : walked(fine_, is_closed, edges)) home_.push_back(cell_at(along));
  }
  /// To a run that was fitted.
  Fit(Run run, std::span<const Edge> edges, const EdgeNoise& noise, const JobControl* job)
      : run_(std::move(run)), edges_(edges), noise_(noise), job_(job), is_alone_(edges.size(), 0) {
    if (noise_.is_blurred) blur_ = kVarianceOfPixel;
    length_ = length_of(run_.nodes, run_.is_closed);
    cells_ = run_.cells;
    for (const double along : walked(run_.nodes, run_.is_closed, edges)) {
      const auto k = static_cast<std::size_t>(along);
      const std::size_t chord = std::min(k, chord_count() - 1);
      const double part = (along - static_cast<double>(chord)) * static_cast<double>(cells_of(chord));
      home_.push_back(cell_at(static_cast<double>(run_.at[chord]) + part));
    }
    begin();
  }

  Run result() && {
    measure_noise();
    begin_coarse();
    descend();
    stiffen();
    run_.farthest = farthest();
    return std::move(run_);
  }

  Run refined() && {
    refine();
    run_.farthest = farthest();
    return std::move(run_);
  }

  /// What is left at the least stiffness.
  void add_noise(std::vector<double>& sizes) {
    begin_evenly(1);
    constexpr int kFirst = 2;
    for (int i = 0; i < kFirst; ++i) {
      is_stale_.assign(chord_count(), 1);
      place();
      step(1);
    }
    for (const Placed& edge : placed_)
      if (edge.weight > 0.0) sizes.push_back(std::abs(edge.offset));
  }

 private:
  void look() const {
    if (job_ != nullptr && job_->stop_requested()) throw Cancelled{};
  }
  std::uint32_t cell_at(double along) const {
    return static_cast<std::uint32_t>(std::min(static_cast<std::size_t>(along), cells_ - 1));
  }
  std::size_t chord_count() const { return run_.is_closed ? run_.nodes.size() : run_.nodes.size() - 1; }
  std::size_t next(std::size_t k) const { return k + 1 < run_.nodes.size() ? k + 1 : 0; }
  std::size_t cells_of(std::size_t chord) const {
    return (chord + 1 < run_.at.size() ? run_.at[chord + 1] : cells_) - run_.at[chord];
  }
  double cell_size() const { return length_ / static_cast<double>(cells_); }
  double apart(std::size_t chord) const { return cell_size() * static_cast<double>(cells_of(chord)); }
  /// Of the chords at a node, the shorter.
  double least_apart(std::size_t k) const {
    const std::size_t chords = chord_count();
    const std::size_t before = k > 0 ? k - 1 : run_.is_closed ? chords - 1 : 0;
    return std::min(apart(before), apart(k < chords ? k : chords - 1));
  }
  /// Of a closed run nine tenths of the radius that it would have as a circle: it may still be an ellipse. Were it a circle
  /// up to rounding, each of its samples could be an end of the axis.
  double stiffest() const { return run_.is_closed ? length_ / 7.0 : 2.0 * length_; }

  /// Stiffness grows by no more than the way.
  void limit_growth(std::vector<double>& stiffness) const {
    const std::size_t chords = chord_count();
    for (int round = 0; round < (run_.is_closed ? 2 : 1); ++round) {
      for (std::size_t k = 0; k < chords; ++k)
        stiffness[next(k)] = std::min(stiffness[next(k)], stiffness[k] + apart(k));
      for (std::size_t k = chords; k-- > 0;) stiffness[k] = std::min(stiffness[k], stiffness[next(k)] + apart(k));
    }
  }

  /// Nodes so many cells apart.
  void begin_evenly(std::size_t apart) {
    for (std::size_t i = 0; i < fine_.size(); i += apart) {
      run_.nodes.push_back(fine_[i]);
      run_.at.push_back(i);
    }
    run_.cells = cells_;
    run_.stiffness.assign(run_.nodes.size(),
                          std::min(static_cast<double>(apart) * noise_.least_stiffness, stiffest()));
    run_.is_held.assign(run_.nodes.size(), false);
    begin();
  }
  void begin_coarse() {
    const std::size_t least = run_.is_closed ? kLeastChordsClosed : kLeastChordsOpen;
    std::size_t apart = 1;
    while (cells_ % (2 * apart) == 0 && cells_ / (2 * apart) >= least &&
           cell_size() * static_cast<double>(2 * apart) < 1.5 * kCoarsest)
      apart *= 2;
    begin_evenly(apart);
    if (run_.is_closed) return;
    // What comes after a corner is asked of the ends.
    for (; apart > 1; apart /= 2) {
      std::vector<char> split(chord_count(), 0);
      split.front() = split.back() = 1;
      remesh(std::move(split), true);
    }
  }
  void begin() {
    placed_.assign(edges_.size(), Placed{});
    has_changed_.assign(edges_.size(), 1);
    solved_.assign(run_.nodes.size(), 0.0);
    is_active_.assign(run_.nodes.size(), 1);
    misfits_.assign(chord_count(), 0);
    note_chords();
    is_stale_.assign(chord_count(), 1);
    frame_ = Frame(run_.nodes, run_.is_closed);
  }
  void note_chords() {
    chord_of_.clear();
    chord_of_.reserve(cells_);
    for (std::size_t k = 0; k < chord_count(); ++k)
      chord_of_.insert(chord_of_.end(), cells_of(k), static_cast<std::uint32_t>(k));
  }

  /// Where the edges are beside the chords that have changed; whether any have.
  bool place() {
    const bool are_all = std::ranges::all_of(is_stale_, [](char is_stale) { return is_stale != 0; });
    if (!are_all && std::ranges::none_of(is_stale_, [](char is_stale) { return is_stale != 0; })) {
      was_stale_.assign(is_stale_.size(), 0);
      return false;
    }
    double blurs = 0.0;
    double weights = 0.0;
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      if (!are_all && is_stale_[placed_[i].chord] == 0) continue;
      placed_[i] = beside(edges_[i], chord_of_[home_[i]]);
      has_changed_[i] = 1;
      const double weight = placed_[i].weight;
      if (edges_[i].variance < 0.0F || weight < kLeastAcross) continue;
      // A pixel counts twice in what is seen of a transition: as the mean of what it covers, and as a step.
      blurs += weight * (edges_[i].variance - kVarianceOfPixel) * weight * weight;
      weights += weight;
    }
    if (noise_.is_blurred && are_all) blur_ = std::max(kVarianceOfPixel, weights > 0.0 ? blurs / weights : 0.0);
    was_stale_ = std::exchange(is_stale_, std::vector<char>(is_stale_.size(), 0));
    return true;
  }

  Placed beside(const Edge& edge, std::size_t at) const {
    constexpr int kMostSteps = 6;
    const std::vector<Chord>& chords = frame_.chords();
    Placed out;
    bool was_forward = false;
    const Chord* chord = nullptr;
    double passed = 0.0;
    for (int steps = kMostSteps;; --steps) {
      chord = &chords[at];
      passed = dot(edge.at - chord->from, chord->along);
      if (steps <= 0) break;
      if (passed > chord->size && (run_.is_closed || at + 1 < chords.size())) {
        at = at + 1 < chords.size() ? at + 1 : 0;
        was_forward = true;
      } else if (passed < 0.0 && !was_forward && (run_.is_closed || at > 0)) {
        at = at > 0 ? at - 1 : chords.size() - 1;
      } else {
        break;
      }
    }
    const double size = chord->size;
    out.chord = static_cast<std::uint32_t>(at);
    out.t = size > 0.0 ? std::clamp(passed / size, 0.0, 1.0) : 0.5;
    if (size == 0.0 || passed < -0.5 * size || passed > 1.5 * size) return out;
    const double along_x = std::abs(chord->along.x);
    const double along_y = std::abs(chord->along.y);
    const double share = edge.is_along_y ? along_x : along_y;
    const double least = std::min(along_x, along_y);
    out.jumps = std::min(least, std::max(along_x, along_y) - least);
    out.offset = cross(chord->along, edge.at - chord->from) - chord->beside(out.t);
    if (blur_ > 0.0) {
      const double across = std::max(share, kLeastAcross);
      const double curvature = chord->bend + out.t * (chord->next_bend - chord->bend);
      out.offset -= 0.5 * curvature * blur_ / (across * across);
    }
    out.weight = share >= kLeastShare ? share : 0.0;
    return out;
  }

  double farthest() {
    is_stale_.assign(chord_count(), 1);
    place();
    double out = 0.0;
    for (std::size_t i = 0; i < placed_.size(); ++i) {
      const Chord& chord = frame_.chords()[placed_[i].chord];
      const double away = size_of(chord.from + (placed_[i].t * chord.size) * chord.along - edges_[i].at);
      // Not a number stays so.
      if (!(away <= out)) out = away;
    }
    return out;
  }

  /// Squares of what edges beside a chord are off by, as a form of the offsets of its two nodes.
  struct Sums {
    double here = 0.0;
    double both = 0.0;
    double there = 0.0;
    double right = 0.0;
    double next_right = 0.0;
  };

  /// One step of Gauss and Newton; and so often again what it has left out: so a bend loses little of itself, and waves
  /// little more are let through. Offsets are small, so that all of it is linear. Nodes that are not active stay.
  void step(int times) {
    look();
    const std::size_t count = run_.nodes.size();
    const std::vector<Stretch> stretches = find_active();
    if (stretches.empty()) return;
    sums_.assign(chord_count(), {});
    for (std::size_t i = 0; i < placed_.size(); ++i) {
      const Placed& edge = placed_[i];
      if (edge.weight == 0.0 || is_alone_[i] != 0) continue;
      if (!is_active_[edge.chord] && !is_active_[next(edge.chord)]) continue;
      Sums& sums = sums_[edge.chord];
      const double here = edge.weight * (1.0 - edge.t);
      const double there = edge.weight * edge.t;
      sums.here += here * (1.0 - edge.t);
      sums.both += here * edge.t;
      sums.there += there * edge.t;
      sums.right += here * edge.offset;
      sums.next_right += there * edge.offset;
    }
    offsets_.assign(count, 0.0);
    for (const Stretch& stretch : stretches) solve(stretch, times);
    // A step of more than a few pixels is beyond what is linear.
    constexpr double kMostStep = 4.0;
    for (double& offset : offsets_) offset = std::clamp(offset, -kMostStep, kMostStep);
    for (std::size_t i = 0; i < placed_.size(); ++i) {
      Placed& edge = placed_[i];
      const std::size_t there = next(edge.chord);
      if (!is_active_[edge.chord] && !is_active_[there]) continue;
      edge.offset -= (1.0 - edge.t) * offsets_[edge.chord] + edge.t * offsets_[there];
      has_changed_[i] = 1;
    }
    // Beside what has moved by more than a part of the noise, edges are placed again.
    constexpr double kMoved = 0.25;
    for (const Stretch& stretch : stretches) {
      for (std::size_t i = 0, k = stretch.first; i < stretch.count; ++i, k = next(k)) {
        run_.nodes[k] = run_.nodes[k] + offsets_[k] * frame_.normal(k);
        solved_[k] = run_.stiffness[k];
        // Not a number has moved.
        if (!(std::abs(offsets_[k]) <= kMoved * noise_.one)) make_stale(k);
      }
    }
    for (const Stretch& stretch : stretches) frame_.renew(run_.nodes, stretch.first, stretch.count);
  }

  /// Nodes in a row, around if the run is closed.
  struct Stretch {
    std::size_t first = 0;
    std::size_t count = 0;
  };

  /// Nodes near to what has changed: farther away than so many times the stiffness nothing moves.
  std::vector<Stretch> find_active() {
    constexpr double kReach = 6.0;
    const std::size_t count = run_.nodes.size();
    const std::size_t chords = chord_count();
    std::vector<double>& reach = reach_;
    reach.assign(count, 0.0);
    std::size_t touched = 0;
    for (std::size_t k = 0; k < count; ++k)
      if (run_.stiffness[k] != solved_[k] || (k < chords && was_stale_[k] != 0)) {
        reach[k] = reach[k < chords ? next(k) : k] = kReach;
        ++touched;
      }
    if (3 * touched > count) {
      is_active_.assign(count, 1);
      return {{0, count}};
    }
    if (touched == 0) {
      is_active_.assign(count, 0);
      return {};
    }
    for (int round = 0; round < (run_.is_closed ? 2 : 1); ++round) {
      const auto follow = [&](std::size_t k, std::size_t from, std::size_t chord) {
        if (reach[from] > reach[k]) reach[k] = std::max(reach[k], reach[from] - apart(chord) / run_.stiffness[from]);
      };
      for (std::size_t k = 0; k < chords; ++k) follow(next(k), k, k);
      for (std::size_t k = chords; k-- > 0;) follow(k, next(k), k);
    }
    std::size_t active = 0;
    for (std::size_t k = 0; k < count; ++k) {
      is_active_[k] = reach[k] > 0.0 ? 1 : 0;
      active += reach[k] > 0.0 ? 1U : 0U;
    }
    if (2 * active > count) {
      is_active_.assign(count, 1);
      return {{0, count}};
    }
    std::vector<Stretch> out;
    std::size_t first = 0;
    while (run_.is_closed && is_active_[first] != 0) ++first;
    for (std::size_t i = 0; i < count; ++i) {
      const std::size_t k = (first + i) % count;
      if (is_active_[k] == 0) continue;
      const bool goes_on = i > 0 && is_active_[(first + i - 1) % count] != 0;
      if (!goes_on) out.push_back({k, 0});
      ++out.back().count;
    }
    return out;
  }

  void solve(const Stretch& stretch, int times) {
    const std::size_t count = stretch.count;
    const bool is_around = run_.is_closed && count == run_.nodes.size();
    const std::size_t nodes = run_.nodes.size();
    system_.clear(count, is_around);
    const auto node = [&](std::ptrdiff_t i) {
      const auto k = static_cast<std::ptrdiff_t>(stretch.first) + i;
      const auto all = static_cast<std::ptrdiff_t>(nodes);
      return static_cast<std::size_t>(k < 0 ? k + all : k >= all ? k - all : k);
    };
    // Chords and rows that begin before the stretch end in it.
    const auto size = static_cast<std::ptrdiff_t>(count);
    const bool is_first = !run_.is_closed && stretch.first == 0;
    const std::ptrdiff_t chords_end = !run_.is_closed && stretch.first + count == nodes ? size - 1 : size;
    const std::ptrdiff_t chords_begin = is_around || is_first ? 0 : -1;
    for (std::ptrdiff_t i = chords_begin; i < chords_end; ++i) {
      const Sums& sums = sums_[node(i)];
      system_.add_pair(i, sums.here, sums.both, sums.there);
    }
    const std::ptrdiff_t least =
        run_.is_closed ? -3 : std::max<std::ptrdiff_t>(-3, -static_cast<std::ptrdiff_t>(stretch.first));
    for (std::ptrdiff_t i = is_around ? 0 : least; i < size; ++i) {
      if (!run_.is_closed && static_cast<std::ptrdiff_t>(stretch.first) + i + 3 >= static_cast<std::ptrdiff_t>(nodes))
        break;
      add_penalty(system_, i, node(i));
    }
    // Where no edge says anything, nodes stay.
    constexpr double kHold = 1e-6;
    for (std::ptrdiff_t i = 0; i < size; ++i) system_.add(i, std::array{1.0}, 0.0, kHold);
    system_.factor();
    std::vector<double>& right = system_.right();
    for (int time = 0; time < times; ++time) {
      if (time > 0) right.assign(count, 0.0);
      for (std::ptrdiff_t i = chords_begin; i < chords_end; ++i) {
        const Sums& sums = sums_[node(i)];
        const double here = offsets_[node(i)];
        const double there = offsets_[node(i + 1)];
        if (i >= 0) right[static_cast<std::size_t>(i)] += sums.right - sums.here * here - sums.both * there;
        const std::ptrdiff_t after = is_around && i + 1 == size ? 0 : i + 1;
        if (after < size)
          right[static_cast<std::size_t>(after)] += sums.next_right - sums.both * here - sums.there * there;
      }
      system_.solve();
      for (std::ptrdiff_t i = 0; i < size; ++i) offsets_[node(i)] += right[static_cast<std::size_t>(i)];
    }
  }

  /// The chords that bend otherwise when a node moves.
  void make_stale(std::size_t node) {
    const std::size_t chords = chord_count();
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t k = node + i;
      if (run_.is_closed)
        is_stale_[(k + chords - 2) % chords] = 1;
      else if (k >= 2 && k - 2 < chords)
        is_stale_[k - 2] = 1;
    }
  }

  /// From the curvature at the node after `before` to that at the next, of unknowns that begin with `before` as `first`.
  void add_penalty(StiffSystem& system, std::ptrdiff_t first, std::size_t before) const {
    const std::vector<Chord>& chords = frame_.chords();
    const std::size_t here = next(before);
    const std::size_t after = next(here);
    constexpr double kLeast = 1e-3;
    const double a = std::max(chords[before].size, kLeast);
    const double b = std::max(chords[here].size, kLeast);
    const double c = std::max(chords[after].size, kLeast);
    const double bend = frame_.curvature(here);
    const double next_bend = frame_.curvature(after);
    const double in = 2.0 / (a + b);
    const double on = 2.0 / (b + c);
    const double stiffness = std::min(run_.stiffness[here], run_.stiffness[after]);
    const double square = stiffness * stiffness;
    // Of three nodes the curvature is that in their mean.
    const double weight = square * square * square * 3.0 / (a + b + c);
    system.add(first,
               std::array{-in / a, on / b + 2.0 / (a * b) - bend * bend,
                          next_bend * next_bend - 2.0 / (b * c) - in / b, on / c},
               bend - next_bend, weight);
  }

  /// The fit at the stiffness that the nodes have.
  void settle() {
    // What does not come to rest, as a corner at the least stiffness, is left until its surroundings change.
    place();
    was_stale_.assign(chord_count(), 0);
    // New nodes may move far.
    const bool is_first = std::exchange(is_remeshed_, false);
    step(is_first ? 1 : kTimes);
    // What the parabolas between the nodes have wrong.
    if (place() || is_first) step(kTimes);
    // Another without what stands alone, if there is anything.
    was_stale_.assign(chord_count(), 0);
    if (find_alone()) step(kTimes);
  }

  void settle_all() {
    is_stale_.assign(chord_count(), 1);
    solved_.assign(run_.nodes.size(), 0.0);
    settle();
  }

  /// Edges of single pixels that stand out from the curve or into it.
  bool find_alone() {
    residuals_.clear();
    for (const Placed& edge : placed_) residuals_.push_back({edge.offset, edge.weight, 0.0});
    bool is_changed = false;
    for_each_stray(residuals_, noise_.one, [&](std::size_t first, std::size_t end, bool are_alone) {
      const char value = are_alone ? 1 : 0;
      for (std::size_t k = first; k < end; ++k) {
        if (is_alone_[k] == value) continue;
        is_changed = true;
        is_alone_[k] = value;
        was_stale_[placed_[k].chord] = 1;
        has_changed_[k] = 1;
      }
    });
    return is_changed;
  }

  /// What a single edge may be off by, from what is left at the least stiffness, of long curves in some parts. Corners leave
  /// much more, so that the quarter of the edges that lie best is asked.
  void measure_noise() {
    constexpr double kPerDeviation = 5.0;
    constexpr double kNormal = 1.0 / 0.3186;  // from that quarter of magnitudes to the deviation
    constexpr double kMost = 0.45;
    if (noise_.one >= kMost) return;
    std::vector<double> sizes;
    constexpr std::size_t kParts = 8;
    constexpr std::size_t kPart = 256;  // cells
    if (cells_ <= 2 * kParts * kPart) {
      Fit(fine_, run_.is_closed, blur_, edges_, noise_, job_).add_noise(sizes);
    } else {
      for (std::size_t part = 0; part < kParts; ++part) {
        const std::size_t from = part * cells_ / kParts;
        const auto is_before = [](std::size_t end) { return [end](std::uint32_t cell) { return cell < end; }; };
        // A closed one begins in some cell.
        const auto begin = home_.begin() + (std::ranges::min_element(home_) - home_.begin());
        const auto first = std::partition_point(begin, home_.end(), is_before(from));
        const auto last = std::partition_point(first, home_.end(), is_before(from + kPart));
        const std::span nodes = std::span<const Vec2>(fine_).subspan(from, kPart + 1);
        Fit({nodes.begin(), nodes.end()}, false, blur_,
            edges_.subspan(static_cast<std::size_t>(first - home_.begin()), static_cast<std::size_t>(last - first)),
            noise_, job_)
            .add_noise(sizes);
      }
    }
    if (sizes.empty()) return;
    const auto quarter = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 4);
    std::ranges::nth_element(sizes, quarter);
    noise_.one = std::clamp(kPerDeviation * kNormal * *quarter, noise_.one, kMost);
  }

  /// Chords within windows whose mean is more than noise.
  bool find_misfits() {
    for (std::size_t i = 0; i < placed_.size(); ++i) {
      const Placed& edge = placed_[i];
      residuals_[i] = {edge.offset, is_alone_[i] != 0 ? 0.0 : edge.weight, edge.jumps, has_changed_[i] != 0};
      if (has_changed_[i] != 0) misfits_[edge.chord] = 0;
    }
    has_changed_.assign(has_changed_.size(), 0);
    bool out = false;
    for_each_misfit(residuals_, run_.is_closed, noise_.one, window_sums_, [&](std::size_t first, std::size_t window) {
      const std::size_t count = edges_.size();
      const std::size_t from = placed_[first % count].chord;
      const std::size_t to = placed_[(first + window - 1) % count].chord;
      const std::size_t chords = misfits_.size();
      const std::size_t all = (to >= from ? to - from : to + chords - from) + 1;
      // What a smaller window has found already.
      for (std::size_t i = 0; i < all; ++i)
        if (misfits_[(from + i) % chords] != 0) return;
      for (std::size_t i = 0; i < all; ++i) misfits_[(from + i) % chords] = 1;
      out = true;
    });
    return out;
  }

  /// Nodes half as far from each other where that is said, and beside it so that no two chords are followed by one of more
  /// than twice their length.
  void remesh(std::vector<char> split, bool are_fine) {
    is_remeshed_ = true;
    const std::size_t chords = chord_count();
    const auto size_after = [&](std::size_t k) { return split[k] != 0 ? cells_of(k) / 2 : cells_of(k); };
    for (bool is_changed = true; is_changed;) {
      is_changed = false;
      for (std::size_t k = 0; k < chords; ++k)
        for (std::size_t i = 1; i <= 2; ++i) {
          if (!run_.is_closed && k + i >= chords) continue;
          const std::size_t other = (k + i) % chords;
          const std::size_t here = size_after(k);
          const std::size_t there = size_after(other);
          if (here > 2 * there || there > 2 * here) {
            split[here > there ? k : other] = 1;
            is_changed = true;
          }
        }
    }
    Run finer{.cells = cells_, .is_closed = run_.is_closed};
    std::vector<std::uint32_t> became(chords);
    std::vector<char> stale;
    std::vector<char> misfits;
    std::vector<double> solved;
    const std::size_t count = run_.nodes.size();
    const std::size_t most = 2 * count;
    finer.nodes.reserve(most);
    finer.at.reserve(most);
    finer.stiffness.reserve(most);
    finer.is_held.reserve(most);
    stale.reserve(most);
    misfits.reserve(most);
    solved.reserve(most);
    for (std::size_t k = 0; k < count; ++k) {
      const bool is_split = k < chords && split[k] != 0;
      const bool was_split = k > 0 ? split[k - 1] != 0 : run_.is_closed && split[chords - 1] != 0;
      const bool is_anew = are_fine && is_split && was_split;
      finer.nodes.push_back(is_anew ? fine_[run_.at[k]] : run_.nodes[k]);
      finer.at.push_back(run_.at[k]);
      finer.stiffness.push_back(run_.stiffness[k]);
      finer.is_held.push_back(run_.is_held[k]);
      solved.push_back(solved_[k]);
      if (k == chords) continue;
      misfits.push_back(misfits_[k]);
      became[k] = static_cast<std::uint32_t>(stale.size());
      const bool will_be = k + 1 < chords ? split[k + 1] != 0 : run_.is_closed && split[0] != 0;
      stale.push_back(is_split || was_split || will_be || is_stale_[k] != 0 ? 1 : 0);
      if (!is_split) continue;
      const std::size_t middle = run_.at[k] + cells_of(k) / 2;
      finer.nodes.push_back(are_fine ? fine_[middle] : frame_.chords()[k].at(0.5));
      finer.at.push_back(middle);
      finer.stiffness.push_back(std::min(run_.stiffness[k], run_.stiffness[next(k)]));
      finer.is_held.push_back(run_.is_held[k] && run_.is_held[next(k)]);
      stale.push_back(1);
      misfits.push_back(misfits_[k]);
      solved.push_back(0.0);
    }
    run_ = std::move(finer);
    for (Placed& edge : placed_) edge.chord = became[edge.chord];
    is_stale_ = std::move(stale);
    solved_ = std::move(solved);
    misfits_ = std::move(misfits);
    is_active_.assign(run_.nodes.size(), 1);
    note_chords();
    frame_ = Frame(run_.nodes, run_.is_closed);
  }

  /// Half as stiff where that does not fit, with nodes half that apart, until it fits or is the least.
  void descend() {
    for (;;) {
      settle();
      if (!find_misfits()) return;
      std::vector<double> halved = run_.stiffness;
      bool is_less = false;
      for (std::size_t k = 0; k < misfits_.size(); ++k) {
        if (misfits_[k] == 0) continue;
        for (const std::size_t node : {k, next(k)}) {
          halved[node] = std::min(halved[node], std::max(noise_.least_stiffness, 0.5 * run_.stiffness[node]));
          is_less = is_less || halved[node] < run_.stiffness[node];
        }
      }
      if (!is_less) return;
      limit_growth(halved);
      run_.stiffness = std::move(halved);
      std::vector<char> split(chord_count(), 0);
      for (std::size_t k = 0; k < split.size(); ++k) {
        const double wanted = 1.01 * std::min(run_.stiffness[k], run_.stiffness[next(k)]);
        split[k] = cells_of(k) > 1 && noise_.least_stiffness * static_cast<double>(cells_of(k)) > wanted ? 1 : 0;
      }
      remesh(std::move(split), true);
    }
  }

  /// The stiffness that the nodes would have, where those that are held allow it.
  std::vector<double> doubled() const {
    std::vector<double> out = run_.stiffness;
    for (std::size_t k = 0; k < out.size(); ++k)
      if (!run_.is_held[k])
        out[k] = std::max(out[k], std::min({2.0 * out[k], kMostNodes * least_apart(k), stiffest()}));
    limit_growth(out);
    return out;
  }

  /// As many nodes, twice as stiff where that fits, until it fits nowhere. Each stretch that becomes stiffer is judged by
  /// itself: what is left over beside places that are held already says nothing against it.
  void stiffen() {
    constexpr int kRounds = 16;
    const std::size_t count = run_.nodes.size();
    for (int round = 0; round < kRounds; ++round) {
      std::vector<double> before = doubled();
      std::swap(before, run_.stiffness);
      const auto is_stiffer = [&](std::size_t k) { return run_.stiffness[k] > 1.01 * before[k]; };
      std::size_t first = 0;  // where no stretch goes on
      while (first < count && run_.is_closed && is_stiffer(first)) ++first;
      bool is_more = first == count;
      for (std::size_t k = 0; k < count && !is_more; ++k) is_more = is_stiffer(k);
      if (!is_more) break;
      settle();
      if (!find_misfits()) continue;
      std::vector<char> is_new(count, 0);
      for (std::size_t k = 0; k < misfits_.size(); ++k)
        if (misfits_[k] != 0)
          for (const std::size_t node : {k, next(k)}) {
            if (run_.is_held[node]) continue;
            run_.is_held[node] = true;
            is_new[node] = 1;
          }
      for (std::size_t passed = 0; passed < count;) {
        const std::size_t begin = passed;
        bool fits = true;
        for (; passed < count && is_stiffer((first + passed) % count); ++passed)
          fits = fits && is_new[(first + passed) % count] == 0;
        for (std::size_t i = begin; i < passed && !fits; ++i)
          run_.stiffness[(first + i) % count] = before[(first + i) % count];
        if (passed == begin) ++passed;
      }
    }
    settle_all();
  }

  /// Nodes as near to each other as pieces of cubics need them that lie on a circle: what they are off by grows with the
  /// fourth power of the turn from node to node.
  void refine() {
    constexpr std::size_t kFew = 32;
    const double most = most_turn(length_);
    bool is_finer = false;
    for (;;) {
      std::vector<char> split(chord_count(), 0);
      bool is_any = false;
      for (std::size_t k = 0; k < split.size(); ++k) {
        const double stiffness = std::max(run_.stiffness[k], run_.stiffness[next(k)]);
        const bool is_turned = 4.0 * std::abs(frame_.chords()[k].bulge) > most;
        if (!is_turned || cells_of(k) == 1 || stiffness > kMostNodes * apart(k)) continue;
        split[k] = 1;
        is_any = true;
      }
      if (!is_any || run_.nodes.size() > edges_.size() + kFew) break;
      remesh(std::move(split), false);
      for (std::size_t k = 0; k < run_.nodes.size(); ++k)
        run_.stiffness[k] = std::min(run_.stiffness[k], 2.0 * kMostNodes * least_apart(k));
      is_finer = true;
    }
    if (is_finer) settle_all();
  }

  Run run_;
  std::vector<Vec2> fine_;
  std::size_t cells_ = 0;  // finest distances
  std::span<const Edge> edges_;
  EdgeNoise noise_;
  const JobControl* job_;
  double length_ = 0.0;
  double blur_ = 0.0;                    // square pixels, of edges that are blurred
  std::vector<std::uint32_t> home_;      // of edges: the cell beside which they are
  std::vector<std::uint32_t> chord_of_;  // of cells
  Frame frame_;
  bool is_remeshed_ = true;
  std::vector<char> is_stale_;     // of chords: they have changed since edges were placed beside them
  std::vector<char> was_stale_;    // of chords: edges were placed beside them anew
  std::vector<char> misfits_;      // of chords: beside them is more than noise
  std::vector<double> solved_;     // the stiffness of nodes when they were moved last
  std::vector<char> is_active_;    // of nodes: they are moved
  std::vector<double> offsets_;    // of nodes
  std::vector<char> has_changed_;  // of edges, since windows were looked at
  std::vector<Placed> placed_;
  std::vector<Sums> sums_;
  std::vector<char> is_alone_;
  std::vector<Residual> residuals_;
  std::vector<ResidualSum> window_sums_;
  std::vector<double> reach_;
  StiffSystem system_;
};

}  // namespace

Run fitted(std::span<const Vec2> start, bool is_closed, std::span<const Edge> edges, const EdgeNoise& noise,
           const JobControl* job) {
  const std::size_t least = is_closed ? kLeastChordsClosed : kLeastChordsOpen;
  // Where a curve is short, its ends and corners are much of it, and its nodes cost little.
  constexpr double kShort = 512.0;  // pixels
  const double apart = (length_of(start, is_closed) < kShort ? 0.5 : 0.75) * noise.least_stiffness;
  // A multiple of a power of two, so that nodes can be halved and halved again.
  auto cells = std::max(least, static_cast<std::size_t>(std::lround(length_of(start, is_closed) / apart)));
  std::size_t together = 1;
  while (cells / (2 * together) >= least && apart * static_cast<double>(2 * together) <= kCoarsest) together *= 2;
  cells = (cells + together / 2) / together * together;
  const double blur = noise.is_blurred ? kVarianceOfPixel : 0.0;
  return Fit(respaced(start, is_closed, is_closed ? cells : cells + 1), is_closed, blur, edges, noise, job).result();
}

double most_turn(double length) {
  constexpr double kWaves = 0.12;  // a thousandth of a pixel of what the edges are off by, in parts that are left
  constexpr double kMost = 0.3;
  return std::min(kMost, std::sqrt(std::sqrt(kWaves / std::max(length, 1.0))));
}

Run refined(Run run, std::span<const Edge> edges, const EdgeNoise& noise, const JobControl* job) {
  return Fit(std::move(run), edges, noise, job).refined();
}

Run evened(const Run& run) {
  Run out{.cells = run.cells, .is_closed = run.is_closed, .farthest = run.farthest};
  const Frame frame(run.nodes, run.is_closed);
  for (std::size_t k = 0; k < run.nodes.size(); ++k) {
    const std::size_t next = k + 1 < run.nodes.size() ? k + 1 : 0;
    const bool is_last = next == 0;
    const std::size_t parts = is_last ? (run.is_closed ? run.cells - run.at[k] : 1) : run.at[next] - run.at[k];
    for (std::size_t i = 0; i < parts; ++i) {
      const double t = static_cast<double>(i) / static_cast<double>(parts);
      out.nodes.push_back(i == 0 ? run.nodes[k] : frame.chords()[k].at(t));
      out.at.push_back(run.at[k] + i);
      out.stiffness.push_back(run.stiffness[k] + t * (run.stiffness[next] - run.stiffness[k]));
      out.is_held.push_back(run.is_held[k] && (i == 0 || run.is_held[next]));
    }
  }
  return out;
}

std::vector<double> places_along(const Run& run, std::span<const Edge> edges) {
  return walked(run.nodes, run.is_closed, edges);
}

std::vector<Vec2> respaced(std::span<const Vec2> nodes, bool is_closed, std::size_t count) {
  const Frame frame(nodes, is_closed);
  const std::vector<Chord>& chords = frame.chords();
  double all = 0.0;
  for (const Chord& chord : chords) all += chord.size;
  std::vector<Vec2> out;
  out.reserve(count);
  std::size_t k = 0;
  double passed = 0.0;
  const double intervals = static_cast<double>(is_closed ? count : count - 1);
  for (std::size_t i = 0; i < count; ++i) {
    const double wanted = all * (static_cast<double>(i) / intervals);
    while (k + 1 < chords.size() && passed + chords[k].size < wanted) passed += chords[k++].size;
    const double t = chords[k].size > 0.0 ? std::clamp((wanted - passed) / chords[k].size, 0.0, 1.0) : 0.0;
    out.push_back(chords[k].at(t));
  }
  return out;
}

}  // namespace mes
