// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/experiments/crash_line.h"

#include <unistd.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <csignal>
#include <cstddef>
#include <string_view>

namespace mes {
namespace {

// The handler may not allocate, so it reads a static text. There are two, so that one is whole while the other is
// written.
constexpr std::size_t kMostBytes = 1000;
std::array<std::array<char, kMostBytes>, 2> texts{};
std::atomic<std::size_t> present{0};

std::string_view name_of(int signal) {
  switch (signal) {
    case SIGSEGV: return "Segmentation fault";
    case SIGBUS: return "Bus error";
    case SIGFPE: return "Floating point exception";
    case SIGILL: return "Illegal instruction";
    default: return "Aborted";
  }
}

void print(std::string_view text) {
  static_cast<void>(!::write(STDERR_FILENO, text.data(), text.size()));
}

// SA_RESETHAND has restored the default action; the raised signal ends the process.
void handle(int signal) {
  const char* const text = texts[present.load()].data();
  if (text[0] != '\0') {
    print("mesecina: crashed (");
    print(name_of(signal));
    print(") with ");
    print(text);
    print("\n");
  }
  ::raise(signal);
}

}  // namespace

void say_at_crash(const std::string& text) {
  const std::size_t next = 1 - present.load();
  const std::size_t size = std::min(text.size(), kMostBytes - 1);
  std::copy_n(text.begin(), size, texts[next].begin());
  texts[next][size] = '\0';
  present = next;
  struct sigaction action {};
  action.sa_handler = handle;
  action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_NODEFER;
  ::sigemptyset(&action.sa_mask);
  for (const int signal : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT}) ::sigaction(signal, &action, nullptr);
}

}  // namespace mes
