// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <map>

#include "app/actions/keymap.h"

using namespace mes;

namespace {

std::optional<ActionId> action_of(const Keymap& keymap, const char* key, bool has_selection = false) {
  const auto chord = parse_chord(key);
  REQUIRE(chord);
  return keymap.find(*chord, has_selection);
}

void check_that_no_keys_compete(const Keymap& keymap) {
  for (const bool has_selection : {false, true}) {
    std::map<std::string, std::string> owner;
    for (const ActionDescriptor& action : action_descriptors()) {
      if (action.context == ActionContext::with_selection && !has_selection) continue;
      for (const std::string& key : keymap.keys_of(action.id)) {
        INFO(key << " of " << action.public_id);
        CHECK(owner.emplace(key, action.public_id).second);
        CHECK(action_of(keymap, key.c_str(), has_selection) == action.id);
      }
    }
  }
}

}  // namespace

TEST_CASE("the keys of the table and those of 2007 each do one thing") {
  check_that_no_keys_compete(Keymap::standard());
  const Keymap classic = Keymap::classic();
  check_that_no_keys_compete(classic);
  CHECK(action_of(classic, "Ctrl+L") == ActionId::open);
  CHECK(action_of(classic, "Ctrl+A") == ActionId::save_as);
  CHECK(action_of(classic, "Ctrl+X") == ActionId::quit);
  CHECK(action_of(classic, "Ctrl+W") == ActionId::toggle_statistics);
  CHECK(action_of(classic, "Ctrl+E") == ActionId::toggle_parameters);
  CHECK(action_of(classic, "Ctrl+Up") == ActionId::evolution_next);
  CHECK(action_of(classic, "Ctrl+Down") == ActionId::evolution_previous);
  CHECK(action_of(classic, "F4") == ActionId::record);
  // What lost its key has another one.
  for (const ActionDescriptor& action : action_descriptors())
    CHECK(classic.keys_of(action.id).empty() == Keymap::standard().keys_of(action.id).empty());
}

TEST_CASE("a line gives a command its keys, takes them from others, and leaves the rest") {
  const KeymapFile read = read_keymap(Keymap::standard(),
                                      "# mine\r\n"
                                      "tool-spray = d Shift+CTRL+pageup   # two\r\n"
                                      "\n"
                                      "undo=Alt+backspace\n"
                                      "redo = \n"
                                      "zoom-in = + #");
  CHECK(read.problems.empty());
  const Keymap& keymap = read.keymap;
  check_that_no_keys_compete(keymap);
  CHECK(keymap.keys_of(ActionId::tool_spray) == std::vector<std::string>{"D", "Ctrl+Shift+PageUp"});
  CHECK(action_of(keymap, "D") == ActionId::tool_spray);
  CHECK_FALSE(action_of(keymap, "S"));
  CHECK(action_of(keymap, "Alt+Backspace") == ActionId::undo);
  CHECK_FALSE(action_of(keymap, "Ctrl+Z"));
  CHECK(keymap.keys_of(ActionId::redo).empty());
  CHECK(keymap.key_of(ActionId::redo).empty());
  CHECK(action_of(keymap, "I") == ActionId::tool_insert);
  const KeymapFile stolen = read_keymap(Keymap::standard(), "help = V #\ntoggle-log = #\n");
  CHECK(stolen.problems.empty());
  CHECK(action_of(stolen.keymap, "V") == ActionId::help);
  CHECK(stolen.keymap.keys_of(ActionId::tool_select).empty());
}

TEST_CASE("what is wrong is named with its line, and only that has no effect") {
  const KeymapFile read = read_keymap(Keymap::standard(),
                                      "undo = Ctrl+U\n"
                                      "undoo = X\n"
                                      "redo = Ctrl+Ctrl+U Hyper+X Ctrl+R\n"
                                      "just words\n"
                                      "fit all = F\n"
                                      "undo = Ctrl+Z\n"
                                      "fit = Ctrl+U G Ctrl+U\n"
                                      "help = Fn\n");
  const auto begins = [&](std::size_t i, const std::string& with) {
    REQUIRE(read.problems.size() > i);
    INFO(read.problems[i]);
    CHECK(read.problems[i].starts_with(with));
  };
  begins(0, "line 2: no command has the id \"undoo\"");
  begins(1, "line 3: \"Ctrl+Ctrl+U\" is not a key");
  begins(2, "line 3: \"Hyper+X\" is not a key");
  begins(3, "line 4: expects");
  begins(4, "line 5: expects the id");
  begins(5, "line 6: undo has its keys from line 1 already");
  begins(6, "line 7: Ctrl+U is given away in line 1 already");
  begins(7, "line 8: \"Fn\" is not a key");
  CHECK(read.problems.size() == 8);
  CHECK(action_of(read.keymap, "Ctrl+U") == ActionId::undo);
  CHECK(action_of(read.keymap, "Ctrl+R") == ActionId::redo);
  CHECK(action_of(read.keymap, "G") == ActionId::fit);
  // A line without one good key takes none away.
  CHECK(action_of(read.keymap, "F1") == ActionId::help);
}

TEST_CASE("the file that is written changes nothing, and says every key when its signs are taken off") {
  for (const Keymap& keymap : {Keymap::standard(), Keymap::classic()}) {
    const std::string text = keymap_template(keymap);
    const KeymapFile unchanged = read_keymap(keymap, text);
    CHECK(unchanged.problems.empty());
    std::string freed;
    for (std::size_t at = 0; at < text.size();) {
      const std::size_t end = text.find('\n', at);
      const std::string line = text.substr(at, end - at);
      freed += (line.starts_with("#") && !line.starts_with("# ") && line != "#" ? line.substr(1) : line) + '\n';
      at = end + 1;
    }
    const KeymapFile read = read_keymap(Keymap::standard(), freed);
    for (const std::string& problem : read.problems) CHECK(problem.empty());
    for (const ActionDescriptor& action : action_descriptors()) {
      INFO(action.public_id);
      CHECK(unchanged.keymap.keys_of(action.id) == keymap.keys_of(action.id));
      CHECK(read.keymap.keys_of(action.id) == keymap.keys_of(action.id));
    }
  }
}
