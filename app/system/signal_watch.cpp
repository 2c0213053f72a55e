// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/system/signal_watch.h"

#include <pthread.h>

#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <system_error>
#include <utility>

#include "app/system/process_end.h"

namespace mes {

std::chrono::milliseconds SignalWatch::usual_patience() {
  const char* const said = std::getenv("MESECINA_PATIENCE");
  const int milliseconds = said == nullptr ? 0 : std::atoi(said);
  return milliseconds > 0 ? std::chrono::milliseconds(milliseconds) : kPatience;
}

SignalWatch::SignalWatch(std::function<void(int)> heard, std::chrono::milliseconds patience)
    : heard_(std::move(heard)), patience_(patience) {
  sigemptyset(&signals_);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    struct sigaction present {};
    if (::sigaction(signal, nullptr, &present) == 0 && present.sa_handler != SIG_IGN) sigaddset(&signals_, signal);
  }
  // The destructor ends the watcher with SIGUSR1, whatever signals are ignored.
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

int SignalWatch::wait_until(Clock::time_point end) const {
  constexpr std::chrono::nanoseconds kLongest = std::chrono::hours(1);
  for (;;) {
    const auto rest = std::clamp<std::chrono::nanoseconds>(end - Clock::now(), std::chrono::nanoseconds(0), kLongest);
    const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(rest);
    const timespec time{seconds.count(), (rest - seconds).count()};
    const int signal = ::sigtimedwait(&signals_, nullptr, &time);
    // A SIGUSR1 from another process means nothing here.
    if (signal > 0 && (signal != SIGUSR1 || is_over_)) return signal;
    if (Clock::now() >= end) return 0;
  }
}

void SignalWatch::watch() {
  const int first = wait_until(Clock::time_point::max());
  if (is_over_) return;
  // Runs on its own thread, since it may wait for something the program holds: a lock, or a display that does not
  // answer.
  std::thread call;
  try {
    call = std::thread([this, first] { heard_(first); });
  } catch (const std::system_error&) {
    end_process(128 + first);
  }
  const int second = wait_until(Clock::now() + patience_);
  if (!is_over_) end_process(128 + (second == 0 ? first : second));
  call.join();
}

}  // namespace mes
