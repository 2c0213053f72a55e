// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions/keymap.h"

#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

#include "core/base/lower_case.h"

namespace mes {
namespace {

// Keys from the shortcuts and the manual of the program of 2007 to 2009. Its Load is our Open, its Export our Save
// as, its settings our parameters, and its full screen our view without panels. A present function whose key is taken
// here keeps a second key. Up and Down are swapped because the list of evolutions ran the other way round.
struct ClassicKeys {
  ActionId id;
  std::string_view keys;
};
constexpr auto kClassic = std::to_array<ClassicKeys>({
    {ActionId::open, "Ctrl+L Ctrl+O"},
    {ActionId::save_as, "Ctrl+A Ctrl+Shift+S"},
    {ActionId::quit, "Ctrl+X Ctrl+Q"},
    {ActionId::snapshot, "F3 Ctrl+I"},
    {ActionId::toggle_statistics, "Ctrl+W T"},
    {ActionId::toggle_parameters, "Ctrl+E P"},
    {ActionId::toggle_panels, "Ctrl+F Tab"},
    {ActionId::evolution_next, "Ctrl+Up"},
    {ActionId::evolution_previous, "Ctrl+Down"},
    {ActionId::help, "F1 ?"},
    {ActionId::export_figure, "Ctrl+Shift+E"},
    {ActionId::select_all, "Ctrl+Shift+A"},
    {ActionId::cut, "Ctrl+Shift+X"},
    {ActionId::invert_selection, "Ctrl+Shift+I"},
});

constexpr std::string_view kBlank = " \t\r";

std::vector<std::string_view> words_of(std::string_view text) {
  std::vector<std::string_view> out;
  for (;;) {
    const std::size_t begin = text.find_first_not_of(kBlank);
    if (begin == std::string_view::npos) return out;
    text.remove_prefix(begin);
    out.push_back(text.substr(0, text.find_first_of(kBlank)));
    text.remove_prefix(out.back().size());
  }
}

std::string_view without_remark(std::string_view line) {
  for (std::size_t at = line.find('#'); at != std::string_view::npos; at = line.find('#', at + 1))
    if (at == 0 || kBlank.find(line[at - 1]) != std::string_view::npos) {
      // "#" alone after the sign is a key.
      const std::string_view before = line.substr(0, at);
      const std::size_t last = before.find_last_not_of(kBlank);
      const bool is_key = last != std::string_view::npos && before[last] == '=' &&
                          line.find_first_not_of(kBlank, at + 1) == std::string_view::npos;
      if (!is_key) return before;
    }
  return line;
}

// Parses a chord in any spelling, e.g. "ctrl+alt+pageup".
std::optional<KeyChord> chord_of(std::string_view word) {
  bool ctrl = false;
  bool alt = false;
  bool shift = false;
  for (;;) {
    const std::size_t plus = word.find('+');
    if (plus == std::string_view::npos || plus == 0 || plus + 1 == word.size()) break;
    const std::string modifier = lower_case(word.substr(0, plus));
    bool& held = modifier == "ctrl" ? ctrl : modifier == "alt" ? alt : shift;
    if ((modifier != "ctrl" && modifier != "alt" && modifier != "shift") || held) return std::nullopt;
    held = true;
    word.remove_prefix(plus + 1);
  }
  std::string key = lower_case(word);
  if (!key.empty() && key.front() >= 'a' && key.front() <= 'z')
    key.front() = static_cast<char>(key.front() - 'a' + 'A');
  if (key == "Escape") key = "Esc";
  if (key == "Return") key = "Enter";
  if (key == "Pageup") key = "PageUp";
  if (key == "Pagedown") key = "PageDown";
  const std::string held = std::string(ctrl ? "Ctrl+" : "") + (alt ? "Alt+" : "") + (shift ? "Shift+" : "");
  return parse_chord(held + key);
}

std::optional<ActionId> action_of(std::string_view public_id) {
  for (const ActionDescriptor& action : action_descriptors())
    if (action.public_id == public_id) return action.id;
  return std::nullopt;
}

std::vector<KeyChord> chords_of(std::string_view keys) {
  std::vector<KeyChord> out;
  for (const std::string_view word : words_of(keys))
    if (const auto chord = parse_chord(word)) out.push_back(*chord);
  return out;
}

/// Reads a keymap file line by line.
class Reader {
 public:
  explicit Reader(Keymap keymap) { file_.keymap = std::move(keymap); }

  void read(std::string_view line) {
    ++number_;
    line = without_remark(line);
    const auto words = words_of(line);
    if (words.empty()) return;
    const std::size_t sign = line.find('=');
    if (sign == std::string_view::npos) return complain("expects COMMAND = KEY KEY...");
    const auto names = words_of(line.substr(0, sign));
    if (names.size() != 1) return complain("expects the id of one command before the sign");
    const auto id = action_of(names.front());
    if (!id) return complain(fmt::format("no command has the id \"{}\"", names.front()));
    if (!lines_.emplace(*id, number_).second)
      return complain(fmt::format("{} has its keys from line {} already", names.front(), lines_[*id]));
    std::vector<KeyChord> chords;
    std::set<std::string_view> seen;
    for (const std::string_view word : words_of(line.substr(sign + 1))) {
      if (!seen.insert(word).second) continue;
      const auto chord = chord_of(word);
      if (!chord)
        complain(fmt::format("\"{}\" is not a key; keys are written as Ctrl+Shift+Z, F5, PageUp, +", word));
      else if (const auto owner = given_.find(to_string(*chord)); owner != given_.end() && owner->second != number_)
        complain(fmt::format("{} is given away in line {} already", to_string(*chord), owner->second));
      else if (given_.emplace(to_string(*chord), number_).second)
        chords.push_back(*chord);
    }
    // A line without a usable key takes no keys away.
    if (!chords.empty() || words_of(line.substr(sign + 1)).empty()) file_.keymap.give(*id, chords);
  }
  KeymapFile take() { return std::move(file_); }

 private:
  void complain(const std::string& what) { file_.problems.push_back(fmt::format("line {}: {}", number_, what)); }

  KeymapFile file_;
  int number_ = 0;
  std::map<ActionId, int> lines_;
  std::map<std::string, int> given_;
};

}  // namespace

Keymap Keymap::standard() {
  Keymap out;
  for (const ActionDescriptor& action : action_descriptors()) {
    std::vector<std::string> keys(action.keys.begin(), action.keys.end());
    std::vector<KeyChord> chords;
    for (const std::string& key : keys)
      if (const auto chord = parse_chord(key)) chords.push_back(*chord);
    out.keys_.push_back(std::move(keys));
    out.chords_.push_back(std::move(chords));
  }
  return out;
}

Keymap Keymap::classic() {
  Keymap out = standard();
  for (const ClassicKeys& row : kClassic) out.give(row.id, {});
  for (const ClassicKeys& row : kClassic) out.give(row.id, chords_of(row.keys));
  return out;
}

std::string Keymap::key_of(ActionId id) const {
  return keys_of(id).empty() ? std::string() : keys_of(id).front();
}

std::optional<ActionId> Keymap::find(const KeyChord& chord, bool has_selection) const {
  for (const ActionDescriptor& action : action_descriptors()) {
    if (action.context == ActionContext::with_selection && !has_selection) continue;
    if (std::ranges::count(chords_[static_cast<std::size_t>(action.id)], chord) != 0) return action.id;
  }
  return std::nullopt;
}

void Keymap::give(ActionId id, const std::vector<KeyChord>& chords) {
  const auto at = static_cast<std::size_t>(id);
  keys_[at].clear();
  chords_[at].clear();
  for (const KeyChord& chord : chords) {
    for (std::size_t i = 0; i < chords_.size(); ++i) {
      std::erase(chords_[i], chord);
      std::erase(keys_[i], to_string(chord));
    }
    chords_[at].push_back(chord);
    keys_[at].push_back(to_string(chord));
  }
}

KeymapFile read_keymap(Keymap keymap, std::string_view text) {
  Reader reader(std::move(keymap));
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    reader.read(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return reader.take();
}

std::string keymap_template(const Keymap& keymap) {
  std::string out =
      "# Keys of Mesecina. A line gives a command its keys:\n"
      "#\n"
      "#     tool-spray = D Ctrl+Shift+D\n"
      "#\n"
      "# Nothing after the sign takes all keys away. A key that is given to one command is taken from the others.\n"
      "# What is not said here stays as it is. The file is read when the program starts, and\n"
      "# again by Help > Write or reread the file of keys.\n";
  ActionGroup group = ActionGroup::help;
  for (const ActionDescriptor& action : action_descriptors()) {
    if (action.group != group || out.ends_with("keys.\n")) out += fmt::format("\n# {}\n", title_of(action.group));
    group = action.group;
    std::string keys;
    for (const std::string& key : keymap.keys_of(action.id)) keys += ' ' + key;
    out += fmt::format("#{} ={}{}# {}\n", action.public_id, keys, keys.empty() ? " " : "  ", action.name);
  }
  return out;
}

}  // namespace mes
