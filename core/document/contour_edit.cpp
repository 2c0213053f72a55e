// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/contour_edit.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <string_view>
#include <unordered_set>
#include <utility>

#include "core/document/live_corners.h"

namespace mes {
namespace {

using Contour = CurveOrder::Contour;

constexpr std::size_t kLeastOfLoop = 3;

constexpr std::array<std::string_view, kContourChanges> kNothingToDo{
    "to join contours, select two samples: each the end of an open contour, or on none",
    "to cut contours, select two or more samples that are neighbours on a contour",
    "to close contours, select a sample of each: open ones of three samples or more",
    "to open contours, select a sample of each: closed ones",
    "to reverse contours, select a sample of each",
    "to forget contours, select a sample of each"};

class Editing {
 public:
  Editing(const Document& document, std::span<const SampleId> samples)
      : document_(document), chosen_(samples.begin(), samples.end()) {}

  bool apply(ContourChange change, std::span<const SampleId> samples);
  CurveOrder take() { return std::move(out_); }

 private:
  bool join(std::span<const SampleId> samples);
  bool change_each(ContourChange change);
  bool change_one(ContourChange change, Contour contour);
  bool cut(const Contour& contour);
  void keep(Contour contour);
  bool is_chosen(SampleId id) const { return chosen_.contains(id); }
  Contour living(const Contour& contour) const;

  const Document& document_;
  std::unordered_set<SampleId> chosen_;
  CurveOrder out_;
};

Contour Editing::living(const Contour& contour) const {
  return {contour.closed, live_corners(document_, contour)};
}

void Editing::keep(Contour contour) {
  if (contour.samples.size() > 1) out_.contours.push_back(std::move(contour));
}

bool Editing::apply(ContourChange change, std::span<const SampleId> samples) {
  return change == ContourChange::join ? join(samples) : change_each(change);
}

bool Editing::change_each(ContourChange change) {
  bool is_changed = false;
  for (const Contour& contour : document_.curve_order()->contours) {
    Contour alive = living(contour);
    const bool is_meant = std::ranges::any_of(alive.samples, [&](SampleId id) { return is_chosen(id); });
    if (is_meant && change_one(change, std::move(alive)))
      is_changed = true;
    else
      out_.contours.push_back(contour);
  }
  return is_changed;
}

// Returns false if the contour needs no change; the caller then keeps it.
bool Editing::change_one(ContourChange change, Contour contour) {
  switch (change) {
    case ContourChange::join: return false;
    case ContourChange::cut: return cut(contour);
    case ContourChange::close:
      if (contour.closed || contour.samples.size() < kLeastOfLoop) return false;
      contour.closed = true;
      break;
    case ContourChange::open:
      if (!contour.closed) return false;
      if (cut(contour)) return true;
      contour.closed = false;
      std::ranges::rotate(contour.samples,
                          std::ranges::find_if(contour.samples, [&](SampleId id) { return is_chosen(id); }));
      break;
    case ContourChange::reverse:
      // A closed contour keeps its first sample.
      std::reverse(contour.samples.begin() + (contour.closed ? 1 : 0), contour.samples.end());
      break;
    case ContourChange::forget: return true;
  }
  keep(std::move(contour));
  return true;
}

bool Editing::cut(const Contour& contour) {
  const std::vector<SampleId>& at = contour.samples;
  const std::size_t count = at.size();
  const bool is_loop = contour.closed && count >= kLeastOfLoop;
  std::vector<std::size_t> cuts;  // link i is between samples i and i + 1
  for (std::size_t i = 0; i < (is_loop ? count : count - 1); ++i)
    if (is_chosen(at[i]) && is_chosen(at[(i + 1) % count])) cuts.push_back(i);
  if (cuts.empty()) return false;
  // Each piece runs from one cut to the next; in a closed contour the last one continues across the beginning.
  const auto piece = [&](std::size_t from, std::size_t to) {
    Contour out{false, {}};
    for (std::size_t i = from; i <= to; ++i) out.samples.push_back(at[i % count]);
    keep(std::move(out));
  };
  if (!is_loop) piece(0, cuts.front());
  for (std::size_t i = 0; i + 1 < cuts.size(); ++i) piece(cuts[i] + 1, cuts[i + 1]);
  piece(cuts.back() + 1, is_loop ? cuts.front() + count : count - 1);
  return true;
}

bool Editing::join(std::span<const SampleId> samples) {
  if (samples.size() != 2 || samples[0] == samples[1]) return false;
  for (const SampleId id : samples)
    if (document_.slot_of(id) == kNoSlot) return false;
  // The contour that ends in the sample, oriented so that the sample is last.
  struct Side {
    std::size_t contour = 0;
    Contour chain{};
  };
  const std::vector<Contour>& all = document_.curve_order()->contours;
  const auto side_of = [&](SampleId id) -> std::optional<Side> {
    std::optional<Side> out;
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (std::ranges::find(all[i].samples, id) == all[i].samples.end()) continue;
      Contour alive = living(all[i]);
      if (out || alive.closed) return std::nullopt;  // more than one contour meets there, or it has no ends
      if (alive.samples.front() == id) std::ranges::reverse(alive.samples);
      if (alive.samples.back() != id) return std::nullopt;
      out = Side{i, std::move(alive)};
    }
    return out ? out : Side{all.size(), Contour{false, {id}}};
  };
  auto first = side_of(samples[0]);
  auto second = side_of(samples[1]);
  if (!first || !second) return false;
  Contour joined{false, first->chain.samples};
  if (first->contour == second->contour && first->contour != all.size()) {
    if (joined.samples.size() < kLeastOfLoop) return false;
    joined.closed = true;
  } else {
    std::ranges::reverse_copy(second->chain.samples, std::back_inserter(joined.samples));
  }
  // The joined contour takes the index and the direction of the earlier contour.
  const std::size_t place = std::min(first->contour, second->contour);
  if (place < all.size()) {
    const Contour before = living(all[place]);
    const auto& at = joined.samples;
    const auto begin = std::ranges::find(at, before.samples.front());
    const auto end = std::ranges::find(at, before.samples.back());
    if (end < begin) std::ranges::reverse(joined.samples);
  }
  for (std::size_t i = 0; i <= all.size(); ++i) {
    if (i == place)
      out_.contours.push_back(std::exchange(joined, {}));
    else if (i < all.size() && i != first->contour && i != second->contour)
      out_.contours.push_back(all[i]);
  }
  return true;
}

}  // namespace

Expected<CurveOrder> changed_contours(const Document& document, ContourChange change,
                                      std::span<const SampleId> samples) {
  Editing editing(document, samples);
  if (editing.apply(change, samples)) return editing.take();
  return std::unexpected(Error{ErrorCode::bad_input, std::string(kNothingToDo[static_cast<std::size_t>(change)])});
}

CurveOrder with_contours(const Document& document, std::vector<CurveOrder::Contour> chains) {
  std::unordered_set<SampleId> taken;
  for (const Contour& chain : chains) taken.insert(chain.samples.begin(), chain.samples.end());
  CurveOrder out;
  for (const Contour& contour : document.curve_order()->contours)
    if (std::ranges::none_of(contour.samples, [&](SampleId id) { return taken.contains(id); }))
      out.contours.push_back(contour);
  std::ranges::move(chains, std::back_inserter(out.contours));
  return out;
}

}  // namespace mes
