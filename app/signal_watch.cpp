// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/signal_watch.h"

#include <pthread.h>

#include <utility>

namespace mes {

SignalWatch::SignalWatch(std::function<void(int)> heard) : heard_(std::move(heard)) {
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

SignalWatch::~SignalWatch() {
  is_over_ = true;
  ::pthread_kill(thread_.native_handle(), SIGUSR1);
  thread_.join();
  ::pthread_sigmask(SIG_SETMASK, &mask_before_, nullptr);
}

void SignalWatch::watch() {
  for (;;) {
    int signal = 0;
    if (::sigwait(&signals_, &signal) != 0) continue;
    if (is_over_) return;
    if (signal != SIGUSR1) heard_(signal);
  }
}

}  // namespace mes
