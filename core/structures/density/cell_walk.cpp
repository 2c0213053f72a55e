// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/density/cell_walk.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "core/base/geometry/double_pair.h"
#include "core/base/geometry/infinity.h"
#include "core/base/jobs/parallel.h"

namespace mes {
namespace {

constexpr std::uint32_t kNone = 0xffffffffU;

/// Samples that walk together, in pairs that the processor handles at once.
constexpr std::size_t kLanes = 4;
constexpr std::size_t kPairs = kLanes / 2;

/// The samples of a group are at most this far apart, relative to the least distance from a sample of their block to
/// the axis of its own cell.
constexpr double kSpread = 1.0;
/// Largest number of cells in a block.
constexpr std::uint32_t kBlock = 8;
/// Number of blocks in one part of the searches.
constexpr std::uint32_t kPart = 256;
/// Largest numbers of blocks and of axis edges in one walk.
constexpr std::uint32_t kLongest = 160;
constexpr std::uint32_t kMostLines = 800;
/// The same for samples that were given up, and how many of these walks may become too long.
constexpr std::uint32_t kLongestAgain = 8192;
constexpr std::uint32_t kMostLinesAgain = 40960;
constexpr int kMostFailures = 3;
/// After a walk that was too long, this many groups go without; twice as many after each further one, up to the most.
constexpr std::size_t kPause = 24;
constexpr std::size_t kLongestPause = 1536;
/// Axis edges within this factor of the best are crossed: two errors of heights, and room.
constexpr double kCrossed = 1.0 + 4.0 * kHeightError;
/// Largest number of cells at vague edges; beyond it, all samples are left to another way of searching.
constexpr std::size_t kMostVague = 32;

/// A float that is not above the true square, whatever the rounding of heights and of the float did to it.
float lowered(double squared) {
  constexpr double kMost = std::numeric_limits<float>::max();
  const double low = squared * ((1.0 - kHeightError) * (1.0 - kHeightError));
  // Subnormal floats are too coarse.
  return low < std::numeric_limits<float>::min() ? 0.0F : static_cast<float>(std::min(kMost, low));
}

/// Distance of two intervals; 0 where they meet.
inline double gap(double low, double high, double other_low, double other_high) {
  const double below = low - other_high;
  const double above = other_low - high;
  const double most = below > above ? below : above;
  return most > 0.0 ? most : 0.0;
}

inline double squared_distance(const Box2& a, const Box2& b) {
  const double x = gap(a.low.x, a.high.x, b.low.x, b.high.x);
  const double y = gap(a.low.y, a.high.y, b.low.y, b.high.y);
  return x * x + y * y;
}

}  // namespace

struct CellWalk::Group {
  std::array<DoublePair, kPairs> x, y;
  std::array<DoublePair, kPairs> best;     // squared
  std::array<DoublePair, kPairs> crossed;  // squared; edges up to this distance are crossed
  std::array<std::uint32_t, kLanes> line;
  std::size_t pairs = kPairs;  // number of pairs in use
  Box2 box;
  double far = kInfinity;  // the largest of `crossed`

  void take(std::size_t lane, double squared, std::uint32_t by) {
    best[lane / 2][lane % 2] = squared;
    crossed[lane / 2][lane % 2] = squared * (kCrossed * kCrossed);
    line[lane] = by;
  }
  void find_far() {
    far = 0.0;
    for (std::size_t i = 0; i < pairs; ++i) far = std::max({far, crossed[i][0], crossed[i][1]});
  }
};

struct CellWalk::Trail {
  Trail(std::uint32_t most_blocks, std::uint32_t most_lines)
      : longest(most_blocks),
        longest_in_lines(most_lines),
        queue(most_blocks),
        marks(std::bit_ceil(2 * most_blocks + 1)),
        last_mark(marks.size() - 1) {}

  const std::uint32_t longest;  ///< number of blocks that there is room for
  const std::uint32_t longest_in_lines;
  std::vector<std::uint32_t> queue;
  std::uint32_t head = 0;
  std::uint32_t tail = 0;
  std::uint32_t line_count = 0;
  /// A hash set of the blocks in the queue, each at its number or behind. Entries with another walk's number are free.
  struct Mark {
    std::uint32_t walk = 0;
    std::uint32_t block = 0;
  };
  std::vector<Mark> marks;
  const std::size_t last_mark;
  std::uint32_t number = 0;
  AxisEntry guess{.line = kNone};

  void begin() {
    ++number;
    head = tail = line_count = 0;
  }
  /// Adds a block that the walk has not reached yet. Returns false if the queue is full.
  bool add(std::uint32_t block) {
    std::size_t at = block & last_mark;
    for (; marks[at].walk == number; at = (at + 1) & last_mark)
      if (marks[at].block == block) return true;
    if (tail == longest) return false;
    marks[at] = {number, block};
    queue[tail++] = block;
    return true;
  }
};

struct CellWalk::Chunk {
  std::vector<EdgeSlot> axis;
  std::vector<EdgeSlot> curve;
  std::uint32_t first = 0;  // index of its first line
  std::vector<std::uint32_t> steep;

  // Curve edges and axis edges alternate without a pattern that a processor could predict, so no branch depends on them.
  void take_edges(const Delaunay& delaunay, const OneStepCrust& crust, std::size_t begin, std::size_t end) {
    axis.resize(end - begin);
    curve.resize(end - begin);
    std::size_t axis_count = 0;
    std::size_t curve_count = 0;
    for (const EdgeSlot edge : slots_between<EdgeSlot>(begin, end)) {
      if (!delaunay.edge(edge).is_alive()) continue;
      const bool is_curve = crust.is_crust(edge);
      axis[axis_count] = curve[curve_count] = edge;
      axis_count += is_curve ? 0U : 1U;
      curve_count += is_curve ? 1U : 0U;
    }
    axis.resize(axis_count);
    curve.resize(curve_count);
  }
};

CellWalk::CellWalk(const Delaunay& delaunay, const OneStepCrust& crust, double unit) {
  const std::size_t edges = delaunay.edge_rows();
  std::vector<Chunk> chunks(chunk_count(edges));
  run_tasks(chunks.size(), [&](std::size_t chunk) {
    chunks[chunk].take_edges(delaunay, crust, first_of_chunk(edges, chunk), first_of_chunk(edges, chunk + 1));
  });
  for (Chunk& chunk : chunks) {
    chunk.first = line_count_;
    line_count_ += static_cast<std::uint32_t>(chunk.axis.size());
  }
  lines_ = std::make_unique_for_overwrite<AxisLine[]>(line_count_);
  run_tasks(1 + chunks.size(), [&](std::size_t task) {
    if (task == 0) return order_cells(delaunay, chunks);
    Chunk& chunk = chunks[task - 1];
    std::uint32_t at = chunk.first;
    constexpr std::size_t kAhead = 16;
    for (std::size_t i = 0; i < chunk.axis.size(); ++i) {
      if (i + kAhead < chunk.axis.size())
        for (const FaceSlot face : delaunay.edge(chunk.axis[i + kAhead]).f) prefetch(delaunay.faces().address(face));
      lines_[at] = axis_line(delaunay, chunk.axis[i], unit);
      if (lines_[at].is_steep) chunk.steep.push_back(at);
      ++at;
    }
  });
  list_lines(delaunay, chunks);
  measure_blocks(delaunay, unit);
  Box2 box;
  for (const Block& block : blocks_) box.add(block.box);
  reach_ = 4.0 * (box.width() + box.height());
  for (const Chunk& chunk : chunks) {
    has_steep_ = has_steep_ || !chunk.steep.empty();
    for (const std::uint32_t line : chunk.steep)
      if (kSteep * lines_[line].half < 2.0 * reach_)
        for (const SiteSlot site : delaunay.edge(lines_[line].edge).v)
          vague_.push_back({line, block_of_[site], 0.0F});
  }
}

std::size_t CellWalk::part_count() const {
  return (blocks_.size() - 1 + kPart - 1) / kPart;
}

// Follows each chain of crust edges from where it is met first. A block ends where the curve does.
void CellWalk::order_cells(const Delaunay& delaunay, const std::vector<Chunk>& chunks) {
  // Most samples have two neighbours.
  struct Neighbours {
    SiteSlot two[2]{};
  };
  Table<SiteSlot, Neighbours> neighbours(delaunay.site_rows());
  std::vector<std::pair<SiteSlot, SiteSlot>> more;
  const auto join = [&](SiteSlot from, SiteSlot to) {
    auto& two = neighbours[from].two;
    if (two[0] == kNoSlot) {
      two[0] = to;
    } else if (two[1] == kNoSlot) {
      two[1] = to;
    } else {
      more.emplace_back(from, to);
    }
  };
  for (const Chunk& chunk : chunks)
    for (const EdgeSlot edge : chunk.curve) {
      const EdgeRow& row = delaunay.edge(edge);
      join(row.v[0], row.v[1]);
      join(row.v[1], row.v[0]);
    }
  block_of_.assign(delaunay.site_rows(), kNone);
  sites_.reserve(delaunay.site_count());
  blocks_.reserve(delaunay.site_count() / kBlock + 16);
  const auto begin_block = [&] { blocks_.emplace_back().first = static_cast<std::uint32_t>(sites_.size()); };
  for (const SiteSlot start : delaunay.site_slots()) {
    if (!delaunay.is_site(start)) continue;
    std::uint32_t count = 0;
    for (SiteSlot at = start; at != kNoSlot && block_of_[at] == kNone;) {
      if (count++ % kBlock == 0) begin_block();
      block_of_[at] = static_cast<std::uint32_t>(blocks_.size() - 1);
      sites_.push_back(at);
      SiteSlot next{};
      for (const SiteSlot other : neighbours[at].two)
        if (other != kNoSlot && block_of_[other] == kNone) next = other;
      at = next;
    }
  }
  begin_block();
  std::ranges::sort(more, {}, [this](const auto& pair) { return block_of_[pair.first]; });
  auto other = more.begin();
  for (std::uint32_t block = 0; block + 1 < blocks_.size(); ++block) {
    blocks_[block].first_link = static_cast<std::uint32_t>(links_.size());
    const auto link = [&](SiteSlot to) {
      if (block_of_[to] != block) links_.push_back(block_of_[to]);
    };
    for (std::uint32_t cell = blocks_[block].first; cell < blocks_[block + 1].first; ++cell)
      for (const SiteSlot to : neighbours[sites_[cell]].two)
        if (to != kNoSlot) link(to);
    for (; other != more.end() && block_of_[other->first] == block; ++other) link(other->second);
  }
  blocks_.back().first_link = static_cast<std::uint32_t>(links_.size());
}

// Runs of chunks first count, then write at the positions that the counts give. There are only a few runs, whatever the
// number of edges, because each counts for all blocks.
void CellWalk::list_lines(const Delaunay& delaunay, const std::vector<Chunk>& chunks) {
  constexpr std::size_t kMostRuns = 8;
  std::vector<std::vector<std::uint32_t>> places(std::min(kMostRuns, chunks.size()));
  const auto for_each_line = [&](std::size_t run, auto visit) {
    const std::size_t end = (run + 1) * chunks.size() / places.size();
    for (std::size_t i = run * chunks.size() / places.size(); i < end; ++i) {
      std::uint32_t line = chunks[i].first;
      for (const EdgeSlot edge : chunks[i].axis) {
        const EdgeRow& row = delaunay.edge(edge);
        visit(line++, block_of_[row.v[0]], block_of_[row.v[1]]);
      }
    }
  };
  run_tasks(places.size(), [&](std::size_t run) {
    std::vector<std::uint32_t>& counted = places[run];
    counted.assign(blocks_.size(), 0);
    for_each_line(run, [&](std::uint32_t, std::uint32_t a, std::uint32_t b) {
      ++counted[a];
      if (a != b) ++counted[b];
    });
  });
  std::uint32_t count = 0;
  for (std::size_t block = 0; block < blocks_.size(); ++block) {
    blocks_[block].first_entry = count;
    for (std::vector<std::uint32_t>& place : places) count += std::exchange(place[block], count);
  }
  entries_ = std::make_unique_for_overwrite<AxisEntry[]>(count);
  run_tasks(places.size(), [&](std::size_t run) {
    std::vector<std::uint32_t>& place = places[run];
    for_each_line(run, [&](std::uint32_t line, std::uint32_t a, std::uint32_t b) {
      const float reach = lowered(lines_[line].squared_reach());
      entries_[place[a]++] = {line, b, reach};
      if (a != b) entries_[place[b]++] = {line, a, reach};
    });
  });
}

void CellWalk::measure_blocks(const Delaunay& delaunay, double unit) {
  const std::size_t blocks = blocks_.size() - 1;
  places_.resize(sites_.size());
  run_tasks(part_count(), [&](std::size_t part) {
    for (std::size_t number = part * kPart; number < std::min((part + 1) * kPart, blocks); ++number) {
      Block& block = blocks_[number];
      const std::uint32_t end = blocks_[number + 1].first_entry;
      sort_by_reach(std::span(entries_.get() + block.first_entry, end - block.first_entry));
      for (std::uint32_t cell = block.first; cell < blocks_[number + 1].first; ++cell) {
        const Vec2 at = delaunay.site_position(sites_[cell]);
        places_[cell] = {at.x * unit, at.y * unit};
        block.box.add(places_[cell]);
      }
    }
  });
}

// Most blocks have some twenty entries: each counts the smaller ones, four at a time.
void CellWalk::sort_by_reach(std::span<AxisEntry> entries) {
  constexpr std::size_t kFew = 64;
  using Quad = float __attribute__((vector_size(4 * sizeof(float))));
  using QuadCount = decltype(Quad{} < Quad{});
  if (entries.size() > kFew) {
    std::ranges::sort(entries, {}, &AxisEntry::reach);
    return;
  }
  std::array<AxisEntry, kFew> before;
  std::array<Quad, kFew / 4> reach;
  std::array<std::uint8_t, kFew> taken{};
  const std::size_t quads = (entries.size() + 3) / 4;
  for (std::size_t i = 0; i < 4 * quads; ++i)
    reach[i / 4][i % 4] = i < entries.size() ? entries[i].reach : std::numeric_limits<float>::infinity();
  std::ranges::copy(entries, before.begin());
  for (std::size_t i = 0; i < entries.size(); ++i) {
    QuadCount less{};
    for (std::size_t k = 0; k < quads; ++k) less -= reach[k] < before[i].reach - Quad{};
    const auto at = static_cast<std::size_t>(less[0] + less[1] + less[2] + less[3]);
    entries[at + taken[at]++] = before[i];
  }
}

bool CellWalk::walk(Group& group, std::uint32_t own, Trail& trail) const {
  trail.begin();
  trail.add(own);
  // Measures these edges and adds the blocks beyond those that the walk crosses. Returns false if it becomes too long.
  const auto look_at = [&](std::span<const AxisEntry> entries) {
    for (const AxisEntry& entry : entries) {
      if (entry.reach > group.far) break;
      if (++trail.line_count > trail.longest_in_lines) return false;
      const AxisLine& line = lines_[entry.line];
      std::array<DoublePair, kPairs> squared;
      DoublePairMask is_crossed{};
      for (std::size_t i = 0; i < group.pairs; ++i) {
        const DoublePair ux = group.x[i] - line.q.x;
        const DoublePair uy = group.y[i] - line.q.y;
        const DoublePair aside = ux * line.along.x + uy * line.along.y - line.half;
        const DoublePair height = line.along.x * uy - line.along.y * ux;
        const DoublePair low = line.low - DoublePair{};
        const DoublePair high = line.high - DoublePair{};
        DoublePair on = height < low ? low : height;
        on = on > high ? high : on;
        const DoublePair rest = height - on;
        squared[i] = aside * aside + rest * rest;
        is_crossed |= squared[i] <= group.crossed[i];
      }
      if (!is_any_set(is_crossed)) continue;
      bool is_nearer = false;
      for (std::size_t k = 0; k < 2 * group.pairs; ++k) {
        if (!(squared[k / 2][k % 2] < group.best[k / 2][k % 2])) continue;
        group.take(k, squared[k / 2][k % 2], entry.line);
        is_nearer = true;
      }
      if (is_nearer) group.find_far();
      if (!trail.add(entry.other)) return false;
    }
    return true;
  };
  // The edge nearest to the group before is most often the nearest here, or not much farther.
  if (trail.guess.line != kNone) look_at(std::span(&trail.guess, 1));
  if (!look_at(entries_of(own))) return false;
  // It is unknown where vague edges end and whether the walk crosses them, so their cells are visited in any case.
  if (!look_at(vague_)) return false;
  for (const AxisEntry& entry : vague_)
    if (!trail.add(entry.other)) return false;
  while (trail.head != trail.tail) {
    const std::uint32_t number = trail.queue[trail.head++];
    const Block& block = blocks_[number];
    if (squared_distance(block.box, group.box) > 4.0 * group.far) continue;
    if (number != own && !look_at(entries_of(number))) return false;
    for (std::uint32_t i = block.first_link; i < blocks_[number + 1].first_link; ++i)
      if (!trail.add(links_[i])) return false;
  }
  // At larger distances the ends of steep edges matter.
  return !has_steep_ || group.far <= reach_ * reach_;
}

/// End of the group of cells in a block that walk with its cell `first`; `kLanes` cells at most.
std::uint32_t CellWalk::end_of_group(std::uint32_t first, std::uint32_t block) const {
  const std::span<const AxisEntry> entries = entries_of(block);
  const double room = entries.empty() ? kInfinity : kSpread * kSpread * double{entries[0].reach};
  const std::uint32_t most = std::min<std::uint32_t>(first + kLanes, blocks_[block + 1].first);
  std::uint32_t end = first + 1;
  while (end < most && dot(places_[end] - places_[first], places_[end] - places_[first]) <= room) ++end;
  return end;
}

/// Searches for the cells from `begin` to `end`, all in one block. False if the walk becomes too long.
bool CellWalk::search_group(std::uint32_t begin, std::uint32_t end, std::uint32_t block, Trail& trail,
                            Table<SiteSlot, double>& squared, Table<SiteSlot, EdgeSlot>& nearest) const {
  Group group;
  group.pairs = (end - begin + 1) / 2;
  for (std::uint32_t k = 0; k < 2 * group.pairs; ++k) {
    const Vec2 p = places_[std::min(begin + k, end - 1)];
    group.x[k / 2][k % 2] = p.x;
    group.y[k / 2][k % 2] = p.y;
    group.box.add(p);
  }
  group.best.fill(DoublePair{kInfinity, kInfinity});
  group.crossed.fill(DoublePair{kInfinity, kInfinity});
  group.line.fill(kNone);
  if (!walk(group, block, trail)) return false;
  for (std::uint32_t cell = begin; cell < end; ++cell) {
    const SiteSlot site = sites_[cell];
    squared[site] = group.best[(cell - begin) / 2][(cell - begin) % 2];
    if (const std::uint32_t line = group.line[cell - begin]; line != kNone) nearest[site] = lines_[line].edge;
  }
  trail.guess = {group.line[end - begin - 1], block, 0.0F};
  return true;
}

void CellWalk::search(std::size_t part, Table<SiteSlot, double>& squared, Table<SiteSlot, EdgeSlot>& nearest,
                      std::vector<SiteSlot>& given_up) const {
  Trail trail(kLongest, kMostLines);
  std::size_t longest_pause = kPause;
  std::size_t pause = vague_.size() > kMostVague ? sites_.size() : 0;
  const std::size_t last_block = std::min<std::size_t>((part + 1) * kPart, blocks_.size() - 1);
  for (auto block = static_cast<std::uint32_t>(part * kPart); block < last_block; ++block) {
    const std::uint32_t end = blocks_[block + 1].first;
    for (std::uint32_t first = blocks_[block].first; first < end;) {
      const std::uint32_t last = end_of_group(first, block);
      bool is_found = false;
      if (pause != 0) {
        --pause;
      } else {
        is_found = search_group(first, last, block, trail, squared, nearest);
        longest_pause = is_found ? kPause : std::min(2 * longest_pause, kLongestPause);
        if (!is_found) pause = longest_pause;
      }
      if (!is_found) given_up.insert(given_up.end(), sites_.begin() + first, sites_.begin() + last);
      first = last;
    }
  }
}

void CellWalk::search_longer(std::vector<SiteSlot>& given_up, Table<SiteSlot, double>& squared,
                             Table<SiteSlot, EdgeSlot>& nearest, JobControl& job) const {
  if (given_up.empty()) return;
  Trail trail(std::min(kLongestAgain, static_cast<std::uint32_t>(blocks_.size())), kMostLinesAgain);
  int failures = 0;
  std::vector<SiteSlot> left;
  for (std::size_t i = 0; i < given_up.size();) {
    job.checkpoint();
    const std::uint32_t block = block_of_[given_up[i]];
    std::uint32_t first = blocks_[block].first;
    while (sites_[first] != given_up[i]) ++first;
    // The samples were given up in these groups.
    const std::uint32_t last = end_of_group(first, block);
    if (failures == kMostFailures || !search_group(first, last, block, trail, squared, nearest)) {
      failures = std::min(failures + 1, kMostFailures);
      left.insert(left.end(), sites_.begin() + first, sites_.begin() + last);
    }
    i += last - first;
  }
  given_up = std::move(left);
}

}  // namespace mes
