// SPDX-License-Identifier: GPL-3.0-or-later
// The displayed workspace, and its reaction to the pointer.
#pragma once

#include <filesystem>
#include <functional>

#include "app/canvas/canvas.h"
#include "app/editing/source_selection.h"
#include "app/panels/on_canvas/cards/canvas_menu.h"
#include "app/panels/on_canvas/cards/pointed_element.h"
#include "app/panels/on_canvas/cards/provenance_card.h"
#include "app/panels/on_canvas/marks/canvas_annotations.h"
#include "app/panels/on_canvas/marks/insertion_preview.h"
#include "app/panes/view_fitter.h"
#include "app/picture/annotations/annotation_drawing.h"
#include "app/picture/picture.h"
#include "app/settings/settings.h"
#include "app/system/waker.h"
#include "app/ui/screen/screen.h"
#include "app/window/work/difference_marks.h"
#include "app/window/work/memory_watch.h"
#include "app/window/work/traced_picture.h"
#include "app/window/work/workspace.h"

namespace mes {

/// Guarantees: it never waits for the engine; lack of memory for a picture is reported once. Needs a current OpenGL
/// context for its whole life. Threads: the window's.
class DrawingBoard {
 public:
  DrawingBoard(Workspace& work, const Settings& settings, Messages& messages, Screen& screen,
               const std::filesystem::path& assets, Waker wake);

  Picture& picture() { return picture_; }
  Canvas& canvas() { return canvas_; }
  const Canvas& canvas() const { return canvas_; }
  ViewMotion& view() { return canvas_.view(); }
  const ViewMotion& view() const { return canvas_.view(); }
  /// Selects the samples and balls from which elements of a layer with values in a range come.
  void select_values(LayerIndex layer, double low, double high);
  ViewFitter& fitter() { return fitter_; }
  ProvenanceCard& provenance() { return provenance_; }
  /// Opens the menu for the thing at the pointer, or for keys at `Canvas::zoom_center`. A sample or ball that is not
  /// selected is selected alone first.
  void open_menu();
  /// Draws the menu and does what is chosen in it.
  void draw_menu(const ActionBindings& actions);
  /// Makes an annotation of the contents of the card: one of its lines, or all.
  void keep_highlight(std::optional<std::size_t> line = std::nullopt);
  TracedPicture& traced() { return traced_; }
  const TracedPicture& traced() const { return traced_; }

  /// Binds the actions for tools, zooming, fitting and nudging.
  void bind(ActionBindings& actions);

  /// True if the picture shows everything requested, as of the present document and settings.
  bool is_up_to_date() const { return has_all_results_ && work_.is_complete(); }
  /// True if nothing moves the view or is going to.
  bool is_at_rest() const;
  /// The contents of the panes beside the main one.
  std::vector<Picture::Pane> panes_beside() const;
  /// True if the differences between the panes are marked, or no marks are wanted.
  bool has_differences() const { return differences_.is_complete(compared_state()); }
  /// Takes the results that the engine has finished.
  void take_results();
  /// Another document was read: lack of memory is reported again.
  void note_new_document();

  /// Begins a frame in a window of this size, in framebuffer pixels.
  void begin_frame(int width, int height);
  /// Follows the layers and the picture to trace; call it after the panels were drawn.
  void follow();
  /// Fits the pending views, now that the free area between the panels is known.
  void fit(Vec2 legend);
  struct Frame {
    Vec2 pointer_px{};
    bool hides_pointer = false;  ///< no element under the pointer is marked
    bool is_kept = false;        ///< as in `Picture::draw`
  };
  /// Draws the layers and the marks of the pointer.
  void draw(const Frame& frame);

  /// The views of the panes beside the main one, if they have their own cameras; else nothing.
  std::vector<Box2> pane_views() const;
  /// Shows these views in the panes, as `pane_views` returned them, together with the next fitting.
  void see_in_panes(std::vector<Box2> views) { wanted_pane_views_ = std::move(views); }

  bool shows_annotations() const;
  /// A measure of what a rectangle of the window, in screen coordinates, would hide: the number of its 64 parts (about)
  /// in which a layer draws something; words of annotations count as all of them. Cost: some microseconds.
  std::size_t hidden_by(const Box2& on_screen) const;

 private:
  /// True once the panels have been drawn and know their sizes, so that the drawing has its area.
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
  CanvasAnnotations annotations_in(const Document& document, const PanePart& pane) const;
  /// Draws the same marks in all panes, so that each shows where the pointer is in the others.
  void draw_marks_in_panes(bool is_marked);
  /// Draws the marks of the pointer and the annotations in one pane.
  void draw_marks(std::size_t number, const PanePart& pane, bool is_marked);
  void fit_pane(std::size_t pane, const Box2& box, double margin_px, bool at_once = false);
  void keep_measurement();
  /// The ends of a centre line: two measured points, else the two selected samples; nothing for another number.
  std::optional<Annotation> two_ends() const;
  void add_center_line(Annotation ends);
  bool may_ask();
  void choose_class(const Pointer& pointer, Vec2 place);
  void ask_beside(const Pointer& pointer, const ChosenThing& chosen);
  void select_sources();
  void take_answer(Provenance answer);
  bool keep(Annotation annotation);
  void insert_at(const Pointer& pointer);

  Workspace& work_;
  const Settings& settings_;
  Messages& messages_;
  Screen& screen_;
  Picture picture_;
  ProvenanceCard provenance_;
  PointedElement pointed_;
  InsertionPreview preview_;
  CanvasMenu menu_;
  ValueSelector values_;
  Snapper snapper_;
  SelectionFrame frame_;
  ToolContext tool_context_;
  Canvas canvas_;
  ViewFitter fitter_;
  TracedPicture traced_;
  DifferenceMarks differences_;
  bool has_all_results_ = false;  ///< true if the engine had finished when its results were taken last
  MemoryWatch memory_;
  AnnotationDrawing annotations_;  // the document's annotations as last drawn, for the view at the pointer
  std::vector<Box2> wanted_pane_views_;
};

}  // namespace mes
