// SPDX-License-Identifier: GPL-3.0-or-later
// Releases and acquires the interpreter lock.
#pragma once

#include <Python.h>
#include <cxxabi.h>
#include <unistd.h>

namespace mes_python {

/// Calls a function of Python that may acquire the interpreter lock.
///
/// When the interpreter ends while other threads are at work, Python unwinds the stack of each thread that acquires the
/// lock. Destructors on that stack would then touch objects without the lock. So the thread blocks here until the
/// process has ended, like threads of Python itself from 3.14 on.
template <class Work>
auto may_take_lock(Work work) {
  try {
    return work();
  } catch (abi::__forced_unwind&) {
    for (;;) pause();
  }
}

/// Releases the lock while it lives.
class Unlocked {
 public:
  Unlocked() : thread_(PyEval_SaveThread()) {}
  ~Unlocked() {
    may_take_lock([this] { PyEval_RestoreThread(thread_); });
  }
  Unlocked(const Unlocked&) = delete;
  Unlocked& operator=(const Unlocked&) = delete;

 private:
  PyThreadState* thread_;
};

/// Holds the lock while it lives, on any thread. Does nothing if the thread already holds the lock.
class Locked {
 public:
  Locked() : state_(may_take_lock([] { return PyGILState_Ensure(); })) {}
  ~Locked() { PyGILState_Release(state_); }
  Locked(const Locked&) = delete;
  Locked& operator=(const Locked&) = delete;

 private:
  PyGILState_STATE state_;
};

}  // namespace mes_python
