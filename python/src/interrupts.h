// SPDX-License-Identifier: GPL-3.0-or-later
// Ctrl-C stops what goes on.
#pragma once

#include <csignal>

#include <mesecina/workbench.h>

namespace mes_python {

/// While it lives, SIGINT stops a job and is then handled as before, so that Python raises `KeyboardInterrupt`
/// afterwards. It does nothing on other threads than the main one of Python, where no such exception is raised, and
/// where SIGINT has no handler.
///
/// Cost: two system calls.
class StopsAtInterrupt {
 public:
  /// The calling thread holds the interpreter lock.
  explicit StopsAtInterrupt(mesecina::Job& job);
  ~StopsAtInterrupt();
  StopsAtInterrupt(const StopsAtInterrupt&) = delete;
  StopsAtInterrupt& operator=(const StopsAtInterrupt&) = delete;

 private:
  bool is_installed_ = false;
};

}  // namespace mes_python
