// SPDX-License-Identifier: GPL-3.0-or-later
// Which keys do what: those of the table of actions, those of the Mesecina of 2007, or those of a file.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/actions/actions.h"

namespace mes {

/// What it guarantees: a key does one thing, given whether anything is selected; what is given to one action is taken
/// from the others.
///
/// Smallest use:
///     const KeymapFile read = read_keymap(Keymap::standard(), "spray = D\nundo = Ctrl+Z Alt+Backspace\n");
///     read.keymap.find(*parse_chord("D"), false);   // tool-spray
class Keymap {
 public:
  /// The keys of the table.
  static Keymap standard();
  /// The same with the keys that the Mesecina of 2007 to 2009 had.
  static Keymap classic();

  /// In their one spelling; the first one is shown in menus.
  const std::vector<std::string>& keys_of(ActionId id) const { return keys_[static_cast<std::size_t>(id)]; }
  /// The first of them, or nothing.
  std::string key_of(ActionId id) const;
  /// The action of a key.
  std::optional<ActionId> find(const KeyChord& chord, bool has_selection) const;
  /// Gives the action these keys in place of its own. O(actions).
  void give(ActionId id, const std::vector<KeyChord>& chords);

 private:
  std::vector<std::vector<std::string>> keys_;
  std::vector<std::vector<KeyChord>> chords_;
};

struct KeymapFile {
  Keymap keymap;
  /// What is wrong, "line 3: ...", in the order of the lines. Those lines have no effect; all others have.
  std::vector<std::string> problems;
};

/// Lines `ID = KEY KEY...`, where nothing behind the sign takes all keys away; what follows `#` at the beginning of a
/// line or after a space is a remark. Letters of keys and the order of modifiers are free. Cost: O(text).
KeymapFile read_keymap(Keymap keymap, std::string_view text);

/// A file for `read_keymap` that changes nothing: every action with its name and keys, as remarks.
std::string keymap_template(const Keymap& keymap);

}  // namespace mes
