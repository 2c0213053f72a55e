// SPDX-License-Identifier: GPL-3.0-or-later
// The contrast of texts and icons as the screen shows them: of the colours of letters and of what is around them, by the
// contrast ratio of WCAG 2.2.
#include <fmt/core.h>
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "tests/window/window_driver.h"

using namespace mes;
using namespace mes::test;

namespace {

constexpr double kLeastOfText = 4.5;
constexpr double kLeastOfIcon = 3.0;

int packed(Color c) {
  return c.r << 16 | c.g << 8 | c.b;
}

double luminance_of(int color) {
  const auto linear = [](int channel) {
    const double c = channel / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(color >> 16) + 0.7152 * linear(color >> 8 & 255) + 0.0722 * linear(color & 255);
}

double contrast(int a, int b) {
  const auto [dark, light] = std::minmax({luminance_of(a), luminance_of(b)});
  return (light + 0.05) / (dark + 0.05);
}

/// Neighbouring pixels that are no ground: a letter, or part of an icon.
struct Mark {
  PixelBox box;
  int ground = 0;         // the colour around it
  double contrast = 0.0;  // of the pixel that stands out most
  int width() const { return box.right - box.left; }
  int height() const { return box.bottom - box.top; }
};

/// Finds marks in a part of a picture. Ground is what has one colour over an area larger than any stroke of a letter.
class Marks {
 public:
  Marks(const Screenshot& shot, const PixelBox& part, int scale)
      : width_(part.right - part.left),
        height_(part.bottom - part.top),
        color_(cells()),
        is_ground_(cells()),
        is_seen_(cells()) {
    for (int i = 0; i < static_cast<int>(cells()); ++i)
      color_[at(i)] = packed(shot.at(part.left + i % width_, part.top + i / width_));
    find_ground(150 * scale * scale);
    is_seen_.assign(cells(), false);
    for (int i = 0; i < static_cast<int>(cells()); ++i)
      if (!is_ground_[at(i)] && !is_seen_[at(i)]) add_mark(i);
    for (Mark& mark : marks)
      mark.box = {mark.box.left + part.left, mark.box.top + part.top, mark.box.right + part.left,
                  mark.box.bottom + part.top};
  }

  std::vector<Mark> marks;

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  std::size_t cells() const { return at(width_) * at(height_); }

  /// Calls `visit` for the neighbours of a pixel, those across corners last.
  template <class Visit>
  void for_each_neighbour(int i, int count, Visit visit) const {
    constexpr int kX[] = {1, -1, 0, 0, 1, 1, -1, -1};
    constexpr int kY[] = {0, 0, 1, -1, 1, -1, 1, -1};
    for (int k = 0; k < count; ++k) {
      const int x = i % width_ + kX[k];
      const int y = i / width_ + kY[k];
      if (x >= 0 && x < width_ && y >= 0 && y < height_) visit(y * width_ + x);
    }
  }

  void find_ground(int least) {
    for (int start = 0; start < static_cast<int>(cells()); ++start) {
      if (is_seen_[at(start)]) continue;
      std::vector<int> area{start};
      is_seen_[at(start)] = true;
      for (std::size_t next = 0; next < area.size(); ++next)
        for_each_neighbour(area[next], 4, [&](int i) {
          if (is_seen_[at(i)] || color_[at(i)] != color_[at(start)]) return;
          is_seen_[at(i)] = true;
          area.push_back(i);
        });
      if (static_cast<int>(area.size()) < least) continue;
      for (const int i : area) is_ground_[at(i)] = true;
    }
  }

  void add_mark(int start) {
    std::vector<int> pixels{start};
    is_seen_[at(start)] = true;
    std::map<int, int> around;
    Mark mark{{width_, height_, 0, 0}};
    for (std::size_t next = 0; next < pixels.size(); ++next) {
      const int x = pixels[next] % width_;
      const int y = pixels[next] / width_;
      mark.box = {std::min(mark.box.left, x), std::min(mark.box.top, y), std::max(mark.box.right, x + 1),
                  std::max(mark.box.bottom, y + 1)};
      for_each_neighbour(pixels[next], 8, [&](int i) {
        if (is_ground_[at(i)]) {
          ++around[color_[at(i)]];
        } else if (!is_seen_[at(i)]) {
          is_seen_[at(i)] = true;
          pixels.push_back(i);
        }
      });
    }
    if (around.empty()) return;
    mark.ground = std::ranges::max_element(around, {}, [](const auto& entry) { return entry.second; })->first;
    for (const int i : pixels) mark.contrast = std::max(mark.contrast, contrast(color_[at(i)], mark.ground));
    marks.push_back(mark);
  }

  int width_;
  int height_;
  std::vector<int> color_;
  std::vector<bool> is_ground_;
  std::vector<bool> is_seen_;
};

/// Words: three marks or more of the size of letters, beside each other on one ground.
std::vector<Mark> words_in(const Screenshot& shot, const PixelBox& part, int scale) {
  std::vector<Mark> letters = Marks(shot, part, scale).marks;
  std::erase_if(letters, [&](const Mark& mark) { return mark.height() > 15 * scale || mark.width() > 40 * scale; });
  std::ranges::sort(letters, {}, [](const Mark& mark) { return mark.box.left; });
  std::vector<bool> is_used(letters.size());
  std::vector<Mark> out;
  for (std::size_t first = 0; first < letters.size(); ++first) {
    if (is_used[first]) continue;
    Mark word = letters[first];
    int count = 1;
    for (std::size_t i = first + 1; i < letters.size(); ++i) {
      const Mark& next = letters[i];
      if (next.box.left - word.box.right > 4 * scale) break;
      const int shared = std::min(word.box.bottom, next.box.bottom) - std::max(word.box.top, next.box.top);
      const int both = std::max(word.box.bottom, next.box.bottom) - std::min(word.box.top, next.box.top);
      if (is_used[i] || next.ground != word.ground || 2 * shared < next.height() || both > 18 * scale) continue;
      is_used[i] = true;
      ++count;
      word.box = {word.box.left, std::min(word.box.top, next.box.top), std::max(word.box.right, next.box.right),
                  std::max(word.box.bottom, next.box.bottom)};
      word.contrast = std::max(word.contrast, next.contrast);
    }
    if (count >= 3) out.push_back(word);
  }
  return out;
}

void check_words(const Screenshot& shot, const PixelBox& part, int scale, double least, std::size_t expected) {
  const std::vector<Mark> words = words_in(shot, part, scale);
  CHECK(words.size() >= expected);
  for (const Mark& word : words) {
    INFO(fmt::format("word at {},{} to {},{} on #{:06x}", word.box.left, word.box.top, word.box.right,
                     word.box.bottom, static_cast<unsigned>(word.ground)));
    CHECK(word.contrast >= least);
  }
}

void check_icons(const Screenshot& shot, const PixelBox& part, int scale) {
  int count = 0;
  for (const Mark& mark : Marks(shot, part, scale).marks) {
    const int larger = std::max(mark.width(), mark.height());
    if (larger < 9 * scale || larger > 24 * scale || 4 * std::min(mark.width(), mark.height()) < larger) continue;
    ++count;
    INFO(fmt::format("icon at {},{} on #{:06x}", mark.box.left, mark.box.top, static_cast<unsigned>(mark.ground)));
    CHECK(mark.contrast >= kLeastOfIcon);
  }
  CHECK(count >= 5);
}

constexpr PixelBox kWholeScreen{0, 0, 1280, 800};

}  // namespace

TEST_CASE("texts and icons stand out on the screen, in both themes and at both sizes") {
  for (const std::string theme : {"light", "dark"})
    for (const int scale : {1, 2}) {
      DrivenProgram window;
      window.folder.write("house.poff", kHouse);
      std::filesystem::create_directories(window.folder / "config" / "mesecina");
      window.folder.write("config/mesecina/settings.json",
                          fmt::format(R"({{"schema": 1, "theme": "{}", "interface_scale": {}}})", theme, scale));
      window.start("house.poff");
      const auto named = [&](const char* what) { return fmt::format("{}, {} %: {}", theme, 100 * scale, what); };
      {
        INFO(named("panels, layers of which some are empty, status bar"));
        const Screenshot shot = window.screen.settled();
        check_words(shot, kWholeScreen, scale, kLeastOfText, 12);
        check_icons(shot, {0, 24 * scale, 54 * scale, 800}, scale);
        check_icons(shot, {1280 - 42 * scale, 24 * scale, 1280, 800}, scale);
      }
      window.press("ctrl+v");
      {
        INFO(named("problem"));
        check_words(window.screen.settled(), kWholeScreen, scale, kLeastOfText, 12);
      }
      window.press("Escape");
      window.screen.xdotool(fmt::format("mousemove {0} {1}", 31 * scale, 53 * scale));
      {
        INFO(named("tooltip"));
        check_words(window.screen.settled(), kWholeScreen, scale, kLeastOfText, 12);
      }
      window.screen.click({62 * scale, 12 * scale});
      {
        // A disabled entry counts as an icon, as elsewhere.
        INFO(named("menu"));
        check_words(window.screen.settled(), kWholeScreen, scale, kLeastOfIcon, 12);
      }
      window.press("Escape");
      window.press("ctrl+e");
      {
        INFO(named("dialog"));
        check_words(window.screen.settled(), {220, 120, 930, 680}, scale, kLeastOfText, 10);
      }
      window.press("Escape");
      window.press("ctrl+n");
      {
        INFO(named("empty document"));
        check_words(window.screen.settled(), kWholeScreen, scale, kLeastOfText, 12);
      }
    }
}
