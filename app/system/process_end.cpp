// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/system/process_end.h"

#include <unistd.h>

#include <chrono>

#include "app/system/child_process.h"
#include "core/io/files/temporary.h"

namespace mes {

void end_process(int code) {
  using namespace std::chrono_literals;
  const auto now = std::chrono::steady_clock::now();
  kill_children(now + 100ms);
  remove_own_temporaries(now + 250ms);
  ::_exit(code);
}

}  // namespace mes
