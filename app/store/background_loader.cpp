// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/store/background_loader.h"

#include <algorithm>
#include <utility>

#include "core/base/coordinate_range.h"
#include "render/picture_file.h"

namespace mes {

BackgroundLoader::BackgroundLoader(std::function<void()> wake) : wake_(std::move(wake)) {}

bool BackgroundLoader::follow(const std::string& file) {
  if (file == file_) return false;
  file_ = file;
  if (reading_) given_up_.push_back(std::move(reading_));
  std::erase_if(given_up_, [](const auto& reading) { return reading->is_done.load(); });
  if (file.empty()) return true;
  reading_ = std::make_unique<Reading>();
  reading_->file = file;
  reading_->thread = std::jthread([reading = reading_.get(), wake = wake_] {
    reading->result = read_background(reading->file);
    reading->is_done = true;
    if (wake) wake();
  });
  return true;
}

std::optional<BackgroundLoader::Outcome> BackgroundLoader::poll() {
  if (!reading_ || !reading_->is_done) return std::nullopt;
  const std::unique_ptr<Reading> reading = std::move(reading_);
  reading->thread.join();
  return Outcome{reading->file, std::move(*reading->result)};
}

Expected<render::Image> read_background(const std::string& file) {
  // More is not seen, and would keep the window from its frames while it goes to the graphics card.
  constexpr int kLongestSide = 8192;
  auto image = render::read_picture(file);
  if (!image) return image;
  return render::reduced(std::move(*image), kLongestSide);
}

BackgroundImage placed_in(const Box2& box, const std::string& file, double height_by_width) {
  Box2 room = box;
  if (room.is_empty()) room = {{0.0, 0.0}, {1.0, 1.0}};
  const double width = std::min(room.width(), room.height() / height_by_width);
  // A view may be deeper or farther than anything a document can hold.
  static constexpr double kLeast = 0x1p-500;
  static constexpr double kMost = 0x1.fffffffffffffp499;
  static_assert(exponent_of(kLeast) == kLeastExponent && exponent_of(kMost) == kMostExponent);
  const auto kept = [](double x) { return without_traces(std::clamp(x, -kMost, kMost), kLeastExponent); };
  const Vec2 center = room.center();
  return {file, {kept(center.x), kept(center.y)}, width > 0.0 ? std::clamp(width, kLeast, kMost) : 1.0};
}

}  // namespace mes
