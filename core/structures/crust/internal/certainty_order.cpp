// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/crust/internal/certainty_order.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include "core/base/parallel.h"

namespace mes {

namespace {

std::pair<Vec2, Vec2> sorted_ends(const Delaunay& delaunay, EdgeSlot edge) {
  const Vec2 a = delaunay.site_position(delaunay.edge(edge).v[0]);
  const Vec2 b = delaunay.site_position(delaunay.edge(edge).v[1]);
  return lexicographically_less(b, a) ? std::pair(b, a) : std::pair(a, b);
}

}  // namespace

void CertaintyOrder::find_keys() {
  forget_keys();
  Table<EdgeSlot, double> keys(delaunay_.edge_rows(), 0.0);
  parallel_for(keys.size(), [&](std::size_t begin, std::size_t end, std::size_t) {
    for (const EdgeSlot edge : slots_between<EdgeSlot>(begin, end))
      if (delaunay_.edge(edge).is_alive()) keys[edge] = rank_of(edge).key;
  });
  keys_ = std::move(keys);
}

// Edges of a lattice are alike, or nearly so: comparing them two by two would make the same rational numbers again and
// again.
void CertaintyOrder::sort_run(std::span<Rank> run, JobControl& job) const {
  std::vector<EdgeCorners> corners;
  corners.reserve(run.size());
  for (const Rank& rank : run) corners.push_back(crust_.corners(rank.edge));
  const std::vector<std::uint32_t> place = ambiguity_places(corners, [&job] { job.checkpoint(); });
  struct Entry {
    std::uint32_t place = 0;
    std::pair<Vec2, Vec2> ends;
    Rank rank;
  };
  std::vector<Entry> entries;
  entries.reserve(run.size());
  for (std::size_t i = 0; i < run.size(); ++i)
    entries.push_back({place[i], sorted_ends(delaunay_, run[i].edge), run[i]});
  std::ranges::sort(entries, [](const Entry& a, const Entry& b) {
    if (a.place != b.place) return a.place < b.place;
    if (a.ends.first != b.ends.first) return lexicographically_less(a.ends.first, b.ends.first);
    return lexicographically_less(a.ends.second, b.ends.second);
  });
  std::ranges::transform(entries, run.begin(), &Entry::rank);
}

void CertaintyOrder::sort(std::vector<Rank>& ranks, JobControl& job) const {
  constexpr std::size_t kFew = 32;
  constexpr std::size_t kLongRun = 64;
  const auto exactly = [this](const Rank& a, const Rank& b) { return is_surer(b, a); };
  if (ranks.size() < kFew) {
    std::ranges::sort(ranks, exactly);
    return;
  }
  // By the keys first: into groups of some four, which are sorted on their own.
  const auto [low, high] = std::ranges::minmax(ranks, {}, &Rank::key);
  const std::size_t groups = ranks.size() / 4;
  const double per_group = static_cast<double>(groups) / std::max(high.key - low.key, 4.0 * kAmbiguityKeyError);
  const auto group_of = [low = low.key, per_group, groups](double key) {
    return std::min(static_cast<std::size_t>((key - low) * per_group), groups - 1);
  };
  std::vector<std::uint32_t> end(groups, 0);
  for (const Rank& rank : ranks) ++end[group_of(rank.key)];
  std::uint32_t total = 0;
  for (std::uint32_t& count : end) total += std::exchange(count, total);
  std::vector<Rank> sorted(ranks.size());
  for (const Rank& rank : ranks) sorted[end[group_of(rank.key)]++] = rank;
  const auto at = [&sorted](std::size_t i) { return sorted.begin() + static_cast<std::ptrdiff_t>(i); };
  for (std::size_t group = 0; group < groups; ++group)
    std::sort(at(group == 0 ? 0 : end[group - 1]), at(end[group]),
              [](const Rank& a, const Rank& b) { return a.key < b.key; });
  // Then exactly, in each run of keys that differ from the one before by no more than their errors.
  for (std::size_t begin = 0; begin < sorted.size();) {
    std::size_t next = begin + 1;
    while (next < sorted.size() && sorted[next].key - sorted[next - 1].key <= 2.0 * kAmbiguityKeyError) ++next;
    if (next - begin > kLongRun && sorted[begin].key >= 0.0)
      sort_run(std::span(sorted).subspan(begin, next - begin), job);
    else if (next - begin > 1)
      std::sort(at(begin), at(next), exactly);
    begin = next;
  }
  ranks.swap(sorted);
}

bool CertaintyOrder::mends(EdgeSlot edge) const {
  if (!keys_.empty()) return keys_[edge] < 0.0;
  const SiteSlot* end = delaunay_.edge(edge).v;
  if (!crust_.is_odd(end[0]) || !crust_.is_odd(end[1])) return false;
  // Which diagonals cocircular sites have is chance, and their triangles are one ball: never between different
  // labels.
  if (crust_.is_cocircular(edge)) return false;
  if (crust_.is_crust(edge)) return crust_.degree(end[0]) >= 3 && crust_.degree(end[1]) >= 3;
  return crust_.degree(end[0]) == 1 && crust_.degree(end[1]) == 1;
}

bool CertaintyOrder::is_surer_by_exact_test(const Rank& a, const Rank& b) const {
  int order = 0;
  if (a.key < 0.0) {
    const SiteSlot* of_a = delaunay_.edge(a.edge).v;
    const SiteSlot* of_b = delaunay_.edge(b.edge).v;
    order = compare_lengths(delaunay_.site_position(of_a[0]), delaunay_.site_position(of_a[1]),
                            delaunay_.site_position(of_b[0]), delaunay_.site_position(of_b[1]));
  } else {
    order = compare_ambiguity(crust_.corners(a.edge), crust_.corners(b.edge));
  }
  if (order != 0) return order > 0;
  const auto [a_low, a_high] = sorted_ends(delaunay_, a.edge);
  const auto [b_low, b_high] = sorted_ends(delaunay_, b.edge);
  if (a_low != b_low) return lexicographically_less(b_low, a_low);
  return lexicographically_less(b_high, a_high);
}

}  // namespace mes
