// SPDX-License-Identifier: GPL-3.0-or-later
// Smoothing: moves every sample part of the way to the midpoint of its two neighbours.
//
// On a closed polygon of n samples the k-th Fourier mode is multiplied by 1 - mu (1 - cos(2 pi k / n)) in each step.
// The second pass, of opposite sign, prevents shrinking (Taubin, A signal processing approach to fair surface design,
// SIGGRAPH 1995).
#include <cmath>

#include "core/evolutions/evolution.h"

namespace mes {
namespace {

const Parameter kMu{.id = "smooth-mu",
                    .explanation = "How far a sample moves towards the middle of its neighbours",
                    .low = 0.001,
                    .default_value = 0.5,
                    .title = "Move to the middle"};
const Parameter kBack{.id = "smooth-back",
                      .explanation =
                          "How far it then moves back, which keeps the curve from shrinking (Taubin); usually a "
                          "little more than smooth-mu; 0: it does not move back",
                      .high = 1.5,
                      .title = "Move back",
                      .window_explanation =
                          "How far it then moves back, which keeps the curve from shrinking (Taubin); usually a "
                          "little more than the move to the middle. 0: it does not move back"};
const Parameter kKeepArea{
    .id = "smooth-keep-area",
    .explanation = "1: each loop is scaled about its middle to the area it had; 0: loops shrink",
    .is_whole = true,
    .title = "Keep the area of loops"};

std::vector<Vec2> averaged(const MovingCurve& curve, const std::vector<Vec2>& from, double mu) {
  std::vector<Vec2> out = from;
  for_each_moving(curve, [&](std::uint32_t before, std::uint32_t sample, std::uint32_t after) {
    // Halve before adding: the sum of two large numbers may overflow.
    const Vec2 middle = 0.5 * from[before] + 0.5 * from[after];
    out[sample] = (1.0 - mu) * from[sample] + mu * middle;
  });
  return out;
}

double twice_area(const MovingCurve::Chain& loop, const std::vector<Vec2>& positions) {
  const Vec2 origin = positions[loop.points.front()];
  double sum = 0.0;
  for (std::size_t i = 0; i + 1 < loop.points.size(); ++i)
    sum += cross(positions[loop.points[i]] - origin, positions[loop.points[i + 1]] - origin);
  return sum;
}

// Loops that turn inside out or lose all area, and loops with fixed samples, do not change.
void restore_areas(const MovingCurve& curve, const std::vector<Vec2>& before, std::vector<Vec2>& positions) {
  for (const MovingCurve::Chain& chain : curve.chains) {
    if (!chain.closed) continue;
    const double factor = std::sqrt(twice_area(chain, before) / twice_area(chain, positions));
    if (!std::isfinite(factor) || factor == 0.0) continue;
    Vec2 center;
    bool all_move = true;
    for (const std::uint32_t sample : chain.points) {
      center = center + (1.0 / static_cast<double>(chain.points.size())) * positions[sample];
      all_move = all_move && curve.may_move[sample];
    }
    if (!all_move) continue;
    for (const std::uint32_t sample : chain.points)
      positions[sample] = center + factor * (positions[sample] - center);
  }
}

Expected<EvolutionState> smooth_step(const EvolutionState& state, const EvolutionStep& step) {
  const ParameterValues& values = step.choice.values;
  EvolutionState out{{}, state.numbers, state.curve};
  out.positions = averaged(step.curve, state.positions, values[kMu]);
  if (values[kBack] > 0.0) out.positions = averaged(step.curve, out.positions, -values[kBack]);
  if (values.is_on(kKeepArea)) restore_areas(step.curve, state.positions, out.positions);
  gather_followers(step.curve, out.positions);
  return out;
}

}  // namespace

Evolution smooth_evolution() {
  return {{"smooth",
           "Smooth",
           "Each sample moves towards the middle of its neighbours on the curve",
           false,
           {kMu, kBack, kKeepArea}},
          smooth_step};
}

}  // namespace mes
