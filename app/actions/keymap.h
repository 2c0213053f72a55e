// SPDX-License-Identifier: GPL-3.0-or-later
// A mapping from keys to actions: the default keys of the table, those of the Mesecina of 2007, or those of a file.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "app/actions/actions.h"

namespace mes {

/// Guarantees: given whether anything is selected, a key has one action; giving a key to one action takes it from the
/// others.
///
/// Smallest use:
///     const KeymapFile read = read_keymap(Keymap::standard(), "spray = D\nundo = Ctrl+Z Alt+Backspace\n");
///     read.keymap.find(*parse_chord("D"), false);   // tool-spray
class Keymap {
 public:
  /// The default keys of the table.
  static Keymap standard();
  /// The same, with the keys of the Mesecina of 2007 to 2009 where they differ.
  static Keymap classic();

  /// The keys in their canonical spelling; menus show the first one.
  const std::vector<std::string>& keys_of(ActionId id) const { return keys_[static_cast<std::size_t>(id)]; }
  /// The first key of the action, or nothing.
  std::string key_of(ActionId id) const;
  /// The action of a key, or nothing.
  std::optional<ActionId> find(const KeyChord& chord, bool has_selection) const;
  /// Replaces the keys of the action by these. O(actions).
  void give(ActionId id, const std::vector<KeyChord>& chords);

 private:
  std::vector<std::vector<std::string>> keys_;
  std::vector<std::vector<KeyChord>> chords_;
};

struct KeymapFile {
  Keymap keymap;
  /// Messages such as "line 3: ...", in the order of the lines. Lines with a problem have no effect; all others do.
  std::vector<std::string> problems;
};

/// Reads lines `ID = KEY KEY...`. A line with nothing after the sign takes all keys away from the action; `#` at the
/// beginning of a line or after a space starts a remark. Key letters may have either case, modifiers any order.
/// O(text).
KeymapFile read_keymap(Keymap keymap, std::string_view text);

/// A file for `read_keymap` that changes nothing: it lists every action with its name and keys in remarks.
std::string keymap_template(const Keymap& keymap);

}  // namespace mes
