// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/store/background_loader.h"

#include <algorithm>
#include <new>
#include <utility>

#include "core/base/geometry/coordinate_range.h"
#include "render/image/picture_file.h"

namespace mes {

BackgroundLoader::BackgroundLoader(Waker wake) : reading_(std::move(wake)) {}

bool BackgroundLoader::follow(const BackgroundImage& image) {
  if (image.file == file_ && (image.is_upright == is_upright_ || file_.empty())) return false;
  file_ = image.file;
  is_upright_ = image.is_upright;
  if (file_.empty())
    reading_.give_up();
  else  // The job cannot be stopped; the caller just does not wait for it.
    reading_.begin([image](const std::stop_token&) { return read_background(image); });
  return true;
}

std::optional<BackgroundLoader::Outcome> BackgroundLoader::poll() {
  auto image = reading_.poll();
  if (!image) return std::nullopt;
  return Outcome{file_, std::move(*image)};
}

Expected<render::Image> read_background(const BackgroundImage& picture) try {
  // More detail is invisible, and uploading it to the graphics card would block the window's frames.
  constexpr int kLongestSide = 8192;
  auto image = render::read_picture(picture.file, picture.is_upright ? PictureTurn::upright : PictureTurn::as_stored);
  if (!image) return image;
  return render::reduced(std::move(*image), kLongestSide);
} catch (const std::bad_alloc&) {
  return std::unexpected(Error{ErrorCode::out_of_memory, "there is not enough memory for it", picture.file});
}

BackgroundImage placed_in(const Box2& box, BackgroundImage image, double height_by_width) {
  Box2 room = box;
  if (room.is_empty()) room = {{0.0, 0.0}, {1.0, 1.0}};
  const double width = std::min(room.width(), room.height() / height_by_width);
  // Views can be deeper or farther than any document, so the numbers are clamped.
  static constexpr double kLeast = 0x1p-500;
  static constexpr double kMost = 0x1.fffffffffffffp499;
  static_assert(exponent_of(kLeast) == kLeastExponent && exponent_of(kMost) == kMostExponent);
  const auto kept = [](double x) { return without_traces(std::clamp(x, -kMost, kMost), kLeastExponent); };
  const Vec2 center = room.center();
  image.center = {kept(center.x), kept(center.y)};
  image.width = width > 0.0 ? std::clamp(width, kLeast, kMost) : 1.0;
  return image;
}

}  // namespace mes
