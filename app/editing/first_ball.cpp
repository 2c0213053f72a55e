// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editing/first_ball.h"

#include <algorithm>
#include <array>
#include <utility>

#include "core/builtins/builtins.h"

namespace mes {

void FirstBall::follow(Editor& editor, LayerStack& layers) {
  const bool has_balls = editor.document().ball_count() != 0;
  if (has_balls == std::exchange(had_balls_, has_balls) || !has_balls) return;
  if (editor.can_redo() || layers.soloed() != kNoLayer) return;
  const std::array of_balls{builtins().find_layer("b-inner-disks"), builtins().find_layer("b-inner-circles"),
                            builtins().find_layer("b-inner-centers")};
  if (std::ranges::any_of(of_balls, [&](LayerIndex layer) { return layers.is_visible(layer); })) return;
  editor.note_layers();
  for (const LayerIndex layer : of_balls) layers.set_visible(layer, true);
  editor.join_layers();
}

}  // namespace mes
