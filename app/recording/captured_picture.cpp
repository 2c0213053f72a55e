// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recording/captured_picture.h"

#include "core/base/assert.h"

namespace mes {

std::size_t CapturedPicture::bytes() const {
  std::size_t out = 0;
  for (const Part& part : parts_)
    out += std::visit([](const auto& pixels) { return pixels.rgba.size(); }, part.pixels);
  return out;
}

render::Image CapturedPicture::image() && {
  MES_ASSERT(is_whole());
  std::vector<render::Image> images;
  for (Part& part : parts_) {
    const auto* const raw = std::get_if<render::RawImage>(&part.pixels);
    images.push_back(raw != nullptr ? render::to_image(*raw) : std::move(std::get<render::Image>(part.pixels)));
    part.overlay.paint(images.back());
    part = {};
  }
  return sheet_ ? sheet_->with(images, *fonts_) : std::move(images.front());
}

}  // namespace mes
