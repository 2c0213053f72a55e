// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/run_window.h"

#include <cstdio>
#include <exception>

#include "app/window/app.h"

namespace mes {

int run_window(const Registry& registry, const WindowOptions& options) {
  constexpr int kNoDisplay = 4;
  const Termination termination([] { GlfwWindow::wake(); });
  LoadedSettings loaded = load_settings(default_settings_path());
  const auto scale_free = [](int size) { return size > 0 ? size : 1; };
  auto window = GlfwWindow::create({.title = "Mesecina",
                                    .width = scale_free(loaded.settings.window_width),
                                    .height = scale_free(loaded.settings.window_height)});
  if (!window) {
    std::fprintf(stderr, "mesecina: %s\n", window.error().message().c_str());
    return kNoDisplay;
  }
  App app(registry, std::move(*window), options, std::move(loaded));
  app.run(termination);
  return termination.signal() == 0 ? 0 : 128 + termination.signal();
}

}  // namespace mes
