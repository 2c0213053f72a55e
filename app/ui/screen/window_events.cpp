// SPDX-License-Identifier: GPL-3.0-or-later
// How the window waits for events, and how other programs know it. A browser has its own way (web/app/ui).
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <dlfcn.h>
#include <fmt/core.h>

#include "app/ui/screen/glfw_window.h"

namespace mes {

void GlfwWindow::poll() {
  glfwPollEvents();
}

void GlfwWindow::wait(double seconds) {
  if (seconds > 0.0)
    glfwWaitEventsTimeout(seconds);
  else
    glfwWaitEvents();
}

void GlfwWindow::wake() {
  glfwPostEmptyEvent();
}

// GLFW has this function only when it was built for X11, and another build may be installed later.
std::string GlfwWindow::desktop_handle() const {
  using Number = unsigned long (*)(GLFWwindow*);
  const auto number_of = reinterpret_cast<Number>(dlsym(RTLD_DEFAULT, "glfwGetX11Window"));
  const unsigned long number = number_of == nullptr ? 0 : number_of(window_);
  return number == 0 ? std::string() : fmt::format("x11:{:x}", number);
}

}  // namespace mes
