// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <catch2/catch.hpp>
#include <set>

#include "app/recording/frame_writer.h"
#include "app/store/autosave.h"
#include "core/io/files/atomic_file.h"
#include "tests/faults/faulty_disk.h"
#include "tests/io/temporary_folder.h"

using namespace mes;
using namespace mes::test;

namespace {

constexpr std::array kCalls{DiskCall::open, DiskCall::write, DiskCall::sync, DiskCall::rename};

/// Calls `attempt(call)` with the n-th call of each kind failing, until there are no more calls of it. How many
/// failed.
template <class Attempt>
int with_each_call_failing(const Attempt& attempt) {
  int out = 0;
  for (const DiskCall kind : kCalls) {
    for (int call = 0;; ++call) {
      REQUIRE(call < 1000);
      INFO("call " << call << " of kind " << static_cast<int>(kind));
      if (!attempt(kind, call)) break;
      ++out;
    }
  }
  return out;
}

Session head_of(const Editor& editor) {
  return {.title = "Work", .data = editor.timeline().data()};
}

std::uint64_t digest_of(const Session& session) {
  DocumentReplay replay;
  REQUIRE(replay_session(session, replay, "test"));
  return replay.document().digest();
}

}  // namespace

TEST_CASE("a file is the old one or the new one, whichever call fails, and nothing else is left") {
  const std::string old_bytes(5000, 'o');
  const std::string new_bytes(70'000, 'n');
  const int failed = with_each_call_failing([&](DiskCall kind, int call) {
    const TemporaryFolder folder;
    folder.write("file", old_bytes);
    bool has_failed = false;
    Expected<void> done;
    {
      const FailingDisk failing(kind, call);
      done = write_file_atomically(folder / "file", new_bytes);
      has_failed = failing.has_failed();
    }
    CHECK(folder.file_count() == 1);
    if (!done) {
      CHECK(has_failed);
      CHECK(done.error().code == ErrorCode::cannot_write);
      CHECK(done.error().message().ends_with("file: cannot be written: No space left on device"));
      CHECK(contents_of(folder / "file") == old_bytes);
      CHECK(write_file_atomically(folder / "file", new_bytes));
    }
    CHECK(contents_of(folder / "file") == new_bytes);
    return has_failed;
  });
  // Opening, writing, syncing file and folder, renaming.
  CHECK(failed >= 5);
}

TEST_CASE("a write that a signal interrupts goes on where it was") {
  std::string bytes;
  for (int i = 0; i < 20'000; ++i) bytes += std::to_string(i) + ' ';
  const TemporaryFolder folder;
  const FailingDisk interrupted(DiskCall::write, 0, false, EINTR);
  REQUIRE(write_file_atomically(folder / "file", bytes));
  CHECK(interrupted.has_failed());
  CHECK(contents_of(folder / "file") == bytes);
}

TEST_CASE("a journal is whole again when the disk is, and its trouble is reported once") {
  const int failed = with_each_call_failing([](DiskCall kind, int call) {
    const TemporaryFolder folder;
    Editor editor({});
    REQUIRE(editor.load({{{0, 0}, {1, 0}}, {}}));
    std::set<std::uint64_t> digests{editor.document().digest()};
    bool has_failed = false;
    int problems = 0;
    {
      Autosave autosave(folder.path(), {}, std::chrono::milliseconds(0));
      const auto edit = [&](int i) {
        REQUIRE(editor.insert(std::array{Vec2{1.0 * i, 2}}, "Insert"));
        digests.insert(editor.document().digest());
        autosave.follow(editor, [&] { return head_of(editor); });
        autosave.flush();
        problems += autosave.take_problem().empty() ? 0 : 1;
      };
      edit(0);
      {
        const FailingDisk failing(kind, call, true);
        for (int i = 1; i <= 4; ++i) edit(i);
        has_failed = failing.has_failed();
      }
      CHECK(problems == (has_failed ? 1 : 0));
      edit(5);
      CHECK(problems == (has_failed ? 1 : 0));
    }
    const FoundWork found = find_left_work(folder.path());
    CHECK(found.message.empty());
    REQUIRE(found.works.size() == 1);
    CHECK(found.works[0].edits() == 6);
    CHECK(digest_of(found.works[0].session()) == editor.document().digest());
    return has_failed;
  });
  CHECK(failed >= 8);
}

TEST_CASE("a journal that could not be brought to an end holds a state that was") {
  for (const DiskCall kind : kCalls) {
    for (int call = 0; call < 12; ++call) {
      const TemporaryFolder folder;
      Editor editor({});
      REQUIRE(editor.load({{{0, 0}, {1, 0}}, {}}));
      std::set<std::uint64_t> digests;
      {
        const FailingDisk failing(kind, call, true);
        Autosave autosave(folder.path(), {}, std::chrono::milliseconds(0));
        for (int i = 0; i < 5; ++i) {
          REQUIRE(editor.insert(std::array{Vec2{1.0 * i, 2}}, "Insert"));
          digests.insert(editor.document().digest());
          autosave.follow(editor, [&] { return head_of(editor); });
          autosave.flush();
        }
      }
      const FoundWork found = find_left_work(folder.path());
      CHECK(found.message.empty());
      for (const LeftWork& work : found.works) CHECK(digests.contains(digest_of(work.session())));
    }
  }
}

TEST_CASE("a recording ends at the first frame that cannot be written, with one problem and whole frames") {
  constexpr int kFrames = 6;
  const int failed = with_each_call_failing([&](DiskCall kind, int call) {
    const TemporaryFolder folder;
    const auto take = begin_take(folder.path(), {8, 6, 25.0});
    REQUIRE(take);
    bool has_failed = false;
    Expected<void> done;
    std::optional<Error> problem;
    std::size_t written = 0;
    {
      const FailingDisk failing(kind, call);
      FrameWriter writer(*take, {.threads = 1});
      for (int i = 0; i < kFrames; ++i)
        if (!writer.push({render::Image{8, 6, std::vector<std::uint8_t>(4 * 8 * 6, 255)}, {"Step"}})) break;
      done = writer.finish();
      problem = writer.problem();
      written = writer.written();
      has_failed = failing.has_failed();
    }
    CHECK(done.has_value() == !problem.has_value());
    if (problem) {
      CHECK(has_failed);
      CHECK(problem->message() == done.error().message());
      CHECK(problem->message().find('\n') == std::string::npos);
    } else {
      CHECK(written == kFrames);
    }
    std::size_t frames = 0;
    for (const auto& entry : std::filesystem::directory_iterator(take->folder)) {
      CHECK(entry.path().extension() != ".part");
      if (entry.path().extension() != ".png") continue;
      ++frames;
      CHECK(contents_of(entry.path()).ends_with(std::string("IEND\xAE\x42\x60\x82", 8)));
    }
    CHECK(frames == written);
    return has_failed;
  });
  CHECK(failed >= 3 * kFrames);
}
