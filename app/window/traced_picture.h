// SPDX-License-Identifier: GPL-3.0-or-later
// The picture to trace: chosen or dropped, read in the background, shown below the drawing.
#pragma once

#include <filesystem>
#include <functional>

#include "app/editing/editor.h"
#include "app/layers/layer_stack.h"
#include "app/model/messages.h"
#include "app/picture/picture.h"
#include "app/store/background_loader.h"
#include "app/system/waker.h"

namespace mes {

/// What it guarantees: the picture that the layers name is shown where they place it; reading it holds up nothing.
/// Threads: the window's; `wake` is called from the reader's.
class TracedPicture {
 public:
  TracedPicture(Editor& editor, LayerStack& layers, Picture& picture, Messages& messages, Waker wake)
      : editor_(editor), layers_(layers), picture_(picture), messages_(messages), new_(wake), loader_(wake) {}

  /// Becomes the picture of the layers once it is read; if it cannot be, they stay as they are.
  void trace(const std::filesystem::path& file);
  /// Gives up what is being read to be traced: it was meant for another document.
  void give_up() { new_.follow({}); }
  /// Once a frame; `free` is what is seen between the panels, which a new picture fills. True when reading has ended.
  bool follow(const Box2& free);

 private:
  void take_new(const BackgroundLoader::Outcome& outcome, const Box2& free);
  bool show_image(const BackgroundLoader::Outcome& outcome);
  void show(const BackgroundLoader::Outcome& outcome, const Box2& free);

  Editor& editor_;
  LayerStack& layers_;
  Picture& picture_;
  Messages& messages_;
  BackgroundLoader new_;     // chosen to be traced
  BackgroundLoader loader_;  // named by the layers
};

}  // namespace mes
