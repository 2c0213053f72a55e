// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/crust/curve.h"

#include <algorithm>

#include "core/base/sum.h"

namespace mes {

Curve::Curve(Delaunay& delaunay, OneStepCrust& crust, Labels& labels)
    : Structure("curve", {&delaunay, &crust, &labels}), delaunay_(delaunay), crust_(crust), labels_(labels) {}

EdgeSlot Curve::other_crust_edge(SiteSlot site, EdgeSlot edge) const {
  EdgeSlot found;
  delaunay_.for_each_edge_at(site, [&](EdgeSlot candidate, SiteSlot, FaceSlot) {
    if (candidate != edge && crust_.is_crust(candidate)) found = candidate;
  });
  return found;
}

void Curve::trace_from(EdgeSlot edge) {
  Chain chain;
  // Walk backwards to an end, or once around.
  EdgeSlot first_edge = edge;
  SiteSlot first_site = delaunay_.edge(edge).v[0];
  while (crust_.degree(first_site) == 2) {
    const EdgeSlot before = other_crust_edge(first_site, first_edge);
    if (before == edge) {
      chain.closed = true;
      break;
    }
    first_edge = before;
    first_site = other_end(before, first_site);
  }
  if (chain.closed) {
    first_edge = edge;
    first_site = delaunay_.edge(edge).v[0];
  }
  SiteSlot site = first_site;
  EdgeSlot at = first_edge;
  for (;;) {
    chain.sites.push_back(site);
    chain.edges.push_back(at);
    site = other_end(at, site);
    if (chain.closed ? site == first_site : crust_.degree(site) != 2) break;
    at = other_crust_edge(site, at);
  }
  if (!chain.closed) chain.sites.push_back(site);
  orient(chain);

  ChainSlot row = chains_.next();
  if (free_chains_.empty()) {
    chains_.emplace_back();
  } else {
    row = free_chains_.back();
    free_chains_.pop_back();
  }
  for (const EdgeSlot e : chain.edges) chain_of_edge_[e] = row;
  set_normals(chain);
  chains_[row] = std::move(chain);
}

void Curve::orient(Chain& chain) const {
  std::size_t left = 0;
  std::size_t right = 0;
  for (std::size_t i = 0; i < chain.edges.size(); ++i) {
    const EdgeRow& row = delaunay_.edge(chain.edges[i]);
    if (row.f[0] == kNoSlot) continue;
    const bool forward = row.v[0] == chain.sites[i];
    const bool inside_left = labels_.is_inside(row.f[forward ? 0 : 1]);
    const bool inside_right = labels_.is_inside(row.f[forward ? 1 : 0]);
    left += inside_left && !inside_right ? 1U : 0U;
    right += inside_right && !inside_left ? 1U : 0U;
  }
  chain.has_inside = left == chain.edges.size() || right == chain.edges.size();
  const auto position = [this](SiteSlot site) { return delaunay_.site_position(site); };
  bool turn = false;
  if (chain.has_inside) {
    turn = right != 0;
  } else if (!chain.closed) {
    // A chain may return to the site where it begins; then the next site decides.
    const std::size_t inwards = chain.sites.front() == chain.sites.back() ? 1 : 0;
    turn = lexicographically_less(position(chain.sites[chain.sites.size() - 1 - inwards]),
                                  position(chain.sites[inwards]));
  } else {
    const auto smallest =
        std::ranges::min_element(chain.sites, lexicographically_less, position) - chain.sites.begin();
    const auto n = static_cast<std::ptrdiff_t>(chain.sites.size());
    const SiteSlot before = chain.sites[static_cast<std::size_t>((smallest + n - 1) % n)];
    const SiteSlot after = chain.sites[static_cast<std::size_t>((smallest + 1) % n)];
    turn = lexicographically_less(position(before), position(after));
  }
  if (turn) {
    std::ranges::reverse(chain.sites);
    std::ranges::reverse(chain.edges);
    // In a loop, edges[i] must again join sites[i] and sites[i + 1].
    if (chain.closed) std::ranges::rotate(chain.edges, chain.edges.begin() + 1);
  }
  if (chain.closed) {
    const auto smallest =
        std::ranges::min_element(chain.sites, lexicographically_less, position) - chain.sites.begin();
    std::ranges::rotate(chain.sites, chain.sites.begin() + smallest);
    std::ranges::rotate(chain.edges, chain.edges.begin() + smallest);
  }
}

void Curve::set_normals(const Chain& chain) {
  const std::size_t n = chain.sites.size();
  // To the right of the direction: outside if the inside is on the left.
  const auto unit_normal = [&](SiteSlot from, SiteSlot to) {
    Vec2 d = delaunay_.site_position(to) - delaunay_.site_position(from);
    // Near the largest doubles the difference or its length overflows.
    if (!std::isfinite(length(d))) d = 0.25 * delaunay_.site_position(to) - 0.25 * delaunay_.site_position(from);
    const double size = length(d);
    return size > 0.0 ? Vec2{d.y / size, -d.x / size} : Vec2{};
  };
  for (std::size_t i = 0; i < n; ++i) {
    const SiteSlot site = chain.sites[i];
    // The ends have no normal; they may be ends of other chains, too.
    if (!chain.closed && (i == 0 || i + 1 == n)) continue;
    const SiteSlot before = chain.sites[i == 0 ? n - 1 : i - 1];
    const SiteSlot after = chain.sites[i + 1 == n ? 0 : i + 1];
    const Vec2 first = unit_normal(before, site);
    const Vec2 sum = first + unit_normal(site, after);
    const double size = length(sum);
    const Vec2 p = delaunay_.site_position(site);
    set_normal(
        site, size > 1e-12 ? (1.0 / size) * sum : first,
        0.5 * distance(delaunay_.site_position(before), p) + 0.5 * distance(p, delaunay_.site_position(after)));
    has_new_normal_.insert(site);
  }
}

// A long chain that is traced again keeps most of its normals.
void Curve::set_normal(SiteSlot site, Vec2 normal, double spacing) {
  if (normal_[site] != normal || spacing_[site] != spacing) recorder_.note(site, true);
  normal_[site] = normal;
  spacing_[site] = spacing;
}

void Curve::dissolve(ChainSlot row) {
  Chain& chain = chains_[row];
  if (chain.sites.empty()) return;
  for (const EdgeSlot edge : chain.edges)
    if (chain_of_edge_[edge] == row) chain_of_edge_[edge] = kNoSlot;
  dissolved_.insert(dissolved_.end(), chain.sites.begin(), chain.sites.end());
  seeds_.insert(seeds_.end(), chain.edges.begin(), chain.edges.end());
  chain = Chain{};
  free_chains_.push_back(row);
}

void Curve::rebuild(JobControl& job) {
  clear_changes();
  chains_.clear();
  free_chains_.clear();
  chain_of_edge_.assign(delaunay_.edge_rows(), kNoSlot);
  normal_.assign(delaunay_.site_rows(), Vec2{});
  spacing_.assign(delaunay_.site_rows(), 0.0);
  recorder_.begin(delaunay_.site_rows());
  has_new_normal_.begin(delaunay_.site_rows());
  for (const EdgeSlot edge : delaunay_.edge_slots()) {
    if ((edge.index() & 0xffffU) == 0) job.checkpoint(edge.index(), delaunay_.edge_rows());
    if (delaunay_.edge(edge).is_alive() && crust_.is_crust(edge) && chain_of_edge_[edge] == kNoSlot) trace_from(edge);
  }
}

bool Curve::update(JobControl&) {
  chain_of_edge_.resize(delaunay_.edge_rows(), kNoSlot);
  normal_.resize(delaunay_.site_rows(), Vec2{});
  spacing_.resize(delaunay_.site_rows(), 0.0);
  recorder_.begin(delaunay_.site_rows());
  has_new_normal_.begin(delaunay_.site_rows());
  seeds_.clear();
  dissolved_.clear();
  const auto touch = [this](EdgeSlot edge) {
    if (chain_of_edge_[edge] != kNoSlot) dissolve(chain_of_edge_[edge]);
    chain_of_edge_[edge] = kNoSlot;
    seeds_.push_back(edge);
  };
  for (const EdgeSlot edge : labels_.edge_changes().removed) touch(edge);
  for (const EdgeSlot edge : labels_.edge_changes().touched) touch(edge);
  // A site whose degree changed ends or joins chains, also through edges that did not change themselves.
  for (const SiteSlot site : crust_.site_changes().touched) recorder_.note(site, true);
  for (const SiteSlot site : crust_.degree_changes()) {
    delaunay_.for_each_edge_at(site, [&](EdgeSlot edge, SiteSlot, FaceSlot) {
      if (crust_.is_crust(edge)) touch(edge);
    });
  }
  for (const SiteSlot site : crust_.site_changes().removed) recorder_.note(site, true);
  for (std::size_t i = 0; i < seeds_.size(); ++i) {
    const EdgeSlot edge = seeds_[i];
    if (delaunay_.edge(edge).is_alive() && crust_.is_crust(edge) && chain_of_edge_[edge] == kNoSlot) trace_from(edge);
  }
  for (const SiteSlot site : dissolved_)
    if (!has_new_normal_.contains(site)) set_normal(site, {}, 0.0);
  recorder_.finish(site_changes_, [this](SiteSlot site) { return delaunay_.is_site(site); });
  return true;
}

StatList Curve::statistics() const {
  std::int64_t loops = 0;
  std::int64_t open = 0;
  Sum length_sum;
  Sum area;
  for (const Chain& chain : chains_) {
    if (chain.sites.empty()) continue;
    (chain.closed ? loops : open) += 1;
    const Vec2 origin = delaunay_.site_position(chain.sites.front());
    for (std::size_t i = 0; i < chain.edges.size(); ++i) {
      const Vec2 a = delaunay_.site_position(chain.sites[i]);
      const Vec2 b = delaunay_.site_position(chain.sites[i + 1 == chain.sites.size() ? 0 : i + 1]);
      length_sum.add(distance(a, b));
      if (chain.closed && chain.has_inside) area.add(0.5 * cross(a - origin, b - origin));
    }
  }
  std::int64_t isolated = 0;
  for (const SiteSlot site : delaunay_.site_slots())
    if (delaunay_.is_site(site) && crust_.degree(site) == 0) ++isolated;
  return {{"loops", loops},
          {"open_chains", open},
          {"isolated", isolated},
          {"length", length_sum.value()},
          {"area", area.value()}};
}

}  // namespace mes
