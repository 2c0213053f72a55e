// SPDX-License-Identifier: GPL-3.0-or-later
// Whole files into memory, without waiting for what never comes.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>

#include "core/base/error.h"
#include "core/base/job_control.h"

namespace mes {

/// Devices and pipes may have no end.
inline constexpr std::uint64_t kMostBytesRead = std::uint64_t{4} << 30U;

struct ReadOptions {
  /// Asked now and then with what was read so far; true ends the reading as if the file ended there.
  std::function<bool(std::string_view)> is_enough{};
  /// Error `cancelled`, a moment after it is stopped, also while a pipe is waited for; null: it is not.
  JobControl* job = nullptr;
  double share = 0.0;  ///< of the progress of the job: what reading a regular file to its end is
  std::uint64_t most_bytes = kMostBytesRead;  ///< more is an error
};

/// A file, a pipe or a device, read to its end; a pipe is waited for. Error: `bad_input`, `out_of_memory`,
/// `cancelled`.
Expected<std::string> read_whole(const std::filesystem::path& path, const ReadOptions& options = {});
/// The same from an open descriptor, which stays open. `name` stands for it in messages.
Expected<std::string> read_whole(int descriptor, const std::string& name, const ReadOptions& options = {});
/// Nothing but a regular file, links followed: whatever else has the name is an error, and is not even opened.
Expected<std::string> read_regular_file(const std::filesystem::path& path, const ReadOptions& options = {});

}  // namespace mes
