// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/system/termination.h"

#include <utility>

namespace mes {

Termination::Termination(std::function<void()> wake)
    : wake_(std::move(wake)), watch_([this](int signal) { hear(signal); }) {}

void Termination::hear(int signal) {
  signal_ = signal;
  wake_();
}

}  // namespace mes
