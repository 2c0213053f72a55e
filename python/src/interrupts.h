// SPDX-License-Identifier: GPL-3.0-or-later
// Lets Ctrl-C stop a running computation.
#pragma once

#include <csignal>

#include <mesecina/workbench.h>

namespace mes_python {

/// While it lives, SIGINT stops a job and then runs the previous handler, so that Python raises `KeyboardInterrupt`
/// afterwards. Does nothing on threads other than Python's main thread, where no such exception is raised, and if
/// SIGINT has no handler. If a Python structure computes another session inside, Ctrl-C stops both.
///
/// Cost: two system calls.
class StopsAtInterrupt {
 public:
  /// The calling thread holds the interpreter lock.
  explicit StopsAtInterrupt(mesecina::Job& job);
  ~StopsAtInterrupt();
  StopsAtInterrupt(const StopsAtInterrupt&) = delete;
  StopsAtInterrupt& operator=(const StopsAtInterrupt&) = delete;

  /// Stops the job and those of the enclosing calls. A signal handler may call this.
  void stop_all() const noexcept;

 private:
  mesecina::Job& job_;
  const StopsAtInterrupt* outer_ = nullptr;  ///< the enclosing call
  bool is_listed_ = false;
};

/// Whether this is the thread on which Python handles signals. The first call imports a module.
bool is_main_thread();

}  // namespace mes_python
