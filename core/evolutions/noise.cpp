// SPDX-License-Identifier: GPL-3.0-or-later
// Noise: moves every sample on the curve at random, by a fraction of the distance between its neighbours.
#include "core/base/rng.h"
#include "core/evolutions/evolution.h"

namespace mes {
namespace {

const Parameter kFactor{
    .id = "noise-factor",
    .explanation = "Largest distance a sample moves, as a multiple of that between its two neighbours",
    .high = 10.0,
    .default_value = 0.05,
    .title = "Strength",
    .window_explanation =
        "Largest distance a sample moves, as a multiple of the distance between its two neighbours"};
const Parameter kIsotropic{.id = "noise-isotropic",
                           .explanation = "0: along the normal of the curve; 1: in every direction",
                           .is_whole = true,
                           .title = "Direction",
                           .window_explanation = "Direction of the moves",
                           .choices = {"Along the normal", "In every direction"}};
constexpr std::uint64_t kStream = 0x6e6f697365ULL;  // a stream that no other evolution uses

// Uniform in the unit disk; uses rejection, because sines and cosines differ between machines.
Vec2 in_unit_disk(Rng& random) {
  for (;;) {
    const double x = random.uniform(-1.0, 1.0);
    const double y = random.uniform(-1.0, 1.0);
    if (x * x + y * y <= 1.0) return {x, y};
  }
}

Expected<EvolutionState> noise_step(const EvolutionState& state, const EvolutionStep& step) {
  const double factor = step.choice.values[kFactor];
  const bool isotropic = step.choice.values.is_on(kIsotropic);
  const Rng of_step(Rng(step.choice.seed ^ kStream).at(step.number));
  EvolutionState out = state;
  for_each_moving(step.curve, [&](std::uint32_t before, std::uint32_t sample, std::uint32_t after) {
    Rng random(of_step.at((*state.numbers)[sample]));
    const Vec2 across = state.positions[after] - state.positions[before];
    // `across` rotated by a right angle is the unit normal times the distance of the neighbours.
    const Vec2 offset =
        isotropic ? length(across) * in_unit_disk(random) : random.uniform(-1.0, 1.0) * perpendicular(across);
    out.positions[sample] = state.positions[sample] + factor * offset;
  });
  gather_followers(step.curve, out.positions);
  return out;
}

}  // namespace

Evolution noise_evolution() {
  return {
      {"noise", "Noise", "Each sample on the curve moves at random along its normal", true, {kFactor, kIsotropic}},
      noise_step};
}

}  // namespace mes
