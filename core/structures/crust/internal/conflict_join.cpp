// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/crust/internal/conflict_join.h"

#include <algorithm>
#include <utility>

namespace mes {

void ConflictJoin::toggle(EdgeSlot edge) {
  in_join_[edge] ^= 1U;
  changed_edges_.push_back(edge);
}

void ConflictJoin::dissolve(SiteSlot cluster) {
  for (SiteSlot site = cluster; site != kNoSlot;) {
    const Member member = std::exchange(member_[site], {});
    if (member.join != kNoSlot) toggle(member.join);
    site = member.next;
  }
}

bool ConflictJoin::grow(SiteSlot seed, JobControl& job) {
  if (!delaunay_.is_site(seed) || !is_odd(seed) || member_[seed].cluster != kNoSlot) return true;
  const bool closes = growth_.grow(
      seed, a_good_part(), [this](SiteSlot site) { return is_odd(site); }, job);
  const auto& steps = growth_.steps();
  if (!closes || steps.size() > may_grow_) return false;
  may_grow_ -= steps.size();
  parity_.assign(steps.size(), 0);
  // Dissolve clusters inside this one.
  for (const auto& step : steps)
    if (member_[step.site].cluster != kNoSlot) dissolve(member_[step.site].cluster);
  SiteSlot next;
  for (std::size_t i = steps.size(); i-- > 0;) {
    const CertaintyGrowth::Place place(i);
    const CertaintyGrowth::Step& step = steps[place];
    if (is_odd(step.site)) parity_[place] ^= 1U;
    const bool is_join = i > 0 && parity_[place] != 0;
    member_[step.site] = {seed, next, is_join ? step.rank.edge : EdgeSlot()};
    next = step.site;
    if (!is_join) continue;
    toggle(step.rank.edge);
    parity_[step.from] ^= 1U;
  }
  return true;
}

void ConflictJoin::make_room() {
  member_.resize(delaunay_.site_rows());
  in_join_.resize(delaunay_.edge_rows(), 0);
}

void ConflictJoin::clear() {
  member_.clear();
  in_join_.clear();
  changed_edges_.clear();
}

// Among random samples, 43 to 45 % are odd, and a cluster has thousands. In a lattice of shapes that are close together
// half of the samples may be odd, and a cluster has two.
bool ConflictJoin::promises_to_be_small(JobControl& job) {
  constexpr std::size_t kTries = 64;
  constexpr std::size_t kLimit = 256;
  const std::size_t rows = delaunay_.site_rows();
  const std::size_t step = rows / kTries + 1;
  std::size_t tries = 0;
  std::size_t grown = 0;
  for (std::size_t begin = 0; begin < rows; begin += step) {
    for (const SiteSlot site : slots_between<SiteSlot>(begin, std::min(begin + step, rows))) {
      if (!delaunay_.is_site(site) || !crust_.is_odd(site)) continue;
      if (!growth_.grow(
              site, kLimit, [this](SiteSlot one) { return crust_.is_odd(one); }, job))
        return false;
      ++tries;
      grown += growth_.steps().size();
      break;
    }
  }
  // A cluster is found from one of its odd sites, of which it has two or more.
  return tries == 0 || crust_.odd_count() / 2 * grown / tries < delaunay_.site_count();
}

bool ConflictJoin::rebuild(JobControl& job) {
  clear();
  if (crust_.odd_count() == 0 || delaunay_.dimension() < 2) return true;
  make_room();
  may_grow_ = a_good_part();
  if (crust_.odd_count() > 64 + delaunay_.site_count() / 3) {
    if (!promises_to_be_small(job)) return false;
    may_grow_ = delaunay_.site_count();
  }
  for (const SiteSlot site : delaunay_.site_slots())
    if (!grow(site, job)) return false;
  return true;
}

bool ConflictJoin::update(const std::vector<SiteSlot>& touched, JobControl& job) {
  changed_edges_.clear();
  make_room();
  seeds_.clear();
  const auto touch = [this](SiteSlot site) {
    seeds_.push_back(site);
    const SiteSlot cluster = member_[site].cluster;
    if (cluster == kNoSlot) return;
    for (SiteSlot one = cluster; one != kNoSlot; one = member_[one].next) seeds_.push_back(one);
    dissolve(cluster);
  };
  for (const SiteSlot site : touched) touch(site);
  for (const SiteSlot site : strokes_.changed_ends()) touch(site);
  may_grow_ = a_good_part();
  for (const SiteSlot site : seeds_)
    if (!grow(site, job)) return false;
  return true;
}

}  // namespace mes
