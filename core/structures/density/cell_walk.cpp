// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/density/cell_walk.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>

namespace mes {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr std::uint32_t kNone = 0xffffffffU;

/// Samples that walk together, in pairs that a processor computes with at once.
constexpr std::size_t kLanes = 4;
constexpr std::size_t kPairs = kLanes / 2;
using Pair = double __attribute__((vector_size(2 * sizeof(double))));
using PairMask = decltype(Pair{} < Pair{});
bool any(PairMask mask) {
  return (mask[0] | mask[1]) != 0;
}

/// The group's samples are that near to each other, over the distance of the first to the axis of its own cell.
constexpr double kSpread = 1.0;
/// Cells of one walk at most.
constexpr std::uint32_t kLongest = 160;
/// So many groups do without a walk after one that was too long.
constexpr std::size_t kPause = 24;
/// Axis edges within this factor of the best are crossed. Two errors of heights, and room.
constexpr double kCrossed = 1.0 + 4.0 * kHeightError;
/// Cells at vague edges; where there are more, all samples are left to another way of searching.
constexpr std::size_t kMostVague = 32;

/// Where the entries of each row begin, and behind them all, in a table that holds `counts` of them row by row.
std::vector<std::uint32_t> first_of_each(const std::vector<std::uint32_t>& counts) {
  std::vector<std::uint32_t> out(counts.size() + 1, 0);
  std::inclusive_scan(counts.begin(), counts.end(), out.begin() + 1);
  return out;
}

}  // namespace

struct CellWalk::Group {
  std::array<Pair, kPairs> x, y;
  std::array<Pair, kPairs> best;     // squared
  std::array<Pair, kPairs> limit;    // the root of best, times kCrossed
  std::array<Pair, kPairs> crossed;  // limit, squared
  std::array<std::uint32_t, kLanes> line;

  void take(std::size_t lane, double squared, std::uint32_t by) {
    best[lane / 2][lane % 2] = squared;
    const double root = kCrossed * std::sqrt(squared);
    limit[lane / 2][lane % 2] = root;
    crossed[lane / 2][lane % 2] = root * root;
    line[lane] = by;
  }
};

struct CellWalk::Trail {
  std::array<std::uint32_t, kLongest> queue;
  std::uint32_t head = 0;
  std::uint32_t tail = 0;
  /// The cells of the queue, each at its number or behind, with the number of the walk: others are free.
  struct Mark {
    std::uint32_t walk = 0;
    std::uint32_t cell = 0;
  };
  static constexpr std::uint32_t kMarks = 512;
  static_assert(kMarks >= 2 * kLongest && std::has_single_bit(kMarks));
  std::array<Mark, kMarks> marks{};
  std::uint32_t number = 0;
  std::uint32_t guess = kNone;

  void begin() {
    ++number;
    head = tail = 0;
  }
  /// Adds a cell that the walk has not come to yet. Returns false if the queue is full.
  bool add(std::uint32_t cell) {
    std::uint32_t at = cell % kMarks;
    for (; marks[at].walk == number; at = (at + 1) % kMarks)
      if (marks[at].cell == cell) return true;
    if (tail == kLongest) return false;
    marks[at] = {number, cell};
    queue[tail++] = cell;
    return true;
  }
};

CellWalk::CellWalk(const Delaunay& delaunay, const OneStepCrust& crust, std::span<const AxisLine> lines, double unit)
    : lines_(lines) {
  order_cells(delaunay, crust);
  places_.reserve(sites_.size());
  for (const SiteSlot site : sites_) {
    const Vec2 at = delaunay.site_position(site);
    places_.push_back({at.x * unit, at.y * unit});
  }
  Box2 box;
  for (const Vec2 place : places_) box.add(place);
  reach_ = 4.0 * (box.width() + box.height());
  list_lines(delaunay);
}

// Along each chain of crust edges from where it is met first.
void CellWalk::order_cells(const Delaunay& delaunay, const OneStepCrust& crust) {
  Table<SiteSlot, std::uint32_t> degree(delaunay.site_rows(), 0);
  const auto for_each_crust_edge = [&](auto visit) {
    for (const EdgeSlot edge : delaunay.edge_slots()) {
      const EdgeRow& row = delaunay.edge(edge);
      if (row.is_alive() && crust.is_crust(edge)) visit(row.v[0], row.v[1]);
    }
  };
  for_each_crust_edge([&](SiteSlot a, SiteSlot b) {
    ++degree[a];
    ++degree[b];
  });
  const std::vector<std::uint32_t> first = first_of_each(degree.values());
  std::vector<SiteSlot> neighbours(first.back());
  Table<SiteSlot, std::uint32_t> filled(delaunay.site_rows(), 0);
  for_each_crust_edge([&](SiteSlot a, SiteSlot b) {
    neighbours[first[a.index()] + filled[a]++] = b;
    neighbours[first[b.index()] + filled[b]++] = a;
  });
  const auto neighbours_of = [&](SiteSlot site) {
    return std::span(neighbours).subspan(first[site.index()], degree[site]);
  };
  cell_of_.assign(delaunay.site_rows(), kNone);
  sites_.reserve(delaunay.site_count());
  for (const SiteSlot start : delaunay.site_slots()) {
    if (!delaunay.is_site(start)) continue;
    for (SiteSlot at = start; at != kNoSlot && cell_of_[at] == kNone;) {
      cell_of_[at] = static_cast<std::uint32_t>(sites_.size());
      sites_.push_back(at);
      SiteSlot next{};
      for (const SiteSlot other : neighbours_of(at))
        if (cell_of_[other] == kNone) next = other;
      at = next;
    }
  }
  first_crust_.reserve(sites_.size() + 1);
  crust_.reserve(neighbours.size());
  first_crust_.push_back(0);
  for (const SiteSlot site : sites_) {
    for (const SiteSlot other : neighbours_of(site)) crust_.push_back(cell_of_[other]);
    first_crust_.push_back(static_cast<std::uint32_t>(crust_.size()));
  }
}

void CellWalk::list_lines(const Delaunay& delaunay) {
  std::vector<std::uint32_t> counts(sites_.size(), 0);
  for (const AxisLine& line : lines_)
    for (const SiteSlot site : delaunay.edge(line.edge).v) ++counts[cell_of_[site]];
  first_line_ = first_of_each(counts);
  axis_.resize(first_line_.back());
  reaches_.assign(sites_.size(), kInfinity);
  std::vector<std::uint32_t> next(first_line_.begin(), first_line_.end() - 1);
  for (std::uint32_t i = 0; i < lines_.size(); ++i) {
    const AxisLine& line = lines_[i];
    const EdgeRow& row = delaunay.edge(line.edge);
    const double reach = line.squared_reach();
    has_steep_ = has_steep_ || line.is_steep;
    for (const std::size_t end : {0U, 1U}) {
      const std::uint32_t cell = cell_of_[row.v[end]];
      axis_[next[cell]++] = {i, cell_of_[row.v[1 - end]]};
      if (line.is_steep && kSteep * line.half < 2.0 * reach_) vague_.push_back({i, cell});
      reaches_[cell] = std::min(reaches_[cell], reach);
    }
  }
  for (double& reach : reaches_) reach = std::sqrt(reach) * (1.0 - kHeightError);
}

bool CellWalk::walk(Group& group, std::size_t begin, std::size_t end, Trail& trail) const {
  trail.begin();
  for (std::size_t cell = begin; cell < end; ++cell) trail.add(static_cast<std::uint32_t>(cell));
  const AxisEntry guess{trail.guess, static_cast<std::uint32_t>(begin)};
  // Measures these edges, and adds the cells beyond those that the walk crosses. Returns false if the queue is full.
  const auto look_at = [&](std::span<const AxisEntry> entries) {
    for (const AxisEntry& entry : entries) {
      const AxisLine& line = lines_[entry.line];
      std::array<Pair, kPairs> squared;
      PairMask is_crossed{};
      for (std::size_t i = 0; i < kPairs; ++i) {
        const Pair ux = group.x[i] - line.q.x;
        const Pair uy = group.y[i] - line.q.y;
        const Pair aside = ux * line.along.x + uy * line.along.y - line.half;
        const Pair height = line.along.x * uy - line.along.y * ux;
        const Pair low = line.low - Pair{};
        const Pair high = line.high - Pair{};
        Pair on = height < low ? low : height;
        on = on > high ? high : on;
        const Pair rest = height - on;
        squared[i] = aside * aside + rest * rest;
        is_crossed |= squared[i] <= group.crossed[i];
      }
      if (!any(is_crossed)) continue;
      for (std::size_t k = 0; k < kLanes; ++k)
        if (squared[k / 2][k % 2] < group.best[k / 2][k % 2]) group.take(k, squared[k / 2][k % 2], entry.line);
      if (!trail.add(entry.other)) return false;
    }
    return true;
  };
  // Most often the one that is nearest to the group before, or not far from it.
  if (trail.guess != kNone) look_at(std::span(&guess, 1));
  // Where vague edges end, and whether the walk crosses them, is not known: their cells are visited in any case.
  if (!look_at(vague_)) return false;
  for (const AxisEntry& entry : vague_)
    if (!trail.add(entry.other)) return false;
  while (trail.head != trail.tail) {
    const std::uint32_t cell = trail.queue[trail.head++];
    const Vec2 s = places_[cell];
    const double reach = reaches_[cell];
    PairMask is_near{};
    PairMask may_hold{};
    for (std::size_t i = 0; i < kPairs; ++i) {
      const Pair dx = group.x[i] - s.x;
      const Pair dy = group.y[i] - s.y;
      const Pair away = dx * dx + dy * dy;
      const Pair rest = reach - group.limit[i];
      is_near |= away <= 4.0 * group.crossed[i];
      may_hold |= (rest <= Pair{}) | (rest * rest <= away);
    }
    if (!any(is_near)) continue;
    if (any(may_hold) &&
        !look_at(std::span(axis_).subspan(first_line_[cell], first_line_[cell + 1] - first_line_[cell])))
      return false;
    for (std::uint32_t i = first_crust_[cell]; i < first_crust_[cell + 1]; ++i)
      if (!trail.add(crust_[i])) return false;
  }
  // So far away the ends of steep edges matter.
  PairMask is_far{};
  for (const Pair best : group.best) is_far |= best > reach_ * reach_;
  return !has_steep_ || !any(is_far);
}

void CellWalk::search(std::size_t begin, std::size_t end, Table<SiteSlot, double>& squared,
                      Table<SiteSlot, EdgeSlot>& nearest, std::vector<SiteSlot>& given_up) const {
  Trail trail;
  std::size_t pause = vague_.size() > kMostVague ? end - begin : 0;
  for (std::size_t first = begin; first < end;) {
    const double room = kSpread * reaches_[first];
    const auto is_near_first = [&](std::size_t cell) {
      const Vec2 d = places_[cell] - places_[first];
      return dot(d, d) <= room * room;
    };
    std::size_t last = first + 1;
    while (last < end && last < first + kLanes && is_near_first(last)) ++last;
    bool is_found = false;
    Group group;
    if (pause != 0) {
      --pause;
    } else {
      for (std::size_t k = 0; k < kLanes; ++k) {
        const Vec2 p = places_[std::min(first + k, last - 1)];
        group.x[k / 2][k % 2] = p.x;
        group.y[k / 2][k % 2] = p.y;
      }
      for (auto* const values : {&group.best, &group.limit, &group.crossed}) values->fill(Pair{kInfinity, kInfinity});
      group.line.fill(kNone);
      is_found = walk(group, first, last, trail);
      if (!is_found) pause = kPause;
    }
    for (std::size_t cell = first; cell < last; ++cell) {
      const SiteSlot site = sites_[cell];
      if (is_found) {
        squared[site] = group.best[(cell - first) / 2][(cell - first) % 2];
        if (const std::uint32_t line = group.line[cell - first]; line != kNone) nearest[site] = lines_[line].edge;
      } else {
        given_up.push_back(site);
      }
    }
    first = last;
    if (is_found) trail.guess = group.line[kLanes - 1];
  }
}

}  // namespace mes
