// SPDX-License-Identifier: GPL-3.0-or-later
#include "interrupts.h"

#include <pybind11/pybind11.h>

#include <atomic>

namespace mes_python {
namespace {

// The innermost call on the main thread that Ctrl-C can stop.
std::atomic<const StopsAtInterrupt*> innermost{nullptr};
static_assert(std::atomic<const StopsAtInterrupt*>::is_always_lock_free);
// The previous handler. Only the main thread changes it, while our handler is not installed.
struct sigaction before;

void stop_and_hand_on(int number, siginfo_t* info, void* context) {
  if (const StopsAtInterrupt* const call = innermost.load()) call->stop_all();
  if ((before.sa_flags & SA_SIGINFO) != 0)
    before.sa_sigaction(number, info, context);
  else
    before.sa_handler(number);
}

}  // namespace

bool is_main_thread() {
  static const unsigned long main =
      pybind11::module_::import("threading").attr("main_thread")().attr("ident").cast<unsigned long>();
  return PyThread_get_thread_ident() == main;
}

StopsAtInterrupt::StopsAtInterrupt(mesecina::Job& job) : job_(job) {
  if (!is_main_thread()) return;
  outer_ = innermost.load();
  if (outer_ == nullptr) {
    if (sigaction(SIGINT, nullptr, &before) != 0) return;
    const bool has_handler =
        (before.sa_flags & SA_SIGINFO) != 0 || (before.sa_handler != SIG_DFL && before.sa_handler != SIG_IGN);
    if (!has_handler) return;
  }
  innermost = this;
  is_listed_ = true;
  if (outer_ != nullptr) return;
  struct sigaction own = before;
  own.sa_flags |= SA_SIGINFO;
  own.sa_sigaction = stop_and_hand_on;
  if (sigaction(SIGINT, &own, nullptr) == 0) return;
  innermost = nullptr;
  is_listed_ = false;
}

StopsAtInterrupt::~StopsAtInterrupt() {
  if (!is_listed_) return;
  if (outer_ == nullptr) sigaction(SIGINT, &before, nullptr);
  innermost = outer_;
}

void StopsAtInterrupt::stop_all() const noexcept {
  for (const StopsAtInterrupt* one = this; one != nullptr; one = one->outer_) one->job_.stop();
}

}  // namespace mes_python
