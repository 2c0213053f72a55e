// SPDX-License-Identifier: GPL-3.0-or-later
// The picture to trace: chosen or dropped, read in the background, shown below the drawing.
#include "app/window/app.h"

namespace mes {

void App::ask_picture() {
  browser_.ask_for("Trace a picture", {".png", ".jpg", ".jpeg"}, browse_folder(),
                   [this](const std::filesystem::path& file) {
                     settings_.last_folder = file.parent_path().string();
                     trace_picture(file);
                   });
}

// Where it goes is known when its proportions are.
void App::trace_picture(const std::filesystem::path& file) {
  std::error_code error;
  std::filesystem::path absolute = std::filesystem::weakly_canonical(file, error);
  if (error) absolute = file;
  layers_.set_image({.file = absolute.string()});
  const LayerIndex layer = find_layer("image");
  if (!layers_.is_visible(layer)) layers_.set_visible(layer, true);
}

void App::follow_picture() {
  if (background_.follow(layers_.image().file)) picture_.clear_background();
  if (auto outcome = background_.poll()) {
    if (!outcome->image) {
      report(outcome->image.error());
    } else if (!picture_.set_background(find_layer("image"), *outcome->image)) {
      report({ErrorCode::out_of_memory, "there is not enough graphics memory for it", outcome->file});
    } else {
      if (!(layers_.image().width > 0.0)) {
        editor_.note_layers();
        layers_.set_image(placed_in(canvas_.view().free_box(), outcome->file, picture_.background_aspect()));
        editor_.join_layers();
      }
    }
    on_anything();
  }
  picture_.place_background({layers_.image().center, layers_.image().width});
}

}  // namespace mes
