// SPDX-License-Identifier: GPL-3.0-or-later
// The persistence diagram of the alpha complexes of the samples or of the balls of a family, with their radius as a
// line that can be dragged.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/canvas/canvas.h"
#include "app/editing/editor.h"
#include "app/insight/computation_control.h"
#include "app/insight/latest_persistence.h"
#include "app/ui/widgets/plot.h"

namespace mes {

/// Guarantees: a point of the diagram and its position on the canvas are chosen together. While the table does not
/// match the display, it is dimmed, and none of it is drawn over the picture. Cost: per frame O(points that can be
/// distinguished on screen); when they change, O(rows). Threads: the window's.
class PersistencePanel {
 public:
  struct Uses {
    const Gui& gui;
    LatestPersistence& latest;
    Canvas& canvas;
    const Editor& editor;
    ComputationControl& computation;
    std::function<void(Expected<std::string>)> export_csv{};  ///< asks for a file for the CSV text
  };
  explicit PersistencePanel(Uses uses) : uses_(std::move(uses)) {}

  void draw();
  /// Draws the same with the diagram as on paper, into a window of its own.
  void draw_large();
  /// Chooses the pair so many after the chosen one among those shown, the longest first.
  void step(std::ptrdiff_t pairs);

 private:
  struct View;
  void draw_in(View& view);
  void draw_growths();
  void draw_choices();
  void draw_proposal();
  void draw_words();
  void draw_diagram(View& view);
  void draw_key(const Plot& plot) const;
  void draw_chosen();
  /// The dot for one or more rows in one pixel; it stands for the longest of them.
  struct Dot {
    float x = 0.0F;  ///< pixels to the right of the lower left corner
    float y = 0.0F;  ///< pixels above it
    std::size_t row = 0;
    bool is_hole = false;
  };
  struct Scale {
    std::shared_ptr<const PersistenceTable> table;
    float width = 0.0F;  ///< in pixels
    float height = 0.0F;
    float never = 0.0F;  ///< height of deaths that do not come
    double begin = 0.0;  ///< the radius at the beginning of the scale, and at its end
    double end = 0.0;
    bool has_components = false;
    bool has_holes = false;
    friend bool operator==(const Scale&, const Scale&) = default;
  };
  /// A diagram in the panel or in the large window.
  struct View {
    bool is_large = false;
    bool is_dragging = false;  ///< the radius is being dragged
    Scale scale{};             ///< of the dots
    std::vector<Dot> dots{};   ///< the longest first
  };
  static void place_dots(View& view, const Scale& scale);
  void draw_places(std::size_t row, bool is_chosen);
  void show(std::size_t row) const;

  Uses uses_;
  bool had_only_balls_ = false;
  std::shared_ptr<const PersistenceTable> gap_of_;
  std::optional<RadiusGap> gap_;
  bool shows_components_ = true;
  bool shows_holes_ = true;
  std::optional<std::size_t> pointed_at_;
  View small_;
  View large_{.is_large = true};
  /// The number of pairs alive.
  struct Alive {
    std::shared_ptr<const PersistenceTable> table;
    double radius = 0.0;
    std::size_t components = 0;
    std::size_t holes = 0;
  };
  Alive alive_;
  std::shared_ptr<const PersistenceTable> outline_of_;  // the table of the hole below
  std::size_t outline_row_ = 0;
  std::vector<std::array<Vec2, 2>> outline_;
};

}  // namespace mes
