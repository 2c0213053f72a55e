// SPDX-License-Identifier: GPL-3.0-or-later
#include "web/app/ui/window_events.h"

#include <atomic>

#include "app/ui/screen/glfw_window.h"

namespace mes {
namespace {

std::atomic<bool> is_woken = false;

}  // namespace

bool take_wake() {
  return is_woken.exchange(false);
}

// Events are delivered between two frames.
void GlfwWindow::poll() {}
void GlfwWindow::wait(double /*seconds*/) {}

void GlfwWindow::wake() {
  is_woken = true;
}

std::string GlfwWindow::desktop_handle() const {
  return {};
}

}  // namespace mes
