// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <deque>
#include <new>

#include "render/frame_capture.h"
#include "tests/faults/faulty_memory.h"
#include "tests/render/drawing.h"

using namespace mes;
using namespace mes::test;

namespace {

constexpr int kSide = 80;

/// A picture of one colour, alone or in tiles.
Expected<void> ask(render::FrameCapture& capture, Drawing& drawing, Rgb color, int tile) {
  return capture.draw(drawing.scene(), pixel_camera(kSide, kSide), {}, {.background = color, .tile_px = tile});
}

bool is_all(const render::RawImage& raw, Rgb color) {
  if (raw.rgba.size() != std::size_t{4} * kSide * kSide) return false;
  for (std::size_t at = 0; at < raw.rgba.size(); at += 4)
    if (raw.rgba[at] != color.r || raw.rgba[at + 1] != color.g || raw.rgba[at + 2] != color.b) return false;
  return true;
}

}  // namespace

TEST_CASE("whichever allocation fails, each picture that was granted comes once, in order, whole or without pixels") {
  Drawing drawing;
  const std::vector<Rgb> colors{{250, 0, 0}, {0, 250, 0}, {0, 0, 250}, {250, 250, 0}, {0, 250, 250}};
  int lost = 0;
  int refused = 0;
  for (const int tile : {2048, 40}) {
    const int failed = with_each_allocation_failing([&](int call) {
      render::FrameCapture capture(drawing.device());
      std::deque<Rgb> granted;
      bool has_failed = false;
      const auto next_is = [&](Rgb color) {
        const auto raw = capture.wait();
        if (!raw || raw->width != kSide || raw->height != kSide) return false;
        lost += raw->rgba.empty() ? 1 : 0;
        return raw->rgba.empty() || is_all(*raw, color);
      };
      bool are_good = true;
      {
        const FailingMemory failing(call);
        // More than can be under way at once.
        for (const Rgb color : colors) {
          // Messages take memory, too.
          try {
            if (ask(capture, drawing, color, tile)) granted.push_back(color);
          } catch (const std::bad_alloc&) {
            ++refused;
          }
        }
        // Some of them as they come in the midst of others.
        for (; are_good && granted.size() > 2; granted.pop_front()) are_good = next_is(granted.front());
        has_failed = failing.has_failed();
      }
      if (ask(capture, drawing, {9, 9, 9}, tile)) granted.push_back({9, 9, 9});
      REQUIRE(are_good);
      for (const Rgb color : granted) REQUIRE(next_is(color));
      CHECK_FALSE(capture.wait());
      CHECK(capture.pending() == 0);
      return has_failed;
    });
    CHECK(failed > 10);
  }
  CHECK(lost > 0);
}
