// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/layers/words/parameter_words.h"

#include <fmt/core.h>
#include <algorithm>
#include <cctype>
#include <utility>

namespace mes {
namespace {

std::string spaced(std::string_view id) {
  std::string out(id);
  std::ranges::replace(out, '-', ' ');
  return out;
}

void replace(std::string& text, std::string_view what, std::string_view by) {
  if (const std::size_t at = text.find(what); at != std::string::npos) text.replace(at, what.size(), by);
}

}  // namespace

std::string title_of(const Parameter& descriptor) {
  if (!descriptor.title.empty()) return std::string(descriptor.title);
  std::string out = spaced(descriptor.id);
  if (!out.empty()) out[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(out[0])));
  return out;
}

std::string beyond_words(const std::string& title, double number, double low, double high) {
  return number < low ? fmt::format("{}: {} is below {}, which is taken instead", title, number, low)
                      : fmt::format("{}: {} is above {}, which is taken instead", title, number, high);
}

std::string with_titles(std::string text) {
  const auto is_of_id = [](char c) { return c == '-' || std::isalnum(static_cast<unsigned char>(c)) != 0; };
  for (std::size_t begin = 0; begin < text.size(); ++begin) {
    if (!is_of_id(text[begin])) continue;
    std::size_t end = begin;
    while (end < text.size() && is_of_id(text[end])) ++end;
    const std::string word = text.substr(begin, end - begin);
    const auto parameters = computation_parameters();
    const auto found = std::ranges::find(parameters, word, &Parameter::id);
    if (word.contains('-') && found != parameters.end()) {
      const std::string title = '"' + title_of(*found) + '"';
      text.replace(begin, word.size(), title);
      end = begin + title.size();
    }
    begin = end;
  }
  return text;
}

std::string spoken_explanation(const Parameter& descriptor) {
  if (!descriptor.window_explanation.empty()) return with_titles(descriptor.window_explanation);
  std::string out(descriptor.explanation);
  if (!is_switch(descriptor)) return with_titles(std::move(out));
  const bool begins_with_off = out.starts_with("0: ");
  replace(out, begins_with_off ? "0: " : "1: ", begins_with_off ? "Off: " : "On: ");
  replace(out, begins_with_off ? "; 1: " : "; 0: ", begins_with_off ? "; on: " : "; off: ");
  return with_titles(std::move(out));
}

}  // namespace mes
