// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the picture that the user traces, on a thread of its own.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "app/system/background_job.h"
#include "core/base/error.h"
#include "core/base/geometry/box2.h"
#include "core/document/settings/layer_configuration.h"
#include "render/image/image.h"

namespace mes {

/// Guarantees: it never waits for a file; of several requests one after the other only the last is delivered, once.
/// Smallest use:
///     loader.follow(layers.image().file);
///     if (auto outcome = loader.poll()) ...
/// Threads: the window's; `wake` is called from the reading one.
class BackgroundLoader {
 public:
  explicit BackgroundLoader(Waker wake);

  /// Begins to read if the file or the way it is turned differs from before, and returns whether it does. An empty
  /// name gives up the reading under way.
  bool follow(const BackgroundImage& image);
  /// Notes that the file was already read elsewhere, upright, so that following it begins nothing.
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

/// Places the picture in the middle of the box, as large as it fits; an empty box stands for the unit square.
BackgroundImage placed_in(const Box2& box, BackgroundImage image, double height_by_width);

}  // namespace mes
