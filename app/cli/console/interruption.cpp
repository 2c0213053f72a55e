// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/console/interruption.h"

#include <poll.h>
#include <unistd.h>

#include <string_view>

#include "app/system/process_end.h"

namespace mes::cli {

void Interruption::end(int signal) {
  const std::lock_guard lock(mutex_);
  // Erases a progress line, unless the terminal is stopped, e.g. by Ctrl-S, and would block.
  pollfd terminal{STDERR_FILENO, POLLOUT, 0};
  if (::isatty(STDERR_FILENO) != 0 && ::poll(&terminal, 1, 0) == 1 && (terminal.revents & POLLOUT) != 0) {
    constexpr std::string_view kEndOfLine = "\r\x1b[K";
    static_cast<void>(!::write(STDERR_FILENO, kEndOfLine.data(), kEndOfLine.size()));
  }
  end_process(128 + signal);
}

}  // namespace mes::cli
