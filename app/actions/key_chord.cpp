// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/actions/key_chord.h"

#include <fmt/core.h>
#include <array>
#include <utility>

namespace mes {
namespace {

constexpr std::array<std::pair<std::string_view, char32_t>, 15> kNamedKeys{{{"Esc", key::escape},
                                                                            {"Enter", key::enter},
                                                                            {"Tab", key::tab},
                                                                            {"Backspace", key::backspace},
                                                                            {"Delete", key::del},
                                                                            {"Home", key::home},
                                                                            {"End", key::end},
                                                                            {"Left", key::left},
                                                                            {"Right", key::right},
                                                                            {"Up", key::up},
                                                                            {"Down", key::down},
                                                                            {"PageUp", key::page_up},
                                                                            {"PageDown", key::page_down},
                                                                            {"Menu", key::menu},
                                                                            {"Space", U' '}}};

bool is_letter_or_digit(char32_t symbol) {
  return (symbol >= U'A' && symbol <= U'Z') || (symbol >= U'0' && symbol <= U'9');
}

std::optional<char32_t> parse_symbol(std::string_view text) {
  if (text.size() == 1 && text[0] > ' ' && text[0] <= '~') {
    const char c = text[0];
    if (c >= 'a' && c <= 'z') return std::nullopt;  // one spelling only
    return static_cast<char32_t>(c);
  }
  for (const auto& [name, symbol] : kNamedKeys)
    if (name == text) return symbol;
  if (text.size() >= 2 && text.size() <= 3 && text[0] == 'F') {
    unsigned number = 0;
    for (const char c : text.substr(1)) {
      if (c < '0' || c > '9') return std::nullopt;
      number = number * 10 + static_cast<unsigned>(c - '0');
    }
    if (number >= 1 && number <= 12) return key::f1 + number - 1;
  }
  return std::nullopt;
}

}  // namespace

bool is_typed_symbol(const KeyChord& chord) {
  return chord.symbol > U' ' && chord.symbol < key::named && !is_letter_or_digit(chord.symbol) &&
         !chord.modifiers.ctrl && !chord.modifiers.alt;
}

std::optional<KeyChord> parse_chord(std::string_view text) {
  KeyChord chord;
  const auto take = [&text](std::string_view prefix) {
    if (!text.starts_with(prefix)) return false;
    text.remove_prefix(prefix.size());
    return true;
  };
  chord.modifiers.ctrl = take("Ctrl+");
  chord.modifiers.alt = take("Alt+");
  chord.modifiers.shift = take("Shift+");
  const auto symbol = parse_symbol(text);
  if (!symbol) return std::nullopt;
  chord.symbol = *symbol;
  if (is_typed_symbol(chord) && chord.modifiers.shift) return std::nullopt;
  return chord;
}

std::string to_string(const KeyChord& chord) {
  std::string out;
  if (chord.modifiers.ctrl) out += "Ctrl+";
  if (chord.modifiers.alt) out += "Alt+";
  if (chord.modifiers.shift) out += "Shift+";
  for (const auto& [name, symbol] : kNamedKeys)
    if (symbol == chord.symbol) return out + std::string(name);
  if (chord.symbol >= key::f1) return fmt::format("{}F{}", out, static_cast<unsigned>(chord.symbol - key::f1) + 1);
  return out + static_cast<char>(chord.symbol);
}

}  // namespace mes
