// SPDX-License-Identifier: GPL-3.0-or-later
// All panels around and over the canvas, and their positions.
#pragma once

#include <functional>
#include <optional>
#include <span>

#include "app/actions/action_bindings.h"
#include "app/actions/palette.h"
#include "app/panels/bars/menu_bar.h"
#include "app/panels/bars/side_column.h"
#include "app/panels/bars/status_bar.h"
#include "app/panels/bars/toolbar.h"
#include "app/panels/layers/bundles_panel.h"
#include "app/panels/layers/layers_panel.h"
#include "app/panels/on_canvas/cards/annotation_card.h"
#include "app/panels/on_canvas/hidden_additions_note.h"
#include "app/panels/on_canvas/presenter.h"
#include "app/panels/on_canvas/problem_note.h"
#include "app/panels/pages/branches_panel.h"
#include "app/panels/pages/curves_panel.h"
#include "app/panels/pages/experiments_panel.h"
#include "app/panels/pages/lesson_panel.h"
#include "app/panels/pages/log_panel.h"
#include "app/panels/pages/parameters_panel.h"
#include "app/panels/pages/persistence_panel.h"
#include "app/panels/pages/sampling_panel.h"
#include "app/panels/pages/selection_panel.h"
#include "app/panels/pages/statistics_panel.h"
#include "app/playing/step_events.h"
#include "app/window/files/document_flow.h"
#include "app/window/runs/experiment_run.h"
#include "app/window/runs/live_recording.h"
#include "app/window/window_marks.h"

namespace mes {

/// Threads: the window's.
class Panels {
 public:
  struct Uses {
    Screen& screen;
    Workspace& work;
    DrawingBoard& board;
    DemoRun& demo;
    LessonRun& lesson;
    LiveRecording& recording;
    DocumentFlow& documents;
    ExperimentRun& experiments;
    const ActionBindings& actions;
    ManualPage& manual;
    Settings& settings;
    Messages& messages;
    std::function<void(const std::string&)> show_parameter{};  ///< lists the parameters with this name
    std::function<void(LayerIndex)> show_layer{};              ///< shows its row in the list of layers
    std::function<void()> show_swatches{};                     ///< opens the list of layers at a shown one
  };
  explicit Panels(const Uses& uses);

  /// Binds the actions that choose what is shown, and its look.
  void bind(ActionBindings& actions);
  Presenter& presenter() { return presenter_; }
  const Presenter& presenter() const { return presenter_; }
  /// Ends the presentation and restores the panels; returns false if there was none.
  bool end_presentation();
  /// Closes the messages over the canvas; returns false if there are none.
  bool close_messages();
  /// Shows the panels again; returns false if they are shown.
  bool show_panels();
  /// Seconds until something over the canvas begins to fade; nothing if nothing will.
  std::optional<double> next_due(double now) const;
  /// Ends at once all that would fade over the canvas.
  void end_what_fades();
  /// The legend or the scale bar, while it is dragged.
  MarkDrag& mark_drag() { return marks_.drag(); }
  /// Where the legend and the scale bar were drawn in this frame.
  const MarkPlaces& mark_places() const { return marks_.places(); }
  /// Entries for everything that has a name now.
  std::vector<PaletteEntry> palette_entries();
  /// True if the panels around the canvas are shown, and not only those on it.
  bool are_shown() const { return are_shown_; }
  /// True if the user sees this panel.
  bool is_seen(PanelPage page) const { return are_shown_ && uses_.settings.panels.is_in_use(page); }
  /// Closes the large window of a diagram; returns false if there was none.
  bool close_large();
  /// Moves the choice in the list under the pointer. Returns false if there is none.
  bool step_in_list(std::ptrdiff_t rows) { return column_.step(rows); }

  /// The free area of the window, in framebuffer pixels.
  struct Room {
    Insets insets{};
    Vec2 legend{};  ///< size of the legend in the lower right corner, with its margin
  };
  Room draw();

 private:
  /// The widths taken at the sides, in screen coordinates.
  struct Sides {
    float left = 0.0F;
    float top = 0.0F;
    float right = 0.0F;
    float bottom = 0.0F;
  };
  void begin_presentation();
  /// Hides the panels while a lesson is shown.
  void follow_lesson();
  std::string slide() const;
  Sides draw_around();
  void draw_lesson(Sides& sides);
  /// Divides the remaining area between the panes, and sets `sides` to those of the main pane.
  void divide(Sides& sides);
  std::vector<SidePage> pages();
  void toggle(PanelPage page);
  void draw_over(Sides& sides);
  void draw_annotation_card(const Sides& sides);
  HiddenAdditionsNote hidden_additions_note() const;
  /// How much of the drawing, the legend and the scale bar a box on the screen would hide.
  std::size_t hidden_by(const Box2& box) const;
  /// The room for texts over the canvas.
  NoteRoom note_room(const Sides& sides) const;
  void draw_messages(const Sides& sides, float width, const NoteRoom& room);
  void bind_shown(ActionBindings& actions);
  void bind_look(ActionBindings& actions);
  void bind_brush(ActionBindings& actions);

  Uses uses_;
  MenuBar menu_bar_;
  StatusBar status_bar_;
  Toolbar toolbar_;
  BundlesPanel bundles_panel_;
  LayersPanel layers_panel_;
  StatisticsPanel statistics_panel_;
  ParametersPanel parameters_panel_;
  LogPanel log_panel_;
  LessonPanel lesson_panel_;
  SelectionPanel selection_panel_;
  CurvesPanel curves_panel_;
  BranchesPanel branches_panel_;
  PersistencePanel persistence_panel_;
  SamplingPanel sampling_panel_;
  ExperimentsPanel experiments_panel_;
  SideColumn column_;
  StepEvents step_events_;
  bool opens_menus_ = false;  // the first menu, with the next frame
  bool are_shown_ = true;
  bool were_shown_ = true;  // state before the presentation
  bool was_full_screen_ = false;
  bool presents_lesson_ = false;
  AnnotationCard annotation_card_;
  Presenter presenter_;
  ProblemNote problem_note_;
  WindowMarks marks_;
};

}  // namespace mes
