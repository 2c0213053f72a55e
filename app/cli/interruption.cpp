// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/interruption.h"

#include <pthread.h>
#include <unistd.h>

#include <string_view>

namespace mes::cli {

Interruption::Interruption() {
  sigemptyset(&signals_);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction present {};
    if (::sigaction(signal, nullptr, &present) == 0 && present.sa_handler != SIG_IGN) sigaddset(&signals_, signal);
  }
  // How the destructor ends the watcher, whatever else is ignored.
  sigaddset(&signals_, SIGUSR1);
  ::pthread_sigmask(SIG_BLOCK, &signals_, &mask_before_);
  thread_ = std::thread([this] { watch(); });
}

Interruption::~Interruption() {
  {
    const std::lock_guard lock(mutex_);
    finished_ = true;
  }
  ::pthread_kill(thread_.native_handle(), SIGUSR1);
  thread_.join();
  ::pthread_sigmask(SIG_SETMASK, &mask_before_, nullptr);
}

void Interruption::watch() {
  for (;;) {
    int signal = 0;
    if (::sigwait(&signals_, &signal) != 0) continue;
    const std::lock_guard lock(mutex_);
    if (finished_) return;
    if (signal == SIGUSR1) continue;
    if (::isatty(STDERR_FILENO) != 0) {
      // A progress line may stand there.
      constexpr std::string_view kEndOfLine = "\r\x1b[K";
      static_cast<void>(!::write(STDERR_FILENO, kEndOfLine.data(), kEndOfLine.size()));
    }
    // No destructors: other threads are in the middle of their work, and nothing is open that could be left in
    // pieces.
    ::_exit(128 + signal);
  }
}

}  // namespace mes::cli
