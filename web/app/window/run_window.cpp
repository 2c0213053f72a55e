// SPDX-License-Identifier: GPL-3.0-or-later
// The browser calls the loop of the window once a frame. The window lives until its page is closed.
#include "app/window/run_window.h"

#include <emscripten/emscripten.h>

#include <cstdio>
#include <exception>
#include <filesystem>
#include <optional>
#include <utility>

#include "app/window/app.h"
#include "web/app/ui/window_events.h"

namespace mes {
namespace {

struct Page {
  App app;
  double last_turn = 0.0;
  std::optional<double> unkept_since{};  // the first turn since the settings were kept
};
Page* the_page = nullptr;

double now() {
  constexpr double kMilliseconds = 1e-3;
  return kMilliseconds * emscripten_get_now();
}

void follow(void* given) {
  Page& page = *static_cast<Page*>(given);
  const double limit = page.app.next_wait();
  const bool is_due = limit > 0.0 && now() - page.last_turn >= limit;
  // A page may end without notice.
  constexpr double kBeforeKeeping = 1.0;
  if (page.unkept_since && now() - *page.unkept_since >= kBeforeKeeping) {
    page.unkept_since.reset();
    page.app.keep_settings();
  }
  if (!take_wake() && !is_due && !page.app.wants_turn()) return;
  page.last_turn = now();
  if (!page.unkept_since) page.unkept_since = page.last_turn;
  try {
    if (page.app.step()) return;
    page.app.end();
    EM_ASM({ say("Mesecina has ended. Reload the page to start it again."); });
  } catch (const std::exception& error) {
    EM_ASM({ say("Mesecina has stopped: " + UTF8ToString($0)); }, error.what());
  }
  the_page = nullptr;
  emscripten_cancel_main_loop();
}

}  // namespace

extern "C" {

/// Called when the page is hidden or closed.
EMSCRIPTEN_KEEPALIVE void mes_keep() {
  if (the_page != nullptr) the_page->app.keep();
}

/// Whether two fingers scroll a panel there or move the drawing.
EMSCRIPTEN_KEEPALIVE bool mes_is_on_panel(double x, double y) {
  return the_page != nullptr && the_page->app.is_on_panel({x, y});
}
}

int run_window(const Registry& registry, const WindowOptions& options) {
  constexpr int kNoDisplay = 4;
  LoadedSettings loaded = load_settings(default_settings_path());
  // Settings outlive the page, and the files that were opened do not.
  std::erase_if(loaded.settings.recent_files, [](const std::string& file) { return !std::filesystem::exists(file); });
  auto window = GlfwWindow::create({.title = "Mesecina",
                                    .width = EM_ASM_INT({ return window.innerWidth; }),
                                    .height = EM_ASM_INT({ return window.innerHeight; })});
  if (!window) {
    std::fprintf(stderr, "mesecina: %s\n", window.error().message().c_str());
    return kNoDisplay;
  }
  the_page = new Page{App(registry, std::move(*window), options, std::move(loaded))};
  emscripten_set_main_loop_arg(follow, the_page, 0, false);
  return 0;
}

}  // namespace mes
