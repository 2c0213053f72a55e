// SPDX-License-Identifier: GPL-3.0-or-later
// The browser calls the loop of the window once a frame. The window lives until its page is closed.
#include "app/window/run_window.h"

#include <emscripten/emscripten.h>

#include <cstdio>
#include <exception>
#include <utility>

#include "app/window/app.h"
#include "web/app/ui/window_events.h"

namespace mes {
namespace {

struct Page {
  App app;
  double last_turn = 0.0;
};

double now() {
  constexpr double kMilliseconds = 1e-3;
  return kMilliseconds * emscripten_get_now();
}

void follow(void* given) {
  Page& page = *static_cast<Page*>(given);
  const double limit = page.app.next_wait();
  const bool is_due = limit > 0.0 && now() - page.last_turn >= limit;
  if (!take_wake() && !is_due && !page.app.wants_turn()) return;
  page.last_turn = now();
  try {
    if (page.app.step()) return;
    page.app.end();
    EM_ASM({ say("Mesecina has ended. Reload the page to start it again."); });
  } catch (const std::exception& error) {
    EM_ASM({ say("Mesecina has stopped: " + UTF8ToString($0)); }, error.what());
  }
  emscripten_cancel_main_loop();
}

}  // namespace

int run_window(const Registry& registry, const WindowOptions& options) {
  constexpr int kNoDisplay = 4;
  LoadedSettings loaded = load_settings(default_settings_path());
  auto window = GlfwWindow::create({.title = "Mesecina",
                                    .width = EM_ASM_INT({ return window.innerWidth; }),
                                    .height = EM_ASM_INT({ return window.innerHeight; })});
  if (!window) {
    std::fprintf(stderr, "mesecina: %s\n", window.error().message().c_str());
    return kNoDisplay;
  }
  auto* const page = new Page{App(registry, std::move(*window), options, std::move(loaded))};
  emscripten_set_main_loop_arg(follow, page, 0, false);
  return 0;
}

}  // namespace mes
