// SPDX-License-Identifier: GPL-3.0-or-later
// The persistence diagram of the alpha complexes of the samples, with their radius as a line that can be dragged.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "app/canvas/canvas.h"
#include "app/model/computation_control.h"
#include "app/model/editor.h"
#include "app/model/persistence_desk.h"
#include "app/ui/gui.h"

namespace mes {

/// What it guarantees: a point of the diagram and its place on the canvas are chosen together. While the table is not that
/// of what is shown it is dimmed, and nothing of it is drawn over the picture. Threads: the window's.
class PersistencePanel {
 public:
  struct Uses {
    const Gui& gui;
    PersistenceDesk& desk;
    Canvas& canvas;
    const Editor& editor;
    ComputationControl& computation;
    std::function<void(std::string)> export_csv{};  ///< asks for a file for the text
  };
  explicit PersistencePanel(Uses uses) : uses_(std::move(uses)) {}

  void draw();

 private:
  void draw_choices();
  void draw_words();
  void draw_diagram();
  void draw_places(std::size_t row, bool is_chosen);
  void show(std::size_t row) const;

  Uses uses_;
  bool shows_components_ = true;
  bool shows_holes_ = true;
  bool is_dragging_ = false;  // the radius
  std::optional<std::size_t> pointed_at_;
  const PersistenceTable* outline_of_ = nullptr;  // whose hole that below is of
  std::size_t outline_row_ = 0;
  std::vector<std::array<Vec2, 2>> outline_;
};

}  // namespace mes
