// SPDX-License-Identifier: GPL-3.0-or-later
// What others do between two calls of the system, which here stand still for it.
#include <fcntl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <catch2/catch.hpp>
#include <cerrno>
#include <filesystem>
#include <functional>
#include <set>
#include <utility>

#include "app/store/autosave.h"
#include "app/store/looks/bundles.h"
#include "core/io/files/atomic_file.h"
#include "tests/io/temporary_folder.h"
#include "tests/support/builtin_layers.h"

using namespace mes;
using mes::test::contents_of;
using mes::test::TemporaryFolder;
namespace fs = std::filesystem;

namespace {

/// Called before the system is; what is not 0 is the error of the call, and the system is not asked.
std::function<int()> before_lock;
std::function<int()> before_sync;

int refused(std::function<int()>& hook) {
  // Not within itself.
  if (const auto now = std::exchange(hook, {})) {
    const int error = now();
    if (!hook) hook = now;
    return error;
  }
  return 0;
}

struct Hooks {
  ~Hooks() {
    before_lock = {};
    before_sync = {};
  }
};

Session head_of(const Editor& editor) {
  return {.title = "Work", .data = editor.timeline().data()};
}

}  // namespace

// In the place of the library's.
int flock_after_hook(int descriptor, int operation) __asm__("flock");
int fsync_after_hook(int descriptor) __asm__("fsync");

int flock_after_hook(int descriptor, int operation) {
  if (const int error = refused(before_lock); error != 0) {
    errno = error;
    return -1;
  }
  return static_cast<int>(::syscall(SYS_flock, descriptor, operation));
}

int fsync_after_hook(int descriptor) {
  if (const int error = refused(before_sync); error != 0) {
    errno = error;
    return -1;
  }
  return static_cast<int>(::syscall(SYS_fsync, descriptor));
}

TEST_CASE("a file that is changed while another version is written is not replaced") {
  const Hooks hooks;
  const TemporaryFolder folder;
  const fs::path file = folder.write("a", "old");
  before_sync = [&] {
    folder.write("a", "his");
    return 0;
  };
  CHECK(replace_file(file, "mine", fingerprint_of("old")).value() == Replaced::changed);
  CHECK(contents_of(file) == "his");
  // Another file in its place, with what was expected.
  int times = 0;
  before_sync = [&] {
    // The folder is synchronised later.
    if (++times == 1) fs::rename(folder.write("b", "his"), file);
    return 0;
  };
  CHECK(replace_file(file, "mine", fingerprint_of("his")).value() == Replaced::done);
  CHECK(contents_of(file) == "mine");
  CHECK(folder.file_count() == 1);
}

TEST_CASE("what a window writes that could not wait for the lock of the bundles is not lost") {
  const Hooks hooks;
  const TemporaryFolder folder;
  const fs::path file = folder / "bundles.json";
  BundleStore slow(layer_descriptors(), file);
  BundleStore hasty(layer_descriptors(), file, std::chrono::milliseconds(0));
  REQUIRE(slow.write(std::vector<Bundle>{{"old"}}));
  static_cast<void>(hasty.load({}));
  int times = 0;
  before_sync = [&] {
    if (++times == 1) REQUIRE(hasty.write(std::vector<Bundle>{{"old"}, {"his"}}));
    return 0;
  };
  const auto written = slow.write(std::vector<Bundle>{{"old"}, {"mine"}});
  REQUIRE(written);
  CHECK(times > 1);
  std::set<std::string> names;
  for (const Bundle& bundle : BundleStore(layer_descriptors(), file).load({}).bundles) names.insert(bundle.name);
  CHECK(names == std::set<std::string>{"old", "mine", "his"});
}

TEST_CASE("a part that is found before it is locked is made anew") {
  const Hooks hooks;
  const TemporaryFolder folder;
  int times = 0;
  before_lock = [&] {
    if (++times == 1) remove_abandoned_parts(folder.path());
    return 0;
  };
  CHECK(write_file_atomically(folder / "a", "text"));
  CHECK(times > 1);
  CHECK(contents_of(folder / "a") == "text");
  CHECK(folder.file_count() == 1);
}

TEST_CASE("a part that another one takes the place of, before it is locked, is not removed with it") {
  const Hooks hooks;
  const TemporaryFolder folder;
  const fs::path part = folder.write(".mesecina-0123456789abcdef.part", "left behind");
  int times = 0;
  before_lock = [&] {
    if (++times == 1) fs::rename(folder.write("b", "of a living process"), part);
    return 0;
  };
  remove_abandoned_parts(folder.path());
  CHECK(times == 1);
  CHECK(contents_of(part) == "of a living process");
}

TEST_CASE("a journal that is found before it is locked is not lost") {
  const Hooks hooks;
  const TemporaryFolder folder;
  Editor editor({});
  REQUIRE(editor.load({{{0, 0}}, {}}));
  REQUIRE(editor.insert(std::array{Vec2{1, 1}}, "Insert"));
  int times = 0;
  before_lock = [&] {
    // A second program that starts just now.
    if (++times == 1) CHECK(find_left_work(folder.path()).works.empty());
    return 0;
  };
  {
    Autosave autosave(folder.path(), {}, std::chrono::milliseconds(0));
    autosave.follow(editor, [&] { return head_of(editor); });
    autosave.flush();
    CHECK(autosave.take_problem().empty());
  }
  CHECK(times > 1);
  const FoundWork found = find_left_work(folder.path());
  REQUIRE(found.works.size() == 1);
  CHECK(found.works[0].edits() == 1);
}

TEST_CASE("where there are no locks there is no journal, which is said once, and nothing is taken for left behind") {
  const Hooks hooks;
  const TemporaryFolder folder;
  const fs::path other = folder.write("20260101-000000-1.journal", "garbage\n");
  const fs::path part = folder.write(".mesecina-0123456789abcdef.part", "of a living process, for all one knows");
  before_lock = [] { return ENOLCK; };
  Editor editor({});
  REQUIRE(editor.load({{{0, 0}}, {}}));
  int problems = 0;
  {
    Autosave autosave(folder.path(), {}, std::chrono::milliseconds(0));
    for (int i = 0; i < 3; ++i) {
      REQUIRE(editor.insert(std::array{Vec2{1, 1}}, "Insert"));
      autosave.follow(editor, [&] { return head_of(editor); });
      autosave.flush();
      const std::string problem = autosave.take_problem();
      if (problem.empty()) continue;
      ++problems;
      CHECK_THAT(problem, Catch::Contains("not protected against a crash") && Catch::Contains("No locks available"));
    }
  }
  CHECK(problems == 1);
  CHECK(find_left_work(folder.path()).works.empty());
  CHECK(write_file_atomically(folder / "a", "text"));
  CHECK(fs::exists(other));
  CHECK(fs::exists(part));
  CHECK(folder.file_count() == 3);
}
