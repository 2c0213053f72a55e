// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editing/places/place_index.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <new>
#include <type_traits>
#include <utility>

#include "core/base/assert.h"

namespace mes {
namespace {

// Cells this far out are finer than doubles can tell apart; clamping keeps the integers defined.
constexpr double kFarthestCell = 4e15;

std::int64_t floor_div(std::int64_t a, std::int64_t b) {
  return a >= 0 ? a / b : -((-a + b - 1) / b);
}

std::int64_t to_cell(double value) {
  return static_cast<std::int64_t>(std::floor(std::clamp(value, -kFarthestCell, kFarthestCell)));
}

double squared_distance_to(const Box2& box, Vec2 p) {
  const double dx = std::max({box.low.x - p.x, 0.0, p.x - box.high.x});
  const double dy = std::max({box.low.y - p.y, 0.0, p.y - box.high.y});
  return dx * dx + dy * dy;
}

// Width of the middle nine tenths of the values, so that outliers do not count.
double robust_width(std::vector<double>& values) {
  const auto low = static_cast<std::ptrdiff_t>(values.size() / 20);
  const auto high = static_cast<std::ptrdiff_t>(values.size() - 1) - low;
  std::nth_element(values.begin(), values.begin() + low, values.end());
  const double first = values[static_cast<std::size_t>(low)];
  std::nth_element(values.begin(), values.begin() + high, values.end());
  return values[static_cast<std::size_t>(high)] - first;
}

}  // namespace

template <class Places>
std::size_t PlaceIndex<Places>::CellHash::operator()(const Cell& cell) const noexcept {
  std::uint64_t h = static_cast<std::uint64_t>(cell.x) * 0x9e3779b97f4a7c15U;
  h ^= static_cast<std::uint64_t>(cell.y) + 0x517cc1b727220a95U + (h << 6U) + (h >> 2U);
  h *= 0xff51afd7ed558ccdU;
  return static_cast<std::size_t>(h ^ (h >> 32U));
}

template <class Places>
PlaceIndex<Places>::PlaceIndex(const Document& document, const JobPart& part) : document_(document) {
  rebuild(part);
}

template <class Places>
void PlaceIndex<Places>::swap_tables(PlaceIndex& other) noexcept {
  std::swap(cell_size_, other.cell_size_);
  std::swap(origin_, other.origin_);
  std::swap(size_, other.size_);
  std::swap(size_at_rebuild_, other.size_at_rebuild_);
  std::swap(is_lost_, other.is_lost_);
  head_.swap(other.head_);
  occupied_children_.swap(other.occupied_children_);
  std::swap(next_, other.next_);
  std::swap(previous_, other.previous_);
}

template <class Places>
typename PlaceIndex<Places>::Cell PlaceIndex<Places>::cell_of(Vec2 p, double size) const {
  return {to_cell((p.x - origin_.x) / size), to_cell((p.y - origin_.y) / size)};
}

template <class Places>
typename PlaceIndex<Places>::Cell PlaceIndex<Places>::parent_of(Cell cell) {
  return {floor_div(cell.x, kFanout), floor_div(cell.y, kFanout)};
}

template <class Places>
Box2 PlaceIndex<Places>::box_of(Cell cell, std::size_t level) const {
  static_assert(kFanout == 4);
  const double size = std::ldexp(cell_size_, 2 * static_cast<int>(level));
  const Vec2 low{origin_.x + static_cast<double>(cell.x) * size, origin_.y + static_cast<double>(cell.y) * size};
  // Wider by one part in 10^12, so that rounding of the cell number cannot hide a point on the border.
  const double slack = 1e-12 * (size + std::abs(low.x - origin_.x) + std::abs(low.y - origin_.y));
  return {{low.x - slack, low.y - slack}, {low.x + size + slack, low.y + size + slack}};
}

template <class Places>
double PlaceIndex<Places>::chosen_cell_size() const {
  std::vector<double> xs;
  std::vector<double> ys;
  const std::size_t rows = Places::rows(document_);
  const std::size_t step = std::max<std::size_t>(1, rows / 4096);
  for (std::size_t row = 0; row < rows; row += step) {
    const Row slot(row);
    if (!Places::is_alive(document_, slot)) continue;
    xs.push_back(Places::place(document_, slot).x);
    ys.push_back(Places::place(document_, slot).y);
  }
  if (xs.size() < 2) return 1.0;
  const double width = std::max(robust_width(xs), robust_width(ys));
  const double size = width / std::max(1.0, std::sqrt(static_cast<double>(Places::count(document_))));
  return std::isfinite(size) && size > 1e-290 ? size : 1.0;
}

template <class Places>
void PlaceIndex<Places>::rebuild(const JobPart& part) {
  head_.clear();
  occupied_children_.assign(kLevels - 1, {});
  next_.assign(Places::rows(document_), kNoSlot);
  previous_.assign(Places::rows(document_), kNoSlot);
  size_ = 0;
  cell_size_ = chosen_cell_size();
  origin_ = {};
  // On a dense curve most samples lie in the cell of the previous one.
  Cell last{};
  Row* head = nullptr;
  constexpr std::size_t kOften = std::size_t{1} << 14U;
  const std::size_t rows = Places::rows(document_);
  for (const Row slot : slots_below<Row>(rows)) {
    if (part.job != nullptr && slot.index() % kOften == 0)
      part.job->checkpoint(part.before + slot.index(), part.total);
    if (!Places::is_alive(document_, slot)) continue;
    const Vec2 place = Places::place(document_, slot);
    if (size_ == 0) origin_ = place;
    const Cell cell = cell_of(place, cell_size_);
    if (head == nullptr || cell != last) {
      add(slot, place);
      head = &head_.find(cell)->second;
      last = cell;
      continue;
    }
    ++size_;
    next_[slot] = *head;
    previous_[*head] = slot;
    *head = slot;
  }
  size_at_rebuild_ = size_;
}

template <class Places>
void PlaceIndex<Places>::add(Row slot, Vec2 p) {
  if (!next_.has(slot)) {
    next_.resize(slot.index() + std::size_t{1}, kNoSlot);
    previous_.resize(slot.index() + std::size_t{1}, kNoSlot);
  }
  ++size_;
  Cell cell = cell_of(p, cell_size_);
  const auto [entry, is_new] = head_.try_emplace(cell, slot);
  next_[slot] = is_new ? kNoSlot : entry->second;
  previous_[slot] = kNoSlot;
  if (!is_new) {
    previous_[entry->second] = slot;
    entry->second = slot;
    return;
  }
  for (auto& level : occupied_children_) {
    cell = parent_of(cell);
    if (++level[cell] > 1) return;
  }
}

template <class Places>
void PlaceIndex<Places>::remove(Row slot, Vec2 p) {
  --size_;
  Cell cell = cell_of(p, cell_size_);
  if (next_[slot] != kNoSlot) previous_[next_[slot]] = previous_[slot];
  if (previous_[slot] != kNoSlot) {
    next_[previous_[slot]] = next_[slot];
    return;
  }
  const auto entry = head_.find(cell);
  MES_ASSERT(entry != head_.end() && entry->second == slot);
  if (next_[slot] != kNoSlot) {
    entry->second = next_[slot];
    return;
  }
  head_.erase(entry);
  for (auto& level : occupied_children_) {
    cell = parent_of(cell);
    const auto parent = level.find(cell);
    MES_ASSERT(parent != level.end());
    if (--parent->second > 0) return;
    level.erase(parent);
  }
}

template <class Places>
void PlaceIndex<Places>::follow(const DocumentDelta& delta) {
  try {
    follow_closely(delta);
    is_lost_ = false;
  } catch (const std::bad_alloc&) {
    is_lost_ = true;
  }
}

template <class Places>
void PlaceIndex<Places>::follow_closely(const DocumentDelta& delta) {
  if (delta.replaces_all() || is_lost_) {
    rebuild();
    return;
  }
  for (const auto& edit : Places::edits(delta)) {
    using Kind = std::remove_cvref_t<decltype(edit)>::Kind;
    if (edit.kind != Kind::insert) remove(edit.slot, Places::place(edit.from));
    if (edit.kind != Kind::remove) add(edit.slot, Places::place(edit.to));
  }
  constexpr std::size_t kSmall = 64;
  if (size_ > 4 * std::max(size_at_rebuild_, kSmall / 4) ||
      (size_at_rebuild_ > kSmall && size_ < size_at_rebuild_ / 4))
    rebuild();
}

template <class Places>
template <class Visit>
void PlaceIndex<Places>::descend(Cell cell, std::size_t level, const Box2& box, const Visit& visit) const {
  if (level == 0) {
    if (const auto entry = head_.find(cell); entry != head_.end()) visit(cell, entry->second);
    return;
  }
  const auto& counts = occupied_children_[level - 1];
  if (!counts.contains(cell)) return;
  for (std::int64_t dy = 0; dy < kFanout; ++dy) {
    for (std::int64_t dx = 0; dx < kFanout; ++dx) {
      const Cell child{cell.x * kFanout + dx, cell.y * kFanout + dy};
      const Box2 child_box = box_of(child, level - 1);
      if (child_box.low.x > box.high.x || child_box.high.x < box.low.x || child_box.low.y > box.high.y ||
          child_box.high.y < box.low.y)
        continue;
      descend(child, level - 1, box, visit);
    }
  }
}

// Visits the occupied cells of level 0 that meet the box, starting at the level where the box is a few cells wide.
template <class Places>
template <class Visit>
void PlaceIndex<Places>::visit_cells(const Box2& box, const Visit& visit) const {
  if (size_ == 0) return;
  const double extent = std::max(box.width(), box.height());
  std::size_t level = 0;
  double size = cell_size_;
  while (level + 1 < kLevels && size < extent) {
    size *= static_cast<double>(kFanout);
    ++level;
  }
  const Cell low = cell_of(box.low, size);
  const Cell high = cell_of(box.high, size);
  const auto& top = occupied_children_[level == 0 ? 0 : level - 1];
  const double cells = (static_cast<double>(high.x - low.x) + 1) * (static_cast<double>(high.y - low.y) + 1);
  if (level > 0 && cells > static_cast<double>(top.size())) {
    for (const auto& [cell, count] : top) descend(cell, level, box, visit);
    return;
  }
  for (std::int64_t y = low.y; y <= high.y; ++y)
    for (std::int64_t x = low.x; x <= high.x; ++x) descend({x, y}, level, box, visit);
}

template <class Places>
typename PlaceIndex<Places>::Row PlaceIndex<Places>::nearest(Vec2 p, double radius) const {
  if (!is_finite(p) || !(radius >= 0.0)) return kNoSlot;
  Best best{kNoSlot, radius};
  const auto look_at = [&](Row slot) {
    const double d = distance(Places::place(document_, slot), p);
    if (d > best.distance || (d == best.distance && best.slot != kNoSlot && slot < best.slot)) return;
    best = {slot, d};
  };
  if (is_lost_) {
    for (const Row slot : slots_below<Row>(Places::rows(document_)))
      if (Places::is_alive(document_, slot)) look_at(slot);
    return best.slot;
  }
  // Grows the box step by step, so that a wide radius among dense points ends after the first steps.
  double reach = std::min(radius, cell_size_);
  for (;;) {
    const Box2 box{{p.x - reach, p.y - reach}, {p.x + reach, p.y + reach}};
    visit_cells(box, [&](Cell cell, Row first) {
      if (best.slot != kNoSlot && squared_distance_to(box_of(cell, 0), p) > best.distance * best.distance) return;
      for (Row slot = first; slot != kNoSlot; slot = next_[slot]) look_at(slot);
    });
    // Everything within the box was seen, so no point outside it can be nearer than one at most `reach` away.
    if ((best.slot != kNoSlot && best.distance <= reach) || reach >= radius) return best.slot;
    reach = std::min(radius, reach * static_cast<double>(kFanout));
  }
}

template <class Places>
std::vector<typename PlaceIndex<Places>::Row> PlaceIndex<Places>::in_box(const Box2& box) const {
  std::vector<Row> out;
  if (box.is_empty()) return out;
  if (is_lost_) {
    for (const Row slot : slots_below<Row>(Places::rows(document_)))
      if (Places::is_alive(document_, slot) && box.contains(Places::place(document_, slot))) out.push_back(slot);
    return out;
  }
  visit_cells(box, [&](Cell, Row first) {
    for (Row slot = first; slot != kNoSlot; slot = next_[slot])
      if (box.contains(Places::place(document_, slot))) out.push_back(slot);
  });
  std::ranges::sort(out);
  return out;
}

template class PlaceIndex<SamplePlaces>;
template class PlaceIndex<CenterPlaces>;

}  // namespace mes
