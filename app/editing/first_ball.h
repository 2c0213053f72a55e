// SPDX-License-Identifier: GPL-3.0-or-later
// The first ball of a document is shown.
#pragma once

#include "app/editing/editor.h"
#include "app/layers/layer_stack.h"

namespace mes {

/// What it guarantees: with a first ball the layers of balls become visible, as a part of the step that made it, if
/// none of them is; but not where undone work can be brought back, which is shown as it was looked at, nor where one
/// layer is shown alone. Threads: none.
class FirstBall {
 public:
  /// Once a frame.
  void follow(Editor& editor, LayerStack& layers);

 private:
  bool had_balls_ = false;
};

}  // namespace mes
