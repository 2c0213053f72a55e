// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of a scene, one after the other, without waiting for the graphics card.
//
// What it guarantees:
//  1. A picture is the one `draw_image` makes of the same camera; larger ones than the hardware can hold are drawn in
//     tiles. Of overlapping disks none is left out.
//  2. With supersampling it is drawn larger and averaged, in premultiplied colours as they are stored. That is how
//  the
//     window blends its edges too, so a supersampled frame is as light or dark as the window; averaging linear light
//     would make thin dark lines paler. Factors are 1, 2 and 4: halving is exact on every card, thirds are not.
//  3. Pictures come out in the order they were asked for, each once and whole.
//
// Smallest use:
//     FrameCapture capture(device);
//     capture.draw(scene, camera, views, {.supersampling = 2});
//     ... later: while (auto raw = capture.poll()) use(*raw);
//
// Cost: drawing; see readback.h for the way back. Threads: the one that owns the context.
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
  int tile_px = 2048;  ///< largest tile as it is drawn; the device's limit caps it
};

class FrameCapture {
 public:
  explicit FrameCapture(GlDevice& device) : device_(device), readback_(device) {}
  ~FrameCapture();
  FrameCapture(const FrameCapture&) = delete;
  FrameCapture& operator=(const FrameCapture&) = delete;

  /// Draws the camera's whole viewport. Error: no memory for it; nothing was asked for then.
  Expected<void> draw(Scene& scene, const Camera& camera, std::span<const LayerView> views,
                      const CaptureOptions& options);
  /// Takes what a target shows now.
  void take(FramebufferId source, const PixelRect& area);

  /// The oldest picture if it has come.
  std::optional<RawImage> poll() { return next(false); }
  /// The oldest picture, waiting for it; none when none is under way.
  std::optional<RawImage> wait() { return next(true); }
  std::size_t pending() const { return wanted_.size(); }

 private:
  struct Wanted {
    int width = 0;
    int height = 0;
    std::deque<PixelRect> tiles;  // still to come, in order
    RawImage picture;             // of several tiles
    bool is_given_up = false;     // memory ran out on the way
  };
  struct Target {
    FramebufferId id{};
    int width = 0;
    int height = 0;
  };
  std::optional<RawImage> next(bool wait);
  FramebufferId target(std::size_t level, int width, int height);

  GlDevice& device_;
  Readback readback_;
  std::deque<Wanted> wanted_;
  std::array<Target, 3> targets_{};  // as drawn, halved, halved again
};

}  // namespace mes::render
