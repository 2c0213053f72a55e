// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/raster/internal/fitting/settling.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace mes {
namespace {

constexpr int kTimes = 3;  // the curve, and two corrections of its bias
// In pixels: a node farther from the starting curve has lost its edges.
constexpr double kMostAstray = 2.0;

}  // namespace

Settling::Settling(std::vector<Vec2> fine, bool is_closed, double blur, std::span<const Edge> edges,
                   const EdgeNoise& noise, const JobControl* job)
    : fine_(std::move(fine)), edges_(edges), noise_(noise), job_(job), blur_(blur), is_alone_(edges.size(), 0) {
  run_.is_closed = is_closed;
  cells_ = is_closed ? fine_.size() : fine_.size() - 1;
  length_ = length_of(fine_, is_closed);
  for (const double along : walked(fine_, is_closed, edges)) home_.push_back(cell_at(along));
}

Settling::Settling(Run run, std::span<const Edge> edges, const EdgeNoise& noise, const JobControl* job)
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

std::size_t Settling::cells_of(std::size_t chord) const {
  return (chord + 1 < run_.at.size() ? run_.at[chord + 1] : cells_) - run_.at[chord];
}

double Settling::least_apart(std::size_t k) const {
  const std::size_t chords = chord_count();
  const std::size_t before = k > 0 ? k - 1 : run_.is_closed ? chords - 1 : 0;
  return std::min(apart(before), apart(k < chords ? k : chords - 1));
}

void Settling::limit_growth(std::vector<double>& stiffness) const {
  const std::size_t chords = chord_count();
  for (int round = 0; round < (run_.is_closed ? 2 : 1); ++round) {
    for (std::size_t k = 0; k < chords; ++k)
      stiffness[next(k)] = std::min(stiffness[next(k)], stiffness[k] + apart(k));
    for (std::size_t k = chords; k-- > 0;) stiffness[k] = std::min(stiffness[k], stiffness[next(k)] + apart(k));
  }
}

void Settling::begin_evenly(std::size_t apart) {
  for (std::size_t i = 0; i < fine_.size(); i += apart) {
    run_.nodes.push_back(fine_[i]);
    run_.at.push_back(i);
  }
  run_.cells = cells_;
  run_.stiffness.assign(run_.nodes.size(), std::min(static_cast<double>(apart) * noise_.least_stiffness, stiffest()));
  run_.is_held.assign(run_.nodes.size(), false);
  begin();
}

void Settling::begin() {
  placed_.assign(edges_.size(), Placed{});
  has_changed_.assign(edges_.size(), 1);
  solved_.assign(run_.nodes.size(), 0.0);
  is_active_.assign(run_.nodes.size(), 1);
  misfits_.assign(chord_count(), 0);
  note_chords();
  is_stale_.assign(chord_count(), 1);
  curve_.reset(run_.nodes, run_.is_closed);
}

void Settling::note_chords() {
  chord_of_.clear();
  chord_of_.reserve(cells_);
  for (std::size_t k = 0; k < chord_count(); ++k)
    chord_of_.insert(chord_of_.end(), cells_of(k), static_cast<std::uint32_t>(k));
}

bool Settling::place() {
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
    // A pixel widens a transition twice: as the mean over its area, and as a step.
    blurs += weight * (edges_[i].variance - kVarianceOfPixel) * weight * weight;
    weights += weight;
  }
  if (noise_.is_blurred && are_all) blur_ = std::max(kVarianceOfPixel, weights > 0.0 ? blurs / weights : 0.0);
  was_stale_ = std::exchange(is_stale_, std::vector<char>(is_stale_.size(), 0));
  return true;
}

Placed Settling::beside(const Edge& edge, std::size_t at) const {
  constexpr int kMostSteps = 6;
  const std::vector<Chord>& chords = curve_.chords();
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

double Settling::farthest() {
  is_stale_.assign(chord_count(), 1);
  place();
  double out = 0.0;
  for (std::size_t i = 0; i < placed_.size(); ++i) {
    const Chord& chord = curve_.chords()[placed_[i].chord];
    const double away = size_of(chord.from + (placed_[i].t * chord.size) * chord.along - edges_[i].at);
    // NaN stays NaN.
    if (!(away <= out)) out = away;
  }
  return out;
}

void Settling::step(int times) {
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
  // A step of more than a few pixels is outside the linear range.
  constexpr double kMostStep = 4.0;
  for (double& offset : offsets_) offset = std::clamp(offset, -kMostStep, kMostStep);
  for (std::size_t i = 0; i < placed_.size(); ++i) {
    Placed& edge = placed_[i];
    const std::size_t there = next(edge.chord);
    if (!is_active_[edge.chord] && !is_active_[there]) continue;
    edge.offset -= (1.0 - edge.t) * offsets_[edge.chord] + edge.t * offsets_[there];
    has_changed_[i] = 1;
  }
  // Edges are placed again beside nodes that moved by more than a part of the noise.
  constexpr double kMoved = 0.25;
  for (const Stretch& stretch : stretches) {
    for (std::size_t i = 0, k = stretch.first; i < stretch.count; ++i, k = next(k)) {
      run_.nodes[k] = run_.nodes[k] + offsets_[k] * curve_.normal(k);
      solved_[k] = run_.stiffness[k];
      // NaN counts as moved.
      if (!(std::abs(offsets_[k]) <= kMoved * noise_.one)) make_stale(k);
    }
  }
  for (const Stretch& stretch : stretches) curve_.renew(run_.nodes, stretch.first, stretch.count);
}

std::vector<Settling::Stretch> Settling::find_active() {
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

void Settling::solve(const Stretch& stretch, int times) {
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
  // Nodes stay where no edge determines them.
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

void Settling::make_stale(std::size_t node) {
  const std::size_t chords = chord_count();
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t k = node + i;
    if (run_.is_closed)
      is_stale_[(k + chords - 2) % chords] = 1;
    else if (k >= 2 && k - 2 < chords)
      is_stale_[k - 2] = 1;
  }
}

void Settling::add_penalty(StiffSystem& system, std::ptrdiff_t first, std::size_t before) const {
  const std::vector<Chord>& chords = curve_.chords();
  const std::size_t here = next(before);
  const std::size_t after = next(here);
  constexpr double kLeast = 1e-3;
  const double a = std::max(chords[before].size, kLeast);
  const double b = std::max(chords[here].size, kLeast);
  const double c = std::max(chords[after].size, kLeast);
  const double bend = curve_.curvature(here);
  const double next_bend = curve_.curvature(after);
  const double in = 2.0 / (a + b);
  const double on = 2.0 / (b + c);
  double stiffness = std::min(run_.stiffness[here], run_.stiffness[after]);
  double change = 0.0;
  if (!calm_.at.empty()) {
    change = calm_.at[after] - calm_.at[here];
    const double most = std::min(kMostNodes * std::min({a, b, c}), stiffest());
    stiffness = calm_.is_level[here] != 0 ? most : std::min(calm_.factor * stiffness, most);
  }
  const double square = stiffness * stiffness;
  // The curvature of three nodes is that at their mean.
  const double weight = square * square * square * 3.0 / (a + b + c);
  system.add(first,
             std::array{-in / a, on / b + 2.0 / (a * b) - bend * bend, next_bend * next_bend - 2.0 / (b * c) - in / b,
                        on / c},
             bend - next_bend + change, weight);
}

void Settling::settle() {
  // An oscillating part, such as a corner at the least stiffness, is left until its surroundings change.
  place();
  was_stale_.assign(chord_count(), 0);
  // New nodes may move far.
  const bool is_first = std::exchange(is_remeshed_, false);
  step(is_first ? 1 : kTimes);
  // Correct the error of the parabolas between the nodes.
  if (place() || is_first) step(kTimes);
  // If there are isolated deviations, step again without them.
  was_stale_.assign(chord_count(), 0);
  if (find_alone()) step(kTimes);
}

void Settling::settle_all() {
  is_stale_.assign(chord_count(), 1);
  solved_.assign(run_.nodes.size(), 0.0);
  settle();
}

bool Settling::find_alone() {
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

bool Settling::is_astray(std::size_t node) const {
  if (fine_.empty()) return false;
  const double away = size_of(run_.nodes[node] - fine_[run_.at[node]]);
  return !(away <= kMostAstray);
}

bool Settling::call_back() {
  bool out = false;
  for (std::size_t k = 0; k < run_.nodes.size(); ++k) {
    if (!is_astray(k)) continue;
    run_.nodes[k] = fine_[run_.at[k]];
    solved_[k] = 0.0;
    make_stale(k);
    if (k < chord_count()) misfits_[k] = 1;
    if (k > 0 || run_.is_closed) misfits_[k > 0 ? k - 1 : chord_count() - 1] = 1;
    out = true;
  }
  if (out) curve_.reset(run_.nodes, run_.is_closed);
  return out;
}

bool Settling::find_misfits() {
  for (std::size_t i = 0; i < placed_.size(); ++i) {
    const Placed& edge = placed_[i];
    residuals_[i] = {edge.offset, is_alone_[i] != 0 ? 0.0 : edge.weight, edge.jumps, has_changed_[i] != 0};
    if (has_changed_[i] != 0) misfits_[edge.chord] = 0;
  }
  has_changed_.assign(has_changed_.size(), 0);
  bool out = call_back();
  for_each_misfit(residuals_, run_.is_closed, noise_.one, window_sums_, [&](std::size_t first, std::size_t window) {
    const std::size_t count = edges_.size();
    const std::size_t from = placed_[first % count].chord;
    const std::size_t to = placed_[(first + window - 1) % count].chord;
    const std::size_t chords = misfits_.size();
    const std::size_t all = (to >= from ? to - from : to + chords - from) + 1;
    // A smaller window has already found this misfit.
    for (std::size_t i = 0; i < all; ++i)
      if (misfits_[(from + i) % chords] != 0) return;
    for (std::size_t i = 0; i < all; ++i) misfits_[(from + i) % chords] = 1;
    out = true;
  });
  return out;
}

void Settling::remesh(std::vector<char> split, bool are_fine) {
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
    finer.nodes.push_back(are_fine ? fine_[middle] : curve_.chords()[k].at(0.5));
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
  curve_.reset(run_.nodes, run_.is_closed);
}

std::vector<double> walked(std::span<const Vec2> nodes, bool is_closed, std::span<const Edge> edges) {
  std::vector<double> out;
  if (edges.empty()) return out;
  out.reserve(edges.size());
  const std::size_t chords = is_closed ? nodes.size() : nodes.size() - 1;
  const auto next = [&](std::size_t k) { return k + 1 < nodes.size() ? k + 1 : 0; };
  const auto to_first = [&](Vec2 q) { return dot(q - edges.front().at, q - edges.front().at); };
  std::size_t chord = 0;
  if (is_closed) chord = static_cast<std::size_t>(std::ranges::min_element(nodes, {}, to_first) - nodes.begin());
  // The next edge is about this share of a chord farther.
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

}  // namespace mes
