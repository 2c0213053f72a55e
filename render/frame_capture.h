// SPDX-License-Identifier: GPL-3.0-or-later
// Captures successive pictures of a scene, without waiting for the graphics card.
//
// Guarantees:
//  1. A picture is the same as that of `draw_image` for the same camera. Pictures larger than the hardware can hold are
//     drawn in tiles. No disk is left out.
//  2. With supersampling a picture is drawn larger and averaged, in premultiplied colours as they are stored. The
//     window blends its edges in the same way, so a supersampled frame is as light as the window; averages of linear
//     light would make thin dark lines paler. The factors are 1, 2 and 4: halving is exact on every card, a third is
//     not.
//  3. Pictures are returned in the order in which they were requested, each once and complete. If memory runs out after
//     the request, the picture is still returned in order, without pixels.
//
// Smallest use:
//     FrameCapture capture(device);
//     capture.draw(scene, camera, views, {.supersampling = 2});
//     ... later: while (auto raw = capture.poll()) use(*raw);
//
// Cost: drawing, and the read-back of readback.h. Threads: the one that owns the context.
#pragma once

#include <deque>
#include <optional>
#include <span>

#include "core/base/color.h"
#include "core/base/error.h"
#include "render/camera.h"
#include "render/readback.h"
#include "render/scene.h"

namespace mes::render {

struct CaptureOptions {
  std::optional<Rgb> background;  ///< none: transparent
  double content_scale = 1.0;     ///< pixels of the picture per logical pixel of styles
  int supersampling = 1;          ///< 1, 2 or 4
  bool overlays = true;
  int tile_px = 2048;  ///< largest side of a tile as drawn, at most the device's limit
};

class FrameCapture {
 public:
  explicit FrameCapture(GlDevice& device) : device_(device), readback_(device) {}
  ~FrameCapture();
  FrameCapture(const FrameCapture&) = delete;
  FrameCapture& operator=(const FrameCapture&) = delete;

  /// Draws the camera's whole viewport. Error `out_of_memory`: no picture was requested.
  Expected<void> draw(Scene& scene, const Camera& camera, std::span<const LayerView> views,
                      const CaptureOptions& options);
  /// Requests the current contents of a target. Error as above.
  Expected<void> take(FramebufferId source, const PixelRect& area);

  /// The oldest picture, if it has arrived.
  std::optional<RawImage> poll() { return next(false); }
  /// The oldest picture; waits for it. None if no picture was requested.
  std::optional<RawImage> wait() { return next(true); }
  std::size_t pending() const { return wanted_.size(); }

 private:
  struct Wanted {
    int width = 0;
    int height = 0;
    std::deque<PixelRect> tiles;  // tiles that have not yet arrived, in order
    RawImage picture;             // assembled from several tiles
    bool is_given_up = false;     // memory ran out after some tiles were requested: it is not returned
    bool is_lost = false;         // memory ran out for a tile: it is returned without pixels
  };
  struct Target {
    FramebufferId id{};
    int width = 0;
    int height = 0;
  };
  std::optional<RawImage> next(bool wait);
  void ask_for_tile(FramebufferId source, const PixelRect& area, const PixelRect& tile);
  FramebufferId target(std::size_t level, int width, int height);

  GlDevice& device_;
  Readback readback_;
  std::deque<Wanted> wanted_;
  std::array<Target, 3> targets_{};  // as drawn, halved, halved again
};

}  // namespace mes::render
