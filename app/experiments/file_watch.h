// SPDX-License-Identifier: GPL-3.0-or-later
// Says which of some files have been written.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <mutex>
#include <thread>
#include <vector>

namespace mes {

/// Looks at times and sizes 25 times a second, on a thread that there is only while there are files. A file that is away
/// for a moment, as while an editor replaces it, has changed once it is there again.
///
/// Threads: one; `wake` is called from another.
class FileWatch {
 public:
  explicit FileWatch(std::function<void()> wake) : wake_(std::move(wake)) {}

  /// Looks at these files from now on. Those that it looked at before are compared with what they were.
  void watch(std::vector<std::filesystem::path> files);
  /// Files that have changed since the last call.
  std::vector<std::filesystem::path> take_changed();

 private:
  using Stamp = std::pair<std::int64_t, std::uintmax_t>;
  void look(const std::stop_token& stop);

  std::function<void()> wake_;
  std::mutex mutex_;
  std::condition_variable_any ends_;
  std::map<std::filesystem::path, Stamp> stamps_;
  std::vector<std::filesystem::path> changed_;
  std::jthread thread_;  // last: it uses all of the above
};

}  // namespace mes
