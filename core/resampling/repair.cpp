// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/resampling/repair.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "core/base/counted.h"
#include "core/graph/explain.h"
#include "core/resampling/internal/before_and_now.h"
#include "core/resampling/internal/repair_on_curves.h"
#include "core/resampling/internal/sampled_curve.h"

namespace mes {
namespace {

constexpr int kMostHalvings = 20;
/// Beyond this depth a piece of the curve is halved at a few places only, as beside a crossing, but not throughout, as
/// where the curve runs back along itself.
constexpr int kHalvingsThroughout = 10;
constexpr std::size_t kFewPlaces = 64;
constexpr int kMostRounds = 200;
constexpr int kMostDoubts = 6;
constexpr int kMostRestarts = 8;
/// Limits the number of samples: where curves meet, as in a lattice, no number would be enough.
std::size_t most_samples(std::size_t given) {
  constexpr std::size_t kForEach = 64;
  constexpr std::size_t kMostNew = 200'000;
  return given + std::min(kForEach * given, kMostNew);
}

/// A cubic through two samples with the tangents of the curve there.
struct SplinePiece {
  Vec2 a{}, b{};
  Vec2 tangent_a{}, tangent_b{};  // derivatives by the parameter, which runs from 0 to 1

  Vec2 at(double u) const {
    const double v = 1.0 - u;
    return (v * v * (1.0 + 2.0 * u)) * a + (u * v * v) * tangent_a + (u * u * (1.0 + 2.0 * v)) * b +
           (-u * u * v) * tangent_b;
  }
};

// Tangent of the centripetal Catmull-Rom spline through three points at the middle one, scaled by the parameter step to
// the neighbour `next`.
Vec2 tangent_at(Vec2 p, Vec2 q, Vec2 r, Vec2 next) {
  const double before = std::sqrt(distance(p, q));
  const double after = std::sqrt(distance(q, r));
  const double step = std::sqrt(distance(q, next));
  const Vec2 slope = (step / before) * (q - p) - (step / (before + after)) * (r - p) + (step / after) * (r - q);
  return before > 0.0 && after > 0.0 && is_finite(slope) ? slope : Vec2{};
}

/// A sample on the curve.
struct Knot {
  std::uint32_t sample = 0;
  std::size_t piece = 0;  ///< index of its spline piece
  double u = 0.0;         ///< parameter on that piece
};

class RepairedChain {
 public:
  RepairedChain(const MovingCurve::Chain& chain, std::span<const Vec2> positions, const std::vector<bool>& is_corner)
      : is_closed_(chain.closed && chain.points.size() > 2) {
    // Consecutive samples at the same position become one: there is no edge between them to halve.
    std::vector<std::uint32_t> points;
    for (const std::uint32_t sample : chain.points)
      if (points.empty() || positions[points.back()] != positions[sample]) points.push_back(sample);
    while (is_closed_ && points.size() > 1 && positions[points.back()] == positions[points.front()])
      points.pop_back();
    is_closed_ = is_closed_ && points.size() > 2;
    const std::size_t n = points.size();
    const auto place = [&](std::size_t i) { return positions[points[i % n]]; };
    for (std::size_t i = 0; i < n; ++i) knots_.push_back({points[i], i, 0.0});
    for (std::size_t i = 0; i < (is_closed_ ? n : n - 1); ++i) {
      SplinePiece piece{place(i), place(i + 1), place(i + 1) - place(i), place(i + 1) - place(i)};
      if ((is_closed_ || i > 0) && !is_corner[points[i]])
        piece.tangent_a = tangent_at(place(i + n - 1), piece.a, piece.b, piece.b);
      if ((is_closed_ || i + 2 < n) && !is_corner[points[(i + 1) % n]])
        piece.tangent_b = tangent_at(piece.a, piece.b, place(i + 2), piece.a);
      pieces_.push_back(piece);
    }
  }

  bool is_closed() const { return is_closed_; }
  const std::vector<Knot>& knots() const { return knots_; }
  std::size_t edges() const { return is_closed_ ? knots_.size() : knots_.size() - 1; }
  std::uint32_t from(std::size_t edge) const { return knots_[edge].sample; }
  std::uint32_t to(std::size_t edge) const { return knots_[(edge + 1) % knots_.size()].sample; }

  std::size_t pieces() const { return pieces_.size(); }
  std::size_t piece_of(std::size_t edge) const { return knots_[edge].piece; }
  /// The parameter middle of an edge.
  Knot middle(std::size_t edge) const {
    const Knot& knot = knots_[edge];
    return {0, knot.piece, knot.u + 0.5 * length_of(edge)};
  }
  bool was_halved(std::size_t edge, int times) const { return length_of(edge) <= std::ldexp(1.0, -times); }
  Vec2 place_of(const Knot& knot) const { return pieces_[knot.piece].at(knot.u); }
  /// Inserts each knot after the knot with the given index; the indices increase.
  void insert(const std::vector<std::pair<std::size_t, Knot>>& added) {
    std::vector<Knot> knots;
    knots.reserve(knots_.size() + added.size());
    auto next = added.begin();
    for (std::size_t i = 0; i < knots_.size(); ++i) {
      knots.push_back(knots_[i]);
      for (; next != added.end() && next->first == i; ++next) knots.push_back(next->second);
    }
    knots_ = std::move(knots);
  }

 private:
  /// Length in the parameter of the piece.
  double length_of(std::size_t edge) const {
    const Knot& knot = knots_[edge];
    const Knot& next = knots_[(edge + 1) % knots_.size()];
    return (next.piece == knot.piece && next.u > knot.u ? next.u : 1.0) - knot.u;
  }

  bool is_closed_;
  std::vector<Knot> knots_;
  std::vector<SplinePiece> pieces_;
};

class Repairer {
 public:
  Repairer(const Registry& registry, JudgedSamples& samples, const MovingCurve& curve, double epsilon)
      : registry_(registry),
        samples_(samples),
        epsilon_(epsilon),
        most_(most_samples(samples.positions().size())),
        is_corner_(corners_of(curve, samples.positions(), epsilon)) {
    is_end_.assign(samples.positions().size(), false);
    is_crossing_ = is_end_;
    std::map<std::pair<double, double>, std::uint32_t> at_place;
    for (const Vec2 p : samples.positions()) {
      const auto number = static_cast<std::uint32_t>(first_at_.size());
      first_at_.push_back(at_place.try_emplace({p.x, p.y}, number).first->second);
    }
    std::vector<std::set<std::uint32_t>> neighbours(first_at_.size());
    for (const MovingCurve::Chain& chain : curve.chains) {
      for (std::size_t i = chain.closed ? 0 : 1; i < chain.points.size(); ++i) {
        const std::uint32_t a = first_at_[chain.points[i == 0 ? chain.points.size() - 1 : i - 1]];
        const std::uint32_t b = first_at_[chain.points[i]];
        if (a == b) continue;
        neighbours[a].insert(b);
        neighbours[b].insert(a);
      }
      if (!chain.closed && !chain.points.empty()) is_end_[chain.points.front()] = is_end_[chain.points.back()] = true;
    }
    // The spline breaks where a loop returns along itself, as at a corner.
    std::vector<bool> is_interrupted = is_corner_;
    for (std::size_t i = 0; i < first_at_.size(); ++i)
      if (neighbours[first_at_[i]].size() == 1) is_interrupted[i] = true;
    for (const MovingCurve::Chain& chain : curve.chains)
      if (chain.points.size() >= 2) chains_.emplace_back(chain, samples.positions(), is_interrupted);
    for (const RepairedChain& chain : chains_) is_given_up_.emplace_back(chain.pieces(), false);
    for (std::size_t i = 0; i < first_at_.size(); ++i)
      if (is_end_[i]) is_end_[first_at_[i]] = true;
    for (std::size_t i = 0; i < first_at_.size(); ++i) {
      const std::size_t count = neighbours[first_at_[i]].size();
      is_crossing_[i] = count > 2;
      // A loop that returns along itself has an end there.
      is_end_[i] = count > 2 || count == 1 || is_end_[first_at_[i]];
    }
  }

  Expected<void> run(JobControl& job) {
    const auto too_long = [this](const RepairedChain& chain, std::size_t i) { return is_too_long(chain, i); };
    const auto doubted = [this](const RepairedChain& chain, std::size_t i) { return is_doubted(chain, i); };
    const State given = state();
    for (int i = 0;; ++i) {
      if (auto good = halve_all(too_long, kMostRounds, job); !good) return good;
      if (i == kMostRestarts || !give_up_pieces()) break;
      if (auto good = restore(given, job); !good) return good;
    }
    if (auto good = samples_.check_theorem(job); !good) return good;
    if (samples_.light() != TheoremLight::yellow) return {};
    // The edges are short enough by the estimate. Where the theorem's conditions still fail, the estimate may have been
    // too large, so more edges are halved. If that does not help, as beside a crust edge off the curve, this is undone.
    const State before = state();
    for (int i = 0; i < kMostDoubts && samples_.light() == TheoremLight::yellow; ++i) {
      if (auto good = halve_all(doubted, 1, job); !good) return good;
      if (auto good = halve_all(too_long, kMostRounds, job); !good) return good;
      if (auto good = samples_.check_theorem(job); !good) return good;
    }
    if (samples_.light() != TheoremLight::yellow) return {};
    return restore(before, job);
  }

  void report(const MovingCurve& curve, Repair& out) const {
    const auto positions = samples_.positions();
    std::map<std::uint32_t, std::size_t> corner_at;  // by the first sample at the same position
    for_each_moving(curve, [&](std::uint32_t before, std::uint32_t at, std::uint32_t after) {
      if (!is_corner_[at] || is_end_[at]) return;
      const double degrees = 180.0 - turn_at(positions[before], positions[at], positions[after]);
      // A corner that the curve passes twice counts once.
      const auto [known, is_new] = corner_at.try_emplace(first_at_[at], out.corners.size());
      if (is_new) {
        out.corners.push_back({positions[at], degrees});
      } else {
        out.corners[known->second].degrees = std::min(out.corners[known->second].degrees, degrees);
      }
    });
    for (std::size_t i = 0; i < is_end_.size(); ++i)
      if (is_end_[i] && first_at_[i] == i) out.open_ends.push_back(positions[i]);
    const bool is_doubtful = samples_.light() == TheoremLight::yellow;
    for (const RepairedChain& chain : chains_) {
      for (std::size_t i = 0; i < chain.edges(); ++i) {
        if (!is_too_long(chain, i) && !(is_doubtful && is_doubted(chain, i))) continue;
        const Vec2 a = positions[chain.from(i)];
        const Vec2 b = positions[chain.to(i)];
        out.left.push_back({0.5 * a.x + 0.5 * b.x, 0.5 * a.y + 0.5 * b.y});
      }
    }
  }

  /// Loops with the new samples, in the order of the given chains.
  std::vector<SampleData::Contour> contours(const std::vector<SampleData::Contour>& given) const {
    std::vector<SampleData::Contour> out;
    auto next = chains_.begin();
    for (const SampleData::Contour& contour : given) {
      out.push_back(contour);
      if (contour.points.size() < 2) continue;
      out.back().points.clear();
      for (const Knot& knot : (next++)->knots()) out.back().points.push_back(knot.sample);
    }
    return out;
  }

 private:
  struct State {
    SampleData samples;
    std::vector<RepairedChain> chains;
  };

  State state() const { return {{.positions = {samples_.positions().begin(), samples_.positions().end()}}, chains_}; }

  Expected<void> restore(const State& state, JobControl& job) {
    auto again = JudgedSamples::of(registry_, state.samples, job);
    if (!again) return std::unexpected(again.error());
    samples_ = *std::move(again);
    chains_ = state.chains;
    first_at_.resize(state.samples.positions.size());
    return {};
  }

  /// Gives up the pieces of the curve that `halve` would halve throughout without an end, so that they keep their
  /// edges. Returns whether there are such pieces.
  bool give_up_pieces() {
    bool is_any = false;
    for (std::size_t c = 0; c < chains_.size(); ++c) {
      std::vector<std::size_t> count(chains_[c].pieces(), 0);
      for (std::size_t i = 0; i < chains_[c].edges(); ++i) {
        const std::size_t piece = chains_[c].piece_of(i);
        if (is_given_up_[c][piece] || !is_too_long(chains_[c], i) || ++count[piece] <= kFewPlaces) continue;
        is_given_up_[c][piece] = is_any = true;
      }
    }
    return is_any;
  }

  /// The first samples at the two end positions of an edge, the smaller number first.
  std::pair<std::uint32_t, std::uint32_t> places_of(const RepairedChain& chain, std::size_t i) const {
    return std::minmax(std::uint32_t{first_at_[chain.from(i)]}, std::uint32_t{first_at_[chain.to(i)]});
  }
  bool is_crossing(std::uint32_t sample) const { return sample < is_crossing_.size() && is_crossing_[sample]; }
  /// Whether the sample is a corner, or an end or junction of the curve: the estimate is meaningless there.
  bool is_corner(std::uint32_t sample) const {
    return sample < is_corner_.size() && (is_corner_[sample] || is_end_[sample]);
  }
  bool ends_at_corner(const RepairedChain& chain, std::size_t i) const {
    return is_corner(chain.from(i)) || is_corner(chain.to(i));
  }
  // At a corner the ratio stays the same however short the edge becomes; where the curve meets itself, so does the
  // crust.
  bool is_too_long(const RepairedChain& chain, std::size_t i) const {
    if (is_crossing(chain.from(i)) || is_crossing(chain.to(i))) return false;
    const auto verdict = samples_.judge(chain.from(i), chain.to(i));
    return !verdict.is_curve || (!ends_at_corner(chain, i) && verdict.epsilon > epsilon_);
  }
  bool is_doubted(const RepairedChain& chain, std::size_t i) const {
    return !ends_at_corner(chain, i) && samples_.judge(chain.from(i), chain.to(i)).is_doubted;
  }

  template <class Wants>
  Expected<void> halve_all(const Wants& wants, int rounds, JobControl& job) {
    for (int round = 0; round < rounds; ++round) {
      job.checkpoint();
      const auto halved = halve(wants, job);
      if (!halved) return std::unexpected(halved.error());
      if (!*halved) break;
    }
    return {};
  }

  /// Halves the edges for which `wants(chain, edge)` holds; returns whether there was such an edge.
  template <class Wants>
  Expected<bool> halve(const Wants& wants, JobControl& job) {
    std::vector<Vec2> places;
    std::vector<std::vector<std::pair<std::size_t, Knot>>> added(chains_.size());
    const auto positions = samples_.positions();
    auto next = static_cast<std::uint32_t>(positions.size());
    // An edge that the curve passes twice is halved once: the second pass shares the sample of the first.
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> halved;
    for (std::size_t c = 0; c < chains_.size(); ++c) {
      const RepairedChain& chain = chains_[c];
      std::vector<std::size_t> wanted;
      std::vector<std::size_t> count(chain.pieces(), 0);
      for (std::size_t i = 0; i < chain.edges(); ++i) {
        if (is_given_up_[c][chain.piece_of(i)] || chain.was_halved(i, kMostHalvings) || !wants(chain, i)) continue;
        wanted.push_back(i);
        ++count[chain.piece_of(i)];
      }
      for (const std::size_t i : wanted) {
        if (chain.was_halved(i, kHalvingsThroughout) && count[chain.piece_of(i)] > kFewPlaces) continue;
        Knot knot = chain.middle(i);
        const Vec2 place = chain.place_of(knot);
        if (!is_finite(place) || place == positions[chain.from(i)] || place == positions[chain.to(i)]) continue;
        const auto [at, is_new] = halved.try_emplace(places_of(chain, i), next);
        knot.sample = at->second;
        if (is_new) {
          places.push_back(place);
          ++next;
        }
        added[c].emplace_back(i, knot);
      }
    }
    if (places.empty() || positions.size() + places.size() > most_) return false;
    if (auto good = samples_.insert(places, job); !good) return std::unexpected(good.error());
    while (first_at_.size() < samples_.positions().size())
      first_at_.push_back(static_cast<std::uint32_t>(first_at_.size()));
    for (std::size_t c = 0; c < chains_.size(); ++c) chains_[c].insert(added[c]);
    return true;
  }

  const Registry& registry_;
  JudgedSamples& samples_;
  double epsilon_;
  std::size_t most_;  // largest number of samples
  std::vector<bool> is_corner_;
  std::vector<bool> is_end_;             // an end of the curve, or a crossing
  std::vector<bool> is_crossing_;        // a sample at which more than two edges meet
  std::vector<std::uint32_t> first_at_;  // by sample: the first sample at the same position
  std::vector<RepairedChain> chains_;
  std::vector<std::vector<bool>> is_given_up_;  // by chain and piece
};

std::string place_and_more(Vec2 place, std::size_t count) {
  return "at " + place_text(place) + (count > 1 ? ", and " + std::to_string(count - 1) + " more" : std::string());
}

/// The verdict also measures edges off the repaired curve.
void name_sparsest(double epsilon, Repair& out) {
  if (out.left.empty() && out.after.epsilon && out.after.epsilon->value > epsilon)
    out.left.push_back(out.after.sparsest);
}

}  // namespace

Expected<Repair> repair(const Registry& registry, const SampleData& data, double epsilon, JobControl& job) {
  auto on_curves = repair_on_curves(registry, data, epsilon, job);
  if (!on_curves) return std::unexpected(on_curves.error());
  if (*on_curves) {
    name_sparsest(epsilon, **on_curves);
    return **std::move(on_curves);
  }
  auto samples = JudgedSamples::of(registry, data, job);
  if (!samples) return std::unexpected(samples.error());
  const MovingCurve curve = curve_of(data, job);
  Repairer repairer(registry, *samples, curve, epsilon);
  Repair out;
  out.before = out.after = samples->verdict();
  out.no_axis = samples->why_no_axis();
  if (!out.no_axis.empty()) {
    out.data = data;
    return out;
  }
  if (auto good = repairer.run(job); !good) return std::unexpected(good.error());
  out.data = data;
  out.data.positions.assign(samples->positions().begin(), samples->positions().end());
  out.data.contours = repairer.contours(data.contours);
  out.inserted = out.data.positions.size() - data.positions.size();
  out.after = samples->verdict();
  repairer.report(curve, out);
  name_sparsest(epsilon, out);
  return out;
}

std::vector<std::string> Repair::words() const {
  if (!no_axis.empty()) return {"nothing to repair: " + no_axis};
  if (crossings != 0)
    return {"nothing was repaired: sides of outlines cross " +
            (crossings == 1 ? std::string("once") : std::to_string(crossings) + " times") +
            ", and no samples are dense enough there"};
  std::vector<std::string> out;
  out.push_back(counted(inserted, "sample", "samples") +
                (is_on_curves ? " inserted on the curves; " : " inserted; ") + before_and_now(before, after));
  if (off_curve != 0)
    out.push_back(counted(off_curve, "sample", "samples") + " off the curves " + (off_curve == 1 ? "stays" : "stay") +
                  " as before");
  if (!corners.empty()) {
    const auto sharpest = std::ranges::min_element(corners, {}, &SampledCorner::degrees);
    out.push_back("at " + counted(corners.size(), "corner", "corners") +
                  " no samples are dense enough: the sharpest has " + number_text(sharpest->degrees) + " degrees, " +
                  place_and_more(sharpest->place, corners.size()));
  }
  if (!left.empty())
    out.push_back(counted(left.size(), "curve edge", "curve edges") + " could not be made short enough, " +
                  place_and_more(left.front(), left.size()));
  if (!open_ends.empty())
    out.push_back("the curve has " + counted(open_ends.size(), "end or junction", "ends or junctions") +
                  ", where its edges stay as they are, " + place_and_more(open_ends.front(), open_ends.size()));
  return out;
}

}  // namespace mes
