// SPDX-License-Identifier: GPL-3.0-or-later
// All panels around and over the canvas, and where each of them lies.
#pragma once

#include "app/actions/action_bindings.h"
#include "app/model/palette.h"
#include "app/panels/annotation_card.h"
#include "app/panels/bundles_panel.h"
#include "app/panels/details_panel.h"
#include "app/panels/layers_panel.h"
#include "app/panels/mark_drag.h"
#include "app/panels/menu_bar.h"
#include "app/panels/presenter.h"
#include "app/panels/status_bar.h"
#include "app/panels/toolbar.h"
#include "app/picture/scale_drawing.h"
#include "app/playing/step_events.h"
#include "app/window/document_flow.h"
#include "app/window/experiment_run.h"
#include "app/window/live_recording.h"

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
    Settings& settings;
    Messages& messages;
    std::function<void(const std::string&)> show_parameter{};  ///< lists those with this name
  };
  explicit Panels(const Uses& uses);

  /// What is shown, and how it looks.
  void bind(ActionBindings& actions);
  Presenter& presenter() { return presenter_; }
  const Presenter& presenter() const { return presenter_; }
  /// Ends the presentation, with the panels as they were before; false when there was none.
  bool end_presentation();
  /// The legend or the scale bar, while it is dragged.
  MarkDrag& mark_drag() { return mark_drag_; }
  /// Everything that has a name, as it is now.
  std::vector<PaletteEntry> palette_entries();
  /// Those around the canvas are shown, and not only what lies on it.
  bool are_shown() const { return are_shown_; }

  /// What the panels have left of the window, in framebuffer pixels.
  struct Room {
    Insets insets{};
    Vec2 legend{};  ///< size of the legend in the lower right corner, with its margin
  };
  Room draw();

 private:
  /// What is taken at the sides, in screen coordinates.
  struct Sides {
    float left = 0.0F;
    float top = 0.0F;
    float right = 0.0F;
    float bottom = 0.0F;
  };
  void begin_presentation();
  /// A lesson is shown without panels.
  void follow_lesson();
  std::string slide() const;
  Sides draw_around();
  void draw_lesson(Sides& sides);
  /// Divides what is left between the panes, and leaves the main one of them.
  void divide(Sides& sides);
  float draw_column(float top, float height);
  void draw_layers(const PanelArea& area);
  /// `upper`: where the details begin below the top; 0: no details, or nothing above them.
  void draw_splitters(const PanelArea& column, float upper);
  void draw_over(Sides& sides);
  void draw_annotation_card(const Sides& sides);
  MarksPlace draw_scale_marks(const Sides& sides);
  ImVec2 draw_legend(const Sides& sides, const MarksPlace& marks);
  void bind_shown(ActionBindings& actions);
  void bind_look(ActionBindings& actions);
  void bind_brush(ActionBindings& actions);

  Uses uses_;
  MenuBar menu_bar_;
  StatusBar status_bar_;
  Toolbar toolbar_;
  BundlesPanel bundles_panel_;
  LayersPanel layers_panel_;
  DetailsPanel details_panel_;
  StepEvents step_events_;
  bool are_shown_ = true;
  bool were_shown_ = true;  // before the presentation
  bool presents_lesson_ = false;
  AnnotationCard annotation_card_;
  Presenter presenter_;
  MarkDrag mark_drag_;
};

}  // namespace mes
