// SPDX-License-Identifier: GPL-3.0-or-later
// The workspace as it is seen, and as the pointer meets it.
#pragma once

#include <filesystem>
#include <functional>

#include "app/canvas/canvas.h"
#include "app/editing/source_selection.h"
#include "app/model/memory_watch.h"
#include "app/model/settings.h"
#include "app/model/view_fitter.h"
#include "app/panels/canvas_annotations.h"
#include "app/panels/insertion_preview.h"
#include "app/panels/pointed_element.h"
#include "app/panels/provenance_card.h"
#include "app/picture/annotation_drawing.h"
#include "app/picture/picture.h"
#include "app/system/waker.h"
#include "app/ui/screen.h"
#include "app/window/difference_marks.h"
#include "app/window/traced_picture.h"
#include "app/window/workspace.h"

namespace mes {

/// What it guarantees: it never waits for the engine; a picture that lacks memory is said so once. Needs a current
/// OpenGL context for its life. Threads: the window's.
class DrawingBoard {
 public:
  DrawingBoard(Workspace& work, const Settings& settings, Messages& messages, Screen& screen,
               const std::filesystem::path& assets, Waker wake);

  Picture& picture() { return picture_; }
  Canvas& canvas() { return canvas_; }
  const Canvas& canvas() const { return canvas_; }
  ViewMotion& view() { return canvas_.view(); }
  const ViewMotion& view() const { return canvas_.view(); }
  /// Selects what elements of a layer with values in a range come from.
  void select_values(LayerIndex layer, double low, double high);
  ViewFitter& fitter() { return fitter_; }
  ProvenanceCard& provenance() { return provenance_; }
  /// Makes what the card shows an annotation: one of its lines, or all.
  void keep_highlight(std::optional<std::size_t> line = std::nullopt);
  TracedPicture& traced() { return traced_; }
  const TracedPicture& traced() const { return traced_; }

  /// Tools, zooming, fitting, nudging.
  void bind(ActionBindings& actions);

  /// Nothing moves the view, and nothing is going to.
  bool is_at_rest() const;
  /// What is shown beside the main pane.
  std::vector<Picture::Pane> panes_beside() const;
  /// What only some of the panes have is marked, where it is to be.
  bool has_differences() const { return differences_.is_complete(compared_state()); }
  /// Takes what the engine has finished.
  void take_results();
  /// Another document was read: what it lacks is said anew.
  void note_new_document();

  /// The frame begins in a window of this size, in framebuffer pixels.
  void begin_frame(int width, int height);
  /// Follows the layers and the picture to trace, after the panels were drawn.
  void follow();
  /// What is free between the panels was found: fits what is to be fitted.
  void fit(Vec2 legend);
  struct Frame {
    Vec2 pointer_px{};
    bool hides_pointer = false;  ///< nothing is marked under it
    bool is_kept = false;        ///< as `Picture::draw` has it
  };
  /// Draws the layers and the marks of the pointer.
  void draw(const Frame& frame);

  /// What the panes beside the main one show, when they have cameras of their own; else nothing.
  std::vector<Box2> pane_views() const;
  /// Shows these in the panes, as `pane_views` gave them, together with what is fitted next.
  void see_in_panes(std::vector<Box2> views) { wanted_pane_views_ = std::move(views); }

 private:
  /// Panels know their size when they have been drawn once, and the drawing has its place from then on.
  static bool has_place();
  void bind_nudges(ActionBindings& actions);
  void bind_view(ActionBindings& actions);
  void nudge(Vec2 px);
  void fit_all();
  void fit_selection();
  void watch_memory();
  bool shows_differences() const;
  std::optional<DifferenceMarks::State> compared_state() const;
  void follow_differences();
  void dim_outdated();
  void draw_pointer(const Frame& frame);
  bool shows_annotations() const;
  CanvasAnnotations annotations_in(const Document& document, const PanePart& pane) const;
  /// In all panes, the same marks, so that one sees in each where the pointer is in the others.
  void draw_marks_in_panes(bool is_marked);
  /// Marks of the pointer and annotations, in one pane.
  void draw_marks(std::size_t number, const PanePart& pane, bool is_marked);
  void fit_pane(std::size_t pane, const Box2& box, double margin_px, bool at_once = false);
  void keep_measurement();
  bool may_ask();
  void choose_class(const Pointer& pointer, Vec2 place);
  void ask_beside(const Pointer& pointer, const ChosenThing& chosen);
  void select_sources();
  void take_answer(Provenance answer);
  bool keep(Annotation annotation);

  Workspace& work_;
  const Settings& settings_;
  Messages& messages_;
  Screen& screen_;
  Picture picture_;
  ProvenanceCard provenance_;
  PointedElement pointed_;
  InsertionPreview preview_;
  ValueSelector values_;
  Snapper snapper_;
  SelectionFrame frame_;
  ToolContext tool_context_;
  Canvas canvas_;
  ViewFitter fitter_;
  TracedPicture traced_;
  DifferenceMarks differences_;
  bool has_all_results_ = false;  ///< of the engine, when they were taken last
  MemoryWatch memory_;
  AnnotationDrawing annotations_;  // of the document, at the view at the pointer, as they were drawn last
  std::vector<Box2> wanted_pane_views_;
};

}  // namespace mes
