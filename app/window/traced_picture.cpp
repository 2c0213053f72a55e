// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/traced_picture.h"

namespace mes {

// Where it goes is known when its proportions are.
void TracedPicture::trace(const std::filesystem::path& file) {
  std::error_code error;
  std::filesystem::path absolute = std::filesystem::weakly_canonical(file, error);
  if (error) absolute = file;
  layers_.set_image({.file = absolute.string()});
  const LayerIndex layer = find_layer("image");
  if (!layers_.is_visible(layer)) layers_.set_visible(layer, true);
}

bool TracedPicture::follow(const Box2& free) {
  if (loader_.follow(layers_.image().file)) picture_.clear_background();
  const auto outcome = loader_.poll();
  if (outcome) show(*outcome, free);
  picture_.place_background({layers_.image().center, layers_.image().width});
  return outcome.has_value();
}

void TracedPicture::show(const BackgroundLoader::Outcome& outcome, const Box2& free) {
  if (!outcome.image) {
    messages_.problem(outcome.image.error().message());
    return;
  }
  if (!picture_.set_background(find_layer("image"), *outcome.image)) {
    messages_.problem(
        Error{ErrorCode::out_of_memory, "there is not enough graphics memory for it", outcome.file}.message());
    return;
  }
  if (layers_.image().width > 0.0) return;
  editor_.note_layers();
  layers_.set_image(placed_in(free, outcome.file, picture_.background_aspect()));
  editor_.join_layers();
}

}  // namespace mes
