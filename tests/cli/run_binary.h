// SPDX-License-Identifier: GPL-3.0-or-later
// Runs the program under test as a child process and keeps what it says.
#pragma once

#include <sys/types.h>

#include <functional>
#include <string>
#include <vector>

namespace mes::test {

struct RunResult {
  int exit_code = -1;  ///< minus the signal's number when one killed it
  std::string out;
  std::string err;
};

struct RunOptions {
  std::string program{};                   ///< another one than the program under test; on the PATH, if it has no /
  std::string folder{};                    ///< where it runs; empty: here
  std::string input{};                     ///< standard input
  bool keep_input_open = false;            ///< it does not end
  std::vector<std::string> environment{};  ///< NAME=VALUE to set
  std::string out_path{};                  ///< standard output goes to this device instead of into the result
  int interrupt_with = 0;           ///< signal to send once the program watches for it, if it can be watched for,
  unsigned interrupt_after_ms = 0;  ///< and this time has passed,
  std::function<bool()> interrupt_when{};  ///< and this is true
  /// Called when the program has begun to complain. What it writes after about 128 KiB waits for the return.
  std::function<void()> at_first_error{};
  unsigned long address_space_mib = 0;  ///< limit; 0 = none
};

RunResult run(const std::vector<std::string>& arguments, const RunOptions& options = {});

}  // namespace mes::test
