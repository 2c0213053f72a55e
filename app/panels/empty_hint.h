// SPDX-License-Identifier: GPL-3.0-or-later
// What to do with an empty canvas.
#pragma once

#include "app/actions/action_bindings.h"
#include "app/canvas/canvas.h"
#include "app/picture/picture.h"
#include "app/store/file_desk.h"
#include "app/ui/gui.h"

namespace mes {

struct EmptyHint {
  const Gui& gui;
  const ActionBindings& actions;
  const Document& document;
  const FileDesk& files;
  const Picture& picture;
  const Canvas& canvas;

  /// Some lines about `middle`, with the keys of their actions; nothing once the document holds anything, above a
  /// picture to trace, or while the pointer is drawing.
  void draw(ImVec2 middle) const;
};

}  // namespace mes
