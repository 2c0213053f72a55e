// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <catch2/catch.hpp>
#include <map>
#include <set>

#include "app/actions/action_bindings.h"
#include "app/actions/actions.h"
#include "app/actions/menus.h"

using namespace mes;

TEST_CASE("the table is in the order of the ids and complete") {
  const auto actions = action_descriptors();
  REQUIRE(actions.size() == kActionCount);
  std::set<std::string_view> public_ids;
  for (std::size_t i = 0; i < actions.size(); ++i) {
    CHECK(static_cast<std::size_t>(actions[i].id) == i);
    CHECK(public_ids.insert(actions[i].public_id).second);
    CHECK_FALSE(actions[i].name.empty());
    CHECK_FALSE(actions[i].tooltip.empty());
    CHECK(actions[i].tooltip.back() != '.');
    for (const char c : actions[i].public_id) CHECK(((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-'));
  }
}

TEST_CASE("every action is in a menu, but for those of keys alone, and once in each") {
  const auto is_of_keys_alone = [](ActionId id) {
    return (id >= ActionId::first_nudge && id <= ActionId::last_nudge) ||
           (id >= ActionId::first_bundle && id <= ActionId::last_bundle) || id == ActionId::evolution_previous ||
           id == ActionId::evolution_next;
  };
  for (const ActionDescriptor& action : action_descriptors()) {
    INFO(action.public_id);
    // Its button is in the panel of the experiments.
    if (action.id == ActionId::add_experiment) continue;
    CHECK(menu_of(action.id).empty() == is_of_keys_alone(action.id));
  }
  std::set<std::pair<std::string_view, ActionId>> seen;
  for (const MenuPart& part : menu_parts())
    for (const ActionId id : part.actions) CHECK(seen.emplace(part.path, id).second);
  CHECK(menu_of(ActionId::full_screen) == "View");
  CHECK(menu_of(ActionId::toggle_key) == "View > Legend and scale");
  CHECK(std::ranges::count(actions_in_menu("Edit > Arrange", 3), ActionId::add_circle) == 1);
}

TEST_CASE("every key is readable, written in its one spelling, and no two actions compete for it") {
  for (const bool has_selection : {false, true}) {
    std::map<std::string_view, std::string_view> owner;
    for (const ActionDescriptor& action : action_descriptors()) {
      if (action.context == ActionContext::with_selection && !has_selection) continue;
      for (const std::string_view key : action.keys) {
        INFO(key << " of " << action.public_id << " and of " << owner[key]);
        const auto chord = parse_chord(key);
        REQUIRE(chord);
        CHECK(to_string(*chord) == key);
        CHECK(owner[key].empty());
        owner[key] = action.public_id;
        CHECK(Keymap::standard().find(*chord, has_selection) == action.id);
      }
    }
  }
}

TEST_CASE("Backspace deletes what is selected and does nothing else; the previous view has a key of its own") {
  const auto backspace = parse_chord("Backspace");
  REQUIRE(backspace);
  CHECK(Keymap::standard().find(*backspace, true) == ActionId::delete_selection);
  CHECK_FALSE(Keymap::standard().find(*backspace, false));
  CHECK_FALSE(Keymap::standard().find(*parse_chord("Delete"), false));
  for (const bool has_selection : {false, true})
    CHECK(Keymap::standard().find(*parse_chord("Alt+Left"), has_selection) == ActionId::previous_view);
}

TEST_CASE("chords are read and written") {
  const auto undo = parse_chord("Ctrl+Shift+Z");
  REQUIRE(undo);
  CHECK(undo->symbol == U'Z');
  CHECK(undo->modifiers == Modifiers{.ctrl = true, .shift = true});
  CHECK(parse_chord("F12")->symbol == key::f1 + 11);
  CHECK(parse_chord("Ctrl++")->symbol == U'+');
  CHECK(is_typed_symbol(*parse_chord("?")));
  CHECK_FALSE(is_typed_symbol(*parse_chord("Ctrl+.")));
  CHECK_FALSE(is_typed_symbol(*parse_chord("V")));
  for (const char* wrong :
       {"", "Ctrl+", "ctrl+z", "z", "F0", "F13", "F1x", "Shift+?", "Hyper+X", "ZZ", "Shift+Ctrl+Z"})
    CHECK_FALSE(parse_chord(wrong));
}

TEST_CASE("an action that is not possible says why, and only then") {
  ActionBindings bindings;
  bool is_selected = false;
  int cuts = 0;
  bindings.bind(ActionId::cut, {[&] { ++cuts; }, {[&] { return is_selected; }, "nothing is selected"}});
  bindings.bind(ActionId::paste, {[] {}});
  CHECK(bindings.missing(ActionId::cut) == "nothing is selected");
  CHECK(bindings.missing(ActionId::paste).empty());
  CHECK_THAT(bindings.tooltip_of(ActionId::cut), Catch::EndsWith("\nNot possible now: nothing is selected"));
  CHECK_FALSE(bindings.run(ActionId::cut));
  is_selected = true;
  CHECK(bindings.missing(ActionId::cut).empty());
  CHECK_THAT(bindings.tooltip_of(ActionId::cut), !Catch::Contains("Not possible"));
  CHECK(bindings.run(ActionId::cut));
  CHECK(cuts == 1);
}

TEST_CASE("of several things that are missing the first is said, each in words of its own") {
  ActionBindings bindings;
  bool has_lesson = false;
  bool is_reading = true;
  bool is_running = false;
  const ActionBindings::Condition condition{{[&] { return has_lesson; }, "there is no lesson"},
                                            {[&] { return !is_reading; }, "a file is being read"}};
  bindings.bind(ActionId::present_lesson, {[] {}, condition});
  bindings.bind(ActionId::next_bundle, {[] {}, condition.unless([&] { return is_running; })});
  CHECK(bindings.missing(ActionId::present_lesson) == "there is no lesson");
  has_lesson = true;
  CHECK(bindings.missing(ActionId::present_lesson) == "a file is being read");
  CHECK_FALSE(bindings.is_enabled(ActionId::present_lesson));
  CHECK(bindings.missing(ActionId::next_bundle) == "a file is being read");
  is_running = true;
  CHECK(bindings.is_enabled(ActionId::next_bundle));
  CHECK(bindings.missing(ActionId::next_bundle).empty());
  CHECK_FALSE(bindings.is_enabled(ActionId::present_lesson));
  is_running = is_reading = false;
  CHECK(bindings.is_enabled(ActionId::present_lesson));
  CHECK(bindings.is_enabled(ActionId::next_bundle));
  // The need that was put first is named first.
  bindings.bind(ActionId::undo, {[] {}, condition.after({[&] { return is_running; }, "nothing runs"})});
  has_lesson = false;
  CHECK(bindings.missing(ActionId::undo) == "nothing runs");
  is_running = true;
  CHECK(bindings.missing(ActionId::undo) == "there is no lesson");
}

TEST_CASE("an action that runs out of memory ends there, and the next one runs") {
  ActionBindings bindings;
  int calls = 0;
  int done = 0;
  bindings.bind(ActionId::undo, {[] { throw std::bad_alloc(); }});
  bindings.bind(ActionId::redo, {[&] { ++done; }, {[] { return true; }, "never"}});
  CHECK(bindings.run(ActionId::undo));
  bindings.when_out_of_memory([&] { ++calls; });
  CHECK(bindings.run(ActionId::undo));
  CHECK(bindings.run(ActionId::redo));
  CHECK(calls == 1);
  CHECK(done == 1);
}
