// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/work/traced_picture.h"

namespace mes {

void TracedPicture::trace(const std::filesystem::path& file) {
  std::error_code error;
  std::filesystem::path absolute = std::filesystem::weakly_canonical(file, error);
  if (error) absolute = file;
  new_.follow({});  // the same file may hold another picture now
  new_.follow({.file = absolute.string()});
}

bool TracedPicture::follow(const Box2& free) {
  auto traced = new_.poll();
  if (traced) take_new(*traced, free);
  if (loader_.follow(layers_.image())) picture_.clear_background();
  const auto outcome = loader_.poll();
  if (outcome) show(*outcome, free);
  picture_.place_background({layers_.image().center, layers_.image().width});
  return traced.has_value() || outcome.has_value();
}

// Changes the layers only when there is a picture to show.
void TracedPicture::take_new(const BackgroundLoader::Outcome& outcome, const Box2& free) {
  if (!show_image(outcome)) return;
  messages_.clear_problem();  // the problem concerned an earlier picture
  loader_.take_as_read(outcome.file);
  editor_.change_layers("Picture underneath", [&] {
    layers_.set_image(placed_in(free, {.file = outcome.file}, picture_.background_aspect()));
    layers_.set_visible(layers_.find("image"), true);
  });
}

bool TracedPicture::show_image(const BackgroundLoader::Outcome& outcome) {
  if (!outcome.image) {
    messages_.problem(outcome.image.error().message());
    return false;
  }
  const LayerIndex layer = layers_.find("image");
  if (layer == kNoLayer) {
    messages_.problem("The picture underneath is not shown: there is no layer for pictures");
    return false;
  }
  if (picture_.set_background(layer, *outcome.image)) return true;
  messages_.problem(
      Error{ErrorCode::out_of_memory, "there is not enough graphics memory for it", outcome.file}.message());
  return false;
}

void TracedPicture::show(const BackgroundLoader::Outcome& outcome, const Box2& free) {
  if (!show_image(outcome) || layers_.image().width > 0.0) return;
  editor_.note_layers();
  layers_.set_image(placed_in(free, layers_.image(), picture_.background_aspect()));
  editor_.join_layers();
}

}  // namespace mes
