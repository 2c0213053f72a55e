// SPDX-License-Identifier: GPL-3.0-or-later
// A key with its modifiers, named by the character that it types on the user's keyboard, never by its position.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace mes {

struct Modifiers {
  bool ctrl = false;
  bool shift = false;
  bool alt = false;
  friend constexpr bool operator==(Modifiers, Modifiers) = default;
};

/// Keys without a printed character have values above every Unicode code point.
namespace key {
inline constexpr char32_t named = 0x200000;
inline constexpr char32_t escape = named + 1;
inline constexpr char32_t enter = named + 2;
inline constexpr char32_t tab = named + 3;
inline constexpr char32_t backspace = named + 4;
inline constexpr char32_t del = named + 5;
inline constexpr char32_t home = named + 6;
inline constexpr char32_t end = named + 7;
inline constexpr char32_t left = named + 8;
inline constexpr char32_t right = named + 9;
inline constexpr char32_t up = named + 10;
inline constexpr char32_t down = named + 11;
inline constexpr char32_t page_up = named + 12;
inline constexpr char32_t page_down = named + 13;
inline constexpr char32_t menu = named + 14;
inline constexpr char32_t f1 = named + 101;  ///< F2 .. F12 follow
}  // namespace key

/// Guarantees:
///  1. `symbol` is an upper-case letter, a digit, another printable character, or one of `key::`.
///  2. A character such as `+` or `?` that is typed without Ctrl or Alt carries no Shift, because the layer of the
///     keyboard on which it lies differs from country to country.
///  3. `parse_chord(to_string(c)) == c`.
struct KeyChord {
  char32_t symbol = 0;
  Modifiers modifiers{};
  friend constexpr bool operator==(KeyChord, KeyChord) = default;
};

/// True for characters that are matched as typed text (guarantee 2).
bool is_typed_symbol(const KeyChord& chord);

/// Reads "Ctrl+Shift+Z", "F1", "?" or "+". Returns nothing when the text is not a chord.
std::optional<KeyChord> parse_chord(std::string_view text);
std::string to_string(const KeyChord& chord);

}  // namespace mes
