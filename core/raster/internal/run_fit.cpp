// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/raster/internal/run_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/raster/internal/residual_windows.h"
#include "core/raster/internal/stiff_system.h"

namespace mes {
namespace {

// Beyond so many distances of nodes a stiffness is no longer told from a larger one in doubles.
constexpr double kMostNodes = 32.0;
constexpr std::size_t kLeastClosed = 16;
constexpr std::size_t kLeastOpen = 6;
double size_of(Vec2 v) {
  return std::sqrt(dot(v, v));  // pixels neither overflow nor vanish
}

/// A curve of nodes: between two of them the parabola that is nearest to the circle with their tangents.
class Frame {
 public:
  Frame(std::span<const Vec2> nodes, bool is_closed)
      : nodes_(nodes),
        is_closed_(is_closed),
        turns_(nodes.size()),
        lengths_(nodes.size()),
        curvatures_(nodes.size()) {
    const std::size_t count = nodes.size();
    for (std::size_t k = 0; k < chords(); ++k) lengths_[k] = size_of(chord(k));
    const std::size_t first = is_closed ? 0 : 1;
    for (std::size_t k = first; k + first < count; ++k) {
      const Vec2 in = nodes[k] - nodes[k == 0 ? count - 1 : k - 1];
      const Vec2 on = chord(k);
      const double sine = cross(in, on);
      turns_[k] = std::atan2(sine, dot(in, on));
      const double sizes = lengths_[k == 0 ? count - 1 : k - 1] * lengths_[k] * size_of(in + on);
      curvatures_[k] = sizes > 0.0 ? 2.0 * sine / sizes : 0.0;
    }
    if (!is_closed) {
      turns_.front() = turns_[1];
      turns_.back() = turns_[count - 2];
      curvatures_.front() = curvatures_[1];
      curvatures_.back() = curvatures_[count - 2];
    }
  }

  std::size_t chords() const { return is_closed_ ? nodes_.size() : nodes_.size() - 1; }
  std::size_t next(std::size_t k) const { return k + 1 < nodes_.size() ? k + 1 : 0; }
  Vec2 chord(std::size_t k) const { return nodes_[next(k)] - nodes_[k]; }
  double length_of(std::size_t k) const { return lengths_[k]; }
  double turn(std::size_t k) const { return turns_[k]; }
  /// Of the circle through the node and its neighbours; the first and last of an open one as at those.
  double curvature(std::size_t k) const { return curvatures_[k]; }
  /// How far the curve lies to the left of the chord.
  double beside(std::size_t k, double t) const {
    // The tangent of a quarter of the turn.
    const double quarter = 0.125 * (turns_[k] + turns_[next(k)]);
    const double tangent = quarter * (1.0 + quarter * quarter / 3.0);
    return -2.0 * t * (1.0 - t) * lengths_[k] * std::clamp(tangent, -0.4, 0.4);
  }
  Vec2 normal(std::size_t k) const {
    const std::size_t count = nodes_.size();
    const std::size_t before = k > 0 ? k - 1 : is_closed_ ? count - 1 : 0;
    const std::size_t after = k + 1 < count ? k + 1 : is_closed_ ? 0 : k;
    const Vec2 along = nodes_[after] - nodes_[before];
    return (1.0 / std::max(size_of(along), 1e-12)) * perpendicular(along);
  }
  Vec2 at(std::size_t k, double t) const {
    const Vec2 along = chord(k);
    if (lengths_[k] == 0.0) return nodes_[k];
    return nodes_[k] + t * along + (beside(k, t) / lengths_[k]) * perpendicular(along);
  }

 private:
  std::span<const Vec2> nodes_;
  bool is_closed_;
  std::vector<double> turns_;       // at the nodes, to the left
  std::vector<double> lengths_;     // of the chords that begin there
  std::vector<double> curvatures_;  // at the nodes
};

/// An edge beside a frame.
struct Placed {
  std::size_t chord = 0;
  double t = 0.0;
  double offset = 0.0;
  double weight = 0.0;
  double jumps = 0.0;  // pixel borders that the curve passes for each pixel of its length, or diagonals of them
};

double length_of(std::span<const Vec2> nodes, bool is_closed) {
  double out = 0.0;
  for (std::size_t k = 1; k < nodes.size(); ++k) out += distance(nodes[k - 1], nodes[k]);
  return is_closed ? out + distance(nodes.back(), nodes.front()) : out;
}

class Fit {
 public:
  Fit(Run start, std::span<const Edge> edges, const EdgeNoise& noise, const JobControl* job)
      : run_(std::move(start)), edges_(edges), noise_(noise), job_(job), is_alone_(edges.size(), false) {
    if (run_.stiffness.empty()) run_.stiffness.assign(run_.nodes.size(), noise.least_stiffness);
    if (run_.is_held.empty()) run_.is_held.assign(run_.nodes.size(), false);
    length_ = length_of(run_.nodes, run_.is_closed);
  }

  std::vector<double> places() {
    place(run_);
    std::vector<double> out;
    out.reserve(placed_.size());
    for (const Placed& edge : placed_) out.push_back(static_cast<double>(edge.chord) + edge.t);
    return out;
  }

  Run result() && {
    constexpr int kFirst = 2;
    for (int i = 0; i < kFirst; ++i) solve(run_, true);
    measure_noise();
    coarsen();
    stiffen();
    run_.farthest = farthest();
    return std::move(run_);
  }

  Run refined() && {
    refine();
    run_.farthest = farthest();
    return std::move(run_);
  }

 private:
  void look() const {
    if (job_ != nullptr && job_->stop_requested()) throw Cancelled{};
  }
  double spacing(const Run& run) const {
    return length_ / static_cast<double>(run.is_closed ? run.nodes.size() : run.nodes.size() - 1);
  }
  /// Of a closed run nine tenths of the radius that it would have as a circle: it may still be an ellipse. Were it a circle
  /// up to rounding, each of its samples could be an end of the axis.
  double stiffest() const { return run_.is_closed ? length_ / 7.0 : 2.0 * length_; }

  /// Where the edges are beside the nodes.
  Frame place(const Run& run) {
    const Frame frame(run.nodes, run.is_closed);
    placed_.resize(edges_.size());
    const std::size_t chords = frame.chords();
    const double share = static_cast<double>(chords) / static_cast<double>(std::max<std::size_t>(edges_.size(), 1));
    std::size_t chord = 0;
    double blurs = 0.0;
    double weights = 0.0;
    for (std::size_t i = 0; i < edges_.size(); ++i) {
      if (i == 0 && !run.is_closed) chord = 0;
      if (i == 0 && run.is_closed) chord = nearest_chord(run, edges_[0].at);
      // The next edge is about a share of a chord farther.
      if (i != 0) chord = placed_[i - 1].chord;
      placed_[i] = beside(frame, run, edges_[i], chord, static_cast<int>(std::ceil(share)) + 3);
      const double weight = placed_[i].weight;
      if (edges_[i].variance < 0.0F || weight < kLeastAcross) continue;
      // A pixel counts twice in what is seen of a transition: as the mean of what it covers, and as a step.
      blurs += weight * (edges_[i].variance - kVarianceOfPixel) * weight * weight;
      weights += weight;
    }
    if (noise_.is_blurred) blur_ = std::max(kVarianceOfPixel, weights > 0.0 ? blurs / weights : 0.0);
    return frame;
  }

  static std::size_t nearest_chord(const Run& run, Vec2 p) {
    const auto found = std::ranges::min_element(run.nodes, {}, [&](Vec2 q) { return dot(q - p, q - p); });
    const auto k = static_cast<std::size_t>(found - run.nodes.begin());
    return run.is_closed ? k : std::min(k, run.nodes.size() - 2);
  }

  Placed beside(const Frame& frame, const Run& run, const Edge& edge, std::size_t chord, int steps) const {
    const std::size_t chords = frame.chords();
    Placed out;
    Vec2 along{};
    double size = 0.0;
    bool was_forward = false;
    for (;; --steps) {
      along = frame.chord(chord);
      size = frame.length_of(chord);
      out.t = size > 0.0 ? dot(edge.at - run.nodes[chord], along) / (size * size) : 0.5;
      if (steps <= 0) break;
      if (out.t > 1.0 && (run.is_closed || chord + 1 < chords)) {
        chord = chord + 1 < chords ? chord + 1 : 0;
        was_forward = true;
      } else if (out.t < 0.0 && !was_forward && (run.is_closed || chord > 0)) {
        chord = chord > 0 ? chord - 1 : chords - 1;
      } else {
        break;
      }
    }
    const bool is_within = out.t >= -0.5 && out.t <= 1.5;
    const double t = std::clamp(out.t, 0.0, 1.0);
    out.chord = chord;
    out.t = t;
    if (size == 0.0 || !is_within) return out;
    const Vec2 unit = (1.0 / size) * along;
    const double share = std::abs(edge.is_along_y ? unit.x : unit.y);
    const double most = std::max(std::abs(unit.x), std::abs(unit.y));
    const double least = std::min(std::abs(unit.x), std::abs(unit.y));
    out.jumps = std::min(least, most - least);
    const double curvature =
        frame.curvature(chord) + t * (frame.curvature(frame.next(chord)) - frame.curvature(chord));
    out.offset = cross(unit, edge.at - run.nodes[chord]) - frame.beside(chord, t);
    if (blur_ > 0.0) {
      const double across = std::max(share, kLeastAcross);
      out.offset -= 0.5 * curvature * blur_ / (across * across);
    }
    out.weight = share >= kLeastShare ? share : 0.0;
    return out;
  }

  double farthest() {
    place(run_);
    double out = 0.0;
    for (std::size_t i = 0; i < placed_.size(); ++i) {
      const Placed& edge = placed_[i];
      const std::size_t next = edge.chord + 1 < run_.nodes.size() ? edge.chord + 1 : 0;
      const Vec2 near = run_.nodes[edge.chord] + edge.t * (run_.nodes[next] - run_.nodes[edge.chord]);
      const double away = distance(near, edges_[i].at);
      // Not a number stays so.
      if (!(away <= out)) out = away;
    }
    return out;
  }

  /// One step of Gauss and Newton. Leaves what remains of each edge in `left_`.
  void solve(Run& run, bool is_first) {
    look();
    const Frame frame = place(run);
    const std::size_t count = run.nodes.size();
    StiffSystem system(count, run.is_closed);
    for (std::size_t i = 0; i < placed_.size(); ++i) {
      const Placed& edge = placed_[i];
      if (edge.weight == 0.0 || is_alone_[i]) continue;
      system.add(edge.chord, std::array{1.0 - edge.t, edge.t}, edge.offset, edge.weight);
    }
    const std::size_t rows = run.is_closed ? count : count - 3;
    for (std::size_t k = 0; k < rows; ++k) {
      // From the curvature at one node to that at the next.
      const std::size_t before = run.is_closed ? (k == 0 ? count - 1 : k - 1) : k;
      const std::size_t here = before + 1 < count ? before + 1 : 0;
      const std::size_t after = here + 1 < count ? here + 1 : 0;
      const double size = std::max(frame.length_of(here), 1e-3);
      const double bend = frame.curvature(here);
      const double next_bend = frame.curvature(after);
      const double per_square = 1.0 / (size * size);
      const double stiffness = std::min(run.stiffness[here], run.stiffness[after]);
      const double square = stiffness * stiffness;
      const double weight = square * square * square / size;
      system.add(before,
                 std::array{-per_square, 3.0 * per_square - bend * bend, next_bend * next_bend - 3.0 * per_square,
                            per_square},
                 is_first ? bend - next_bend : 0.0, weight);
    }
    // Where no edge says anything, nodes stay.
    constexpr double kHold = 1e-6;
    for (std::size_t k = 0; k < count; ++k) system.add(k, std::array{1.0}, 0.0, kHold);
    const std::vector<double> offsets = std::move(system).solved();
    left_.resize(placed_.size());
    for (std::size_t i = 0; i < placed_.size(); ++i) {
      const Placed& edge = placed_[i];
      left_[i] = edge.offset - (1.0 - edge.t) * offsets[edge.chord] - edge.t * offsets[frame.next(edge.chord)];
    }
    std::vector<Vec2> moved(count);
    // A step of more than a few pixels is beyond what is linear.
    constexpr double kMostStep = 4.0;
    for (std::size_t k = 0; k < count; ++k)
      moved[k] = run.nodes[k] + std::clamp(offsets[k], -kMostStep, kMostStep) * frame.normal(k);
    run.nodes = std::move(moved);
  }

  /// A step, and another without what stands alone, if there is anything.
  void solve_without_specks(Run& run) {
    solve(run);
    if (find_alone()) solve(run);
  }

  /// The curve, and twice what it has left out: so a bend loses little of itself, and waves little more are let through.
  void solve(Run& run) {
    solve(run, true);
    constexpr int kAgain = 2;
    for (int i = 0; i < kAgain; ++i) solve(run, false);
  }

  /// Edges of single pixels that stand out from the curve or into it.
  bool find_alone() {
    residuals_.clear();
    for (std::size_t i = 0; i < left_.size(); ++i) residuals_.push_back({left_[i], placed_[i].weight, 0.0});
    bool is_changed = false;
    for_each_stray(residuals_, noise_.one, [&](std::size_t first, std::size_t end, bool are_alone) {
      for (std::size_t k = first; k < end; ++k) {
        is_changed = is_changed || is_alone_[k] != are_alone;
        is_alone_[k] = are_alone;
      }
    });
    return is_changed;
  }

  /// What a single edge may be off by, from what is left at the least stiffness. Corners leave much more, so that the
  /// quarter of the edges that lie best is asked.
  void measure_noise() {
    constexpr double kPerDeviation = 5.0;
    constexpr double kNormal = 1.0 / 0.3186;  // from that quarter of magnitudes to the deviation
    constexpr double kMost = 0.45;
    std::vector<double> sizes;
    for (std::size_t i = 0; i < left_.size(); ++i)
      if (placed_[i].weight > 0.0) sizes.push_back(std::abs(left_[i]));
    if (sizes.empty()) return;
    const auto quarter = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 4);
    std::ranges::nth_element(sizes, quarter);
    noise_.one = std::clamp(kPerDeviation * kNormal * *quarter, noise_.one, std::max(noise_.one, kMost));
  }

  /// Nodes within windows whose mean is more than noise.
  bool find_misfits(const Run& run, std::vector<bool>& misfits) {
    misfits.assign(run.nodes.size(), false);
    residuals_.clear();
    for (std::size_t i = 0; i < left_.size(); ++i)
      residuals_.push_back({left_[i], is_alone_[i] ? 0.0 : placed_[i].weight, placed_[i].jumps});
    bool out = false;
    for_each_misfit(residuals_, run.is_closed, noise_.one, [&](std::size_t first, std::size_t window) {
      note_misfit(run, first, window, misfits);
      out = true;
    });
    return out;
  }

  void note_misfit(const Run& run, std::size_t first, std::size_t window, std::vector<bool>& misfits) const {
    const std::size_t count = edges_.size();
    // Both ends, on the nodes.
    std::size_t node = placed_[first % count].chord;
    const std::size_t last = placed_[(first + window - 1) % count].chord;
    const std::size_t nodes = run.nodes.size();
    // What a smaller window has found already.
    bool is_known = false;
    std::size_t passed = 0;
    for (std::size_t k = node; passed <= nodes; k = k + 1 < nodes ? k + 1 : 0, ++passed) {
      is_known = is_known || misfits[k];
      if (k == last) break;
    }
    if (is_known) return;
    passed = 0;
    for (;; node = node + 1 < nodes ? node + 1 : 0, ++passed) {
      misfits[node] = true;
      if (node == last || passed > nodes) break;
    }
    misfits[last + 1 < nodes ? last + 1 : run.is_closed ? 0 : last] = true;
  }

  /// Half as many nodes, twice as stiff, while all of it fits.
  void coarsen() {
    const std::size_t least = run_.is_closed ? kLeastClosed : kLeastOpen;
    std::vector<bool> misfits;
    while (run_.nodes.size() / 2 >= least && 1.01 * run_.stiffness.front() < stiffest()) {
      Run wider{.is_closed = run_.is_closed};
      const std::size_t count = run_.is_closed ? run_.nodes.size() / 2 : (run_.nodes.size() + 1) / 2;
      wider.nodes = respaced(run_.nodes, run_.is_closed, count);
      wider.stiffness.assign(count, std::min(2.0 * run_.stiffness.front(), stiffest()));
      wider.is_held.assign(count, false);
      const std::vector<bool> alone = is_alone_;
      solve_without_specks(wider);
      if (find_misfits(wider, misfits)) {
        is_alone_ = alone;
        return;
      }
      run_ = std::move(wider);
    }
  }

  /// The stiffness that the nodes would have, where those that are held allow it.
  std::vector<double> doubled() const {
    const double distance_of_nodes = spacing(run_);
    const double most = std::min(kMostNodes * distance_of_nodes, stiffest());
    const std::size_t count = run_.nodes.size();
    std::vector<double> out(count);
    for (std::size_t k = 0; k < count; ++k)
      out[k] =
          run_.is_held[k] ? run_.stiffness[k] : std::max(run_.stiffness[k], std::min(2.0 * run_.stiffness[k], most));
    const auto follow = [&](std::size_t k, std::size_t before) {
      out[k] = std::min(out[k], out[before] + distance_of_nodes);
    };
    for (int round = 0; round < (run_.is_closed ? 2 : 1); ++round) {
      for (std::size_t k = 1; k < count; ++k) follow(k, k - 1);
      if (run_.is_closed) follow(0, count - 1);
      for (std::size_t k = count - 1; k > 0; --k) follow(k - 1, k);
      if (run_.is_closed) follow(count - 1, 0);
    }
    return out;
  }

  /// As many nodes, twice as stiff where that fits, until it fits nowhere.
  void stiffen() {
    constexpr int kRounds = 16;
    std::vector<bool> misfits;
    Run wider = run_;
    for (int round = 0; round < kRounds; ++round) {
      const std::vector<double> next = doubled();
      bool is_more = false;
      for (std::size_t k = 0; k < next.size(); ++k) is_more = is_more || next[k] > 1.01 * run_.stiffness[k];
      if (!is_more) return;
      wider.nodes = run_.nodes;
      wider.stiffness = next;
      solve_without_specks(wider);
      bool is_new = false;
      if (find_misfits(wider, misfits))
        for (std::size_t k = 0; k < misfits.size(); ++k) {
          is_new = is_new || (misfits[k] && !run_.is_held[k]);
          run_.is_held[k] = run_.is_held[k] || misfits[k];
        }
      if (is_new) continue;
      // What is left over is beside places that are held already.
      run_.nodes = wider.nodes;
      run_.stiffness = wider.stiffness;
    }
  }

  /// Nodes as near to each other as pieces of cubics need them that lie on a circle: what they are off by grows with the
  /// fourth power of the turn from node to node.
  void refine() {
    constexpr double kFew = 32.0;
    const double stiffest = *std::ranges::max_element(run_.stiffness);
    const Frame frame(run_.nodes, run_.is_closed);
    double most = 0.0;
    for (std::size_t k = 0; k < run_.nodes.size(); ++k) most = std::max(most, std::abs(frame.turn(k)));
    const double parts =
        std::min({std::ceil(most / most_turn(length_)),
                  std::floor((static_cast<double>(edges_.size()) + kFew) / static_cast<double>(run_.nodes.size())),
                  std::floor(2.0 * kMostNodes * spacing(run_) / stiffest)});
    if (parts < 2.0) return;
    const auto times = static_cast<std::size_t>(parts);
    const std::size_t chords = run_.is_closed ? run_.nodes.size() : run_.nodes.size() - 1;
    Run finer{.nodes = respaced(run_.nodes, run_.is_closed, times * chords + (run_.is_closed ? 0 : 1)),
              .is_closed = run_.is_closed};
    for (std::size_t k = 0; k < finer.nodes.size(); ++k) {
      const std::size_t from = std::min(k / times, run_.nodes.size() - 1);
      finer.stiffness.push_back(run_.stiffness[from]);
      finer.is_held.push_back(run_.is_held[from]);
    }
    // What the parabolas between the nodes have wrong is taken out first.
    solve(finer, true);
    solve(finer, true);
    solve(finer);
    run_ = std::move(finer);
  }

  Run run_;
  std::span<const Edge> edges_;
  EdgeNoise noise_;
  const JobControl* job_;
  double length_ = 0.0;
  double blur_ = 0.0;  // square pixels, of edges that are blurred
  std::vector<Placed> placed_;
  std::vector<double> left_;
  std::vector<bool> is_alone_;
  std::vector<Residual> residuals_;
};

}  // namespace

Run fitted(Run start, std::span<const Edge> edges, const EdgeNoise& noise, const JobControl* job) {
  return Fit(std::move(start), edges, noise, job).result();
}

double most_turn(double length) {
  constexpr double kWaves = 0.12;  // a thousandth of a pixel of what the edges are off by, in parts that are left
  constexpr double kMost = 0.3;
  return std::min(kMost, std::sqrt(std::sqrt(kWaves / std::max(length, 1.0))));
}

Run refined(Run run, std::span<const Edge> edges, const EdgeNoise& noise, const JobControl* job) {
  return Fit(std::move(run), edges, noise, job).refined();
}

std::vector<double> places_along(const Run& run, std::span<const Edge> edges) {
  return Fit(run, edges, {}, nullptr).places();
}

std::vector<Vec2> respaced(std::span<const Vec2> nodes, bool is_closed, std::size_t count) {
  const Frame frame(nodes, is_closed);
  const std::size_t chords = frame.chords();
  std::vector<double> lengths(chords);
  double all = 0.0;
  for (std::size_t k = 0; k < chords; ++k) all += lengths[k] = frame.length_of(k);
  std::vector<Vec2> out;
  out.reserve(count);
  std::size_t k = 0;
  double passed = 0.0;
  const double intervals = static_cast<double>(is_closed ? count : count - 1);
  for (std::size_t i = 0; i < count; ++i) {
    const double wanted = all * (static_cast<double>(i) / intervals);
    while (k + 1 < chords && passed + lengths[k] < wanted) passed += lengths[k++];
    const double t = lengths[k] > 0.0 ? std::clamp((wanted - passed) / lengths[k], 0.0, 1.0) : 0.0;
    out.push_back(frame.at(k, t));
  }
  return out;
}

}  // namespace mes
