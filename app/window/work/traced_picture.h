// SPDX-License-Identifier: GPL-3.0-or-later
// The picture that the user traces: chosen or dropped, read in the background, shown below the drawing.
#pragma once

#include <filesystem>
#include <functional>

#include "app/actions/messages.h"
#include "app/editing/editor.h"
#include "app/layers/layer_stack.h"
#include "app/picture/picture.h"
#include "app/store/background_loader.h"
#include "app/system/waker.h"

namespace mes {

/// Guarantees: the picture named in the layers is shown where they place it; its reading blocks nothing. Threads: the
/// window's; `wake` is called from the reader's.
class TracedPicture {
 public:
  TracedPicture(Editor& editor, LayerStack& layers, Picture& picture, Messages& messages, Waker wake)
      : editor_(editor), layers_(layers), picture_(picture), messages_(messages), new_(wake), loader_(wake) {}

  /// Reads a file, which then becomes the picture of the layers; if it cannot be read, the layers stay as they are.
  void trace(const std::filesystem::path& file);
  /// Gives up the reading of a picture to trace, because it was meant for another document.
  void give_up() { new_.follow({}); }
  /// Call it once per frame; a new picture fills `free`, the visible area between the panels. True when a reading has
  /// ended.
  bool follow(const Box2& free);

 private:
  void take_new(const BackgroundLoader::Outcome& outcome, const Box2& free);
  bool show_image(const BackgroundLoader::Outcome& outcome);
  void show(const BackgroundLoader::Outcome& outcome, const Box2& free);

  Editor& editor_;
  LayerStack& layers_;
  Picture& picture_;
  Messages& messages_;
  BackgroundLoader new_;     // reads a picture chosen for tracing
  BackgroundLoader loader_;  // reads the picture that the layers name
};

}  // namespace mes
