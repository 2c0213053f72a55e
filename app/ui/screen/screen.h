// SPDX-License-Identifier: GPL-3.0-or-later
// The system window, the panels' interface in it, and the clock that decides when to draw.
#pragma once

#include <filesystem>
#include <memory>
#include <utility>

#include "app/ui/screen/frame_clock.h"
#include "app/ui/screen/frame_times.h"
#include "app/ui/screen/glfw_window.h"
#include "app/ui/screen/gui.h"

namespace mes {

/// An OpenGL context must be current for its whole life. Threads: the window's.
struct Screen {
  Screen(std::unique_ptr<GlfwWindow> opened, std::filesystem::path assets)
      : window(std::move(opened)), gui(*window, std::move(assets)) {}

  std::unique_ptr<GlfwWindow> window;
  Gui gui;
  FrameClock clock;
  FrameTimes times;
};

}  // namespace mes
