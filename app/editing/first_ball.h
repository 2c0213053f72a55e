// SPDX-License-Identifier: GPL-3.0-or-later
// Makes the first ball of a document visible.
#pragma once

#include "app/editing/editor.h"
#include "app/layers/layer_stack.h"

namespace mes {

/// Guarantees: the first ball makes the layers of balls visible, in the same step, if none of them is. It does not if
/// undone work can be redone, because its layers are then restored, nor if one layer is shown alone. Threads: none.
class FirstBall {
 public:
  /// Call it once per frame.
  void follow(Editor& editor, LayerStack& layers);

 private:
  bool had_balls_ = false;
};

}  // namespace mes
