// SPDX-License-Identifier: GPL-3.0-or-later
#include <signal.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <catch2/catch.hpp>
#include <thread>
#include <unordered_set>

#include "app/store/autosave.h"
#include "core/base/rng.h"
#include "tests/io/temporary_folder.h"
#include "tests/model/editing/random_editing.h"

using namespace mes;
using namespace mes::test;
using std::chrono::milliseconds;
namespace fs = std::filesystem;

namespace {

Session head_of(const Editor& editor) {
  return {.title = "Work", .data = editor.timeline().data()};
}

std::uint64_t digest_of(const Session& session) {
  DocumentReplay replay;
  REQUIRE(replay_session(session, replay, "test"));
  return replay.document().digest();
}

}  // namespace

TEST_CASE("what was edited is found after the program is gone, and what was saved is not") {
  const TemporaryFolder folder;
  Editor editor({});
  REQUIRE(editor.load({{{0, 0}, {1, 0}}, {}}));
  const auto work_left = [&](auto edit) {
    Autosave autosave(folder.path(), {}, milliseconds(0));
    const auto follow = [&] { autosave.follow(editor, [&] { return head_of(editor); }); };
    follow();
    edit(autosave, follow);
    autosave.flush();
    // Its own program still runs: no other may take the work.
    CHECK(find_left_work(folder.path()).works.empty());
  };
  work_left([](Autosave&, auto) {});
  CHECK(folder.file_count() == 0);

  work_left([&](Autosave&, auto follow) {
    REQUIRE(editor.insert(std::array{Vec2{2, 3}}, "Insert"));
    follow();
    REQUIRE(editor.insert(std::array{Vec2{4, 5}}, "Insert"));
    editor.undo();
    follow();
  });
  {
    FoundWork found = find_left_work(folder.path());
    CHECK(found.message.empty());
    REQUIRE(found.works.size() == 1);
    CHECK(found.works[0].edits() == 3);
    CHECK(found.works[0].session().title == "Work");
    CHECK(digest_of(found.works[0].session()) == editor.document().digest());
    // While one program asks about it, no other does.
    CHECK(find_left_work(folder.path()).works.empty());
  }
  {
    FoundWork found = find_left_work(folder.path());
    REQUIRE(found.works.size() == 1);
    found.works[0].remove();
  }
  CHECK(folder.file_count() == 0);

  editor.mark_saved();
  work_left([&](Autosave& autosave, auto follow) {
    REQUIRE(editor.insert(std::array{Vec2{7, 7}}, "Insert"));
    follow();
    editor.mark_saved();
    autosave.note_saved();
  });
  CHECK(folder.file_count() == 1);
  CHECK(find_left_work(folder.path()).works.empty());
  CHECK(folder.file_count() == 0);

  // The file in which the document is kept is known afterwards: the one it came from, then the one it was saved in.
  const auto from = [] { return std::optional(SourceFile{"/work/from.json", {1, 2}}); };
  for (const bool is_saved : {false, true}) {
    work_left([&](Autosave& autosave, auto) {
      const auto follow_file = [&] {
        autosave.follow(
            editor, [&] { return head_of(editor); }, from);
      };
      REQUIRE(editor.insert(std::array{Vec2{is_saved ? 9.0 : 10.0, 8}}, "Insert"));
      follow_file();
      if (!is_saved) return;
      editor.mark_saved();
      autosave.note_saved(SourceFile{"/work/to.json", {3, 4}});
      REQUIRE(editor.insert(std::array{Vec2{11, 8}}, "Insert"));
      follow_file();
    });
    FoundWork found = find_left_work(folder.path());
    REQUIRE(found.works.size() == 1);
    CHECK(found.works[0].name() == (is_saved ? "to.json" : "from.json"));
    REQUIRE(found.works[0].file());
    CHECK(found.works[0].file()->fingerprint == (is_saved ? FileFingerprint{3, 4} : FileFingerprint{1, 2}));
    if (is_saved) CHECK(found.works[0].edits() == 1);
    found.works[0].remove();
  }

  work_left([&](Autosave& autosave, auto follow) {
    REQUIRE(editor.insert(std::array{Vec2{8, 7}}, "Insert"));
    follow();
    autosave.discard();
    CHECK(folder.file_count() == 0);
    // Another document, another journal.
    REQUIRE(editor.load({{{0, 0}}, {}}));
    REQUIRE(editor.insert(std::array{Vec2{8, 7}}, "Insert"));
    follow();
    REQUIRE(editor.load({{{0, 0}, {5, 5}}, {}}));
    follow();
  });
  CHECK(find_left_work(folder.path()).works.empty());
}

TEST_CASE("a search for left work that is stopped loses nothing") {
  const TemporaryFolder folder;
  Editor editor({});
  {
    Autosave autosave(folder.path(), {}, milliseconds(0));
    for (int i = 0; i < 20; ++i) {
      REQUIRE(editor.insert(std::array{Vec2{1.0 * i, 1.0 * i * i}}, "Insert"));
      autosave.follow(editor, [&] { return head_of(editor); });
    }
    autosave.flush();
  }
  std::stop_source stop;
  stop.request_stop();
  CHECK_THROWS_AS(find_left_work(folder.path(), stop.get_token()), Cancelled);
  const FoundWork found = find_left_work(folder.path());
  REQUIRE(found.works.size() == 1);
  CHECK(digest_of(found.works[0].session()) == editor.document().digest());

  // At whichever line the reader is stopped.
  std::string text = write_journal_head(head_of(Editor({})));
  for (const TimelineEntry& entry : found.works[0].session().entries) text += write_journal_line(entry);
  int stops = 0;
  for (std::int64_t look = 1;; ++look) {
    JobControl job;
    job.stop_at_look(look);
    try {
      const auto journal = read_journal(text, "test", &job);
      REQUIRE(journal);
      CHECK(journal->session.entries.size() == 20);
      break;
    } catch (const Cancelled&) {
      ++stops;
    }
  }
  CHECK(stops > 20);
}

TEST_CASE("a lesson that no file holds is found after the program is gone, with the work it is made of") {
  const TemporaryFolder folder;
  Editor editor({});
  REQUIRE(editor.load({{{0, 0}, {1, 0}}, {}}));
  const auto with_lesson = [&] {
    Session out = head_of(editor);
    out.lesson = editor.lesson();
    return out;
  };
  const auto found_after = [&](auto edit) {
    {
      Autosave autosave(folder.path(), {}, milliseconds(0));
      edit(autosave, [&] {
        autosave.follow(editor, with_lesson);
        autosave.flush();
        // One journal at any time, whichever was renewed.
        CHECK(folder.file_count() == (editor.is_modified() ? 1U : 0U));
      });
    }
    FoundWork found = find_left_work(folder.path());
    CHECK(found.message.empty());
    REQUIRE(found.works.size() == 1);
    const Session session = found.works[0].session();
    CHECK(found.works[0].edits() > 0);
    CHECK(session.lesson == editor.lesson());
    CHECK(digest_of(session) == editor.document().digest());
    found.works[0].remove();
  };
  found_after([&](Autosave&, auto follow) {
    editor.set_lesson({.title = "Alone", .steps = {{.caption = "one"}}});
    follow();
  });
  found_after([&](Autosave&, auto follow) {
    REQUIRE(editor.insert(std::array{Vec2{2, 3}}, "Insert"));
    follow();
    editor.set_lesson({.title = "First", .steps = {{.caption = "one", .position = 1}}});
    follow();
    REQUIRE(editor.insert(std::array{Vec2{4, 5}}, "Insert"));
    follow();
    editor.set_lesson({.title = "Second", .steps = {{.caption = "one", .position = 2}, {.position = 1}}});
    editor.undo();
    follow();
    REQUIRE(editor.insert(std::array{Vec2{6, 5}}, "Insert"));
    follow();
  });
}

TEST_CASE("edits that the opened file holds are not counted as unsaved") {
  const TemporaryFolder folder;
  Editor before({});
  REQUIRE(before.load({{{0, 0}}, {}}));
  for (int i = 1; i < 10; ++i) REQUIRE(before.insert(std::array{Vec2{1.0 * i, 1.0}}, "Insert"));
  const Lesson lesson{.steps = {{.caption = "one", .position = 3}}};
  const auto edits_after = [&](const Lesson& opened, bool is_recovered, auto edit) {
    Editor editor({});
    DocumentReplay replay;
    REQUIRE(replay.begin(*before.timeline().data()));
    for (const TimelineEntry& entry : before.timeline().entries()) REQUIRE(replay.apply(entry));
    editor.restore(std::move(replay), before.timeline().data(), before.timeline().entries(), opened);
    if (is_recovered) editor.mark_unsaved();
    {
      Autosave autosave(folder.path(), {}, milliseconds(0));
      const auto follow = [&] {
        autosave.follow(editor, [&] {
          Session out = head_of(editor);
          out.lesson = editor.lesson();
          return out;
        });
        autosave.flush();
      };
      follow();
      edit(editor, follow);
      follow();
    }
    FoundWork found = find_left_work(folder.path());
    REQUIRE(found.works.size() == 1);
    CHECK(digest_of(found.works[0].session()) == editor.document().digest());
    CHECK(found.works[0].session().lesson == editor.lesson());
    const std::size_t out = found.works[0].edits();
    found.works[0].remove();
    return out;
  };
  const auto insert = [](Editor& editor, auto) { REQUIRE(editor.insert(std::array{Vec2{2, 3}}, "Insert")); };
  const auto teach = [&](Editor& editor, auto) { editor.set_lesson({.title = "Mine", .steps = lesson.steps}); };
  const auto insert_and_teach = [&](Editor& editor, auto follow) {
    insert(editor, follow);
    follow();
    teach(editor, follow);
  };
  for (const Lesson& opened : {Lesson{}, lesson}) {
    CHECK(edits_after(opened, false, insert) == 1);
    CHECK(edits_after(opened, false, teach) == 1);
    CHECK(edits_after(opened, false, insert_and_teach) == 1);
    CHECK(edits_after(opened, true, insert) == 10);
  }
}

TEST_CASE("a gesture that is not finished waits; an unreadable journal is set aside with a message") {
  const TemporaryFolder folder;
  Editor editor({});
  REQUIRE(editor.load({{{0, 0}}, {}}));
  {
    Autosave autosave(folder.path(), {}, milliseconds(0));
    REQUIRE(editor.insert(std::array{Vec2{1, 1}}, "Insert"));
    editor.begin_gesture("Drag");
    REQUIRE(editor.move(std::array{std::pair{editor.document().id(SampleSlot(0)), Vec2{5, 5}}}, "Drag"));
    autosave.follow(editor, [&] { return head_of(editor); });
    autosave.flush();
  }
  FoundWork found = find_left_work(folder.path());
  REQUIRE(found.works.size() == 1);
  CHECK(found.works[0].edits() == 1);
  found.works[0].remove();

  folder.write("20260101-000000-1.journal", "garbage\n");
  found = find_left_work(folder.path());
  CHECK(found.works.empty());
  CHECK(found.message.find("20260101-000000-1.journal.broken") != std::string::npos);
  CHECK(folder.file_count() == 1);
}

TEST_CASE("a journal that holds anything is kept when it cannot be read, and nothing that was kept is replaced") {
  const TemporaryFolder folder;
  // As a loss of power can leave it, and as a full disk does.
  const std::string zeros(5000, '\0');
  for (const std::string& text : {zeros, std::string("{\"torn")}) {
    folder.write("20260101-000000-1.journal", text);
    const FoundWork found = find_left_work(folder.path());
    CHECK(found.works.empty());
    CHECK(found.message.find("20260101-000000-1.journal.broken") != std::string::npos);
  }
  CHECK(contents_of(folder / "20260101-000000-1.journal.broken") == zeros);
  CHECK(contents_of(folder / "20260101-000000-1.journal.broken-2") == "{\"torn");
  CHECK(folder.file_count() == 2);
  // A journal that was just begun holds nothing.
  folder.write("20260101-000000-2.journal", "");
  CHECK(find_left_work(folder.path()).message.empty());
  CHECK(folder.file_count() == 2);
}

TEST_CASE("a journal that is read in part is offered up to there, and kept when that was taken or refused") {
  const TemporaryFolder folder;
  Editor editor({});
  REQUIRE(editor.load({{{0, 0}}, {}}));
  {
    Autosave autosave(folder.path(), {}, milliseconds(0));
    REQUIRE(editor.insert(std::array{Vec2{1, 1}}, "Insert"));
    autosave.follow(editor, [&] { return head_of(editor); });
    autosave.flush();
  }
  const std::uint64_t digest = editor.document().digest();
  const fs::path file = fs::directory_iterator(folder.path())->path();
  const std::string bytes = contents_of(file) + "{\"edit\":\n{\"undo\":true}\n";
  folder.write(file.filename().string(), bytes);

  FoundWork found = find_left_work(folder.path());
  CHECK(
      found.message.starts_with("some of the work that was left unsaved cannot be read: " + file.string() + ":3: "));
  REQUIRE(found.works.size() == 1);
  CHECK(found.works[0].edits() == 1);
  CHECK(digest_of(found.works[0].session()) == digest);
  found.works[0].remove();
  found.works.clear();
  CHECK(folder.file_count() == 1);
  CHECK(contents_of(file.string() + ".broken") == bytes);
  CHECK(find_left_work(folder.path()).works.empty());
}

TEST_CASE("what is not a file is not taken for a journal") {
  const TemporaryFolder folder;
  REQUIRE(::mkfifo((folder / "20260101-000000-1.journal").c_str(), 0600) == 0);
  const fs::path elsewhere = folder.write("elsewhere", "garbage\n");
  fs::create_symlink("elsewhere", folder / "20260101-000000-2.journal");
  const FoundWork found = find_left_work(folder.path());
  CHECK(found.works.empty());
  CHECK(found.message.empty());
  CHECK(folder.file_count() == 3);
  CHECK(contents_of(elsewhere) == "garbage\n");
}

TEST_CASE("killed at any moment, a program leaves a journal that can be read, of a state that was") {
  const TemporaryFolder folder;
  Rng random(11);
  int found_works = 0;
  for (int round = 0; round < 200; ++round) {
    const std::uint64_t seed = random.next();
    constexpr int kSteps = 400;
    const auto run = [&](auto after_each) {
      Editor editor({});
      RandomEditing script(seed);
      if (!editor.load(script.data())) return;
      for (int i = 0; i < kSteps; ++i) {
        script.step(editor);
        after_each(editor);
      }
    };
    // In every other round not before some steps are on the disk, however slow the machine is.
    const std::uint64_t sure_steps = round % 2 == 0 ? 0 : 1 + random.below(kSteps);
    std::array<int, 2> are_on_disk{};
    REQUIRE(::pipe(are_on_disk.data()) == 0);
    const pid_t child = ::fork();
    REQUIRE(child >= 0);
    if (child == 0) {
      Autosave autosave(folder.path(), {}, milliseconds(0));
      std::uint64_t steps = 0;
      run([&](const Editor& editor) {
        autosave.follow(editor, [&] { return head_of(editor); });
        if (++steps == sure_steps) {
          autosave.flush();
          ::close(are_on_disk[1]);
        }
        std::this_thread::sleep_for(std::chrono::microseconds(50));
      });
      for (;;) ::pause();
    }
    ::close(are_on_disk[1]);
    char nothing = 0;
    if (sure_steps != 0) CHECK(::read(are_on_disk[0], &nothing, 1) == 0);
    ::close(are_on_disk[0]);
    std::this_thread::sleep_for(std::chrono::microseconds(random.below(20'000)));
    ::kill(child, SIGKILL);
    ::waitpid(child, nullptr, 0);

    FoundWork found = find_left_work(folder.path());
    CHECK(found.message.empty());
    REQUIRE(found.works.size() <= 1);
    if (found.works.empty()) continue;
    ++found_works;
    std::unordered_set<std::uint64_t> states;
    run([&](const Editor& editor) { states.insert(editor.document().digest()); });
    CHECK(states.contains(digest_of(found.works[0].session())));
    found.works[0].remove();
  }
  CHECK(found_works > 50);
}

TEST_CASE("when the disk is full work goes on, with one message, and is protected again later") {
  const TemporaryFolder folder;
  const pid_t child = ::fork();
  REQUIRE(child >= 0);
  if (child == 0) {
    // A limit on the size of files stands for the full disk.
    ::signal(SIGXFSZ, SIG_IGN);
    rlimit limit{};
    ::getrlimit(RLIMIT_FSIZE, &limit);
    const rlimit small{400, limit.rlim_max};
    Editor editor({});
    int problems = 0;
    if (!editor.load({{{0, 0}}, {}})) ::_exit(1);
    Autosave autosave(folder.path(), {}, milliseconds(0));
    const auto edit = [&] {
      if (!editor.insert(std::array{Vec2{1, 2}}, "Insert")) ::_exit(2);
      autosave.follow(editor, [&] { return head_of(editor); });
      autosave.flush();
      problems += autosave.take_problem().empty() ? 0 : 1;
    };
    if (autosave.holds_all()) ::_exit(5);
    edit();
    if (!autosave.holds_all()) ::_exit(6);
    ::setrlimit(RLIMIT_FSIZE, &small);
    for (int i = 0; i < 50; ++i) edit();
    if (problems != 1 || autosave.holds_all()) ::_exit(3);
    ::setrlimit(RLIMIT_FSIZE, &limit);
    edit();
    ::_exit(problems == 1 && autosave.holds_all() ? 0 : 4);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  REQUIRE(WIFEXITED(status));
  CHECK(WEXITSTATUS(status) == 0);
  const FoundWork found = find_left_work(folder.path());
  REQUIRE(found.works.size() == 1);
  CHECK(found.works[0].edits() == 52);
}
