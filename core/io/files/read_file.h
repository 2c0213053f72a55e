// SPDX-License-Identifier: GPL-3.0-or-later
// Reads whole files into memory, without blocking forever.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "core/base/error.h"
#include "core/base/jobs/job_control.h"

namespace mes {

/// Devices and pipes may be endless.
inline constexpr std::uint64_t kMostBytesRead = std::uint64_t{4} << 30U;

struct ReadOptions {
  /// Called now and then with the bytes read so far; true ends the reading as if the file ended there.
  std::function<bool(std::string_view)> is_enough{};
  /// Error `cancelled` soon after it is stopped, also while waiting for a pipe; null: never stopped.
  JobControl* job = nullptr;
  double share = 0.0;  ///< share of the job's progress that reading a regular file to its end makes up
  std::uint64_t most_bytes = kMostBytesRead;  ///< more is an error
};

/// Reads a file, a pipe or a device to its end; waits for a pipe. Error: `bad_input`, `out_of_memory`, `cancelled`.
Expected<std::string> read_whole(const std::filesystem::path& path, const ReadOptions& options = {});
/// The same for an open descriptor, which stays open. `name` stands for it in messages.
Expected<std::string> read_whole(int descriptor, const std::string& name, const ReadOptions& options = {});
/// Reads only a regular file, links followed: anything else is an error, and is not even opened.
Expected<std::string> read_regular_file(const std::filesystem::path& path, const ReadOptions& options = {});

}  // namespace mes
