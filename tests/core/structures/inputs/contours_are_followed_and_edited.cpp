// SPDX-License-Identifier: GPL-3.0-or-later
// Links of contours follow the samples as if made anew; joining, cutting, closing, opening and turning around do what
// they say.
#include <algorithm>
#include <catch2/catch.hpp>
#include <memory>
#include <set>
#include <string>
#include <vector>

#include "core/base/rng.h"
#include "core/document/contour_edit.h"
#include "core/graph/explain.h"
#include "core/structures/inputs/contours.h"
#include "tests/support/workbench.h"

using namespace mes;
using namespace mes::test;

namespace {

// The links of each contour by the ids of their samples, as the definition says: no row, no list.
std::vector<std::pair<std::uint32_t, std::uint32_t>> links_of(const Document& document) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> out;
  for (const CurveOrder::Contour& contour : document.curve_order()->contours) {
    std::vector<std::uint32_t> alive;
    for (const SampleId id : contour.samples)
      if (document.slot_of(id) != kNoSlot) alive.push_back(id.value);
    alive.erase(std::ranges::unique(alive).begin(), alive.end());
    if (contour.closed && alive.size() > 1 && alive.front() == alive.back()) alive.pop_back();
    for (std::size_t i = 0; i + 1 < alive.size(); ++i) out.emplace_back(alive[i], alive[i + 1]);
    if (contour.closed && alive.size() > 2) out.emplace_back(alive.back(), alive.front());
  }
  std::ranges::sort(out);
  return out;
}

struct Desk {
  Document document;
  Samples samples;
  Contours contours{samples};
  JobControl job;
  std::set<ContourSlot> linked;  // as the change sets say

  explicit Desk(const SampleData& data) {
    post(*replace_all(document, data));
    samples.rebuild(job);
    rebuild();
  }
  void rebuild() {
    contours.rebuild(job);
    linked.clear();
    for (const ContourSlot row : slots_below<ContourSlot>(contours.row_count()))
      if (contours.has_link(row)) linked.insert(row);
  }
  void post(const DocumentDelta& delta) {
    document.apply(delta);
    samples.post(std::make_shared<const DocumentDelta>(delta));
  }
  void run() {
    if (!samples.update(job)) samples.rebuild(job);
    if (samples.touched() != 0) {
      if (contours.update(job)) {
        for (const ContourSlot row : contours.changes().removed) REQUIRE(linked.erase(row) == 1);
        for (const ContourSlot row : contours.changes().touched) linked.insert(row);
      } else {
        rebuild();
      }
    }
    samples.clear_changes();
  }
  std::vector<std::pair<std::uint32_t, std::uint32_t>> links() const {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> out;
    for (const ContourSlot row : slots_below<ContourSlot>(contours.row_count())) {
      REQUIRE(contours.has_link(row) == linked.contains(row));
      if (!contours.has_link(row)) continue;
      const auto [from, to] = contours.link(row);
      out.emplace_back(samples.id(from).value, samples.id(to).value);
    }
    std::ranges::sort(out);
    return out;
  }
  void check() const { REQUIRE(links() == links_of(document)); }
};

// Samples of 0 to count - 1, at any places.
SampleData with_contours_of(std::size_t count, std::vector<SampleData::Contour> contours) {
  SampleData out;
  for (std::size_t i = 0; i < count; ++i)
    out.positions.push_back({static_cast<double>(i), static_cast<double>(i * i % 7)});
  out.contours = std::move(contours);
  return out;
}

std::string words(const CurveOrder& order, std::uint32_t first) {
  std::string out;
  for (const CurveOrder::Contour& contour : order.contours) {
    out += contour.closed ? "(" : "[";
    for (const SampleId id : contour.samples)
      out += (out.back() == '(' || out.back() == '[' ? "" : " ") + std::to_string(id.value - first);
    out += contour.closed ? ")" : "]";
  }
  return out;
}

// What the change makes of the contours, as "(closed) [open]"; "-" where it is refused.
std::string after(const SampleData& data, ContourChange change, const std::vector<std::uint32_t>& chosen,
                  const std::vector<std::uint32_t>& removed = {}) {
  Document document;
  document.apply(*replace_all(document, data));
  const std::uint32_t first = document.first_id().value;
  std::vector<SampleId> gone, ids;
  for (const std::uint32_t i : removed) gone.push_back(SampleId{first + i});
  if (!gone.empty()) document.apply(*remove_samples(document, gone));
  for (const std::uint32_t i : chosen) ids.push_back(SampleId{first + i});
  const auto out = changed_contours(document, change, ids);
  if (out) return words(*out, first);
  CHECK(out.error().code == ErrorCode::bad_input);
  CHECK(out.error().text.find("select") != std::string::npos);
  return "-";
}

}  // namespace

TEST_CASE("links of contours follow random edits as if they were made anew") {
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    Rng rng(seed);
    const std::size_t count = 1 + rng.below(14);
    std::vector<SampleData::Contour> contours(rng.below(4));
    for (auto& contour : contours) {
      contour.closed = rng.below(2) == 0;
      const std::size_t length = rng.below(10);
      for (std::size_t i = 0; i < length; ++i) contour.points.push_back(static_cast<std::uint32_t>(rng.below(count)));
    }
    Desk desk(with_contours_of(count, contours));
    desk.check();
    std::vector<DocumentDelta> done;
    for (int step = 0; step < 60; ++step) {
      const auto slots = desk.document.slots_in_input_order();
      const auto some = [&] { return desk.document.id(slots[rng.below(slots.size())]); };
      switch (slots.empty() ? 3 : rng.below(6)) {
        case 0:
          done.push_back(*move_samples(desk.document, std::vector{std::pair{some(), Vec2{rng.uniform(), 0}}}));
          break;
        case 1: done.push_back(*remove_samples(desk.document, std::vector{some()})); break;
        case 2: {
          std::set<SampleId> ids;
          for (std::size_t i = 0; i <= rng.below(6); ++i) ids.insert(some());
          done.push_back(*remove_samples(desk.document, std::vector(ids.begin(), ids.end())));
          break;
        }
        case 3: done.push_back(*insert_samples(desk.document, std::vector{Vec2{rng.uniform(), 1}})); break;
        default: {
          // Several steps back within one run, so that rows change their samples and samples come back.
          std::size_t steps = done.empty() ? 0 : 1 + rng.below(std::min<std::size_t>(done.size(), 4));
          for (; steps > 0; --steps) {
            desk.post(done.back().inverted());
            done.pop_back();
          }
          desk.run();
          desk.check();
          continue;
        }
      }
      desk.post(done.back());
      if (rng.below(4) == 0) continue;  // two edits in one run
      desk.run();
      desk.check();
    }
  }
}

TEST_CASE("a contour is described by its corners and its samples, not by how often it names them") {
  const auto links = [](bool closed, std::vector<std::uint32_t> points) {
    Desk desk(with_contours_of(4, {{closed, std::move(points)}}));
    desk.check();
    return desk.links().size();
  };
  CHECK(links(true, {0, 0, 1}) == 1);
  CHECK(links(true, {0, 1, 0}) == 1);
  CHECK(links(true, {0, 1, 1, 2, 0}) == 3);
  CHECK(links(true, {0, 1, 0, 2}) == 4);
  CHECK(links(false, {0, 1, 1, 0}) == 2);

  TestBench bench;
  bench.show({"contours"});
  bench.load(with_contours_of(4, {{true, {0, 1, 1, 0, 2}}}));
  const auto& contours = bench.get<Contours>();
  int links_seen = 0;
  for (const ContourSlot row : slots_below<ContourSlot>(contours.row_count())) {
    if (!contours.has_link(row)) continue;
    JobControl job;
    Explanation said(
        bench.graph().structures(), [](const Structure&) { return true; }, job);
    contours.explain(ElementKind::contour_link, row.index(), said);
    const std::vector<ProvenanceLine> lines = said.take();
    REQUIRE(!lines.empty());
    CHECK(lines.front().text == "Link of contour 1, which is closed and has 3 samples");
    ++links_seen;
  }
  CHECK(links_seen == 4);
}

TEST_CASE("contours that were edited are shown without an edit of samples") {
  TestBench bench;
  bench.load(with_contours_of(6, {{true, {0, 1, 2, 3, 4, 5}}}));
  CHECK(bench.count("contours", "links") == 6);
  CHECK(bench.count("contours", "closed") == 1);
  Desk desk(with_contours_of(6, {{true, {0, 1, 2, 3, 4, 5}}}));
  const std::uint32_t first = desk.document.first_id().value;
  const auto cut =
      changed_contours(desk.document, ContourChange::cut, std::vector{SampleId{first}, SampleId{first + 5}});
  REQUIRE(cut);
  DocumentDelta delta = *change_document(desk.document, {});
  delta.to_revision = desk.document.next_revision();
  delta.curve_after = std::make_shared<const CurveOrder>(*cut);
  desk.post(delta);
  desk.run();
  desk.check();
  CHECK(desk.links().size() == 5);
}

TEST_CASE("contours are joined, cut, closed, opened, turned around and forgotten") {
  using enum ContourChange;
  const SampleData loop = with_contours_of(8, {{true, {0, 1, 2, 3, 4}}});
  const SampleData two = with_contours_of(9, {{false, {0, 1, 2}}, {false, {3, 4, 5}}});
  CHECK(after(two, join, {2, 3}) == "[0 1 2 3 4 5]");
  CHECK(after(two, join, {3, 2}) == "[0 1 2 3 4 5]");
  CHECK(after(two, join, {0, 5}) == "[3 4 5 0 1 2]");
  CHECK(after(two, join, {0, 3}) == "[5 4 3 0 1 2]");
  CHECK(after(two, join, {2, 5}) == "[0 1 2 5 4 3]");
  CHECK(after(two, join, {0, 2}) == "(0 1 2)[3 4 5]");
  CHECK(after(two, join, {2, 7}) == "[0 1 2 7][3 4 5]");
  CHECK(after(two, join, {7, 8}) == "[0 1 2][3 4 5][7 8]");
  CHECK(after(two, join, {1, 3}) == "-");
  CHECK(after(two, join, {2}) == "-");
  CHECK(after(two, join, {2, 3, 7}) == "-");
  CHECK(after(loop, join, {0, 7}) == "-");
  CHECK(after(loop, cut, {1, 2}) == "[2 3 4 0 1]");
  CHECK(after(loop, cut, {0, 4}) == "[0 1 2 3 4]");
  CHECK(after(loop, cut, {1, 2, 3}) == "[3 4 0 1]");
  CHECK(after(loop, cut, {0, 1, 3, 4}) == "[1 2 3]");
  CHECK(after(loop, cut, {1, 3}) == "-");
  CHECK(after(loop, cut, {0, 1, 2, 3, 4}) == "");
  CHECK(after(two, cut, {1, 2, 3, 4}) == "[0 1][4 5]");
  CHECK(after(two, close, {1}) == "(0 1 2)[3 4 5]");
  CHECK(after(two, close, {1, 5}) == "(0 1 2)(3 4 5)");
  CHECK(after(loop, close, {1}) == "-");
  CHECK(after(loop, open, {3}) == "[3 4 0 1 2]");
  CHECK(after(loop, open, {3, 4}) == "[4 0 1 2 3]");
  CHECK(after(two, open, {3}) == "-");
  CHECK(after(loop, reverse, {3}) == "(0 4 3 2 1)");
  CHECK(after(two, reverse, {3}) == "[0 1 2][5 4 3]");
  CHECK(after(two, forget, {3}) == "[0 1 2]");
  CHECK(after(two, forget, {8}) == "-");
  // Samples that are gone are passed over, and stay in contours that do not change.
  CHECK(after(two, join, {1, 3}, {2}) == "[0 1 3 4 5]");
  CHECK(after(two, reverse, {4}, {2, 3}) == "[0 1 2][5 4]");
  CHECK(after(two, close, {0}, {1}) == "-");
}

TEST_CASE("joining what was cut gives the contour back, up to its beginning") {
  for (std::uint32_t i = 0; i < 7; ++i) {
    const SampleData loop = with_contours_of(7, {{true, {0, 1, 2, 3, 4, 5, 6}}});
    Desk desk(loop);
    const std::uint32_t first = desk.document.first_id().value;
    const auto before = desk.links();
    const std::vector<SampleId> ends{SampleId{first + i}, SampleId{first + (i + 1) % 7}};
    for (const ContourChange change : {ContourChange::cut, ContourChange::join}) {
      const auto changed = changed_contours(desk.document, change, ends);
      REQUIRE(changed);
      DocumentDelta delta = *change_document(desk.document, {});
      delta.to_revision = desk.document.next_revision();
      delta.curve_after = std::make_shared<const CurveOrder>(*changed);
      desk.post(delta);
      desk.run();
      desk.check();
    }
    CHECK(desk.links() == before);
  }
}
