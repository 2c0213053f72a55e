// SPDX-License-Identifier: GPL-3.0-or-later
// Subdivision: inserts a sample between each two neighbours; existing samples may move.
//
// The cubic B-spline mask is that of Lane and Riesenfeld (1980), the rule of Mesecina from its beginning; Chaikin's
// gives quadratic B-splines (1974); the four-point scheme, of Dyn, Levin and Gregory (1987), and midpoints keep every
// sample. The ends of an open chain stay.
#include <fmt/core.h>
#include <array>
#include <string>

#include "core/evolutions/evolution.h"

namespace mes {
namespace {

constexpr std::size_t kMostSamples = 4'000'000;

enum class Scheme : std::uint8_t { cubic, chaikin, four_point, midpoint };
const Parameter kScheme{
    .id = "subdivide-scheme",
    .explanation =
        "0: cubic B-spline; 1: Chaikin's corner cutting; 2: four-point, through every sample; 3: "
        "midpoints",
    .high = 3.0,
    .is_whole = true,
    .title = "Scheme",
    .window_explanation = "What the curve through the samples becomes",
    .choices = {"Cubic B-spline", "Corner cutting (Chaikin)", "Four-point, through every sample", "Midpoints"}};

/// Indexes the samples of one chain, also beyond its ends.
class Walk {
 public:
  Walk(const MovingCurve::Chain& chain, const std::vector<Vec2>& positions)
      : at_(chain.points), closed_(chain.closed), positions_(positions) {}

  std::size_t size() const { return at_.size(); }
  std::size_t edge_count() const { return closed_ ? size() : size() - 1; }
  bool has_neighbours(std::size_t i) const { return closed_ || (i > 0 && i + 1 < size()); }
  /// Beyond an open end the chain is extended straight.
  Vec2 operator[](std::ptrdiff_t i) const {
    const auto n = static_cast<std::ptrdiff_t>(size());
    if (closed_) return positions_[at_[static_cast<std::size_t>((i + n) % n)]];
    if (i < 0) return 2.0 * (*this)[0] - (*this)[1];
    if (i >= n) return 2.0 * (*this)[n - 1] - (*this)[n - 2];
    return positions_[at_[static_cast<std::size_t>(i)]];
  }

 private:
  const std::vector<std::uint32_t>& at_;
  bool closed_;
  const std::vector<Vec2>& positions_;
};

/// New position of sample i.
Vec2 moved(Scheme scheme, const Walk& walk, std::ptrdiff_t i) {
  if (scheme == Scheme::cubic) return 0.125 * walk[i - 1] + 0.75 * walk[i] + 0.125 * walk[i + 1];
  if (scheme == Scheme::chaikin) return 0.75 * walk[i] + 0.25 * walk[i + 1];
  return walk[i];
}

/// The new sample between i and i + 1.
Vec2 between(Scheme scheme, const Walk& walk, std::ptrdiff_t i) {
  if (scheme == Scheme::chaikin) return 0.25 * walk[i] + 0.75 * walk[i + 1];
  if (scheme == Scheme::four_point)
    return 0.5625 * walk[i] + 0.5625 * walk[i + 1] - 0.0625 * walk[i - 1] - 0.0625 * walk[i + 2];
  return 0.5 * walk[i] + 0.5 * walk[i + 1];
}

// Chaikin cuts corners; the last edge of an open chain has no corner to cut.
std::size_t new_samples(Scheme scheme, const Walk& walk, bool closed) {
  const std::size_t edges = walk.edge_count();
  return scheme == Scheme::chaikin && !closed && edges > 0 ? edges - 1 : edges;
}

Expected<EvolutionState> subdivide_step(const EvolutionState& state, const EvolutionStep& step) {
  const auto scheme = static_cast<Scheme>(step.choice.values[kScheme]);
  std::size_t wanted = state.positions.size();
  for (const MovingCurve::Chain& chain : step.curve.chains)
    wanted += new_samples(scheme, Walk(chain, state.positions), chain.closed);
  if (wanted > kMostSamples)
    return std::unexpected(
        Error{ErrorCode::cannot_compute,
              fmt::format("step {} would make {} samples; {} are the most", step.number + 1, wanted, kMostSamples),
              {},
              0,
              0});
  EvolutionState out{state.positions, nullptr, nullptr};
  out.positions.reserve(wanted);
  MovingCurve refined;
  for (const MovingCurve::Chain& chain : step.curve.chains) {
    const Walk walk(chain, state.positions);
    const std::size_t added = new_samples(scheme, walk, chain.closed);
    MovingCurve::Chain& to = refined.chains.emplace_back(MovingCurve::Chain{chain.closed, {}});
    to.points.reserve(walk.size() + added);
    for (std::size_t i = 0; i < walk.size(); ++i) {
      const std::uint32_t sample = chain.points[i];
      const auto at = static_cast<std::ptrdiff_t>(i);
      if (step.curve.may_move[sample] && walk.has_neighbours(i)) out.positions[sample] = moved(scheme, walk, at);
      to.points.push_back(sample);
      if (i >= added) continue;
      to.points.push_back(static_cast<std::uint32_t>(out.positions.size()));
      out.positions.push_back(between(scheme, walk, at));
    }
  }
  gather_followers(step.curve, out.positions);

  std::vector<std::uint32_t> numbers = *state.numbers;
  std::uint32_t next = numbers.empty() ? 0 : numbers.back() + 1;
  while (numbers.size() < out.positions.size()) numbers.push_back(next++);
  out.numbers = std::make_shared<const std::vector<std::uint32_t>>(std::move(numbers));
  if (state.curve) {
    MovingCurve curve = known_curve(std::move(refined.chains), out.positions.size());
    curve.is_known = state.curve->is_known;
    curve.followers = state.curve->followers;
    out.curve = std::make_shared<const MovingCurve>(std::move(curve));
  }
  return out;
}

}  // namespace

Evolution subdivide_evolution() {
  return {{"subdivide",
           "Subdivide",
           "A subdivision scheme inserts a sample between every two neighbours on the curve",
           false,
           {kScheme}},
          subdivide_step};
}

}  // namespace mes
