// SPDX-License-Identifier: GPL-3.0-or-later
#include "interrupts.h"

#include <pybind11/pybind11.h>

#include <atomic>

namespace mes_python {
namespace {

std::atomic<mesecina::Job*> interrupted{nullptr};
static_assert(std::atomic<mesecina::Job*>::is_always_lock_free);
// Of before. Only the main thread changes it, while the handler is not installed.
struct sigaction before;

void stop_and_hand_on(int number, siginfo_t* info, void* context) {
  if (mesecina::Job* const job = interrupted.load()) job->stop();
  if ((before.sa_flags & SA_SIGINFO) != 0)
    before.sa_sigaction(number, info, context);
  else
    before.sa_handler(number);
}

bool is_main_thread() {
  static const unsigned long main =
      pybind11::module_::import("threading").attr("main_thread")().attr("ident").cast<unsigned long>();
  return PyThread_get_thread_ident() == main;
}

}  // namespace

StopsAtInterrupt::StopsAtInterrupt(mesecina::Job& job) {
  if (interrupted.load() != nullptr || !is_main_thread()) return;
  if (sigaction(SIGINT, nullptr, &before) != 0) return;
  const bool has_handler =
      (before.sa_flags & SA_SIGINFO) != 0 || (before.sa_handler != SIG_DFL && before.sa_handler != SIG_IGN);
  if (!has_handler) return;
  interrupted = &job;
  struct sigaction own = before;
  own.sa_flags |= SA_SIGINFO;
  own.sa_sigaction = stop_and_hand_on;
  is_installed_ = sigaction(SIGINT, &own, nullptr) == 0;
  if (!is_installed_) interrupted = nullptr;
}

StopsAtInterrupt::~StopsAtInterrupt() {
  if (!is_installed_) return;
  sigaction(SIGINT, &before, nullptr);
  interrupted = nullptr;
}

}  // namespace mes_python
