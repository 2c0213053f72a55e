// SPDX-License-Identifier: GPL-3.0-or-later
// The panels at the right edge of the window, and the rail of icons that opens them.
#pragma once

#include <cstddef>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "app/actions/action_bindings.h"
#include "app/settings/settings.h"
#include "app/ui/widgets/icons.h"
#include "app/ui/widgets/widgets.h"

namespace mes {

/// A panel as the column and its rail show it.
struct SidePage {
  PanelPage page = PanelPage::layers;
  const char* title = "";
  Icon icon = Icon::layers;
  ActionId toggle = ActionId::toggle_layers;
  bool begins_group = false;      ///< a line of the rail is above its icon
  std::function<void()> draw{};   ///< draws the content
  std::function<void()> large{};  ///< draws the content of the large window; empty: the panel has none
  /// Chooses the row so many rows below the chosen one, as far as there are; empty: the panel has no list of rows.
  std::function<void(std::ptrdiff_t)> step{};
};

/// A panel has the height of the column, or shares it with a second one. Width, share and open panels are settings.
/// Threads: the window's.
class SideColumn {
 public:
  /// `pages`: in the order of the rail.
  SideColumn(const Gui& gui, const ActionBindings& actions, Settings& settings, std::vector<SidePage> pages)
      : gui_(gui), actions_(actions), settings_(settings), pages_(std::move(pages)) {}

  std::span<const SidePage> pages() const { return pages_; }
  /// Draws rail and panels below `top`; returns the width that they take.
  float draw(float top, float height);
  /// The width of the panels alone, when they were last drawn.
  float panels_width() const { return panels_width_; }
  /// Moves the choice in the list of the panel under the pointer, or in that of its large diagram. Returns false if
  /// there is none.
  bool step(std::ptrdiff_t rows);
  /// Returns how much of the drawing a box on the screen would hide.
  using Hides = std::function<std::size_t(const Box2&)>;
  /// Draws the window over the canvas if there is one; `room` is the area of the canvas.
  void draw_large(const PanelArea& room, const Hides& hides);

 private:
  const SidePage& page_of(PanelPage page) const;
  PanelArea large_area(const PanelArea& room, const Hides& hides) const;
  float draw_rail(float top, float height);
  void draw_panel(const SidePage& page, const PanelArea& area);
  void draw_title(const SidePage& page);
  void draw_splitters(const PanelArea& column, float upper);

  const Gui& gui_;
  const ActionBindings& actions_;
  Settings& settings_;
  std::vector<SidePage> pages_;
  float panels_width_ = 0.0F;
  std::optional<PanelPage> pointed_at_;
  std::optional<PanelPage> large_;  // the large window that was drawn last, and where
  PanelArea large_at_{};
};

}  // namespace mes
