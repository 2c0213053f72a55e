// SPDX-License-Identifier: GPL-3.0-or-later
// Several windows, each a process of its own, write the same small files at the same moment.
#include <fcntl.h>
#include <fmt/core.h>
#include <sys/file.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <catch2/catch.hpp>
#include <functional>
#include <set>

#include "app/settings/settings_file.h"
#include "app/store/looks/bundles.h"
#include "core/io/files/file_lock.h"
#include "tests/io/temporary_folder.h"
#include "tests/support/builtin_layers.h"

using namespace mes;
using mes::test::TemporaryFolder;

namespace {

/// Runs it in as many processes, which wait for each other before they begin. True if each of them returned true.
bool all_at_once(int count, const std::function<bool(int)>& run) {
  std::array<int, 2> start{};
  REQUIRE(pipe(start.data()) == 0);
  std::vector<pid_t> children;
  for (int i = 0; i < count; ++i) {
    const pid_t child = fork();
    REQUIRE(child >= 0);
    if (child == 0) {
      close(start[1]);
      char none = 0;
      const bool is_open = read(start[0], &none, 1) == 0;  // when the other end is closed
      _exit(is_open && run(i) ? 0 : 1);
    }
    children.push_back(child);
  }
  close(start[0]);
  close(start[1]);
  bool all_good = true;
  for (const pid_t child : children) {
    int status = 0;
    waitpid(child, &status, 0);
    all_good = all_good && WIFEXITED(status) && WEXITSTATUS(status) == 0;
  }
  return all_good;
}

}  // namespace

TEST_CASE("windows that save bundles at the same moment lose none of them") {
  const TemporaryFolder folder;
  const auto file = folder / "data/bundles.json";
  constexpr int kWindows = 12;
  constexpr int kEach = 8;
  const auto name = [](int window, int i) { return fmt::format("{} of window {}", i, window); };
  CHECK(all_at_once(kWindows, [&](int window) {
    BundleStore store(layer_descriptors(), file);
    BundleList list(store.load({}).bundles);
    for (int i = 0; i < kEach; ++i) {
      if (!list.save(name(window, i), {})) return false;
      auto written = store.write(list.bundles());
      if (!written || !written->message.empty()) return false;
      list.replace(std::move(written->bundles));
    }
    return true;
  }));
  std::set<std::string> found;
  for (const Bundle& bundle : BundleStore(layer_descriptors(), file).load({}).bundles) found.insert(bundle.name);
  CHECK(found.size() == kWindows * kEach);
  for (int window = 0; window < kWindows; ++window)
    for (int i = 0; i < kEach; ++i) CHECK(found.contains(name(window, i)));
}

TEST_CASE("windows that end at the same moment keep the recent files of each other") {
  const TemporaryFolder folder;
  const auto file = folder / "config/settings.json";
  constexpr int kWindows = 12;
  static_assert(kWindows <= kRecentFiles);
  CHECK(all_at_once(kWindows, [&](int window) {
    SettingsFile settings(file, {});
    settings.settings().recent_files = {fmt::format("/{}.poff", window)};
    return settings.save().has_value();
  }));
  std::vector<std::string> found = load_settings(file).settings.recent_files;
  std::ranges::sort(found);
  std::vector<std::string> expected;
  for (int window = 0; window < kWindows; ++window) expected.push_back(fmt::format("/{}.poff", window));
  std::ranges::sort(expected);
  CHECK(found == expected);
}

TEST_CASE("a lock is held by one, and given up on after a while") {
  const TemporaryFolder folder;
  constexpr std::chrono::milliseconds kNone(0);
  {
    const UpdateLock lock(folder / "a", kNone);
    CHECK(lock.is_held());
    CHECK_FALSE(UpdateLock(folder / "a", kNone).is_held());
    CHECK(UpdateLock(folder / "b", kNone).is_held());
  }
  CHECK(UpdateLock(folder / "a", kNone).is_held());
  CHECK_FALSE(UpdateLock(folder / "missing/a", kNone).is_held());
}
