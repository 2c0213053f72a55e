// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editing/first_ball.h"

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

#include "app/layers/ball_families.h"

namespace mes {

void FirstBall::follow(Editor& editor, LayerStack& layers) {
  const bool has_balls = editor.document().ball_count() != 0;
  if (has_balls == std::exchange(had_balls_, has_balls) || !has_balls) return;
  if (editor.can_redo() || layers.soloed() != kNoLayer) return;
  std::vector<LayerIndex> of_balls;
  for (const std::string_view id : kOwnBallLayers)
    if (const LayerIndex layer = layers.find(id); layer != kNoLayer) of_balls.push_back(layer);
  if (of_balls.empty() || std::ranges::any_of(of_balls, [&](LayerIndex layer) { return layers.is_visible(layer); }))
    return;
  editor.note_layers();
  for (const LayerIndex layer : of_balls) layers.set_visible(layer, true);
  editor.join_layers();
}

}  // namespace mes
