// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/window/termination.h"

#include <unistd.h>

#include <utility>

namespace mes {

Termination::Termination(std::function<void()> wake)
    : wake_(std::move(wake)), watch_([this](int signal) { hear(signal); }) {}

void Termination::hear(int signal) {
  if (signal_ != 0) ::_exit(128 + signal);
  signal_ = signal;
  wake_();
}

}  // namespace mes
