// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/experiments/file_watch.h"

#include <algorithm>
#include <chrono>
#include <optional>
#include <system_error>
#include <utility>

namespace mes {
namespace {

namespace fs = std::filesystem;

constexpr auto kInterval = std::chrono::milliseconds(40);

std::optional<std::pair<std::int64_t, std::uintmax_t>> stamp_of(const fs::path& file) {
  std::error_code error;
  const auto time = fs::last_write_time(file, error);
  if (error) return {};
  const std::uintmax_t size = fs::file_size(file, error);
  if (error) return {};
  return std::pair{static_cast<std::int64_t>(time.time_since_epoch().count()), size};
}

}  // namespace

void FileWatch::watch(std::vector<fs::path> files) {
  const bool is_empty = files.empty();
  {
    const std::lock_guard lock(mutex_);
    std::map<fs::path, Stamp> stamps;
    for (fs::path& file : files) {
      const auto known = stamps_.find(file);
      const Stamp stamp = known != stamps_.end() ? known->second : stamp_of(file).value_or(Stamp());
      stamps.emplace(std::move(file), stamp);
    }
    stamps_ = std::move(stamps);
  }
  if (is_empty)
    thread_ = {};
  else if (!thread_.joinable())
    thread_ = std::jthread([this](const std::stop_token& stop) { look(stop); });
}

std::vector<fs::path> FileWatch::take_changed() {
  const std::lock_guard lock(mutex_);
  return std::exchange(changed_, {});
}

void FileWatch::look(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (!ends_.wait_for(lock, stop, kInterval, [] { return false; }) && !stop.stop_requested()) {
    std::vector<fs::path> files;
    for (const auto& [file, stamp] : stamps_) files.push_back(file);
    // Unlocked, so that a file system that does not answer blocks only this thread.
    lock.unlock();
    std::vector<std::pair<fs::path, Stamp>> found;
    for (const fs::path& file : files)
      if (const auto stamp = stamp_of(file)) found.emplace_back(file, *stamp);
    lock.lock();
    bool has_news = false;
    for (const auto& [file, stamp] : found) {
      const auto known = stamps_.find(file);
      if (known == stamps_.end() || known->second == stamp) continue;
      known->second = stamp;
      if (std::ranges::find(changed_, file) == changed_.end()) changed_.push_back(file);
      has_news = true;
    }
    if (has_news && wake_) wake_();
  }
}

}  // namespace mes
