// SPDX-License-Identifier: GPL-3.0-or-later
// Reports that added elements are hidden, and offers to show them.
#pragma once

#include "app/editing/editor.h"
#include "app/editing/hidden_additions.h"
#include "app/ui/screen/gui.h"

namespace mes {

struct HiddenAdditionsNote {
  const Gui& gui;
  HiddenAdditions& hidden;
  Editor& editor;
  LayerStack& layers;
  bool shows_annotations;  ///< for now, perhaps only because of the tool in use
  bool& show_annotations;  ///< the setting

  /// `top`: the middle of its upper edge.
  void draw(ImVec2 top) const;
  /// Closes it; returns false if it shows nothing.
  bool close() const;

 private:
  std::size_t count(AddedKind kind) const;
  void draw_row(AddedKind kind) const;
  void show(AddedKind kind) const;
};

}  // namespace mes
