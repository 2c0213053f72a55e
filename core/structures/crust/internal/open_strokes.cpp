// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/crust/internal/open_strokes.h"

#include <algorithm>
#include <atomic>
#include <limits>
#include <utility>

#include "core/base/jobs/parallel.h"
#include "core/base/jobs/prefetch.h"
#include "core/structures/crust/internal/length_limits.h"
#include "core/structures/delaunay/sorted_ends.h"

namespace mes {

bool OpenStrokes::repairs(EdgeSlot edge) const {
  if (order_.mends(edge)) return true;
  const SiteSlot* end = delaunay_.edge(edge).v;
  return crust_.is_wall(edge) && crust_.is_odd(end[0]) && crust_.is_odd(end[1]) &&
         (crust_.wall_degree(end[0]) == 1 || crust_.wall_degree(end[1]) == 1);
}

void OpenStrokes::set_match(SiteSlot site, const Match& match) {
  if (noted_.insert(site)) matches_before_.push_back({site, match_[site]});
  match_[site] = match;
  degree_change_[site] = match.partner == kNoSlot ? 0 : (crust_.is_wall(match.edge) ? -1 : 1);
}

// Frees the site and its partner, if any, to look for others.
void OpenStrokes::part(SiteSlot site) {
  const SiteSlot partner = match_[site].partner;
  set_match(site, {});
  if (partner == kNoSlot) return;
  set_match(partner, {});
  proposers_.push_back(partner);
}

// The most doubtful edge of the site that it and the other end would take.
OpenStrokes::Proposal OpenStrokes::best_proposal(SiteSlot site) const {
  Proposal best{{}, site, kNoSlot};
  if (!delaunay_.is_site(site) || !crust_.is_odd(site)) return best;
  delaunay_.for_each_edge_at(site, [&](EdgeSlot edge, SiteSlot other, FaceSlot) {
    if (!repairs(edge)) return;
    const CertaintyOrder::Rank rank = order_.rank_of(edge);
    if (best.partner != kNoSlot && order_.is_surer(rank, best.rank)) return;
    if (would_take(site, rank) && would_take(other, rank)) best = {rank, site, other};
  });
  return best;
}

void OpenStrokes::match(const Proposal& proposal) {
  const auto& [rank, site, partner] = proposal;
  part(site);
  part(partner);
  set_match(site, {rank.edge, partner});
  set_match(partner, {rank.edge, site});
}

// Matches those that are each other's first choice, which most are where the partner is near, and keeps the proposals
// of the others. No site is matched twice, and nothing has to be put in order.
void OpenStrokes::match_first_choices(JobControl& job) {
  first_choice_.resize(delaunay_.site_rows());
  const std::vector<SiteSlot> proposers = std::exchange(proposers_, {});
  for (std::size_t i = 0; i < proposers.size(); ++i) {
    if ((i & 1023U) == 0) job.checkpoint();
    const Proposal best = best_proposal(proposers[i]);
    if (best.partner == kNoSlot) continue;
    first_choice_[best.site] = best.rank.edge;
    proposals_.push_back(best);
  }
  std::erase_if(proposals_, [this](const Proposal& proposal) {
    if (match_[proposal.site].edge == proposal.rank.edge) return true;
    if (first_choice_[proposal.partner] != proposal.rank.edge) return false;
    match(proposal);
    return true;
  });
  for (const SiteSlot site : proposers) first_choice_[site] = kNoSlot;
}

// Sites propose along their most doubtful edge to those that are free or prefer it to theirs. The result does not
// depend on the order of proposals, since all agree on which edges are better. The best come first, as far as keys and
// places tell, so that hardly a match is undone: what a site that is left proposes next is worse than what it had.
void OpenStrokes::match_all(JobControl& job) {
  const auto is_worse = [this](const Proposal& a, const Proposal& b) {
    if (a.rank.key != b.rank.key) return a.rank.key > b.rank.key;
    const auto [a_low, a_high] = sorted_ends(delaunay_, a.rank.edge);
    const auto [b_low, b_high] = sorted_ends(delaunay_, b.rank.edge);
    return a_low != b_low ? lexicographically_less(b_low, a_low) : lexicographically_less(b_high, a_high);
  };
  const auto propose = [&](SiteSlot site) {
    const Proposal best = best_proposal(site);
    if (best.partner == kNoSlot) return;
    proposals_.push_back(best);
    std::ranges::push_heap(proposals_, is_worse);
  };
  proposals_.clear();
  match_first_choices(job);
  std::ranges::make_heap(proposals_, is_worse);
  std::size_t done = 0;
  for (;;) {
    for (; !proposers_.empty(); ++done) {
      if ((done & 1023U) == 0) job.checkpoint();
      const SiteSlot site = proposers_.back();
      proposers_.pop_back();
      propose(site);
    }
    if (proposals_.empty()) return;
    const Proposal best = proposals_.front();
    std::ranges::pop_heap(proposals_, is_worse);
    proposals_.pop_back();
    if (match_[best.site].edge == best.rank.edge) continue;
    if (would_take(best.site, best.rank) && would_take(best.partner, best.rank))
      match(best);
    else
      proposers_.push_back(best.site);
  }
}

bool OpenStrokes::is_on_curve(EdgeSlot edge) const {
  return crust_.is_wall(edge) != (match_[delaunay_.edge(edge).v[0]].edge == edge);
}

void OpenStrokes::watch(ChainSlot chain, SiteSlot site) {
  WatchSlot slot = watches_.next();
  if (free_watches_.empty()) {
    watches_.emplace_back();
  } else {
    slot = free_watches_.back();
    free_watches_.pop_back();
  }
  const WatchSlot next = first_watch_[site];
  watches_[slot] = {chain, site, next, kNoSlot};
  if (next != kNoSlot) watches_[next].previous = slot;
  first_watch_[site] = slot;
  chains_[chain].watched.push_back(slot);
}

void OpenStrokes::toggle(const Chain& chain) {
  for (const EdgeSlot edge : chain.edges) {
    on_stroke_[edge] ^= 1U;
    changed_edges_.push_back(edge);
  }
  for (const SiteSlot site : {chain.begin, chain.end}) {
    is_end_[site] ^= 1U;
    changed_ends_.push_back(site);
  }
}

void OpenStrokes::forget(ChainSlot slot) {
  Chain& chain = chains_[slot];
  for (const WatchSlot watch : chain.watched) {
    const auto& [of, site, next, previous] = watches_[watch];
    if (next != kNoSlot) watches_[next].previous = previous;
    (previous == kNoSlot ? first_watch_[site] : watches_[previous].next) = next;
    free_watches_.push_back(watch);
  }
  if (!chain.edges.empty()) {
    toggle(chain);
    --count_;
  }
  begins_.push_back(chain.begin);
  chain = {};
  free_chains_.push_back(slot);
}

void OpenStrokes::forget_those_at(SiteSlot site) {
  while (first_watch_[site] != kNoSlot) forget(watches_[first_watch_[site]].chain);
}

bool OpenStrokes::grow(SiteSlot site, std::size_t reach, Walk& walk, JobControl& job) const {
  return walk.growth.grow(
      site, reach, [this](SiteSlot one) { return (curve_degree(one) & 1) != 0; }, job);
}

bool OpenStrokes::finds_partner(SiteSlot site, std::size_t reach, Walk& walk, JobControl& job) const {
  const bool finds = grow(site, reach, walk, job);
  for (const auto& step : walk.growth.steps()) walk.met.push_back(step.site);
  return finds;
}

// If one end finds a partner that is not the other end, the other's growth does not matter: looking a little way from
// both first decides most chains of noise.
bool OpenStrokes::finds_other_nearby(SiteSlot a, SiteSlot b, Walk& walk, JobControl& job) const {
  for (const auto& [from, to] : {std::pair(b, a), std::pair(a, b)}) {
    if (!grow(from, kNearby, walk, job) || walk.growth.holds(to)) continue;
    for (const auto& step : walk.growth.steps()) walk.met.push_back(step.site);
    return true;
  }
  return false;
}

bool OpenStrokes::are_near(SiteSlot a, SiteSlot b, const std::vector<EdgeSlot>& edges) const {
  const auto ends = [this](EdgeSlot edge) {
    const SiteSlot* end = delaunay_.edge(edge).v;
    return std::pair(delaunay_.site_position(end[0]), delaunay_.site_position(end[1]));
  };
  const auto square = [](Vec2 from, Vec2 to) { return dot(to - from, to - from); };
  const Vec2 at_a = delaunay_.site_position(a);
  const Vec2 at_b = delaunay_.site_position(b);
  double longest = 0.0;
  for (const EdgeSlot edge : edges) longest = std::max(longest, square(ends(edge).first, ends(edge).second));
  const int order = compare_rounded(square(at_a, at_b), kGap, longest);
  if (order != 0) return order < 0;
  return std::ranges::any_of(
      edges, [&](EdgeSlot edge) { return !is_longer(at_a, at_b, kGap, ends(edge).first, ends(edge).second); });
}

bool OpenStrokes::is_open(SiteSlot a, SiteSlot b, Walk& walk, JobControl& job) const {
  using Place = CertaintyGrowth::Place;
  const std::size_t edges = walk.edges.size();
  if (are_near(a, b, walk.edges)) return false;
  if (finds_other_nearby(a, b, walk, job)) return false;
  const std::size_t reach = kReach + (edges + 1) / kStrokeSites;
  const bool b_finds = finds_partner(b, reach, walk, job);
  const std::size_t component = walk.growth.steps().size();
  if (b_finds && !walk.growth.holds(a)) return false;
  const bool a_finds = finds_partner(a, reach, walk, job);
  if (!a_finds && !b_finds) return true;
  if (!a_finds || !b_finds || walk.growth.steps().size() != component) return false;
  std::size_t apart = 0;
  const auto& steps = walk.growth.steps();
  Place at(0);
  while (steps[at].site != b) ++at;
  for (; steps[at].from != kNoSlot; at = steps[at].from) ++apart;
  return apart > 2 && edges + 1 < kStrokeSites * component;
}

// The curve edge at the site that is not `last`; there is only one, so stopping there halves the search.
EdgeSlot OpenStrokes::next_on_curve(SiteSlot site, EdgeSlot last) const {
  FaceSlot at = delaunay_.site_face(site);
  for (;;) {
    const FaceRow& row = delaunay_.face(at);
    const int i = row.index_of_site(site);
    const EdgeSlot edge = row.e[prev3(i)];
    if (edge != kNoSlot && edge != last && is_on_curve(edge)) return edge;
    at = row.n[next3(i)];
  }
}

SiteSlot OpenStrokes::end_of_stroke(SiteSlot begin, Walk& walk, JobControl& job) const {
  walk.edges.clear();
  walk.met.clear();
  walk.end = kNoSlot;
  std::size_t most_edges = std::numeric_limits<std::size_t>::max();
  SiteSlot site = begin;
  for (;;) {
    walk.met.push_back(site);
    if (site != begin && curve_degree(site) != 2) break;
    const EdgeSlot on = next_on_curve(site, walk.edges.empty() ? EdgeSlot() : walk.edges.back());
    walk.edges.push_back(on);
    site = delaunay_.edge(on).v[delaunay_.edge(on).v[0] == site ? 1 : 0];
    if ((walk.edges.size() & 1023U) == 0) job.checkpoint();
    // Around a closed curve with a gap the walk is long, but the partner is near.
    if (walk.edges.size() == kLong && finds_partner(begin, kReach, walk, job))
      most_edges = kStrokeSites * walk.growth.steps().size();
    if (walk.edges.size() + 1 >= most_edges) return {};
  }
  // A stroke is recorded once, at its end with the lower row: the other end may depend on fewer sites.
  if (curve_degree(site) != 1) return {};
  walk.end = site;
  if (site < begin || !is_open(begin, site, walk, job)) return {};
  return site;
}

OpenStrokes::ChainSlot OpenStrokes::new_chain(SiteSlot begin) {
  ChainSlot slot = chains_.next();
  if (free_chains_.empty()) {
    chains_.emplace_back();
  } else {
    slot = free_chains_.back();
    free_chains_.pop_back();
  }
  chains_[slot].begin = begin;
  return slot;
}

void OpenStrokes::note_stroke(ChainSlot slot, SiteSlot end, const std::vector<EdgeSlot>& edges) {
  Chain& chain = chains_[slot];
  chain.end = end;
  chain.edges = edges;
  toggle(chain);
  ++count_;
}

void OpenStrokes::find_chain(SiteSlot begin, JobControl& job) {
  if (!delaunay_.is_site(begin) || curve_degree(begin) != 1) return;
  // The chain that begins here is known already.
  for (WatchSlot at = first_watch_[begin]; at != kNoSlot; at = watches_[at].next)
    if (chains_[watches_[at].chain].begin == begin) return;
  const ChainSlot slot = new_chain(begin);
  const SiteSlot end = end_of_stroke(begin, walk_, job);
  for (const SiteSlot site : walk_.met) watch(slot, site);
  if (end != kNoSlot) note_stroke(slot, end, walk_.edges);
}

// Runs on all cores, without recording the sites that the outcome depends on.
void OpenStrokes::find_strokes(const std::vector<SiteSlot>& begins, const Table<EdgeSlot, std::uint8_t>& tree,
                               JobControl& job) {
  constexpr std::size_t kPiece = 512;
  const std::size_t pieces = (begins.size() + kPiece - 1) / kPiece;
  std::vector<std::vector<Stroke>> found(pieces);
  std::atomic<std::size_t> next_piece{0};
  // A stroke is noted at its first end only, so a walk from the other end finds nothing and can be skipped. The order of
  // the threads decides which walks are skipped; the result is the same.
  std::vector<std::atomic<bool>> is_known(delaunay_.site_rows());
  run_tasks(std::min(worker_count(), pieces), [&](std::size_t) {
    Walk walk{CertaintyGrowth(delaunay_, order_, &tree)};
    for (std::size_t piece = next_piece++; piece < pieces; piece = next_piece++) {
      job.checkpoint();
      for (std::size_t i = kPiece * piece; i < std::min(kPiece * (piece + 1), begins.size()); ++i) {
        if (is_known[begins[i].index()].load(std::memory_order_relaxed)) continue;
        const SiteSlot end = end_of_stroke(begins[i], walk, job);
        if (walk.end != kNoSlot && begins[i] < walk.end)
          is_known[walk.end.index()].store(true, std::memory_order_relaxed);
        if (end != kNoSlot) found[piece].push_back({begins[i], end, walk.edges});
      }
    }
  });
  for (const std::vector<Stroke>& strokes : found)
    for (const Stroke& stroke : strokes) note_stroke(new_chain(stroke.begin), stroke.end, stroke.edges);
}

void OpenStrokes::make_room() {
  match_.resize(delaunay_.site_rows());
  degree_change_.resize(delaunay_.site_rows(), 0);
  is_end_.resize(delaunay_.site_rows(), 0);
  first_watch_.resize(delaunay_.site_rows());
  on_stroke_.resize(delaunay_.edge_rows(), 0);
}

void OpenStrokes::clear() {
  match_.clear();
  degree_change_.clear();
  is_end_.clear();
  first_watch_.clear();
  on_stroke_.clear();
  chains_.clear();
  free_chains_.clear();
  watches_.clear();
  free_watches_.clear();
  count_ = 0;
  proposers_.clear();
  first_choice_.clear();
  matches_before_.clear();
  begins_.clear();
  changed_edges_.clear();
  changed_ends_.clear();
}

// Gives the result of `match_all` if the keys of all edges are known: all agree on which edges are better, so they are
// taken in that order, each if both of its ends are still free. Nothing may be matched before.
void OpenStrokes::match_in_order(JobControl& job) {
  std::vector<std::vector<CertaintyOrder::Rank>> found(chunk_count(delaunay_.edge_rows()));
  parallel_for(delaunay_.edge_rows(), [&](std::size_t begin, std::size_t end, std::size_t chunk) {
    for (const EdgeSlot edge : slots_between<EdgeSlot>(begin, end))
      if (delaunay_.edge(edge).is_alive() && repairs(edge)) found[chunk].push_back(order_.rank_of(edge));
  });
  std::vector<CertaintyOrder::Rank> repairing;
  for (const auto& ranks : found) repairing.insert(repairing.end(), ranks.begin(), ranks.end());
  order_.sort(repairing, job);
  constexpr std::size_t kAhead = 16;
  for (std::size_t i = 0; i < repairing.size(); ++i) {
    if (i + 2 * kAhead < repairing.size()) prefetch(delaunay_.edges().address(repairing[i + 2 * kAhead].edge));
    if (i + kAhead < repairing.size())
      for (const SiteSlot site : delaunay_.edge(repairing[i + kAhead].edge).v) prefetch(match_.address(site));
    const EdgeSlot edge = repairing[i].edge;
    const SiteSlot* end = delaunay_.edge(edge).v;
    if (match_[end[0]].partner != kNoSlot || match_[end[1]].partner != kNoSlot) continue;
    match_[end[0]] = {edge, end[1]};
    match_[end[1]] = {edge, end[0]};
    degree_change_[end[0]] = degree_change_[end[1]] = static_cast<std::int8_t>(crust_.is_wall(edge) ? -1 : 1);
  }
}

void OpenStrokes::rebuild(JobControl& job) {
  // If interrupted, the rebuild is done again before anything is updated.
  is_ready_to_update_ = false;
  clear();
  if (crust_.odd_count() == 0 || delaunay_.dimension() < 2) {
    is_ready_to_update_ = true;
    return;
  }
  make_room();
  noted_.begin(delaunay_.site_rows());
  for (const SiteSlot site : delaunay_.site_slots())
    if (delaunay_.is_site(site) && crust_.is_odd(site)) proposers_.push_back(site);
  begins_ = proposers_;
  match_all(job);
  for (const SiteSlot site : begins_) find_chain(site, job);
  is_ready_to_update_ = true;
}

void OpenStrokes::rebuild_for_labels_alone(const Table<EdgeSlot, std::uint8_t>& tree, JobControl& job) {
  clear();
  is_ready_to_update_ = false;
  make_room();
  match_in_order(job);
  job.checkpoint();
  for (const SiteSlot site : delaunay_.site_slots())
    if (delaunay_.is_site(site) && curve_degree(site) == 1) begins_.push_back(site);
  find_strokes(begins_, tree, job);
}

void OpenStrokes::update(const std::vector<SiteSlot>& touched, JobControl& job) {
  changed_edges_.clear();
  changed_ends_.clear();
  make_room();
  noted_.begin(delaunay_.site_rows());
  matches_before_.clear();
  proposers_.clear();
  for (const SiteSlot site : touched) {
    part(site);
    proposers_.push_back(site);
  }
  match_all(job);
  begins_ = touched;
  for (const SiteSlot site : touched) forget_those_at(site);
  for (const auto& [site, before] : matches_before_) {
    if (match_[site] == before) continue;
    forget_those_at(site);
    begins_.push_back(site);
  }
  for (std::size_t i = 0; i < begins_.size(); ++i) find_chain(begins_[i], job);
}

}  // namespace mes
