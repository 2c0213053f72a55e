// SPDX-License-Identifier: GPL-3.0-or-later
// On SIGINT, SIGTERM or SIGHUP, asks the window to end in order.
#pragma once

#include <atomic>
#include <functional>

#include "app/system/signal_watch.h"

namespace mes {

/// Guarantees: the first such signal is noted and `wake` is called. The second signal, or the end of the patience of
/// `SignalWatch`, ends the process at once with exit code 128 + signal; the journal then holds the unsaved changes.
/// Signals that are ignored when the object is made stay ignored.
///
/// Make it before any other thread is started, since threads inherit the mask that leaves these signals to it.
class Termination {
 public:
  explicit Termination(std::function<void()> wake);

  /// The signal that asked the window to end, or 0.
  int signal() const { return signal_; }

 private:
  void hear(int signal);

  std::function<void()> wake_;
  std::atomic<int> signal_ = 0;
  SignalWatch watch_;
};

}  // namespace mes
