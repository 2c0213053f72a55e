// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <catch2/catch.hpp>
#include <functional>
#include <stdexcept>

#include "app/editing/editor.h"
#include "app/editing/prepared_document.h"
#include "core/base/rng.h"
#include "tests/faults/faulty_memory.h"

using namespace mes;
using namespace mes::test;

namespace {

/// What an editor holds; without the ends of gestures, which come with the next entry when they find no room.
struct State {
  std::uint64_t revision, digest;
  std::string undo, redo;
  bool is_in_gesture;
  std::size_t selected;
  std::vector<TimelineEntry> entries;
  friend bool operator==(const State&, const State&) = default;
};

/// An editor whose listener keeps a document of its own.
class Desk {
 public:
  Editor& editor() { return editor_; }
  State state() const {
    const TimelineLog& log = editor_.timeline().entries();
    std::vector<TimelineEntry> entries = log.between(0, log.size());
    std::erase_if(entries, [](const TimelineEntry& entry) { return std::holds_alternative<GestureEnded>(entry); });
    const Selection& selection = editor_.selection();
    return {editor_.document().revision(),
            editor_.document().digest(),
            editor_.undo_name(),
            editor_.redo_name(),
            editor_.in_gesture(),
            selection.sample_count() + selection.ball_count(),
            std::move(entries)};
  }
  /// The listener's document, once it has heard of everything.
  std::uint64_t heard() {
    editor_.catch_up();
    CHECK(copy_.revision() == editor_.document().revision());
    return copy_.digest();
  }

 private:
  Document copy_;
  Editor editor_{[this](const std::shared_ptr<const DocumentDelta>& delta) { copy_.apply(*delta); }};
};

/// Catch2's own would take a lack of memory for a failure.
template <class Result>
void require(const Expected<Result>& result) {
  if (!result) throw std::logic_error(result.error().text);
}

/// Every kind of edit, with numbers of their own.
class Edits {
 public:
  explicit Edits(std::uint64_t seed) : random_(seed) {}

  std::function<void(Editor&)> next(const Editor& editor) {
    const Document& document = editor.document();
    const auto samples = document.slots_in_input_order();
    const auto balls = document.ball_slots_in_input_order();
    const Vec2 p{random_.uniform(), random_.uniform()};
    const std::uint64_t kind = random_.below(12);
    if (samples.size() < 3 || kind < 3) {
      const std::vector<Vec2> places(1 + random_.below(5), p);
      return [places](Editor& e) { require(e.insert(places, "Insert")); };
    }
    const SampleId sample = document.id(samples[random_.below(samples.size())]);
    if (kind == 3) return [sample](Editor& e) { require(e.remove(std::array{sample}, "Remove")); };
    if (kind <= 5) return [=](Editor& e) { require(e.move(std::array{std::pair{sample, p}}, "Move")); };
    if (balls.empty() || kind == 6)
      return [=](Editor& e) { require(e.insert_balls(std::array{Disk{p, 0.5}}, "Ball")); };
    if (kind == 7) {
      const BallId ball = document.ball_id(balls[random_.below(balls.size())]);
      return [=](Editor& e) { require(e.move({}, std::array{std::pair{ball, Disk{p, 0.25}}}, "Ball")); };
    }
    if (kind == 8 && !editor.in_gesture()) {
      std::vector<Vec2> places;
      for (const SampleSlot slot : samples) places.push_back(0.5 * (document.position(slot) + p));
      return [places](Editor& e) { require(e.evolve(places, {}, "Evolve")); };
    }
    if (kind == 9) return [](Editor& e) { e.in_gesture() ? e.end_gesture() : e.begin_gesture("Drag"); };
    if (editor.in_gesture()) return [](Editor& e) { e.end_gesture(); };
    if (kind == 10) return [](Editor& e) { e.redo(); };
    return [](Editor& e) { e.undo(); };
  }

 private:
  Rng random_;
};

}  // namespace

TEST_CASE("whichever allocation of an edit fails, the edit is done or not begun, and undo takes back what was done") {
  Edits edits(11);
  Desk desk;
  Desk plain;  // where memory never fails
  int failures = 0;
  int done_in_spite = 0;
  for (int i = 0; i < 400; ++i) {
    const auto edit = edits.next(desk.editor());
    const State before = desk.state();
    failures += with_each_allocation_failing([&](int call) {
      try {
        const FailingMemory failing(call);
        edit(desk.editor());
        // What does not reach the index or the listener at first does not stop the edit.
        if (failing.has_failed()) ++done_in_spite;
        return false;
      } catch (const std::bad_alloc&) {
      }
      REQUIRE(desk.state() == before);
      return true;
    });
    edit(plain.editor());
    REQUIRE(desk.state() == plain.state());
    REQUIRE(desk.heard() == desk.editor().document().digest());
  }
  CHECK(failures > 2000);
  CHECK(done_in_spite > 100);
  for (Editor* editor : {&desk.editor(), &plain.editor()}) {
    if (editor->in_gesture()) editor->end_gesture();
    while (editor->can_undo()) editor->undo();
  }
  CHECK(desk.editor().document().sample_count() == 0);
  CHECK(desk.heard() == desk.editor().document().digest());
  CHECK(std::ranges::equal(desk.editor().timeline().entries(), plain.editor().timeline().entries()));
}

TEST_CASE("a document that finds no room to be taken over leaves the one before as it was") {
  for (const bool is_session : {false, true}) {
    Desk desk;
    Editor& editor = desk.editor();
    REQUIRE(editor.load({{{0, 0}, {1, 0}}, {}, {}}).has_value());
    REQUIRE(editor.insert(std::array<Vec2, 2>{{{2, 2}, {3, 5}}}, "Mine").has_value());
    const State before = desk.state();
    const auto data = std::make_shared<const SampleData>(SampleData{.positions = {{7, 7}, {8, 7}, {7, 9}}});
    const int failures = with_each_allocation_failing([&](int call) {
      DocumentReplay replay(editor.document());
      REQUIRE(replay.begin(*data).has_value());
      PreparedDocument next(std::move(replay), data);
      try {
        const FailingMemory failing(call);
        is_session ? editor.restore(next) : editor.load(next);
        return false;
      } catch (const std::bad_alloc&) {
      }
      REQUIRE(desk.state() == before);
      return true;
    });
    CHECK(failures > 0);
    CHECK(editor.document().sample_count() == 3);
    CHECK(editor.timeline().entries().empty());
    CHECK_FALSE(editor.can_undo());
    CHECK(desk.heard() == editor.document().digest());
  }
}

TEST_CASE("a listener that finds no room hears of everything later, at once") {
  Document copy;
  bool has_room = true;
  int calls = 0;
  Editor editor([&](const std::shared_ptr<const DocumentDelta>& delta) {
    if (!has_room) throw std::bad_alloc();
    copy.apply(*delta);
    ++calls;
  });
  REQUIRE(editor.load({{{0, 0}, {1, 0}, {0, 1}}, {}, {}}).has_value());
  has_room = false;
  REQUIRE(editor.insert(std::array<Vec2, 1>{{{2, 2}}}, "Insert").has_value());
  REQUIRE(editor.insert(std::array<Vec2, 1>{{{3, 3}}}, "Insert").has_value());
  editor.undo();
  CHECK(copy.sample_count() == 3);
  has_room = true;
  editor.catch_up();
  CHECK(calls == 2);
  CHECK(copy.digest() == editor.document().digest());
  CHECK(copy.sample_count() == 4);
  editor.redo();
  CHECK(calls == 3);
  CHECK(copy.digest() == editor.document().digest());
}
