// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <limits>

#include "core/base/rng.h"
#include "core/document/timeline/timeline.h"

using namespace mes;

namespace {

double some_number(Rng& random) {
  switch (random.below(6)) {
    case 0: return -0.0;
    case 1: return std::numeric_limits<double>::denorm_min();
    case 2: return -std::numeric_limits<double>::max();
    default: return static_cast<double>(random.next()) * 0x1p-60;
  }
}

Vec2 some_place(Rng& random) {
  return {some_number(random), some_number(random)};
}

std::uint32_t some_count(Rng& random) {
  return static_cast<std::uint32_t>(random.next() >> (32 + random.below(32)));
}

std::string some_text(Rng& random) {
  std::string out(random.below(random.below(50) == 0 ? 300'000 : 30), ' ');
  for (char& c : out) c = static_cast<char>(random.below(256));
  return out;
}

LayerStyle some_style(Rng& random) {
  if (random.below(2) == 0) return {};
  LayerStyle out;
  out.color = {static_cast<std::uint8_t>(random.below(256)), 0, 255};
  out.opacity = some_number(random);
  out.dashed = random.below(2) == 0;
  out.color_map = some_text(random);
  out.range_low = some_number(random);
  out.thin_when_dense = random.below(2) == 0;
  return out;
}

TimelineEdit some_edit(Rng& random) {
  TimelineEdit out;
  out.name = some_text(random);
  out.continues = random.below(2) == 0;
  out.replaces = random.below(2) == 0;
  out.is_state = random.below(2) == 0;
  const auto many = [&](auto add) {
    for (std::uint64_t n = random.below(4); n > 0; --n) add();
  };
  many([&] { out.removed.push_back(some_count(random)); });
  many([&] { out.moved.emplace_back(some_count(random), some_place(random)); });
  many([&] { out.inserted.push_back(some_place(random)); });
  many([&] { out.removed_balls.push_back(some_count(random)); });
  many([&] { out.changed_balls.push_back({some_count(random), {some_place(random), some_number(random)}}); });
  many([&] { out.inserted_balls.push_back({some_place(random), some_number(random)}); });
  if (random.below(3) == 0) {
    out.annotations.emplace();
    many([&] {
      out.annotations->push_back({static_cast<AnnotationKind>(random.below(kAnnotationKinds)),
                                  some_text(random),
                                  {{some_place(random), {some_count(random)}}, {some_place(random), {}}},
                                  some_place(random),
                                  some_number(random),
                                  random.below(2) == 0 ? std::optional(Rgb{1, 2, 3}) : std::nullopt,
                                  {{PrimitiveKind::disk, ProvenanceRole::product, some_number(random)}}});
    });
  }
  if (random.below(3) == 0) out.curve = {{true, {some_count(random), 0}}, {false, {}}};
  return out;
}

TimelineEntry some_entry(Rng& random) {
  switch (random.below(std::variant_size_v<TimelineEntry>)) {
    case 0: return some_edit(random);
    case 1: return GestureBegun{some_text(random)};
    case 2: return GestureEnded{};
    case 3: return Undone{};
    case 4: return Redone{};
    case 5:
      return LayersChanged{
          {{some_text(random), random.below(2) == 0, some_style(random)}},
          {some_text(random), some_text(random)},
          random.below(2) == 0 ? std::optional(BackgroundImage{some_text(random), {1, 2}, 3}) : std::nullopt};
    case 6: {
      SettingsChanged out;
      if (random.below(2) == 0) out.settings.precision = Precision::exact;
      if (random.below(2) == 0)
        out.settings[computation_parameters()[random.below(computation_parameters().size())]] = some_number(random);
      if (random.below(4) == 0) out.settings.values.keep("not-known-here", some_number(random));
      return out;
    }
    case 7: {
      ViewChanged out;
      if (random.below(2) == 0) out.visible.add(some_place(random));
      return out;
    }
    default: return Captioned{some_text(random), some_number(random)};
  }
}

bool same(const TimelineLog& log, const std::vector<TimelineEntry>& entries) {
  if (log.size() != entries.size() || log != TimelineLog(entries)) return false;
  std::size_t i = 0;
  for (const TimelineEntry& entry : log)
    if (entry != entries[i++]) return false;
  return i == entries.size();
}

}  // namespace

TEST_CASE("entries come out of a timeline as they went in, whatever happens to their neighbours") {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    Rng random(seed);
    TimelineLog log;
    std::vector<TimelineEntry> expected;
    for (int step = 0; step < 400; ++step) {
      const TimelineEntry entry = some_entry(random);
      switch (expected.empty() ? 0 : random.below(8)) {
        case 0:
          expected.push_back(entry);
          log.push_back(entry);
          break;
        case 1:
          expected.pop_back();
          log.pop_back();
          break;
        case 2:
          expected.back() = entry;
          log.replace_back(entry);
          break;
        case 3: {
          const std::size_t at = expected.size() - 1 - random.below(std::min<std::size_t>(expected.size(), 5));
          expected.erase(expected.begin() + static_cast<std::ptrdiff_t>(at));
          log.erase(at);
          break;
        }
        default: expected.push_back(entry); log.emplace_back(entry);
      }
      if (!expected.empty()) REQUIRE(log.back() == expected.back());
    }
    REQUIRE(same(log, expected));
    TimelineLog copy = log;
    copy.push_back(Undone{});
    CHECK(copy != log);
    CHECK(same(log, expected));
    const std::size_t half = expected.size() / 2;
    CHECK(log.between(half, expected.size()) ==
          std::vector<TimelineEntry>(expected.begin() + static_cast<std::ptrdiff_t>(half), expected.end()));
  }
}
