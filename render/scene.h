// SPDX-License-Identifier: GPL-3.0-or-later
// The layers as instance buffers on a device, kept up to date by patches and drawn through a camera.
//
// What it guarantees:
//  1. `apply` uploads the changed instances of a patch and nothing else. Instances next to each other go together.
//  2. `draw` uploads no instances: camera, style, colour map, range and stacking order are uniforms and order of
//  calls.
//  3. Layers are painted in the order given, bottom first, each above all before it.
//  4. Nothing that is finite makes garbage: coordinates of any size are clipped to where they can be seen.
//  5. With a colour map of a known name, instances have the colours of their scalars; a scalar beyond the range, an
//     infinite one too, has the end colour, what is not a number the plain colour. In a flat layer the later instance
//     hides the one before it, and the whole is as opaque as its style says.
//
// Smallest use:
//     Scene scene(device);
//     scene.apply(*engine.sync());
//     scene.draw(camera, views, {.content_scale = 2.0});
//
// Cost: `apply` O(changed instances); `draw` one call a layer and kind, whatever the count, plus one pass over the
// view for a layer drawn as a group. No pass over the instances on the CPU. Threads: the one that owns the context.
//
// Inside: coordinates are mapped to drawing space (`DrawingFrame`) in double and uploaded as the bits of doubles;
// the vertex shader takes the camera's centre off before anything is rounded to single precision.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/draw/layer_style.h"
#include "core/draw/patch.h"
#include "core/draw/primitives.h"
#include "render/camera.h"
#include "render/colormap.h"
#include "render/device.h"
#include "render/image.h"
#include "render/instance_buffer.h"

namespace mes::render {

/// What colours a layer now.
struct ShownMap {
  const ColorMap* map = nullptr;  ///< none: it has its plain colour
  ScalarRange range;              ///< may be empty: no scalar is finite
};

struct LayerView {
  LayerIndex layer = 0;
  LayerStyle style;
  /// Of disks only each `every`-th is drawn: a preview for when so many large ones lie on each other that painting
  /// them all takes too long. Pictures for keeps have 1.
  std::uint32_t every = 1;
};

struct DrawOptions {
  double content_scale = 1.0;  ///< framebuffer pixels per logical pixel; sizes of styles are logical
  FramebufferId target{};      ///< the window by default
  int left = 0;                ///< lower left corner of the view in the target; its size is the camera's
  int bottom = 0;
  bool overlays = true;
};

/// Where a picture lies, in document units: its height follows from its pixels.
struct PicturePlace {
  Vec2 center{};
  double width = 0.0;  ///< not above 0: it is not drawn
  friend bool operator==(const PicturePlace&, const PicturePlace&) = default;
};

/// A few primitives of the app above all layers: selection, hovered sample, rubber band.
struct Overlay {
  PrimitiveKind kind = PrimitiveKind::point;
  std::span<const double> data;  ///< `stride_of(kind)` doubles each, document units; copied
  LayerStyle style;
  bool ring = false;  ///< points are drawn as circles `line_width_px` wide instead of filled
};

class Scene {
 public:
  explicit Scene(Device& device);
  ~Scene();
  Scene(const Scene&) = delete;
  Scene& operator=(const Scene&) = delete;

  /// Throws std::bad_alloc when graphics memory is exhausted; the kind concerned is then empty, and the layer has to
  /// be asked for again as a whole.
  void apply(const FramePatch& patch);
  /// Forgets all instances of a layer and gives its memory back.
  void forget(LayerIndex layer);

  /// Draws a picture in the place of a layer, with the opacity of its style; uploaded now, at most once. Its edges
  /// lie where doubles say, at any zoom. Throws std::bad_alloc.
  void set_picture(LayerIndex layer, const Image& image);
  void place_picture(const PicturePlace& place) { picture_place_ = place; }
  void clear_picture();

  /// Overlays are drawn in the order of their slots, a small number the app chooses. Cheap enough for every frame.
  void set_overlay(std::uint32_t slot, const Overlay& overlay);
  void clear_overlay(std::uint32_t slot);

  /// Replaces the maps that styles name; those that need no file are there from the beginning. Of two with one name
  /// the first counts.
  void set_color_maps(std::vector<ColorMap> maps);
  const std::vector<ColorMap>& color_maps() const { return maps_; }
  /// Range of the finite scalars of a layer.
  ScalarRange scalar_range(LayerIndex layer) const;
  ShownMap shown_map(LayerIndex layer, const LayerStyle& style) const;

  void draw(const Camera& camera, std::span<const LayerView> views, const DrawOptions& options);

  /// The frame of the last patch; overlays are placed in it.
  const DrawingFrame& frame() const { return frame_; }
  std::uint32_t instances(LayerIndex layer, PrimitiveKind kind) const;
  /// Bytes of instances uploaded by `apply` and `set_overlay` since the scene exists.
  std::uint64_t bytes_uploaded() const { return bytes_uploaded_; }
  /// Draw calls of the last `draw`.
  std::uint32_t draw_calls() const { return draw_calls_; }

 private:
  struct Layer {
    std::array<InstanceBuffer, kPrimitiveKinds> kinds;
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

  void draw_layer(const Pass& pass, std::span<const InstanceBuffer> kinds, const Look& look);
  void draw_group(const Pass& pass, std::span<const InstanceBuffer> kinds, const Look& look);
  void draw_kind(const Pass& pass, const InstanceBuffer& buffer, const Look& look, const PremultipliedColor& color,
                 Blend blend);
  void draw_picture(const Pass& pass, const LayerStyle& style);
  FramebufferId group_target(TargetFormat format, int width, int height);
  TextureId map_texture();

  Device& device_;
  std::vector<Layer> layers_;
  std::vector<OverlaySet> overlays_;
  DrawingFrame frame_;
  std::vector<ColorMap> maps_ = builtin_color_maps();
  TextureId map_texture_{};
  TextureId picture_{};
  LayerIndex picture_layer_ = kNoSlot;
  double picture_aspect_ = 1.0;  // height by width
  PicturePlace picture_place_;
  std::array<GroupTarget, 2> groups_;  // by TargetFormat
  std::uint64_t bytes_uploaded_ = 0;
  std::uint32_t draw_calls_ = 0;
};

}  // namespace mes::render
