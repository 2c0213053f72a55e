// SPDX-License-Identifier: GPL-3.0-or-later
// Ctrl-C stops the computation that goes on.
#pragma once

#include <csignal>

#include <mesecina/workbench.h>

namespace mes_python {

/// While it lives, SIGINT stops a job and is then handled as before, so that Python raises `KeyboardInterrupt`
/// afterwards. It does nothing on other threads than the main one of Python, where no such exception is raised, and
/// where SIGINT has no handler. Within a structure of Python another session may compute: Ctrl-C then stops both.
///
/// Cost: two system calls.
class StopsAtInterrupt {
 public:
  /// The calling thread holds the interpreter lock.
  explicit StopsAtInterrupt(mesecina::Job& job);
  ~StopsAtInterrupt();
  StopsAtInterrupt(const StopsAtInterrupt&) = delete;
  StopsAtInterrupt& operator=(const StopsAtInterrupt&) = delete;

  /// Stops the job and those of the calls around it. A signal handler may call this.
  void stop_all() const noexcept;

 private:
  mesecina::Job& job_;
  const StopsAtInterrupt* outer_ = nullptr;  ///< the call within which this one is made
  bool is_listed_ = false;
};

/// Is this the thread on which Python handles signals? The first call imports a module.
bool is_main_thread();

}  // namespace mes_python
