// SPDX-License-Identifier: GPL-3.0-or-later
// Ctrl-C and its kin: end at once, with nothing half written.
#pragma once

#include <csignal>
#include <mutex>
#include <thread>

namespace mes::cli {

/// While it lives, SIGINT, SIGTERM and SIGHUP end the process immediately with exit code 130 (143, 129), except that
/// what runs in `uninterrupted` is finished first. Signals that are ignored when it is made stay ignored.
///
/// Make it before any other thread is started: they inherit that these signals are left to it.
class Interruption {
 public:
  Interruption();
  ~Interruption();
  Interruption(const Interruption&) = delete;
  Interruption& operator=(const Interruption&) = delete;

  template <class Work>
  auto uninterrupted(Work work) {
    const std::lock_guard lock(mutex_);
    return work();
  }

 private:
  void watch();

  sigset_t signals_{};
  sigset_t mask_before_{};
  std::mutex mutex_;
  bool finished_ = false;
  std::thread thread_;
};

}  // namespace mes::cli
