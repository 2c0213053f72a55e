// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the picture to trace on a thread of its own.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "app/system/background_job.h"
#include "core/base/box2.h"
#include "core/base/error.h"
#include "core/document/layer_configuration.h"
#include "render/image.h"

namespace mes {

/// What it guarantees: it never waits for a file; of several asked for one after the other only the last is
/// delivered, once. Smallest use:
///     loader.follow(layers.image().file);
///     if (auto outcome = loader.poll()) ...
/// Threads: the window's; `wake` is called from the reading one.
class BackgroundLoader {
 public:
  explicit BackgroundLoader(Waker wake);

  /// Begins to read if this is another file than before, or the same turned in another way, which is returned; an empty
  /// name gives up what is being read.
  bool follow(const BackgroundImage& image);
  /// The file was read elsewhere, upright: following it begins nothing.
  void take_as_read(const std::string& file) {
    follow({});
    file_ = file;
    is_upright_ = true;
  }
  bool is_reading() const { return reading_.is_under_way(); }

  struct Outcome {
    std::string file;
    Expected<render::Image> image;
  };
  std::optional<Outcome> poll();

 private:
  std::string file_;
  bool is_upright_ = true;
  BackgroundJob<Expected<render::Image>> reading_;
};

/// The picture of a file, reduced to what the eye and a graphics card need for tracing. Any thread.
Expected<render::Image> read_background(const BackgroundImage& image);

/// The picture as large as it can be within the box, in its middle; an empty box is the unit square.
BackgroundImage placed_in(const Box2& box, BackgroundImage image, double height_by_width);

}  // namespace mes
