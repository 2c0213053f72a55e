// SPDX-License-Identifier: GPL-3.0-or-later
// Another program that works for this one and does not outlive it. No other file starts programs. (Computations in a
// copy of this process are in core/base/jobs/isolated.h.)
#pragma once

#include <sys/types.h>

#include <chrono>
#include <cstdio>
#include <filesystem>
#include <stop_token>
#include <string>
#include <vector>

namespace mes {

/// A program that runs in its own folder, with its errors in a file without a name, nothing to read, and default
/// signal actions. Threads: one at a time.
class ChildProcess {
 public:
  ChildProcess() = default;
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Starts the program, which is looked up on the PATH. Returns 0 or errno.
  int start(const std::vector<std::string>& words, const std::filesystem::path& folder);
  /// Waits, and returns whether the program ended well. A requested stop asks it to end; it is killed if it does not,
  /// or when the time is over.
  bool wait(const std::stop_token& stop, std::chrono::steady_clock::time_point until = kNoEnd);
  /// The signal that killed it, or 0.
  int signal() const { return signal_; }
  /// The last printable line of its error output.
  std::string complaint();
  /// All of its error output.
  std::string complaints();

 private:
  static constexpr auto kNoEnd = std::chrono::steady_clock::time_point::max();
  pid_t pid_ = -1;
  int signal_ = 0;
  std::FILE* errors_ = nullptr;
};

/// Whether `ChildProcess` finds a program of this name.
bool is_program_on_path(const std::string& name);

/// For a process that ends without destructors: kills its children and waits for their end, as far as the time
/// allows. No child can be started afterwards.
void kill_children(std::chrono::steady_clock::time_point until);

}  // namespace mes
