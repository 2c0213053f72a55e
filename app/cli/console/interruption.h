// SPDX-License-Identifier: GPL-3.0-or-later
// On Ctrl-C and similar signals, ends the program at once without leaving half-written files.
#pragma once

#include <mutex>

#include "app/system/signal_watch.h"

namespace mes::cli {

/// While it lives, SIGINT, SIGTERM and SIGHUP end the process immediately with exit code 130 (143, 129). A function
/// running in `uninterrupted` is finished first if that takes less than the patience of `SignalWatch`. Signals that
/// are ignored when the object is made stay ignored.
///
/// Make it before any other thread is started, since threads inherit the mask that leaves these signals to it.
class Interruption {
 public:
  Interruption() : watch_([this](int signal) { end(signal); }) {}

  template <class Work>
  auto uninterrupted(Work work) {
    const std::lock_guard lock(mutex_);
    return work();
  }

 private:
  [[noreturn]] void end(int signal);

  std::mutex mutex_;
  SignalWatch watch_;
};

}  // namespace mes::cli
