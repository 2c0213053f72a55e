// SPDX-License-Identifier: GPL-3.0-or-later
// Suggestions on an empty canvas.
#pragma once

#include "app/actions/action_bindings.h"
#include "app/canvas/canvas.h"
#include "app/picture/picture.h"
#include "app/store/document_files.h"
#include "app/ui/screen/gui.h"

namespace mes {

struct EmptyHint {
  const Gui& gui;
  const ActionBindings& actions;
  const Document& document;
  const DocumentFiles& files;
  const Picture& picture;
  const Canvas& canvas;

  /// Draws some lines around `middle`, with the keys of their actions; draws nothing if the document holds anything,
  /// above a picture to trace, or while the pointer is drawing.
  void draw(ImVec2 middle) const;
};

}  // namespace mes
