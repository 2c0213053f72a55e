// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/lessons/lesson_captions.h"

#include <fmt/core.h>
#include <cmath>
#include <cstdint>

#include "app/picture/paper/caption_text.h"
#include "app/playing/lesson_walk.h"

namespace mes {
namespace {

std::string time_text(double seconds) {
  const auto all = static_cast<std::uint64_t>(std::llround(1000.0 * seconds));
  return fmt::format("{:02}:{:02}:{:02}.{:03}", all / 3'600'000, all / 60'000 % 60, all / 1000 % 60, all % 1000);
}

std::string escaped(const std::string& text) {
  std::string out;
  for (const char c : text) switch (c) {
      case '&': out += "&amp;"; break;
      case '<': out += "&lt;"; break;
      case '>': out += "&gt;"; break;
      default: out += c;
    }
  return out;
}

}  // namespace

std::string web_vtt_of(const Lesson& lesson, std::span<const std::size_t> steps) {
  std::string out = "WEBVTT\n";
  double begin = 0.0;
  for (const std::size_t i : steps) {
    const double end = begin + seconds_of(lesson.steps[i]);
    std::string words;
    for (const CaptionBlock& block : caption_text(lesson.steps[i].caption)) {
      const std::string line = escaped(plain_text(block));
      if (line.find_first_not_of(' ') == std::string::npos) continue;
      const bool is_heading = block.kind == CaptionBlock::Kind::heading;
      const bool is_item = block.kind == CaptionBlock::Kind::item;
      words += is_heading ? "<b>" + line + "</b>\n" : (is_item ? "- " : "") + line + '\n';
    }
    if (!words.empty()) out += fmt::format("\n{}\n{} --> {}\n{}", i + 1, time_text(begin), time_text(end), words);
    begin = end;
  }
  return out;
}

}  // namespace mes
