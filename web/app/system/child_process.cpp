// SPDX-License-Identifier: GPL-3.0-or-later
// A page starts no programs.
#include "app/system/child_process.h"

#include <cerrno>

namespace mes {

ChildProcess::~ChildProcess() = default;

int ChildProcess::start(const std::vector<std::string>& /*words*/, const std::filesystem::path& /*folder*/) {
  return ENOSYS;
}

bool ChildProcess::wait(const std::stop_token& /*stop*/, std::chrono::steady_clock::time_point /*until*/) {
  return false;
}

std::string ChildProcess::complaint() {
  return {};
}

std::string ChildProcess::complaints() {
  return {};
}

bool is_program_on_path(const std::string& /*name*/) {
  return false;
}

void kill_children(std::chrono::steady_clock::time_point /*until*/) {}

}  // namespace mes
