// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/interruption.h"

#include <unistd.h>

#include <string_view>

namespace mes::cli {

void Interruption::end(int signal) {
  const std::lock_guard lock(mutex_);
  if (::isatty(STDERR_FILENO) != 0) {
    // A progress line may stand there.
    constexpr std::string_view kEndOfLine = "\r\x1b[K";
    static_cast<void>(!::write(STDERR_FILENO, kEndOfLine.data(), kEndOfLine.size()));
  }
  // No destructors: other threads are in the middle of their work, and nothing is open that could be left in pieces.
  ::_exit(128 + signal);
}

}  // namespace mes::cli
