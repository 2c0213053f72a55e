// SPDX-License-Identifier: GPL-3.0-or-later
// A picture read back from the graphics card: one part, or one for each pane of a sheet.
//
// Smallest use:
//     CapturedPicture picture = raw_image;           // or: CapturedPicture(sheet, fonts), then `add` for each pane
//     if (picture.is_whole()) encode(std::move(picture).image());
//
// Cost: `add` is a move, `image` O(pixels). Threads: any, one at a time.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

#include "app/picture/paper/pane_sheet.h"
#include "app/picture/picture_overlay.h"
#include "render/image/image.h"

namespace mes {

class CapturedPicture {
 public:
  using Pixels = std::variant<render::Image, render::RawImage>;

  CapturedPicture() = default;
  /// A whole picture, perhaps with an overlay.
  CapturedPicture(render::Image image, PictureOverlay overlay = {}) { add(std::move(image), std::move(overlay)); }
  CapturedPicture(render::RawImage raw, PictureOverlay overlay = {}) { add(std::move(raw), std::move(overlay)); }
  /// A sheet without its panes, which must be added in their order. `fonts` is not null.
  CapturedPicture(PaneSheet sheet, std::shared_ptr<const PaperFonts> fonts)
      : sheet_(std::move(sheet)), fonts_(std::move(fonts)) {}

  void add(Pixels pixels, PictureOverlay overlay) { parts_.push_back({std::move(pixels), std::move(overlay)}); }
  bool is_whole() const { return parts_.size() == (sheet_ ? sheet_->labels.size() : 1); }
  /// Size of its pixels.
  std::size_t bytes() const;
  /// The picture with its overlays and labels; it must be whole.
  render::Image image() &&;

 private:
  struct Part {
    Pixels pixels;
    PictureOverlay overlay;
  };
  std::vector<Part> parts_;
  std::optional<PaneSheet> sheet_;
  std::shared_ptr<const PaperFonts> fonts_;
};

}  // namespace mes
