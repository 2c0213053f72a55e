// SPDX-License-Identifier: GPL-3.0-or-later
// Reads the picture to trace on a thread of its own.
#pragma once

#include <atomic>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <thread>
#include <vector>

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
  explicit BackgroundLoader(std::function<void()> wake);

  /// Begins to read if this is another file than before, which is returned; an empty name gives up what is being
  /// read.
  bool follow(const std::string& file);
  bool is_reading() const { return reading_ != nullptr; }

  struct Outcome {
    std::string file;
    Expected<render::Image> image;
  };
  std::optional<Outcome> poll();

 private:
  struct Reading {
    std::string file;
    std::atomic<bool> is_done = false;
    std::optional<Expected<render::Image>> result;
    std::jthread thread;  // last: it ends before what it writes to
  };

  std::function<void()> wake_;
  std::string file_;
  std::unique_ptr<Reading> reading_;
  std::vector<std::unique_ptr<Reading>> given_up_;  // a reader cannot be stopped, only not waited for
};

/// The picture of a file, reduced to what the eye and a graphics card need for tracing. Any thread.
Expected<render::Image> read_background(const std::string& file);

/// The picture as large as it can be within the box, in its middle; an empty box is the unit square.
BackgroundImage placed_in(const Box2& box, const std::string& file, double height_by_width);

}  // namespace mes
