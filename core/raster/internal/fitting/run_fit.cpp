// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/raster/internal/fitting/run_fit.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "core/raster/internal/fitting/curvature.h"
#include "core/raster/internal/fitting/node_curve.h"
#include "core/raster/internal/fitting/settling.h"

namespace mes {
namespace {

constexpr std::size_t kLeastChordsClosed = 16;
constexpr std::size_t kLeastChordsOpen = 5;
constexpr double kCoarsest = 16.0;  // pixels between nodes

class Fit : private Settling {
 public:
  using Settling::Settling;

  Run result() && {
    measure_noise();
    begin_coarse();
    descend();
    stiffen();
    run_.farthest = farthest();
    for (std::size_t k = 0; k < run_.nodes.size(); ++k)
      if (is_astray(k)) run_.farthest = std::numeric_limits<double>::infinity();
    return std::move(run_);
  }

  Run refined() && {
    const bool is_near = refine();
    run_.farthest = is_near ? farthest() : std::numeric_limits<double>::infinity();
    return std::move(run_);
  }

  Run with_few_extremes() && {
    calm();
    run_.farthest = farthest();
    return std::move(run_);
  }

  /// Adds the distances of the edges from the curve at the least stiffness.
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
  void begin_coarse() {
    const std::size_t least = run_.is_closed ? kLeastChordsClosed : kLeastChordsOpen;
    std::size_t apart = 1;
    while (cells_ % (2 * apart) == 0 && cells_ / (2 * apart) >= least &&
           cell_size() * static_cast<double>(2 * apart) < 1.5 * kCoarsest)
      apart *= 2;
    begin_evenly(apart);
    if (run_.is_closed) return;
    // The ends need fine nodes, because corners follow there.
    for (; apart > 1; apart /= 2) {
      std::vector<char> split(chord_count(), 0);
      split.front() = split.back() = 1;
      remesh(std::move(split), true);
    }
  }

  /// Measures the error of a single edge from the residuals at the least stiffness, for long curves in some parts.
  /// Corners leave much larger residuals, so the smallest quarter of the residuals counts.
  void measure_noise() {
    constexpr double kPerDeviation = 5.0;
    constexpr double kNormal = 1.0 / 0.3186;  // from that quartile of magnitudes to the deviation
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
        // The edges of a closed curve begin in some cell.
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

  /// Halves stiffness and node distance where the curve does not fit, until it fits or the stiffness is the least.
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

  /// The doubled stiffness at the nodes, except at held ones.
  std::vector<double> doubled() const {
    std::vector<double> out = run_.stiffness;
    for (std::size_t k = 0; k < out.size(); ++k)
      if (!run_.is_held[k])
        out[k] = std::max(out[k], std::min({2.0 * out[k], kMostNodes * least_apart(k), stiffest()}));
    limit_growth(out);
    return out;
  }

  /// Keeps the nodes and doubles the stiffness wherever that fits, until it fits nowhere. Each stretch that becomes
  /// stiffer is judged separately: residuals beside nodes that are already held do not count against it.
  void stiffen() {
    constexpr int kRounds = 16;
    const std::size_t count = run_.nodes.size();
    for (int round = 0; round < kRounds; ++round) {
      std::vector<double> before = doubled();
      std::swap(before, run_.stiffness);
      const auto is_stiffer = [&](std::size_t k) { return run_.stiffness[k] > 1.01 * before[k]; };
      std::size_t first = 0;  // start where no stretch continues
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

  /// Reduces the extremes of curvature as far as the edges allow. At first only level parts become stiff, so that the
  /// rest can follow; then the whole curve becomes stiffer in steps, as long as the number of misfits does not grow.
  void calm() {
    constexpr double kLeastShare = 0.2;
    constexpr int kLooseRounds = 5;
    constexpr double kStiffest = 64.0;
    settle_all();
    find_misfits();
    const auto known = std::ranges::count(misfits_, 1);
    std::vector<Vec2> best = run_.nodes;
    const std::vector<Vec2> before = best;
    bool is_calmer = false;
    for (double share = 1.0; share > kLeastShare && !is_calmer; share *= 0.5) {
      run_.nodes = before;
      curve_.reset(run_.nodes, run_.is_closed);
      for (double factor = 1.0; factor <= kStiffest; factor *= 2.0) {
        for (int round = 0; round < (factor == 1.0 ? kLooseRounds : 1); ++round) settle_calmly(share, factor);
        find_misfits();
        if (std::ranges::count(misfits_, 1) > known) break;
        best = run_.nodes;
        is_calmer = true;
      }
    }
    calm_ = {};
    run_.nodes = std::move(best);
    curve_.reset(run_.nodes, run_.is_closed);
  }

  /// Calms the curvature, with a share of the noise as tolerance, and fits again with `factor` times the stiffness.
  void settle_calmly(double share, double factor) {
    std::vector<double> curvature, lengths;
    for (std::size_t k = 0; k < run_.nodes.size(); ++k) curvature.push_back(curve_.curvature(k));
    for (const Chord& chord : curve_.chords()) lengths.push_back(chord.size);
    calm_ = calmed(curvature, lengths, run_.is_closed, [&](double length) {
      return share * noise_.one * (kSystematic + kIndependent / std::sqrt(std::max(length, 1.0)));
    });
    calm_.factor = factor;
    settle_all();
  }

  /// Makes nodes as dense as cubic pieces on a circle need: their error grows with the fourth power of the turn from
  /// node to node. Returns whether the nodes stay near their old positions.
  bool refine() {
    constexpr std::size_t kFew = 32;
    const double most = most_turn(length_);
    bool is_finer = false;
    for (;;) {
      std::vector<char> split(chord_count(), 0);
      bool is_any = false;
      for (std::size_t k = 0; k < split.size(); ++k) {
        const double stiffness = std::max(run_.stiffness[k], run_.stiffness[next(k)]);
        const bool is_turned = 4.0 * std::abs(curve_.chords()[k].bulge) > most;
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
    if (!is_finer) return true;
    const std::vector<Vec2> before = run_.nodes;
    settle_all();
    constexpr double kMostMoved = 1.0;  // pixels
    return std::ranges::equal(before, run_.nodes, [](Vec2 a, Vec2 b) { return size_of(b - a) <= kMostMoved; });
  }
};

}  // namespace

Run fitted(std::span<const Vec2> start, bool is_closed, std::span<const Edge> edges, const EdgeNoise& noise,
           const JobControl* job) {
  const std::size_t least = is_closed ? kLeastChordsClosed : kLeastChordsOpen;
  // In a short curve, ends and corners are a large part, and nodes cost little.
  constexpr double kShort = 512.0;  // pixels
  const double apart = (length_of(start, is_closed) < kShort ? 0.5 : 0.75) * noise.least_stiffness;
  // A multiple of a power of two, so that node distances can be halved repeatedly.
  auto cells = std::max(least, static_cast<std::size_t>(std::lround(length_of(start, is_closed) / apart)));
  std::size_t together = 1;
  while (cells / (2 * together) >= least && apart * static_cast<double>(2 * together) <= kCoarsest) together *= 2;
  cells = (cells + together / 2) / together * together;
  const double blur = noise.is_blurred ? kVarianceOfPixel : 0.0;
  return Fit(respaced(start, is_closed, is_closed ? cells : cells + 1), is_closed, blur, edges, noise, job).result();
}

double most_turn(double length) {
  constexpr double kWaves = 0.12;  // allows for a remaining edge error of a thousandth of a pixel
  constexpr double kMost = 0.3;
  return std::min(kMost, std::sqrt(std::sqrt(kWaves / std::max(length, 1.0))));
}

Run refined(Run run, std::span<const Edge> edges, const EdgeNoise& noise, const JobControl* job) {
  return Fit(std::move(run), edges, noise, job).refined();
}

Run with_few_extremes(Run run, std::span<const Edge> edges, const EdgeNoise& noise, const JobControl* job) {
  return Fit(std::move(run), edges, noise, job).with_few_extremes();
}

Run evened(const Run& run) {
  Run out{.cells = run.cells, .is_closed = run.is_closed, .farthest = run.farthest};
  const NodeCurve curve(run.nodes, run.is_closed);
  for (std::size_t k = 0; k < run.nodes.size(); ++k) {
    const std::size_t next = k + 1 < run.nodes.size() ? k + 1 : 0;
    const bool is_last = next == 0;
    const std::size_t parts = is_last ? (run.is_closed ? run.cells - run.at[k] : 1) : run.at[next] - run.at[k];
    for (std::size_t i = 0; i < parts; ++i) {
      const double t = static_cast<double>(i) / static_cast<double>(parts);
      out.nodes.push_back(i == 0 ? run.nodes[k] : curve.chords()[k].at(t));
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

}  // namespace mes
