// SPDX-License-Identifier: GPL-3.0-or-later
// The layers as instance buffers on a device, updated by patches and drawn through a camera.
//
// Guarantees:
//  1. `apply` uploads the changed instances of a patch and nothing else. Adjacent instances are uploaded together.
//  2. `draw` uploads no instances: camera, style, colour map and range are uniforms, and the stacking of layers is the
//     order of draw calls.
//  3. Layers are painted in the given order, bottom first, each above all earlier ones.
//  4. Finite coordinates of any size are drawn correctly: they are clipped to the possibly visible range.
//  5. If the style names a known colour map, instances have the colours of their scalars. A scalar beyond the range,
//     including an infinite one, has the colour of that end; NaN has the plain colour. In a flat layer a later instance
//     hides earlier ones, and the layer as a whole has the opacity of its style.
//  6. A view with texts shows these instead of its layer's instances, in the colour and opacity of its style.
//  7. Disks of one colour that would take long to paint are counted on the processor instead (`CountedInstances`), and
//     so are segments and points if a processor would paint them, and circles of a preview; the picture is that of
//     painting without rounding.
//
// Smallest use:
//     Scene scene(device);
//     scene.apply(*engine.sync());
//     scene.draw(camera, views, {.content_scale = 2.0});
//
// Cost: `apply` O(changed instances); `draw` one call a layer and kind, whatever the number of instances, and one pass
// over the view for a layer drawn as a group. The CPU iterates over disks of one colour in every frame, and over
// counted instances whenever the view changes. Threads: the one that owns the context.
//
// Inside: coordinates are mapped to drawing space (`DrawingFrame`) in double and uploaded as the bits of doubles. The
// vertex shader subtracts the camera's centre before it rounds to single precision.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "core/draw/layer_style.h"
#include "core/draw/patch.h"
#include "core/draw/primitives.h"
#include "render/camera.h"
#include "render/device/device.h"
#include "render/image/image.h"
#include "render/instances/colormap.h"
#include "render/instances/counted_instances.h"
#include "render/instances/instance_buffer.h"
#include "render/layer_texts.h"
#include "render/text_mask.h"

namespace mes::render {

/// The current colour map of a layer.
struct ShownMap {
  const ColorMap* map = nullptr;  ///< null: the layer has its plain colour
  ScalarRange range;              ///< empty if no scalar is finite
};

struct LayerView {
  VariantLayer layer{};
  LayerStyle style;
  /// Paints only one of `every` disks: a preview for large overlapping disks, too many to paint all of them. Counted
  /// disks are complete. Saved pictures use 1.
  std::uint32_t every = 1;
  /// Drawn instead of the instances; null: the instances are drawn.
  std::shared_ptr<const LayerTexts> texts{};
};

struct DrawOptions {
  double content_scale = 1.0;  ///< framebuffer pixels per logical pixel; sizes of styles are logical
  FramebufferId target{};      ///< default: the window
  int left = 0;                ///< lower left corner of the view in the target; the camera has the size
  int bottom = 0;
  bool overlays = true;
  Preview preview = Preview::none;  ///< for counted instances; not for a saved picture
};

/// Position and size of a picture in document units; its height follows from its proportions.
struct PicturePlace {
  Vec2 center{};
  double width = 0.0;  ///< 0 or less: the picture is not drawn
  friend bool operator==(const PicturePlace&, const PicturePlace&) = default;
};

/// A few primitives above all layers, such as the marks of selected samples.
struct Overlay {
  PrimitiveKind kind = PrimitiveKind::point;
  std::span<const double> data;  ///< `stride_of(kind)` doubles a primitive, in document units; copied
  LayerStyle style;
  bool ring = false;  ///< points are drawn as circles `line_width_px` wide instead of filled
};

class Scene {
 public:
  explicit Scene(Device& device);
  ~Scene();
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  /// Throws std::bad_alloc when graphics memory is exhausted. The affected kind is then empty, and the layer must be
  /// sent again as a whole.
  void apply(const FramePatch& patch);
  /// Removes all instances of a layer and releases their memory.
  void forget(VariantLayer layer);

  /// Draws a picture instead of a layer, with the opacity of its style. Uploads it now; `place_picture` moves it
  /// without another upload. Its edges are placed in double precision, at any zoom. Throws std::bad_alloc.
  void set_picture(VariantLayer layer, const Image& image);
  void place_picture(const PicturePlace& place) { picture_place_ = place; }
  void clear_picture();

  /// Overlays are drawn in the order of their slots, which are small numbers. Cheap enough for every frame.
  void set_overlay(std::uint32_t slot, const Overlay& overlay);
  void clear_overlay(std::uint32_t slot);

  /// Replaces the maps that styles may name; the default is `builtin_color_maps`. If two maps have the same name, the
  /// first counts.
  void set_color_maps(std::vector<ColorMap> maps);
  const std::vector<ColorMap>& color_maps() const { return maps_; }
  /// The range of the finite scalars of a layer.
  ScalarRange scalar_range(VariantLayer layer) const;
  ShownMap shown_map(VariantLayer layer, const LayerStyle& style) const;

  void draw(const Camera& camera, std::span<const LayerView> views, const DrawOptions& options);

 private:
  /// Draws at most so many instances, and returns true if none are left.
  using Step = std::function<bool(std::uint32_t)>;
  using Steps = std::vector<Step>;

 public:
  /// A `draw` in several turns, for a window that must not wait for it. Once it is complete, the target has the pixels
  /// that `draw` would have given it. It refers to the scene: drop it before any other call of one of its functions
  /// that are not const.
  class Drawing {
   public:
    /// Draws on for about this many milliseconds, or for one step, and returns true once all is drawn.
    bool go_on(double ms);

   private:
    friend class Scene;
    Device* device_ = nullptr;
    Steps steps_;
    std::size_t next_ = 0;
    std::uint32_t piece_ = 1;  ///< instances to draw at a time
  };
  /// Begins a drawing, which draws nothing yet.
  Drawing begin(const Camera& camera, std::span<const LayerView> views, const DrawOptions& options);

  /// The frame of the last patch; it also maps overlays.
  const DrawingFrame& frame() const { return frame_; }
  std::uint32_t instances(VariantLayer layer, PrimitiveKind kind) const;
  /// The number of segments of a layer whose ends are equal, such as Voronoi edges of samples on one circle.
  std::uint32_t zero_length_segments(VariantLayer layer) const;
  /// The number of disks of a layer that `draw` paints one by one, however long that takes; 0 if they are counted
  /// because counting takes less time.
  std::uint32_t painted_disks(const Camera& camera, VariantLayer layer, const LayerStyle& style) const;
  /// Total bytes of instances uploaded by `apply` and `set_overlay` so far.
  std::uint64_t bytes_uploaded() const { return bytes_uploaded_; }
  /// Whether a finer preview would have changed the last `draw`.
  bool is_coarse() const { return is_coarse_; }
  /// The number of draw calls of the last `draw`.
  std::uint32_t draw_calls() const { return draw_calls_; }

 private:
  struct Layer {
    bool is_used = false;  ///< the buffers exist on the device
    std::array<InstanceBuffer, kPrimitiveKinds> kinds;
    std::array<std::unique_ptr<CountedInstances>, kPrimitiveKinds> counted;  ///< null: this kind is painted
  };
  struct OverlaySet {
    PrimitiveKind kind = PrimitiveKind::point;
    InstanceBuffer buffer;
    LayerStyle style;
    bool ring = false;
  };
  struct Pass;
  struct Look;
  struct GroupTarget {
    FramebufferId id{};
    int width = 0;
    int height = 0;
  };

  void draw_layer(Steps& steps, const Pass& pass, std::span<InstanceBuffer> kinds, const Look& look);
  void draw_group(Steps& steps, const Pass& pass, std::span<InstanceBuffer> kinds, const Look& look);
  void draw_kind(Steps& steps, const Pass& pass, InstanceBuffer& buffer, const Look& look,
                 const PremultipliedColor& color, Blend blend);
  bool draw_counted(Steps& steps, const Pass& pass, InstanceBuffer& buffer, const Look& look, const PixelFrame& frame,
                    const PremultipliedColor& color);
  FramebufferId target_of(const Pass& pass);
  void draw_picture(const Pass& pass, const LayerStyle& style);
  void draw_texts(const Pass& pass, const LayerView& view);
  FramebufferId group_target(TargetFormat format, int width, int height);
  TextureId map_texture();

  Device& device_;
  LayerTable<Layer> layers_;
  LayerTable<std::unique_ptr<TextMask>> texts_;  // null: none were drawn
  std::vector<OverlaySet> overlays_;
  DrawingFrame frame_;
  std::vector<ColorMap> maps_ = builtin_color_maps();
  TextureId map_texture_{};
  TextureId picture_{};
  VariantLayer picture_layer_ = kNoLayer;
  double picture_aspect_ = 1.0;  // height divided by width
  PicturePlace picture_place_;
  std::array<GroupTarget, 2> groups_;  // by TargetFormat
  std::uint64_t bytes_uploaded_ = 0;
  std::uint32_t draw_calls_ = 0;
  bool is_coarse_ = false;
};

}  // namespace mes::render
