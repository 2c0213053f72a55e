// SPDX-License-Identifier: GPL-3.0-or-later
// No signal reaches a page.
#include "app/system/signal_watch.h"

namespace mes {

std::chrono::milliseconds SignalWatch::usual_patience() {
  return kPatience;
}

SignalWatch::SignalWatch(std::function<void(int)> heard, std::chrono::milliseconds patience)
    : heard_(std::move(heard)), patience_(patience) {}

SignalWatch::~SignalWatch() = default;

}  // namespace mes
