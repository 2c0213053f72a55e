// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/crust/internal/certainty_order.h"

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <utility>

#include "core/base/jobs/parallel.h"
#include "core/base/jobs/prefetch.h"
#include "core/structures/crust/internal/length_limits.h"
#include "core/structures/delaunay/sorted_ends.h"

namespace mes {

void CertaintyOrder::clear() {
  forget_keys();
  longest_ = {};
  changed_edges_.clear();
}

double CertaintyOrder::square(EdgeSlot edge) const {
  const SiteSlot* end = delaunay_.edge(edge).v;
  const Vec2 along = delaunay_.site_position(end[1]) - delaunay_.site_position(end[0]);
  return dot(along, along);
}

double CertaintyOrder::find_longest_at(SiteSlot site) const {
  double longest = 0.0;
  delaunay_.for_each_edge_at(site, [&](EdgeSlot edge, SiteSlot, FaceSlot) {
    if (crust_.is_wall(edge)) longest = std::max(longest, square(edge));
  });
  return longest;
}

double CertaintyOrder::longest_at(SiteSlot site) const {
  if (!longest_.has(site)) longest_.resize(delaunay_.site_rows(), kUnknown);
  double& longest = longest_[site];
  if (longest == kUnknown) longest = find_longest_at(site);
  return longest;
}

// The bits of non-negative doubles have the order of their values, so all cores can look for the largest at once.
void CertaintyOrder::find_all_longest() {
  longest_.assign(delaunay_.site_rows(), 0.0);
  parallel_for(delaunay_.edge_rows(), [&](std::size_t begin, std::size_t end, std::size_t) {
    for (const EdgeSlot edge : slots_between<EdgeSlot>(begin, end)) {
      if (!delaunay_.edge(edge).is_alive() || !crust_.is_wall(edge)) continue;
      const double length = square(edge);
      for (const SiteSlot site : delaunay_.edge(edge).v) {
        const std::atomic_ref longest(longest_[site]);
        double before = longest.load(std::memory_order_relaxed);
        while (before < length && !longest.compare_exchange_weak(before, length, std::memory_order_relaxed)) {
        }
      }
    }
  });
}

bool CertaintyOrder::is_long(EdgeSlot edge) const {
  if (crust_.is_wall(edge)) return false;
  const SiteSlot* end = delaunay_.edge(edge).v;
  const int order = compare_rounded(square(edge), kLong, std::max(longest_at(end[0]), longest_at(end[1])));
  if (order != 0) return order > 0;
  bool is_longer_than_all = true;
  for (const SiteSlot site : {end[0], end[1]})
    delaunay_.for_each_edge_at(site, [&](EdgeSlot other, SiteSlot far, FaceSlot) {
      if (!crust_.is_wall(other) || !is_longer_than_all) return;
      is_longer_than_all = is_longer(delaunay_.site_position(end[0]), delaunay_.site_position(end[1]), kLong,
                                     delaunay_.site_position(site), delaunay_.site_position(far));
    });
  return is_longer_than_all;
}

// Site by site, against the table's entries of the others: an edge that changes does so in one of these steps. If
// rounding decides, it may have changed. If one end of an edge is unknown, nothing depends on the edge.
void CertaintyOrder::update(const std::vector<SiteSlot>& touched) {
  changed_edges_.clear();
  if (longest_.empty()) return;
  longest_.resize(delaunay_.site_rows(), kUnknown);
  for (const SiteSlot site : touched) {
    const double before = longest_[site];
    if (before == kUnknown) continue;
    if (!delaunay_.is_site(site)) {
      longest_[site] = kUnknown;
      continue;
    }
    const double now = longest_[site] = find_longest_at(site);
    delaunay_.for_each_edge_at(site, [&](EdgeSlot edge, SiteSlot other, FaceSlot) {
      if (crust_.is_wall(edge) || longest_[other] == kUnknown) return;
      const double length = square(edge);
      const int order = compare_rounded(length, kLong, std::max(now, longest_[other]));
      if (order == 0 || order != compare_rounded(length, kLong, std::max(before, longest_[other])))
        changed_edges_.push_back(edge);
    });
  }
}

bool CertaintyOrder::has_other_kind(const Rank& rank) const {
  if (mends(rank.edge) != (rank.key < 0.0)) return true;
  return rank.key >= 0.0 && comes_last(rank.edge) != (rank.key >= kLast);
}

void CertaintyOrder::find_keys() {
  forget_keys();
  Table<EdgeSlot, double> keys;
  run_tasks(2, [&](std::size_t i) { i == 0 ? find_all_longest() : keys.assign(delaunay_.edge_rows(), 0.0); });
  // Prefetch the second face only: the rows of the first come in order.
  constexpr std::size_t kAhead = 16;
  parallel_for(keys.size(), [&](std::size_t begin, std::size_t end, std::size_t) {
    for (const EdgeSlot edge : slots_between<EdgeSlot>(begin, end)) {
      if (const EdgeSlot ahead(edge.index() + kAhead); ahead.index() < end)
        prefetch(delaunay_.faces().address(delaunay_.edge(ahead).f[1]));
      if (delaunay_.edge(edge).is_alive()) keys[edge] = rank_of(edge).key;
    }
  });
  keys_ = std::move(keys);
}

// Edges of a lattice are equally certain, or nearly so: comparing them in pairs would compute the same rational numbers
// again and again.
void CertaintyOrder::sort_run(std::span<Rank> run, JobControl& job) const {
  std::vector<EdgeCorners> corners;
  corners.reserve(run.size());
  for (const Rank& rank : run) corners.push_back(crust_.corners(rank.edge));
  const std::vector<std::uint32_t> place = ambiguity_places(corners, [&job] { job.checkpoint(); });
  struct Entry {
    std::uint32_t place = 0;
    std::array<Vec2, 2> ends;
    Rank rank;
  };
  std::vector<Entry> entries;
  entries.reserve(run.size());
  for (std::size_t i = 0; i < run.size(); ++i)
    entries.push_back({place[i], sorted_ends(delaunay_, run[i].edge), run[i]});
  std::ranges::sort(entries, [](const Entry& a, const Entry& b) {
    if (a.place != b.place) return a.place < b.place;
    if (a.ends[0] != b.ends[0]) return lexicographically_less(a.ends[0], b.ends[0]);
    return lexicographically_less(a.ends[1], b.ends[1]);
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
  // First by keys: into groups of about four, each of which is sorted on its own.
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
  parallel_for(groups, [&](std::size_t first, std::size_t last, std::size_t) {
    for (std::size_t group = first; group < last; ++group)
      std::sort(at(group == 0 ? 0 : end[group - 1]), at(end[group]),
                [](const Rank& a, const Rank& b) { return a.key < b.key; });
  });
  // Then exactly, in each run of keys that differ from the one before by at most their errors.
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
  // The diagonals of cocircular sites are arbitrary, and their triangles are one ball, which never has different
  // labels.
  if (crust_.is_cocircular(edge)) return false;
  if (crust_.is_wall(edge)) return crust_.wall_degree(end[0]) >= 3 && crust_.wall_degree(end[1]) >= 3;
  return crust_.wall_degree(end[0]) == 1 && crust_.wall_degree(end[1]) == 1 && !is_long(edge);
}

bool CertaintyOrder::is_surer_by_exact_test(const Rank& a, const Rank& b) const {
  int order = 0;
  if (a.key < 0.0) {
    const SiteSlot* of_a = delaunay_.edge(a.edge).v;
    const SiteSlot* of_b = delaunay_.edge(b.edge).v;
    order = compare_lengths(delaunay_.site_position(of_a[0]), delaunay_.site_position(of_a[1]),
                            delaunay_.site_position(of_b[0]), delaunay_.site_position(of_b[1]));
  } else if (const bool is_infinite = crust_.is_cocircular(a.edge); is_infinite || crust_.is_cocircular(b.edge)) {
    order = (is_infinite ? 1 : 0) - (crust_.is_cocircular(b.edge) ? 1 : 0);
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
