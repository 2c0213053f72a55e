// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <catch2/catch.hpp>
#include <cmath>

#include "app/playing/evolution_player.h"
#include "app/playing/session_evolution.h"
#include "core/builtins/builtins.h"
#include "tests/model/editing/positions_of.h"
#include "tests/support/bell.h"
#include "tests/support/builtin_layers.h"

using namespace mes;
using mes::test::Bell;
using mes::test::positions_of;

namespace {

SampleData wavy_loop(bool known) {
  SampleData out;
  constexpr std::uint32_t kSamples = 60;
  if (known) out.contours.push_back({true, {}});
  for (std::uint32_t i = 0; i < kSamples; ++i) {
    const double t = 0.10471975511965977 * i;
    const double r = 2.0 + 0.2 * std::cos(7.0 * t);
    out.positions.push_back({r * std::cos(t), r * std::sin(t)});
    if (known) out.contours[0].points.push_back(i);
  }
  return out;
}

struct EvolutionBench {
  // Follows the deltas alone, as the engine does.
  Document heard;
  std::size_t changes = 0;
  Editor editor{[this](const std::shared_ptr<const DocumentDelta>& delta) {
    heard.apply(*delta);
    ++changes;
  }};
  ComputationSettings computation;
  Bell bell;
  EvolutionPlayer player{builtins(),
                         editor,
                         {[this](const Parameter& parameter) { return computation[parameter]; },
                          [this](const Parameter& parameter, double value) { computation[parameter] = value; }},
                         bell.ring()};
  double now = 0.0;

  explicit EvolutionBench(bool known = false) { REQUIRE(editor.load(wavy_loop(known))); }
  void settle() {
    player.follow(true, now);
    bell.wait_until([&] {
      if (player.is_waiting()) player.follow(false, now);
      return !player.is_waiting();
    });
    CHECK(heard.digest() == editor.document().digest());
  }
  std::vector<Vec2> at(std::uint64_t k) {
    player.step_to(k);
    settle();
    REQUIRE(player.position() == k);
    return positions_of(editor.document());
  }
  void set_value(std::string_view id, double value) {
    const auto all = parameters_of(*player.choice().evolution);
    const auto found = std::ranges::find(all, id, &Parameter::id);
    REQUIRE(found != all.end());
    player.set_value(*found, value);
  }
  double value(std::string_view id) const {
    const auto all = parameters_of(*player.choice().evolution);
    const auto found = std::ranges::find(all, id, &Parameter::id);
    REQUIRE(found != all.end());
    return player.choice().values[*found];
  }
  void insert() { REQUIRE(editor.insert(std::array{Vec2{9, 9}}, "Insert")); }
};

}  // namespace

TEST_CASE("moving the slider to and fro gives the same states, and the beginning exactly") {
  for (const auto& evolution : builtins().evolutions().all()) {
    if (evolution->moved_parameter() != nullptr) continue;  // moves no samples
    for (const bool known : {false, true}) {
      EvolutionBench desk(known);
      desk.player.choose(evolution);
      const std::uint64_t digest = desk.editor.document().digest();
      const auto curve = desk.editor.document().curve_order();
      const std::vector<Vec2> first = desk.at(1);
      const std::vector<Vec2> third = desk.at(3);
      CHECK(first != third);
      CHECK(desk.at(1) == first);
      CHECK(desk.editor.is_modified());
      CHECK(desk.at(3) == third);
      desk.at(0);
      CHECK(desk.editor.document().digest() == digest);
      CHECK(desk.editor.document().curve_order() == curve);
      CHECK_FALSE(desk.editor.is_modified());
      CHECK(desk.at(3) == third);
      desk.editor.undo();
      CHECK(desk.editor.document().digest() == digest);
      CHECK_FALSE(desk.editor.can_undo());
      CHECK(desk.player.position() == 0);
    }
  }
}

TEST_CASE("an evolution is one step of undo, named by its last state") {
  EvolutionBench desk;
  const std::vector<Vec2> beginning = positions_of(desk.editor.document());
  desk.at(1);
  CHECK(desk.editor.undo_name() == "Smooth, 1 step");
  const std::vector<Vec2> twelve = desk.at(12);
  CHECK(desk.editor.undo_name() == "Smooth, 12 steps");
  desk.insert();
  CHECK(desk.player.position() == 0);
  desk.editor.undo();
  CHECK(positions_of(desk.editor.document()) == twelve);
  CHECK(desk.player.position() == 12);
  desk.editor.undo();
  CHECK(positions_of(desk.editor.document()) == beginning);
  CHECK_FALSE(desk.editor.can_undo());
  desk.editor.redo();
  CHECK(positions_of(desk.editor.document()) == twelve);
  CHECK(desk.player.position() == 12);
  desk.editor.redo();
  CHECK(desk.editor.document().sample_count() == beginning.size() + 1);
  CHECK_FALSE(desk.editor.can_redo());
}

TEST_CASE("an edit at a later state begins a new evolution there") {
  EvolutionBench desk;
  desk.at(5);
  desk.insert();
  const std::vector<Vec2> edited = positions_of(desk.editor.document());
  desk.at(2);
  CHECK(desk.editor.undo_name() == "Smooth, 2 steps");
  desk.editor.undo();
  CHECK(positions_of(desk.editor.document()) == edited);
  CHECK(desk.editor.undo_name() == "Insert");
}

TEST_CASE("another evolution begins from what is shown, and each is a step of undo of its own") {
  EvolutionBench desk;
  const std::vector<Vec2> beginning = positions_of(desk.editor.document());
  const std::vector<Vec2> smooth = desk.at(3);
  desk.player.choose(find_evolution("subdivide"));
  CHECK(desk.player.position() == 0);
  CHECK(desk.player.take_remark() == "Smooth, 3 steps: kept; Subdivide begins from there");
  CHECK(desk.player.take_remark().empty());
  CHECK(positions_of(desk.editor.document()) == smooth);
  CHECK(desk.editor.undo_name() == "Smooth, 3 steps");
  const std::vector<Vec2> fine = desk.at(1);
  CHECK(fine.size() > smooth.size());
  desk.at(2);
  CHECK(desk.editor.undo_name() == "Subdivide, 2 steps");
  CHECK_FALSE(desk.player.take_restart());
  CHECK(desk.at(0) == smooth);
  CHECK(desk.at(1) == fine);
  desk.player.choose_next(1);
  CHECK(positions_of(desk.editor.document()) == fine);
  desk.editor.undo();
  CHECK(positions_of(desk.editor.document()) == smooth);
  CHECK(desk.player.position() == 0);
  desk.editor.undo();
  CHECK(positions_of(desk.editor.document()) == beginning);
  CHECK_FALSE(desk.editor.can_undo());
  desk.editor.redo();
  desk.editor.redo();
  CHECK(positions_of(desk.editor.document()) == fine);
  CHECK_FALSE(desk.editor.can_redo());
  DocumentReplay replay;
  REQUIRE(replay.begin(*desk.editor.timeline().data()));
  for (const TimelineEntry& entry : desk.editor.timeline().entries()) REQUIRE(replay.apply(entry));
  CHECK(replay.document().digest() == desk.editor.document().digest());
}

TEST_CASE("choosing another evolution while steps are computed keeps those that are shown") {
  EvolutionBench desk;
  const std::vector<Vec2> smooth = desk.at(2);
  desk.player.step_to(1'000'000'000);
  desk.player.choose_next(-1);
  CHECK(desk.player.descriptor().id == builtins().evolutions().ids().back());
  CHECK(desk.player.take_remark() ==
        "Smooth: step 1000000000 was not computed yet, and is given up. Smooth, 2 steps: kept; " +
            desk.player.descriptor().name + " begins from there");
  desk.settle();
  CHECK_FALSE(desk.player.is_waiting());
  CHECK(positions_of(desk.editor.document()) == smooth);
  // Nothing was done, so that nothing is kept.
  desk.player.choose_next(1);
  desk.player.choose_next(1);
  CHECK(desk.player.take_remark().empty());
}

TEST_CASE("another seed or parameter keeps the beginning") {
  EvolutionBench desk;
  const std::vector<Vec2> beginning = positions_of(desk.editor.document());
  const std::vector<Vec2> smooth = desk.at(4);
  desk.at(0);
  desk.player.choose(find_evolution("noise"));
  const std::vector<Vec2> noise = desk.at(4);
  desk.player.set_seed(8);
  desk.settle();
  CHECK(desk.player.position() == 4);
  CHECK(positions_of(desk.editor.document()) != noise);
  desk.player.set_seed(1);
  desk.settle();
  CHECK(positions_of(desk.editor.document()) == noise);
  desk.at(0);
  desk.player.choose(find_evolution("smooth"));
  desk.set_value("smooth-mu", 0.25);
  CHECK(desk.at(4) != smooth);
  desk.set_value("smooth-mu", 0.5);
  desk.settle();
  CHECK(positions_of(desk.editor.document()) == smooth);
  desk.at(0);
  CHECK(positions_of(desk.editor.document()) == beginning);
  CHECK_FALSE(desk.editor.can_undo());
}

TEST_CASE("each state reaches those who follow the document as one change") {
  EvolutionBench desk;
  const std::size_t before = desk.changes;
  for (const std::uint64_t k : {1U, 2U, 7U, 3U}) desk.at(k);
  CHECK(desk.changes == before + 4);
}

TEST_CASE("playing waits for complete pictures and for its time, and stops at the beginning") {
  EvolutionBench desk;
  desk.player.set_speed(10.0);
  desk.player.play(EvolutionPlayer::Direction::forward);
  desk.now = 1.0;
  desk.settle();
  CHECK(desk.player.position() == 1);
  desk.player.follow(false, 2.0);
  CHECK_FALSE(desk.player.is_waiting());
  desk.player.follow(true, 1.05);
  CHECK_FALSE(desk.player.is_waiting());
  CHECK(desk.player.next_due(1.05) == Approx(0.05));
  desk.now = 1.2;
  desk.settle();
  CHECK(desk.player.position() == 2);
  desk.player.play(EvolutionPlayer::Direction::backward);
  for (int i = 0; i < 5; ++i) {
    desk.now += 1.0;
    desk.settle();
  }
  CHECK(desk.player.position() == 0);
  CHECK(desk.player.direction() == EvolutionPlayer::Direction::none);
}

TEST_CASE("what is being computed can be given up, by hand or by an edit") {
  EvolutionBench desk;
  const std::vector<Vec2> beginning = positions_of(desk.editor.document());
  desk.player.step_to(1'000'000'000);
  CHECK(desk.player.is_waiting());
  desk.player.cancel();
  CHECK_FALSE(desk.player.is_waiting());
  CHECK(desk.player.take_remark().empty());
  CHECK(positions_of(desk.editor.document()) == beginning);
  desk.player.step_to(1'000'000'000);
  desk.insert();
  desk.settle();
  CHECK_FALSE(desk.player.is_waiting());
  CHECK(desk.player.take_remark() ==
        "Smooth: step 1000000000 was not computed yet, and is given up: the samples were edited");
  CHECK(desk.editor.document().sample_count() == beginning.size() + 1);
}

TEST_CASE("a step that is refused stops the playing with a reason and leaves the last state") {
  EvolutionBench desk;
  desk.player.choose(find_evolution("subdivide"));
  desk.at(2);
  desk.player.play(EvolutionPlayer::Direction::forward);
  desk.player.step_to(40);
  desk.settle();
  CHECK(desk.player.position() == 2);
  CHECK(desk.player.direction() == EvolutionPlayer::Direction::none);
  const auto problem = desk.player.take_problem();
  REQUIRE(problem);
  CHECK_THAT(problem->text, Catch::Contains("4000000 are the most"));
  CHECK_FALSE(desk.player.take_problem());
}

TEST_CASE("a timeline keeps each state of a small evolution and the last of a large one") {
  EvolutionBench desk;
  for (std::uint64_t k = 1; k <= 10; ++k) desk.at(k);
  CHECK(desk.editor.timeline().entries().size() == 10);
  SampleData many;
  for (int i = 0; i < 5000; ++i)
    many.positions.push_back({100.0 * std::cos(0.0012566 * i), 100.0 * std::sin(0.0012566 * i)});
  REQUIRE(desk.editor.load(many));
  for (std::uint64_t k = 1; k <= 5; ++k) desk.at(k);
  CHECK(desk.editor.timeline().entries().size() == 1);
  CHECK(desk.editor.timeline().settled() == 0);
  desk.insert();
  CHECK(desk.editor.timeline().settled() == 2);
  DocumentReplay replay;
  REQUIRE(replay.begin(*desk.editor.timeline().data()));
  for (const TimelineEntry& entry : desk.editor.timeline().entries()) REQUIRE(replay.apply(entry));
  CHECK(replay.document().digest() == desk.editor.document().digest());
}

TEST_CASE("growing moves the scale of a family and nothing else, and goes back exactly") {
  EvolutionBench desk;
  desk.computation[Parameter::b_scale] = 1.7;
  const ComputationSettings before = desk.computation;
  const auto samples = positions_of(desk.editor.document());
  desk.player.choose(find_evolution("b-growing"));
  CHECK(desk.at(10) == samples);
  CHECK(desk.computation[Parameter::b_scale] == Approx(1.7 * 1.3));
  CHECK(desk.computation[Parameter::a_scale] == 1.0);
  CHECK_FALSE(desk.editor.can_undo());
  desk.set_value("growing-step", 10.0);
  CHECK(desk.player.position() == 10);
  CHECK(desk.computation[Parameter::b_scale] == Approx(3.4));
  CHECK(desk.player.parameter_value() == desk.computation[Parameter::b_scale]);
  desk.at(0);
  CHECK(desk.computation == before);
  desk.at(4);
  CHECK(desk.computation[Parameter::b_scale] == Approx(2.38));
  desk.player.choose(find_evolution("b-shrinking"));
  CHECK(desk.computation[Parameter::b_scale] == Approx(2.38));
  desk.at(10);
  CHECK(desk.computation[Parameter::b_scale] == Approx(1.19));
  desk.at(0);
  CHECK(desk.computation[Parameter::b_scale] == Approx(2.38));
  // By hand: that is where the next step starts from.
  desk.computation[Parameter::b_scale] = 3.0;
  CHECK(desk.player.position() == 0);
  desk.at(10);
  CHECK(desk.computation[Parameter::b_scale] == Approx(1.5));
  desk.player.choose(find_evolution("smooth"));
  CHECK_FALSE(desk.player.parameter_value());
  CHECK(desk.computation[Parameter::b_scale] == Approx(1.5));
  CHECK(desk.at(1) != samples);
}

TEST_CASE("a step that is a length follows the size of the document until it is set by hand") {
  EvolutionBench desk;
  const auto step = [&desk] { return desk.value("alpha-step"); };
  const auto resize = [&desk](double size) {
    SampleData data = wavy_loop(false);
    for (Vec2& p : data.positions) p = size * p;
    REQUIRE(desk.editor.load(data));
    desk.player.follow(true, desk.now);
  };
  desk.player.choose(find_evolution("alpha-growing"));
  CHECK(step() == 0.02);
  resize(100.0);
  CHECK(step() == 2.0);
  // In the middle of an evolution steps are as they were, and another document makes the present value the first.
  desk.at(3);
  CHECK(desk.computation[Parameter::alpha_radius] == 6.0);
  resize(1.0);
  CHECK(step() == 2.0);
  desk.at(0);
  desk.player.follow(true, desk.now);
  CHECK(step() == 0.02);
  desk.set_value("alpha-step", 0.3);
  resize(100.0);
  CHECK(step() == 0.3);
  // Its default is no length, but stands for one that fits.
  desk.set_value("alpha-step", 1.0);
  CHECK(step() == 2.0);
  resize(1.0);
  CHECK(step() == 0.02);
  // A session has the length only. That which would be proposed was not set by hand.
  desk.player.resume(EvolutionChoice(desk.player.choice()), 0);
  resize(100.0);
  CHECK(step() == 2.0);
  desk.set_value("alpha-step", 0.3);
  desk.player.resume(EvolutionChoice(desk.player.choice()), 0);
  resize(1.0);
  CHECK(step() == 0.3);
  // What is set by hand stays, though it was proposed for another document.
  desk.set_value("alpha-step", 0.02);
  resize(100.0);
  CHECK(step() == 0.02);
}

TEST_CASE("growing ends where the parameter does") {
  EvolutionBench desk;
  desk.player.choose(find_evolution("a-growing"));
  desk.at(3300);
  desk.player.play(EvolutionPlayer::Direction::forward);
  desk.now = 1.0;
  desk.settle();
  CHECK(desk.player.position() == 3300);
  CHECK(desk.player.direction() == EvolutionPlayer::Direction::none);
  const auto problem = desk.player.take_problem();
  REQUIRE(problem);
  CHECK_THAT(problem->text, Catch::Contains("a-scale"));
}

TEST_CASE("an evolution goes on where a session left it") {
  for (const bool known : {false, true}) {
    EvolutionBench before(known);
    before.insert();
    EvolutionChoice choice{.evolution = find_evolution("noise"), .seed = 7};
    before.player.resume(choice, 0);
    const auto start = before.at(0);
    const auto second = before.at(2);
    const auto fifth = before.at(5);

    EvolutionBench after(known);
    DocumentReplay replay(after.editor.document());
    REQUIRE(replay.begin(*before.editor.timeline().data()));
    const TimelineLog& entries = before.editor.timeline().entries();
    for (const TimelineEntry& entry : entries) REQUIRE(replay.apply(entry));
    after.editor.restore(std::move(replay), before.editor.timeline().data(), {entries.begin(), entries.end()});
    after.player.resume(choice, 5);
    CHECK(after.player.position() == 5);
    CHECK(positions_of(after.editor.document()) == fifth);
    CHECK(after.at(2) == second);
    CHECK(after.at(0) == start);
    CHECK(after.at(5) == fifth);
    // Still one step, with the insertion below it.
    after.editor.undo();
    after.editor.undo();
    CHECK_FALSE(after.editor.can_undo());
    // With nothing to undo there is no state to take up.
    after.player.resume(choice, 3);
    CHECK(after.player.position() == 0);
  }
}

TEST_CASE("growing goes on where a session left it") {
  EvolutionBench desk;
  const EvolutionChoice choice{.evolution = find_evolution("a-growing")};
  desk.computation[Parameter::a_scale] = 1.3;
  desk.player.resume(choice, 10);
  CHECK(desk.player.position() == 10);
  desk.at(0);
  CHECK(desk.computation[Parameter::a_scale] == 1.0);
  // From another value than the default nothing tells where it came from.
  desk.computation[Parameter::a_scale] = 2.0;
  desk.player.resume(choice, 10);
  CHECK(desk.player.position() == 0);
  CHECK(desk.computation[Parameter::a_scale] == 2.0);
}

TEST_CASE("an evolution that the program lacks is kept with its state") {
  EvolutionBench desk;
  desk.insert();
  const std::vector<Vec2> positions = positions_of(desk.editor.document());
  const SessionEvolution lloyd{.id = "lloyd", .seed = 5, .step = 7, .parameters = {{"lloyd-pull", 0.25}}};
  const auto now = [&] { return session_evolution(builtins(), desk.player.choice(), desk.player.position()); };
  desk.player.resume(choice_of(builtins(), lloyd), lloyd.step);
  SessionEvolution saved = now();
  CHECK(saved.id == "lloyd");
  CHECK(saved.seed == 5);
  CHECK(saved.step == 7);
  CHECK(std::ranges::count(saved.parameters, lloyd.parameters.front()) == 1);
  CHECK(choice_of(builtins(), saved) == choice_of(builtins(), lloyd));
  // It has no other state: the samples and the steps of undo stay.
  for (const std::uint64_t k : {8U, 0U}) {
    desk.player.step_to(k);
    const auto problem = desk.player.take_problem();
    REQUIRE(problem);
    CHECK(problem->text == "the evolution lloyd is not available here");
    CHECK(desk.player.position() == 7);
    CHECK(positions_of(desk.editor.document()) == positions);
  }
  desk.editor.undo();
  CHECK(now().step == 0);
  desk.player.choose_next(1);
  CHECK(now().id == builtins().evolutions().ids()[1]);
  CHECK(desk.at(1) != positions);

  JobControl job;
  const EvolutionState state = state_of(desk.editor.document());
  const auto next = next_state(state, 0, choice_of(builtins(), lloyd), job);
  REQUIRE_FALSE(next);
  CHECK(next.error().text == "the evolution lloyd is not available here");
}
