// SPDX-License-Identifier: GPL-3.0-or-later
// The engine's results on the graphics card, with the marks of the window above them.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "app/editing/curves/sample_spacing.h"
#include "app/editing/editor.h"
#include "app/layers/layer_stack.h"
#include "app/panes/pane_list.h"
#include "app/panes/pane_places.h"
#include "app/picture/detail.h"
#include "app/picture/ink_map.h"
#include "app/picture/leaving_layers.h"
#include "app/picture/moved_points.h"
#include "app/picture/paper/canvas_look.h"
#include "app/picture/paper/legend.h"
#include "core/draw/layer_mirror.h"
#include "core/engine/engine.h"
#include "core/engine/memory_lack.h"
#include "core/graph/live_registry.h"
#include "render/device/gl_device.h"
#include "render/frame_capture.h"
#include "render/kept_frame.h"
#include "render/scene.h"

namespace mes {

/// Guarantees:
///  1. It never waits for the engine. A layer whose structure failed keeps its last good picture, greyed.
///  2. The layers are drawn only when the view, a style, a patch or the selection changed. A frame in which only panels
///     or the pointer moved costs one copy of the last picture, however many primitives there are.
///  3. If MESECINA_CHECK_PATCHES is set, as in the tests of the window, each patch also goes through a `LayerMirror`,
///     which refuses broken patches and must have as many instances as the scene.
///  4. Selected samples are drawn at their positions in the document, although their structures follow only when the
///     engine has computed them.
///  5. However many large disks there are, a moving picture is painted within a fraction of a second (detail.h).
///  6. `draw` paints for a fraction of a second only. While a picture needs longer, the last complete one is shown,
///     moved and scaled to the view; once nothing changes any more, the pixels are those of painting at once.
///  7. While the engine computes layers that are newly shown, those that they replace stay (leaving_layers.h).
///
/// An OpenGL context must be current as long as the object exists. Threads: the window's.
class Picture {
 public:
  explicit Picture(LiveRegistry registry);

  void set_color_maps(std::vector<render::ColorMap> maps) {
    stop_painting();
    scene_.set_color_maps(std::move(maps));
  }
  /// Sets the letters for layers of texts; without them these layers are empty.
  void set_letters(render::Font font) { letters_ = std::move(font); }
  /// Sets the picture to trace, which is drawn as a layer. Returns false if graphics memory is exhausted.
  bool set_background(LayerIndex layer, const render::Image& image);
  void place_background(const render::PicturePlace& place);
  void clear_background();
  /// The height of the picture to trace divided by its width; 0 without one.
  double background_aspect() const { return background_aspect_; }

  /// Takes the finished results; returns false if there were none. While a picture is being painted, they wait, so that
  /// it shows one state.
  bool take_from(Engine& engine);
  /// Call it when the engine is asked for other layers. The graphics memory of the others is released once a patch says
  /// that the engine sends them no more: if they are demanded again before that, it does not send them again.
  void follow_demand(const ShownPanes& shown);
  /// Sets the colour behind the layers.
  void set_canvas(Rgb background) { canvas_ = background; }
  Rgb canvas() const { return canvas_; }
  /// A pane beside the main one.
  struct Pane {
    const ShownPanes::Layers& layers;
    const Document* version = nullptr;  ///< null: the document of the main pane, with the marks of its selection
    std::size_t number = 0;             ///< among all panes; 0: the main one
    /// The camera of a window in which the pane has the position of the main pane; null: that of the main pane.
    const render::Camera* camera = nullptr;
  };
  /// Begins or stops keeping the drawing in memory for comparisons. Returns false if it must be sent completely
  /// first.
  bool keep_instances(bool wanted);
  /// All demanded layers as of the last patch; null while they are not kept or not completely sent. A caller's copy
  /// keeps this state.
  std::shared_ptr<const LayerMirror> instances() const { return has_instances_ ? instances_ : nullptr; }
  /// The first layer that shows an earlier picture because it could not be computed; null if there is none.
  const LayerReport* first_failed() const;
  /// Replaces the marks above the layers of each pane, the main one first; they are layers of the patch.
  void set_marks(FramePatch patch, std::vector<std::vector<render::LayerView>> marks);
  /// Draws the background alone.
  void clear(const render::Camera& camera);
  /// Draws the canvas, which fills the window. Very many instances are only a preview (`render::Preview`) unless the
  /// picture is kept in a file (`is_kept`), and a coarse one while the view moves. A picture to keep is painted at once. With several `places`, the main pane
  /// shows the layers, and the others show the contents of `panes`, in their order.
  void draw(const render::Camera& camera, const LayerStack& layers, const Editor& editor, double content_scale,
            bool is_kept, const PanePlaces& places = {}, std::span<const Pane> panes = {});

  /// Captures layers as they are now, in full detail, with the marks of the selection as last drawn, without panels.
  /// `is_beside`: the pane is one of several.
  Expected<void> capture(render::FrameCapture& capture, const render::Camera& camera, const Pane& pane,
                         const Editor& editor, render::CaptureOptions options, bool is_beside = false);
  render::GlDevice& device() { return device_; }
  /// The layers of the main pane on screen: the visible ones, and those that the next picture will replace.
  ShownPanes::Layers layers_on_screen(const LayerStack& layers) const {
    return leaving_.drawn(0, visible_layers(layers));
  }
  /// The entries of the legend for these layers.
  std::vector<LegendEntry> legend(const ShownPanes::Layers& layers, LegendScope scope) const;

  /// True if the picture at rest can be painted in more detail: it needs another `draw` soon.
  bool is_refining() const { return detail_.is_refining() || is_coarse_ || is_painting(); }
  /// True while a picture is being painted that is not yet on screen; `draw` goes on with it.
  bool is_painting() const { return painting_.has_value(); }
  /// Where something is drawn, as of the last picture at rest.
  const InkMap& ink() const { return ink_; }
  /// True if `ink` does not know the last picture yet: it needs another `draw` soon.
  bool awaits_ink() const { return ink_capture_.pending() != 0 || ink_of_ != pictures_; }
  /// One of this many disks is on screen; 1: all.
  std::uint32_t every() const { return every_; }

  NodeState state(VariantLayer layer) const;
  const LayerReport* report(VariantLayer layer) const;
  /// Nodes of the main computation come first.
  const std::vector<NodeReport>& nodes() const { return report_.nodes; }
  /// True after memory was exhausted for a patch: the layers are grey until the engine sends all of them again. An
  /// empty demand, followed by the old one, makes it do so.
  bool is_lost() const { return is_lost_; }
  /// True if some layers show their last picture because another one exhausted the memory.
  bool lacks_memory() const { return mes::lacks_memory(report_.nodes, report_.reports); }
  /// The document revision on screen.
  std::uint64_t document_revision() const { return document_revision_; }
  /// Another document has replaced the previous one at this revision.
  void expect(std::uint64_t revision) {
    expected_ = revision;
    is_outdated_ = document_revision_ < expected_;
  }
  /// True while the picture on screen shows a previous document.
  bool is_outdated() const { return is_outdated_; }
  const render::Scene& scene() const { return scene_; }

 private:
  struct MarkedState {
    std::uint64_t document = ~std::uint64_t{0};
    std::uint64_t selection = ~std::uint64_t{0};
    DrawingFrame frame;
    Rgb canvas;
    friend bool operator==(const MarkedState&, const MarkedState&) = default;
  };
  /// The state on which the pixels of the layers depend.
  struct ShownState {
    render::Camera camera;
    double content_scale = 0.0;
    std::uint64_t patches = 0;
    std::uint64_t background = 0;
    MarkedState marked;
    ShownPanes::Layers layers;
    bool is_kept = false;
    PanePlaces places;
    std::vector<ShownPanes::Layers> panes;
    std::vector<std::optional<std::uint64_t>> versions;  // document revisions of panes that have their own
    std::vector<render::Camera> cameras;                 // for panes beside the main one
    friend bool operator==(const ShownState&, const ShownState&) = default;
  };
  /// A picture on its way.
  struct Painting {
    ShownState state;
    render::FramebufferId target;
    std::uint32_t every = 1;
    render::Preview preview = render::Preview::none;
    bool counts = true;  ///< its time is a measure for `Detail`
    double ms = 0.0;     ///< time spent so far
    bool is_coarse = false;
    std::size_t pane = 0;                           ///< that of `drawing`
    std::optional<render::Scene::Drawing> drawing;  ///< none: not yet begun
  };
  void check(const FramePatch& patch);
  void keep(const FramePatch& patch);
  /// `spacing_px`: spacing of the samples, in logical pixels.
  ShownPanes::Layers as_drawn(ShownPanes::Layers layers, const std::optional<Rgb>& background,
                              double spacing_px) const;
  /// Spacing of the samples that a pane shows, in units of the document.
  double spacing_in(const Pane& pane, const Editor& editor);
  void add_marks(std::vector<render::LayerView>& views, std::size_t pane) const;
  void choose_views(const ShownState& shown, const Editor& editor, std::span<const Pane> panes);
  /// The camera of a pane, for its part of the window.
  static render::Camera camera_of(const ShownState& shown, std::size_t pane);
  ShownState state_now(const render::Camera& camera, const LayerStack& layers, const Editor& editor,
                       double content_scale, bool is_kept, const PanePlaces& places, std::span<const Pane> panes);
  void begin_painting(ShownState now, const LayerStack& layers, const Editor& editor, std::span<const Pane> panes);
  /// Paints for about so many milliseconds; returns true once the picture is complete.
  bool go_on_painting(double ms);
  bool paint_pane(double ms);
  void complete_painting();
  /// Call it before the scene changes: the picture on its way is dropped.
  void stop_painting();
  bool is_worth_completing(const ShownState& now) const;
  void show(const ShownState& now);
  void follow_ink(bool rests);
  static render::PixelRect area_of(const ShownState& shown, std::size_t pane);
  static std::vector<render::LayerView> views_of(const ShownPanes::Layers& layers, std::uint32_t every);
  void add_texts(std::vector<render::LayerView>& views, const Editor& editor, const Document* version,
                 const render::Camera& camera, double content_scale) const;
  bool apply(const FramePatch& patch);
  static bool brings_all(const FramePatch& patch);
  bool has_picture(VariantLayer layer) const;
  void forget_layers_without_need();
  void mark_selection(const Editor& editor);
  void draw_moved(const Editor& editor);
  void set_mark(std::uint32_t slot, PrimitiveKind kind, const LayerStyle& style);
  std::uint32_t largest_painted_layer(const render::Camera& camera, const LayerStack& layers) const;

  LiveRegistry registry_;
  render::GlDevice device_;
  render::Scene scene_;
  std::unique_ptr<LayerMirror> mirror_;     // null unless patches are checked
  std::shared_ptr<LayerMirror> instances_;  // null unless they are kept
  bool has_instances_ = false;              // true when all layers are complete
  std::vector<VariantLayer> loaded_;        // layers of which the scene may have instances
  LeavingLayers leaving_;
  RunReport report_;
  bool is_lost_ = false;
  std::uint64_t document_revision_ = 0;
  std::uint64_t expected_ = 0;
  bool is_outdated_ = false;  // false once the expected revision was seen: undo may then return to earlier ones
  std::vector<FollowedSpacing> spacings_;  // for the samples of each pane, the main one first
  std::uint64_t patches_ = 0;              // number of patches with something to draw
  DrawingFrame last_frame_;
  Rgb canvas_ = kWhiteCanvas;
  std::uint64_t background_revision_ = 0;  // grows with the picture and its position
  double background_aspect_ = 0.0;
  render::PicturePlace background_place_;
  MarkedState marked_;
  MovedPoints moved_;
  MarkedState moved_at_;  // state for which the samples were last drawn
  std::uint64_t moved_at_patch_ = 0;
  std::vector<double> mark_data_;  // kept to reuse its memory
  ShownState shown_;
  std::vector<std::vector<render::LayerView>>
      views_;  // for each pane of `shown_`, the main one first, with their texts
  std::vector<std::vector<render::LayerView>> marks_;  // for each pane
  std::optional<render::Font> letters_;
  bool is_coarse_ = false;  // on screen
  std::uint32_t every_ = 1;
  Detail detail_;
  render::KeptFrame kept_;
  bool is_kept_foreign_ = true;  // true while the kept picture shows another document, or nothing
  std::optional<Painting> painting_;
  InkMap ink_;
  render::FrameCapture ink_capture_;
  std::uint64_t pictures_ = 0;  // number of complete ones
  std::uint64_t ink_of_ = 0;    // picture of which the pixels were requested last
  render::Camera ink_camera_;   // its camera and canvas
  Rgb ink_canvas_ = kWhiteCanvas;
  render::Camera last_camera_;  // of the last frame
  std::uint64_t last_document_ = 0;
};

}  // namespace mes
