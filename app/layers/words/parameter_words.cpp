// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/layers/words/parameter_words.h"

#include <fmt/core.h>
#include <algorithm>
#include <cctype>

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

std::string spoken_explanation(const Parameter& descriptor) {
  if (!descriptor.window_explanation.empty()) return std::string(descriptor.window_explanation);
  std::string out(descriptor.explanation);
  if (!is_switch(descriptor)) return out;
  const bool begins_with_off = out.starts_with("0: ");
  replace(out, begins_with_off ? "0: " : "1: ", begins_with_off ? "Off: " : "On: ");
  replace(out, begins_with_off ? "; 1: " : "; 0: ", begins_with_off ? "; on: " : "; off: ");
  return out;
}

}  // namespace mes
