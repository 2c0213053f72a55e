// SPDX-License-Identifier: GPL-3.0-or-later
// Whatever contours a document is given and whatever is removed and brought back, no sample follows itself on one.
#include <algorithm>
#include <catch2/catch.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "core/base/rng.h"
#include "core/document/commands.h"
#include "core/document/contour_edit.h"
#include "core/document/live_corners.h"

using namespace mes;

namespace {

/// As the definition says, one repetition at a time.
std::vector<SampleId> corners_of(const Document& document, const CurveOrder::Contour& contour) {
  std::vector<SampleId> out = contour.samples;
  std::erase_if(out, [&](SampleId id) { return document.slot_of(id) == kNoSlot; });
  const auto repetition = [&]() -> std::optional<std::size_t> {
    for (std::size_t i = 0; i + 1 < out.size(); ++i)
      if (out[i] == out[i + 1]) return i + 1;
    if (contour.closed && out.size() > 1 && out.back() == out.front()) return out.size() - 1;
    return std::nullopt;
  };
  while (const auto i = repetition()) out.erase(out.begin() + static_cast<std::ptrdiff_t>(*i));
  return out;
}

SampleData data_with_repetitions(Rng& random) {
  SampleData out;
  const std::size_t count = 1 + random.below(8);
  for (std::size_t i = 0; i < count; ++i) out.positions.push_back({static_cast<double>(i), 0.0});
  for (std::uint64_t k = random.below(4); k > 0; --k) {
    SampleData::Contour& contour = out.contours.emplace_back(SampleData::Contour{random.below(2) == 0, {}});
    for (std::uint64_t i = random.below(12); i > 0; --i)
      contour.points.push_back(static_cast<std::uint32_t>(random.below(count)));
  }
  return out;
}

void check(const Document& document) {
  const std::vector<SampleSlot> slots = document.slots_in_input_order();
  std::vector<SampleData::Contour> expected;
  for (const CurveOrder::Contour& contour : document.curve_order()->contours) {
    const std::vector<SampleId> corners = corners_of(document, contour);
    REQUIRE(live_corners(document, contour) == corners);
    SampleData::Contour& out = expected.emplace_back(SampleData::Contour{contour.closed, {}});
    for (const SampleId id : corners)
      out.points.push_back(
          static_cast<std::uint32_t>(std::ranges::find(slots, document.slot_of(id)) - slots.begin()));
    if (corners.empty()) expected.pop_back();
  }
  REQUIRE(data_of(document).contours == expected);
}

}  // namespace

TEST_CASE("no sample follows itself on a contour, whatever is removed and undone") {
  Rng random(17);
  for (int round = 0; round < 300; ++round) {
    Document document;
    document.apply(*replace_all(document, data_with_repetitions(random)));
    check(document);
    std::vector<std::pair<DocumentDelta, std::vector<SampleData::Contour>>> done;  // with what was before
    for (int step = 0; step < 30; ++step) {
      if (random.below(3) == 0 && !done.empty()) {
        document.apply(done.back().first.inverted());
        REQUIRE(data_of(document).contours == done.back().second);
        done.pop_back();
      } else {
        auto before = data_of(document).contours;
        const std::vector<SampleSlot> slots = document.slots_in_input_order();
        std::optional<DocumentDelta> delta;
        if (!slots.empty() && random.below(3) != 0) {
          const SampleId id = document.id(slots[random.below(slots.size())]);
          delta = *remove_samples(document, std::vector{id});
        } else {
          const Vec2 at{static_cast<double>(step), 1.0};
          delta = *insert_samples(document, std::vector{at});
        }
        document.apply(*delta);
        done.emplace_back(*std::move(delta), std::move(before));
      }
      check(document);
    }
    // What was made of it is the same again.
    Document again;
    again.apply(*replace_all(again, data_of(document)));
    REQUIRE(data_of(again).contours == data_of(document).contours);
  }
}

TEST_CASE("a loop that goes to a sample and back has one corner left without it, and cannot be closed") {
  Document document;
  document.apply(
      *replace_all(document, {.positions = {{0, 0}, {1, 0}, {2, 0}}, .contours = {{false, {0, 1, 0, 2}}}}));
  const std::vector<SampleSlot> slots = document.slots_in_input_order();
  const SampleId first = document.id(slots[0]);
  document.apply(*remove_samples(document, std::vector{document.id(slots[1])}));
  CHECK(data_of(document).contours == std::vector<SampleData::Contour>{{false, {0, 1}}});
  // Three places, but two samples.
  CHECK_FALSE(changed_contours(document, ContourChange::close, std::vector{first}));
}

TEST_CASE("a contour may come back to a sample that it has left") {
  Document document;
  const std::vector<SampleData::Contour> eight{{true, {0, 1, 2, 0, 3, 4}}};
  document.apply(
      *replace_all(document, {.positions = {{0, 0}, {1, 1}, {1, -1}, {-1, 1}, {-1, -1}}, .contours = eight}));
  CHECK(data_of(document).contours == eight);
}
