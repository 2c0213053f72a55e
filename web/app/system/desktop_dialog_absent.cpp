// SPDX-License-Identifier: GPL-3.0-or-later
// The files of the user lie in the folder /files of the page. A file to open is chosen in the dialog of the browser and
// copied there. A file that appears there is handed to the browser as a download (web/page/page.js).
#include <emscripten/em_js.h>
#include <emscripten/proxying.h>
#include <emscripten/threading.h>

#include <array>
#include <chrono>
#include <filesystem>
#include <functional>
#include <string>
#include <thread>

#include "app/system/desktop_dialog.h"

namespace mes {
namespace {

namespace fs = std::filesystem;

// 0: not answered yet, 1: a file has been copied, 2: cancelled.
EM_JS(void, mes_ask_file, (const char* extensions), { askFile(UTF8ToString(extensions)); });
EM_JS(int, mes_answer_file, (char* name, int size), { return answerFile(name, size); });

std::string extensions_of(const DesktopQuestion& question) {
  std::string out;
  if (question.filters.empty()) return out;
  for (const std::string& pattern : question.filters.front().patterns)
    if (pattern.starts_with("*.")) out += (out.empty() ? "" : ",") + pattern.substr(1);
  return out;
}

}  // namespace

bool may_have_desktop_dialog() {
  return true;
}

DesktopAnswer ask_desktop(const DesktopQuestion& question, const std::stop_token& stop) {
  const fs::path folder = "/files";
  if (question.is_saving)
    return {.kind = DesktopAnswer::Kind::chosen,
            .file = folder / (question.name.empty() ? "mesecina" : question.name)};
  const auto of_page = [](const std::function<void()>& call) {
    emscripten::ProxyingQueue queue;
    queue.proxySync(emscripten_main_runtime_thread_id(), call);
  };
  of_page([&] { mes_ask_file(extensions_of(question).c_str()); });
  std::array<char, 512> name{};
  for (;;) {
    int answer = 0;
    of_page([&] { answer = mes_answer_file(name.data(), static_cast<int>(name.size())); });
    if (answer == 1) return {.kind = DesktopAnswer::Kind::chosen, .file = folder / name.data()};
    if (answer == 2 || stop.stop_requested()) return {.kind = DesktopAnswer::Kind::cancelled};
    constexpr auto kBetweenLooks = std::chrono::milliseconds(50);
    std::this_thread::sleep_for(kBetweenLooks);
  }
}

}  // namespace mes
