// SPDX-License-Identifier: GPL-3.0-or-later
// The texts of one layer as a mask (`Device::paint_mask`), for one view.
//
// Guarantees:
//  1. The mask is that of the texts, the view and the scale of the last `show`; repeating these costs nothing.
//  2. Positions are rounded to a quarter of a pixel, but not letters: they look the same at every position.
//
// Smallest use:
//     mask.show(texts, camera, content_scale);
//     if (!mask.parts().empty()) device.paint_mask(target, area, mask.mask(), mask.parts(), color);
//
// Cost: `show` O(pixels of the view + visible letters): two milliseconds for five thousand numbers. Threads: the one
// that owns the context.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <vector>

#include "render/camera.h"
#include "render/device/device.h"
#include "render/layer_texts.h"

namespace mes::render {

class TextMask {
 public:
  explicit TextMask(Device& device) : device_(device) {}
  ~TextMask() { forget(); }
  TextMask(const TextMask&) = delete;
  TextMask& operator=(const TextMask&) = delete;

  /// The texts must have a font. On std::bad_alloc the mask is empty.
  void show(const std::shared_ptr<const LayerTexts>& texts, const Camera& camera, double content_scale);
  TextureId mask() const { return mask_; }
  /// One part, or none if no letter is visible; the rest of the mask is undefined.
  std::span<const PixelRect> parts() const { return parts_; }

 private:
  /// The area of painted letters, in rows from the top.
  struct Painted {
    int left = 0;
    int top = 0;
    int right = 0;
    int bottom = 0;
  };
  void forget();
  void clear();
  void paint(Vec2 start, const std::vector<Glyph>& glyphs);
  void paint(const GlyphPicture& picture, int left, int top);
  const std::vector<Glyph>& glyphs_of(const std::string& text);
  const GlyphPicture& picture_of(int glyph, int quarter_x, int quarter_y);

  Device& device_;
  std::shared_ptr<const LayerTexts> texts_;
  Camera camera_;
  double scale_ = 0.0;
  TextureId mask_{};
  std::vector<std::uint16_t> rows_;  // bottom row first, as in masks
  Painted painted_;
  std::vector<PixelRect> parts_;
  std::optional<Font> font_;  // font of the two members below, at this size
  double size_px_ = 0.0;
  std::unordered_map<std::string, std::vector<Glyph>> lines_;
  std::unordered_map<std::uint64_t, GlyphPicture> pictures_;
};

}  // namespace mes::render
