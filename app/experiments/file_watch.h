// SPDX-License-Identifier: GPL-3.0-or-later
// Reports which of some files have been written.
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

/// Looks at times and sizes 25 times a second, on a thread that exists only while there are files. A file that is
/// missing for a moment, as while an editor replaces it, counts as changed once it is back.
///
/// Threads: one; `wake` is called from another.
class FileWatch {
 public:
  explicit FileWatch(std::function<void()> wake) : wake_(std::move(wake)) {}

  /// Watches these files from now on. Files that it watched before are compared with their former state.
  void watch(std::vector<std::filesystem::path> files);
  /// The files that have changed since the last call.
  std::vector<std::filesystem::path> take_changed();

 private:
  using Stamp = std::pair<std::int64_t, std::uintmax_t>;
  void look(const std::stop_token& stop);

  std::function<void()> wake_;
  std::mutex mutex_;
  std::condition_variable_any ends_;
  std::map<std::filesystem::path, Stamp> stamps_;
  std::vector<std::filesystem::path> changed_;
  std::jthread thread_;  // last: it uses all members above
};

}  // namespace mes
