// SPDX-License-Identifier: GPL-3.0-or-later
// SIGINT, SIGTERM and SIGHUP ask the window to end in order.
#pragma once

#include <atomic>
#include <functional>

#include "app/system/signal_watch.h"

namespace mes {

/// What it guarantees: the first such signal is noted and `wake` is called. The second ends the process at once, and
/// so does the end of the patience of `SignalWatch`, with exit code 128 + signal: what is unsaved by then is in the
/// journal. Signals that are ignored when it is made stay ignored.
///
/// Make it before any other thread is started: they inherit that these signals are left to it.
class Termination {
 public:
  explicit Termination(std::function<void()> wake);

  /// The signal that asked for it, or 0.
  int signal() const { return signal_; }

 private:
  void hear(int signal);

  std::function<void()> wake_;
  std::atomic<int> signal_ = 0;
  SignalWatch watch_;
};

}  // namespace mes
