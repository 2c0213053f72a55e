// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/inputs/contours.h"

#include <fmt/core.h>

#include <algorithm>

#include "core/base/counted.h"
#include "core/graph/explain.h"

namespace mes {
namespace {

// Below three corners, the link from the last to the first exists already.
constexpr std::uint32_t kLeastOfLoop = 3;

}  // namespace

Contours::Contours(Samples& samples) : Structure("contours", {&samples}), samples_(samples) {}

bool Contours::has_link(ContourSlot row) const {
  const Place& place = places_[row];
  if (place.sample == kNoSlot || place.sample == places_[place.next].sample) return false;
  const Contour& contour = contours_[place.contour];
  if (!contour.closed) return place.next > row;
  // Both directions are the same link; count the one that begins where the contour does.
  return contour.corners >= kLeastOfLoop || place.sample == places_[contour.head].sample;
}

std::pair<SampleSlot, SampleSlot> Contours::link(ContourSlot row) const {
  return {places_[row].sample, places_[places_[row].next].sample};
}

template <class Visit>
void Contours::for_each_place(SampleId id, Visit visit) const {
  const auto first = [](const auto& entry) { return entry.first; };
  for (const auto& [other, row] : std::ranges::equal_range(of_sample_, id, {}, first)) visit(row);
}

// Notes the rows whose links begin or end at a live place.
void Contours::note_around(ContourSlot row) {
  note(row);
  note(places_[row].previous);
}

// Notes the other links that appear or vanish as the contour gets these corners and this first sample. Call it first.
void Contours::become(Contour& contour, std::uint32_t corners, ContourSlot head, SampleSlot head_sample) {
  const bool was_loop = contour.corners >= kLeastOfLoop;
  const bool is_loop = corners >= kLeastOfLoop;
  const bool begins_elsewhere = contour.live != 0 && places_[contour.head].sample != head_sample;
  if (contour.closed && (was_loop != is_loop || (!is_loop && begins_elsewhere))) {
    ContourSlot row = contour.head;
    for (std::uint32_t i = 0; i < contour.live; ++i, row = places_[row].next) note(row);
  }
  contour.corners = corners;
  contour.head = head;
}

void Contours::kill(ContourSlot row) {
  Place& place = places_[row];
  Contour& contour = contours_[place.contour];
  note_around(row);
  const SampleSlot before = places_[place.previous].sample;
  const SampleSlot after = places_[place.next].sample;
  const std::uint32_t corners =
      contour.corners + is_step(before, after) - is_step(before, place.sample) - is_step(place.sample, after);
  const ContourSlot head = contour.head == row ? place.next : contour.head;
  become(contour, corners, head, places_[head].sample);
  places_[place.previous].next = place.next;
  places_[place.next].previous = place.previous;
  place.sample = kNoSlot;
  --contour.live;
}

// The live place before `row`; `row` itself if no other is alive.
ContourSlot Contours::live_before(ContourSlot row) const {
  const Contour& contour = contours_[places_[row].contour];
  if (contour.live == 0) return row;
  std::uint32_t at = row.index();
  do {
    at = (at == contour.first ? contour.first + contour.size : at) - 1;
  } while (places_[ContourSlot(at)].sample == kNoSlot);
  return ContourSlot(at);
}

void Contours::revive(ContourSlot row, SampleSlot sample) {
  Place& place = places_[row];
  Contour& contour = contours_[place.contour];
  note(row);
  const ContourSlot previous = live_before(row);
  if (previous == row) {
    become(contour, 0, row, sample);
    place.previous = place.next = row;
  } else {
    note(previous);
    const ContourSlot next = places_[previous].next;
    const SampleSlot before = places_[previous].sample;
    const SampleSlot after = places_[next].sample;
    const std::uint32_t corners =
        contour.corners + is_step(before, sample) + is_step(sample, after) - is_step(before, after);
    const bool is_first = row < contour.head;
    become(contour, corners, is_first ? row : contour.head, is_first ? sample : places_[contour.head].sample);
    place.previous = previous;
    place.next = next;
    places_[next].previous = row;
    places_[previous].next = row;
  }
  place.sample = sample;
  ++contour.live;
}

void Contours::rebuild(JobControl&) {
  changes_.clear();
  order_ = samples_.curve_order_shared();
  contours_.clear();
  places_.clear();
  of_sample_.clear();
  id_.assign(samples_.row_count(), SampleId{});
  std::size_t count = 0;
  for (const CurveOrder::Contour& contour : order_->contours) count += contour.samples.size();
  places_.reserve(count);
  of_sample_.reserve(count);
  for (const CurveOrder::Contour& contour : order_->contours) {
    const auto number = static_cast<std::uint32_t>(contours_.size());
    contours_.push_back({static_cast<std::uint32_t>(places_.size()),
                         static_cast<std::uint32_t>(contour.samples.size()),
                         0,
                         0,
                         {},
                         contour.closed});
    for (const SampleId id : contour.samples) {
      of_sample_.emplace_back(id, places_.next());
      places_.push_back({id, kNoSlot, number, {}, {}});
    }
  }
  recorder_.begin(count);
  std::ranges::sort(of_sample_);
  if (count == 0) return;
  for (const SampleSlot slot : slots_below<SampleSlot>(samples_.row_count())) {
    if (!samples_.is_alive(slot)) continue;
    for_each_place(samples_.id(slot), [&](ContourSlot row) {
      places_[row].sample = slot;
      id_[slot] = samples_.id(slot);
    });
  }
  // Reviving in the order of rows puts each live place behind the one before.
  for (const ContourSlot row : places_.rows())
    if (const SampleSlot slot = std::exchange(places_[row].sample, kNoSlot); slot != kNoSlot) revive(row, slot);
}

bool Contours::update(JobControl&) {
  if (order_ != samples_.curve_order_shared()) return false;
  recorder_.begin(places_.size());
  if (id_.size() < samples_.row_count()) id_.resize(samples_.row_count());
  std::vector<std::pair<ContourSlot, SampleSlot>> revived;
  const auto take = [&](SampleSlot slot) {
    const SampleId before = id_[slot];
    const SampleId now = samples_.id(slot);
    if (before == now) {
      if (before.is_valid()) for_each_place(before, [&](ContourSlot row) { note_around(row); });
      return;
    }
    if (before.is_valid()) for_each_place(before, [&](ContourSlot row) { kill(row); });
    id_[slot] = SampleId{};
    if (!now.is_valid()) return;
    for_each_place(now, [&](ContourSlot row) {
      revived.emplace_back(row, slot);
      id_[slot] = now;
    });
  };
  for (const SampleSlot slot : samples_.changes().removed) take(slot);
  for (const SampleSlot slot : samples_.changes().touched) take(slot);
  // In this order, the walk back to a live place is made once for all places on it.
  std::ranges::sort(revived);
  for (const auto& [row, slot] : revived) revive(row, slot);
  recorder_.finish(changes_, [this](ContourSlot row) { return has_link(row); });
  return true;
}

StatList Contours::statistics() const {
  std::int64_t contours = 0, closed = 0, links = 0;
  for (const Contour& contour : contours_) {
    if (contour.live == 0) continue;
    ++contours;
    if (contour.closed) ++closed;
  }
  for (const ContourSlot row : places_.rows()) links += has_link(row) ? 1 : 0;
  return {{"contours", contours}, {"closed", closed}, {"links", links}};
}

void Contours::explain(ElementKind kind, RowNumber number, Explanation& out) const {
  const ContourSlot row(number);
  if (kind != ElementKind::contour_link || !places_.has(row) || !has_link(row)) return;
  const auto [from, to] = link(row);
  const std::uint32_t which = contour(row);
  std::vector<SampleSlot> samples;
  ContourSlot place = row;
  do {
    samples.push_back(places_[place].sample);
    place = places_[place].next;
  } while (place != row);
  std::ranges::sort(samples);
  const auto count = static_cast<std::uint32_t>(std::ranges::unique(samples).begin() - samples.begin());
  ProvenanceShapes itself, ends;
  itself.segment(samples_.position(from), samples_.position(to));
  out.say(ProvenanceRole::itself,
          fmt::format("Link of contour {}, which is {} and has {}", which + 1, is_closed(which) ? "closed" : "open",
                      counted(count, "sample", "samples")),
          itself);
  ends.point(samples_.position(from));
  ends.point(samples_.position(to));
  out.say(ProvenanceRole::origin, "2 samples, neighbours on the contour", ends);
}

}  // namespace mes
