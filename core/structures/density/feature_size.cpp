// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/density/feature_size.h"

#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <string>
#include <utility>

#include "core/base/geometry/coordinate_range.h"
#include "core/base/geometry/infinity.h"
#include "core/base/jobs/parallel.h"
#include "core/kernel/corner_angle.h"
#include "core/structures/density/cell_walk.h"

namespace mes {
namespace {

/// Exponents of coordinates may differ this much from those that the unit was chosen for, before another is chosen.
constexpr int kExponentsApart = 200;
/// Largest number of sites that query together, and largest size of their box over the smallest distance that one of
/// them begins with.
constexpr std::size_t kGroup = 8;
constexpr double kGroupWidth = 0.5;
/// Edges that a group visits at most, before its sites search one by one.
constexpr std::size_t kMostOfGroup = 1000;

/// Turn of the curve at a point, in degrees.
double turn_of(Vec2 before, Vec2 at, Vec2 after) {
  return 180.0 - angle_at(at, before, after);
}

/// True if products alone show that the turn is less than 20 degrees; false for some such turns.
bool goes_on_nearly_straight(Vec2 before, Vec2 at, Vec2 after) {
  constexpr double kLeastCosine = 0.94;
  const Vec2 in = at - before;
  const Vec2 out = after - at;
  const double along = dot(in, out);
  return along > 0x1p-400 && along * along > kLeastCosine * kLeastCosine * (dot(in, in) * dot(out, out));
}

}  // namespace

FeatureSize::FeatureSize(Delaunay& delaunay, OneStepCrust& crust)
    : FeatureSize(delaunay, crust, {&delaunay, &crust}, nullptr) {}

FeatureSize::FeatureSize(Delaunay& delaunay, OneStepCrust& crust, CurveSampling& curves)
    : FeatureSize(delaunay, crust, {&delaunay, &crust, &curves}, &curves) {}

FeatureSize::FeatureSize(Delaunay& delaunay, OneStepCrust& crust, std::vector<Structure*> inputs,
                         const CurveSampling* curves)
    : Structure("feature-size", std::move(inputs)), delaunay_(delaunay), crust_(crust), curves_(curves) {}

std::string_view FeatureSize::reason() const {
  if (has_axis()) return {};
  return delaunay_.dimension() < 2 ? "fewer than three samples, or all of them on a line: there is no axis"
                                   : "all edges between samples are curve: there is no axis";
}

bool FeatureSize::has_epsilon(EdgeSlot edge) const {
  const EdgeRow& row = delaunay_.edge(edge);
  return row.is_alive() && crust_.is_crust(edge) && has_size(row.v[0]) && has_size(row.v[1]) &&
         std::min(squared_[row.v[0]], squared_[row.v[1]]) > 0.0;
}

double FeatureSize::epsilon(EdgeSlot edge) const {
  const EdgeRow& row = delaunay_.edge(edge);
  return 0.5 * distance(delaunay_.site_position(row.v[0]), delaunay_.site_position(row.v[1])) /
         std::min(size(row.v[0]), size(row.v[1]));
}

EdgeSlot FeatureSize::sparsest_edge() const {
  if (!epsilons_.is_empty()) return epsilons_.largest() >= 0.0 ? epsilons_.row_of_largest() : EdgeSlot();
  EdgeSlot out{};
  double most = -1.0;
  for (const EdgeSlot edge : delaunay_.edge_slots()) {
    if (!has_epsilon(edge)) continue;
    const double now = epsilon(edge);
    if (now < most || ends_at_exempt(edge)) continue;
    if (!(now > most) && !(now == most && is_first(edge, out))) continue;
    most = now;
    out = edge;
  }
  return out;
}

std::array<SiteSlot, 2> FeatureSize::crust_neighbours(SiteSlot site) const {
  std::array<SiteSlot, 2> out{kNoSlot, kNoSlot};
  std::size_t count = 0;
  delaunay_.for_each_edge_at(site, [&](EdgeSlot edge, SiteSlot other, FaceSlot) {
    if (crust_.is_crust(edge) && count < out.size()) out[count++] = other;
  });
  // Their order must not depend on that of the edges.
  if (count == 2 && lexicographically_less(delaunay_.site_position(out[1]), delaunay_.site_position(out[0])))
    std::swap(out[0], out[1]);
  return out;
}

/// Turn of the crust at a site, in degrees; 0 unless the site has two crust edges.
double FeatureSize::turn_at(SiteSlot site) const {
  if (crust_.degree(site) != 2) return 0.0;
  const auto [a, b] = crust_neighbours(site);
  return turn_of(delaunay_.site_position(a), delaunay_.site_position(site), delaunay_.site_position(b));
}

FeatureSize::Exemption FeatureSize::exemption_of(SiteSlot site) const {
  if (crust_.degree(site) == 0) return Exemption::alone;
  if (crust_.degree(site) != 2) return crust_.degree(site) == 1 ? Exemption::end : Exemption::junction;
  static const double kLeast = 2.0 * std::asin(kDenseEpsilon) * 180.0 / std::numbers::pi;
  constexpr double kMoreThanNeighbours = 4.0;
  const auto [a, b] = crust_neighbours(site);
  if (goes_on_nearly_straight(place_of(a), place_of(site), place_of(b))) return Exemption::none;
  const double turn = turn_of(delaunay_.site_position(a), delaunay_.site_position(site), delaunay_.site_position(b));
  return turn > kLeast && turn > kMoreThanNeighbours * (turn_at(a) + turn_at(b)) ? Exemption::corner
                                                                                 : Exemption::none;
}

FeatureSize::Exempt FeatureSize::count_exempt() const {
  const std::size_t rows = delaunay_.site_rows();
  std::vector<Exempt> parts(chunk_count(rows));
  parallel_for(rows, [&](std::size_t begin, std::size_t end, std::size_t chunk) {
    for (std::size_t i = begin; i < end; ++i)
      if (const SiteSlot site(i); delaunay_.is_site(site))
        ++parts[chunk][static_cast<std::size_t>(exemption_of(site))];
  });
  Exempt out{};
  for (const Exempt& part : parts)
    for (std::size_t i = 0; i < out.size(); ++i) out[i] += part[i];
  return out;
}

void FeatureSize::set_exemption(SiteSlot site, Exemption now) {
  --exempt_[static_cast<std::size_t>(exemption_[site])];
  ++exempt_[static_cast<std::size_t>(now)];
  exemption_[site] = now;
}

std::optional<SamplingEpsilon> FeatureSize::estimated_epsilon() const {
  const EdgeSlot edge = sparsest_edge();
  if (edge == kNoSlot) return std::nullopt;
  const Exempt exempt = is_ready_ ? exempt_ : count_exempt();
  return SamplingEpsilon{.value = epsilon(edge),
                         .corners = exempt[static_cast<std::size_t>(Exemption::corner)],
                         .ends = exempt[static_cast<std::size_t>(Exemption::end)],
                         .junctions = exempt[static_cast<std::size_t>(Exemption::junction)],
                         .is_estimate = true};
}

bool FeatureSize::ends_at_exempt(EdgeSlot edge) const {
  const auto& [a, b] = delaunay_.edge(edge).v;
  return is_exempt(a) || is_exempt(b);
}

// Compares the lesser ends, and then the greater ones.
bool FeatureSize::is_first(EdgeSlot a, EdgeSlot b) const {
  const auto key = [this](EdgeSlot edge) {
    const EdgeRow& row = delaunay_.edge(edge);
    const Vec2 p = delaunay_.site_position(row.v[0]);
    const Vec2 q = delaunay_.site_position(row.v[1]);
    const std::pair ends(std::array{p.x, p.y}, std::array{q.x, q.y});
    return ends.first < ends.second ? ends : std::pair(ends.second, ends.first);
  };
  return key(a) < key(b);
}

// Coordinates have exponents up to 500 in either direction, and squares of distances must not leave the range of
// doubles. A unit that is a power of two changes no last bit, so any unit not too far from the coordinates will do.
bool FeatureSize::fits(SiteSlot site) const {
  const Vec2 at = delaunay_.site_position(site);
  return std::ranges::all_of(std::array{at.x, at.y}, [this](double x) {
    return x == 0.0 || std::abs(exponent_of(x) - exponent_) < kExponentsApart;
  });
}

void FeatureSize::choose_unit() {
  double most = 0.0;
  for (const SiteSlot site : delaunay_.site_slots()) {
    if (!delaunay_.is_site(site)) continue;
    const Vec2 at = delaunay_.site_position(site);
    most = std::max({most, std::abs(at.x), std::abs(at.y)});
  }
  exponent_ = most > 0.0 ? exponent_of(most) : 0;
  unit_ = std::ldexp(1.0, -exponent_);
}

std::vector<AxisLine> FeatureSize::all_lines() const {
  std::vector<EdgeSlot> edges;
  for (const EdgeSlot edge : delaunay_.edge_slots())
    if (is_axis(edge)) edges.push_back(edge);
  std::vector<AxisLine> lines(edges.size());
  parallel_for(edges.size(), [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t i = begin; i < end; ++i) lines[i] = axis_line(delaunay_, edges[i], unit_);
  });
  return lines;
}

void FeatureSize::make_line_tree(std::span<const AxisLine> lines) {
  line_at_.assign(delaunay_.edge_rows(), kNowhere);
  lines_.build(
      lines, [](const AxisLine& line) { return line.bounds(); },
      [this](const AxisLine& line, std::uint32_t place) { line_at_[line.edge] = place; });
}

void FeatureSize::make_ball_tree() {
  std::vector<Ball> balls;
  ball_at_.assign(delaunay_.site_rows(), kNowhere);
  reach_ = squared_;
  for (const SiteSlot site : squared_.rows())
    if (delaunay_.is_site(site) && has_size(site)) balls.push_back({place_of(site), site});
  balls_.build(
      std::span<const Ball>(balls),
      [this](const Ball& ball) {
        return TreeBounds{{ball.center, ball.center}, std::sqrt(reach_[ball.site])};
      },
      [this](const Ball& ball, std::uint32_t place) { ball_at_[ball.site] = place; });
}

FeatureSize::Found FeatureSize::search(Vec2 p, Found best) const {
  lines_.visit_near(p, best.squared, [&](const AxisLine& line) {
    const double squared = line.squared_distance(p);
    if (squared < best.squared) best = {squared, line.edge};
  });
  return best;
}

void FeatureSize::attach(SiteSlot site, const Found& found) {
  squared_[site] = found.squared;
  nearest_[site] = found.edge;
  links_[site] = {};
  if (found.edge == kNoSlot) return;
  SiteSlot& first = first_site_[found.edge];
  links_[site].after = first;
  if (first != kNoSlot) links_[first].before = site;
  first = site;
}

void FeatureSize::detach(SiteSlot site) {
  const EdgeSlot edge = nearest_[site];
  nearest_[site] = kNoSlot;
  squared_[site] = kInfinity;
  if (edge == kNoSlot) return;
  const Links links = links_[site];
  if (links.after != kNoSlot) links_[links.after].before = links.before;
  (links.before != kNoSlot ? links_[links.before].after : first_site_[edge]) = links.after;
}

// Sites that lie together query the tree together: boxes that are near to none of them are skipped at once, by the
// distance from the middle of the group. `sites` follow a curve through the plane; a group ends where it would become
// large against the distances it asks for. Around the centre of a circle with many samples lie edges whose distances
// differ by less than the size of a group; there each site searches alone.
void FeatureSize::search_in_groups(std::span<const SiteSlot> sites) {
  struct Group {
    std::array<Vec2, kGroup> at;
    std::array<double, kGroup> aside;  // distance from the middle
    std::array<Found, kGroup> found;
    std::size_t count = 0;
  };
  Group group;
  EdgeSlot guess{};
  for (std::size_t first = 0; first < sites.size(); first += group.count) {
    group.count = 0;
    Box2 box;
    double room = kInfinity;
    while (group.count < kGroup && first + group.count < sites.size()) {
      const SiteSlot site = sites[first + group.count];
      const Vec2 p = place_of(site);
      Found found;
      const auto look_at = [&](const AxisLine& line) {
        const double squared = line.squared_distance(p);
        if (squared < found.squared) found = {squared, line.edge};
      };
      for (const EdgeSlot edge : {guess, nearest_[site]})
        if (edge != kNoSlot) look_at(lines_.at(line_at_[edge]));
      Box2 larger = box;
      larger.add(p);
      const double size = std::max(larger.width(), larger.height());
      room = std::min(room, found.squared);
      if (group.count != 0 && size * size > kGroupWidth * kGroupWidth * room) break;
      box = larger;
      group.at[group.count] = p;
      group.found[group.count++] = found;
    }
    const Vec2 middle = box.center();
    double radius = 0.0;
    for (std::size_t i = 0; i < group.count; ++i) {
      group.aside[i] = distance(middle, group.at[i]) * (1.0 + 0x1p-40);
      radius = std::max(radius, group.aside[i]);
    }
    // Anything farther from the middle than this is nearest to no site of the group.
    double bound = kInfinity;
    const auto lower_bound = [&] {
      double far = 0.0;
      for (std::size_t i = 0; i < group.count; ++i)
        far = std::max(far, std::sqrt(group.found[i].squared) + group.aside[i]);
      bound = far * far * (1.0 + 0x1p-40);
    };
    lower_bound();
    std::size_t visited = 0;
    lines_.visit_near(middle, bound, [&](const AxisLine& line) {
      if (++visited > kMostOfGroup) bound = -1.0;  // ends the visit
      if (line.squared_distance(middle) > bound) return;
      bool is_nearer = false;
      for (std::size_t i = 0; i < group.count; ++i) {
        const double squared = line.squared_distance(group.at[i]);
        if (!(squared < group.found[i].squared)) continue;
        group.found[i] = {squared, line.edge};
        is_nearer = true;
      }
      if (is_nearer) lower_bound();
    });
    for (std::size_t i = 0; i < group.count; ++i) {
      if (visited > kMostOfGroup) group.found[i] = search(group.at[i], group.found[i]);
      squared_[sites[first + i]] = group.found[i].squared;
      nearest_[sites[first + i]] = group.found[i].edge;
    }
    guess = group.found[group.count - 1].edge;
  }
}

void FeatureSize::rebuild(JobControl& job) {
  clear_changes();
  is_ready_ = false;
  epsilons_.clear();
  squared_.assign(delaunay_.site_rows(), kInfinity);
  nearest_.assign(delaunay_.site_rows(), kNoSlot);
  lines_.clear();
  line_count_ = 0;
  balls_.clear();
  if (delaunay_.dimension() != 2) return;
  choose_unit();
  const CellWalk walk(delaunay_, crust_, unit_);
  line_count_ = walk.line_count();
  if (line_count_ == 0) return;
  job.checkpoint();
  std::vector<std::vector<SiteSlot>> given_up(walk.part_count());
  run_tasks(walk.part_count(), [&](std::size_t part) {
    job.checkpoint();
    walk.search(part, squared_, nearest_, given_up[part]);
  });
  std::size_t left = 0;
  for (const std::vector<SiteSlot>& sites : given_up) left += sites.size();
  // A tree costs about as much as longer walks for this share of the samples.
  constexpr std::size_t kFew = 32;
  if (kFew * left < delaunay_.site_count())
    run_tasks(given_up.size(),
              [&](std::size_t part) { walk.search_longer(given_up[part], squared_, nearest_, job); });
  if (std::ranges::all_of(given_up, [](const auto& sites) { return sites.empty(); })) return;
  const std::vector<AxisLine> lines = all_lines();
  make_line_tree(lines);
  // Every site starts with some edge of its own cell.
  for (const AxisLine& line : lines)
    for (const SiteSlot site : delaunay_.edge(line.edge).v)
      if (nearest_[site] == kNoSlot) nearest_[site] = line.edge;
  run_tasks(given_up.size(), [&](std::size_t i) {
    job.checkpoint();
    search_in_groups(given_up[i]);
  });
}

void FeatureSize::get_ready_to_update(JobControl& job) {
  if (is_ready_ || line_count_ == 0) return;
  if (lines_.is_empty()) make_line_tree(all_lines());
  links_.assign(squared_.size(), {});
  first_site_.assign(line_at_.size(), kNoSlot);
  for (const SiteSlot site : squared_.rows())
    if (nearest_[site] != kNoSlot) attach(site, {squared_[site], nearest_[site]});
  job.checkpoint();
  make_ball_tree();
  job.checkpoint();
  epsilons_.build(
      delaunay_.edge_rows(), [this](EdgeSlot edge) { return epsilon_or_none(edge); },
      [this](EdgeSlot a, EdgeSlot b) { return is_first(a, b); });
  exemption_.assign(delaunay_.site_rows(), Exemption::none);
  exempt_ = {exemption_.size()};
  for (const SiteSlot site : delaunay_.site_slots())
    if (delaunay_.is_site(site)) set_exemption(site, exemption_of(site));
  is_ready_ = true;
}

void FeatureSize::add_line(const AxisLine& line) {
  lines_.insert(
      line, [](const AxisLine& one) { return one.bounds(); },
      [this](const AxisLine& one, std::uint32_t place) { line_at_[one.edge] = place; });
}

void FeatureSize::remove_line(EdgeSlot edge) {
  lines_.remove(line_at_[edge], [this](const AxisLine& line, std::uint32_t place) { line_at_[line.edge] = place; });
  line_at_[edge] = kNowhere;
}

void FeatureSize::add_ball(SiteSlot site) {
  reach_[site] = squared_[site];
  balls_.insert(
      Ball{place_of(site), site},
      [this](const Ball& ball) {
        return TreeBounds{{ball.center, ball.center}, std::sqrt(reach_[ball.site])};
      },
      [this](const Ball& ball, std::uint32_t place) { ball_at_[ball.site] = place; });
}

void FeatureSize::remove_ball(SiteSlot site) {
  if (ball_at_[site] == kNowhere) return;
  balls_.remove(ball_at_[site], [this](const Ball& ball, std::uint32_t place) { ball_at_[ball.site] = place; });
  ball_at_[site] = kNowhere;
}

void FeatureSize::search_anew(SiteSlot site) {
  const double before = squared_[site];
  detach(site);
  attach(site, search(place_of(site), {}));
  if (squared_[site] != before) site_recorder_.note(site, true);
  const bool is_in_tree = ball_at_[site] != kNowhere;
  if (is_in_tree && squared_[site] <= reach_[site]) return;
  remove_ball(site);
  if (!has_size(site)) return;
  add_ball(site);
  if (balls_.is_worn()) make_ball_tree();
}

void FeatureSize::shrink_balls_at(const AxisLine& line) {
  // If a box meets the line, its centre is within half its diagonal of the line.
  const auto may_hold = [&line](const Box2& box, double reach) {
    const double x = 0.5 * box.width();
    const double y = 0.5 * box.height();
    const Vec2 center = box.center();
    const double far = (std::sqrt(x * x + y * y) + reach) * (1.0 + 0x1p-40) +
                       0x1p-44 * std::max(std::abs(center.x), std::abs(center.y));
    return line.squared_distance(center) <= far * far;
  };
  balls_.visit_where(may_hold, [&](const Ball& ball) {
    const double squared = line.squared_distance(ball.center);
    if (!(squared < squared_[ball.site])) return;
    detach(ball.site);
    attach(ball.site, {squared, line.edge});
    site_recorder_.note(ball.site, true);
  });
}

bool FeatureSize::update(JobControl& job) {
  if (delaunay_.dimension() != 2 || line_count_ == 0) return false;
  if (!std::ranges::all_of(delaunay_.site_changes().touched, [this](SiteSlot site) { return fits(site); }))
    return false;
  // All samples are tested against each new edge; where these are many, a rebuild is quicker.
  if (delaunay_.edge_changes().touched.size() > 64 + delaunay_.edge_rows() / 8) return false;
  get_ready_to_update(job);
  squared_.resize(delaunay_.site_rows(), kInfinity);
  nearest_.resize(delaunay_.site_rows(), kNoSlot);
  links_.resize(delaunay_.site_rows());
  ball_at_.resize(delaunay_.site_rows(), kNowhere);
  reach_.resize(delaunay_.site_rows(), 0.0);
  first_site_.resize(delaunay_.edge_rows(), kNoSlot);
  line_at_.resize(delaunay_.edge_rows(), kNowhere);
  job.checkpoint();
  site_recorder_.begin(delaunay_.site_rows());
  edge_recorder_.begin(delaunay_.edge_rows());
  to_search_.begin(delaunay_.site_rows());
  searches_.clear();
  new_lines_.clear();
  for (const auto* edges : {&delaunay_.edge_changes().removed, &delaunay_.edge_changes().touched})
    for (const EdgeSlot edge : *edges) {
      for (SiteSlot site = first_site_[edge]; site != kNoSlot; site = links_[site].after) queue_search(site);
      if (line_at_[edge] != kNowhere) remove_line(edge);
    }
  for (const EdgeSlot edge : delaunay_.edge_changes().touched) {
    if (!is_axis(edge)) continue;
    new_lines_.push_back(axis_line(delaunay_, edge, unit_));
    if (!lines_.is_worn()) add_line(new_lines_.back());
  }
  if (lines_.is_worn()) make_line_tree(all_lines());
  line_count_ = lines_.size();
  for (const SiteSlot site : delaunay_.site_changes().removed) {
    detach(site);
    remove_ball(site);
    site_recorder_.note(site, true);
  }
  for (const SiteSlot site : delaunay_.site_changes().touched) {
    remove_ball(site);
    site_recorder_.note(site, true);
    queue_search(site);
  }
  for (const SiteSlot site : searches_)
    if (delaunay_.is_site(site)) search_anew(site);
  for (const AxisLine& line : new_lines_) shrink_balls_at(line);
  finish_changes();
  return true;
}

void FeatureSize::finish_changes() {
  site_recorder_.finish(site_changes_, [this](SiteSlot site) { return delaunay_.is_site(site); });
  for (const EdgeSlot edge : delaunay_.edge_changes().removed) edge_recorder_.note(edge, true);
  for (const EdgeSlot edge : delaunay_.edge_changes().touched) edge_recorder_.note(edge, true);
  for (const SiteSlot site : site_changes_.touched)
    delaunay_.for_each_edge_at(site, [&](EdgeSlot edge, SiteSlot, FaceSlot) {
      if (crust_.is_crust(edge)) edge_recorder_.note(edge, true);
    });
  edge_recorder_.finish(edge_changes_, [this](EdgeSlot edge) { return delaunay_.edge(edge).is_alive(); });
  epsilons_.set_all(
      edges_to_count_anew(), [this](EdgeSlot edge) { return epsilon_or_none(edge); },
      [this](EdgeSlot a, EdgeSlot b) { return is_first(a, b); });
  // The walk over these edges has met all sites whose exemption may differ.
  exempt_[0] += delaunay_.site_rows() - exemption_.size();
  exemption_.resize(delaunay_.site_rows(), Exemption::none);
  for (const SiteSlot site : delaunay_.site_changes().removed) set_exemption(site, Exemption::none);
  for (const SiteSlot site : searches_) set_exemption(site, exemption_of(site));
}

double FeatureSize::epsilon_or_none(EdgeSlot edge) const {
  return has_epsilon(edge) && !ends_at_exempt(edge) ? epsilon(edge) : -kInfinity;
}

// Exemption of a sample depends on its crust neighbours and theirs. So a site that moved or has another neighbour
// affects the edges of all sites two steps away. One that lost a crust edge has another degree or a new edge.
std::vector<EdgeSlot> FeatureSize::edges_to_count_anew() {
  std::vector<EdgeSlot> out = edge_changes_.removed;
  counted_.begin(delaunay_.edge_rows());
  const auto count = [&](EdgeSlot edge) {
    if (counted_.insert(edge)) out.push_back(edge);
  };
  std::ranges::for_each(edge_changes_.touched, count);
  to_search_.begin(delaunay_.site_rows());
  searches_.clear();
  for (const SiteSlot site : crust_.site_changes().touched) queue_search(site);
  for (const EdgeSlot edge : delaunay_.edge_changes().touched)
    if (crust_.is_crust(edge))
      for (const SiteSlot site : delaunay_.edge(edge).v) queue_search(site);
  constexpr int kSteps = 2;
  std::size_t first = 0;
  for (int step = 0; step <= kSteps; ++step) {
    const std::size_t end = searches_.size();
    for (; first < end; ++first)
      delaunay_.for_each_edge_at(searches_[first], [&](EdgeSlot edge, SiteSlot other, FaceSlot) {
        if (!crust_.is_crust(edge)) return;
        count(edge);
        if (step < kSteps) queue_search(other);
      });
  }
  return out;
}

void FeatureSize::clear_changes() {
  site_changes_.clear();
  edge_changes_.clear();
}

StatList FeatureSize::statistics() const {
  std::int64_t samples = 0;
  double least = kInfinity;
  double most = -kInfinity;
  for (const SiteSlot site : squared_.rows()) {
    if (!delaunay_.is_site(site) || !has_size(site)) continue;
    ++samples;
    least = std::min(least, size(site));
    most = std::max(most, size(site));
  }
  std::vector<double> epsilons;
  for (const EdgeSlot edge : delaunay_.edge_slots())
    if (const double value = epsilon_or_none(edge); value > -kInfinity) epsilons.push_back(value);
  const auto above = std::ranges::count_if(epsilons, [](double value) { return value > kDenseEpsilon; });
  StatList out{{"samples", samples}, {"size_min", least}, {"size_max", most}};
  const EdgeSlot sparsest = sparsest_edge();
  const bool is_known = curves_ != nullptr && curves_->has_standing();
  out.push_back({"epsilon", is_known              ? curves_->standing().epsilon
                            : sparsest != kNoSlot ? epsilon(sparsest)
                                                  : kInfinity});
  if (!epsilons.empty()) {
    const auto middle = epsilons.begin() + static_cast<std::ptrdiff_t>(epsilons.size() / 2);
    std::ranges::nth_element(epsilons, middle);
    out.push_back({"epsilon_median", *middle});
  }
  out.push_back({"curve_edges_above_0.25", static_cast<std::int64_t>(above)});
  out.push_back({"estimate", std::string("distance to the axis and between neighbours as the samples show them")});
  if (!has_axis()) out.push_back({"nothing_because", std::string(reason())});
  return out;
}

void FeatureSize::find(std::vector<Finding>& out) const {
  if (curves_ != nullptr && curves_->has_standing()) return;
  const auto measured = estimated_epsilon();
  if (!measured) return;
  const EdgeRow& row = delaunay_.edge(sparsest_edge());
  const Vec2 a = delaunay_.site_position(row.v[0]);
  const Vec2 b = delaunay_.site_position(row.v[1]);
  Finding& finding = out.emplace_back();
  finding.level = FindingLevel::note;
  finding.epsilon = measured;
  finding.text = fmt::format("curve edge is the sparsest: {}; samples of smooth curves are dense up to {}",
                             measured->text(), kDenseEpsilon);
  finding.count = 1;
  finding.places.push_back({0.5 * a.x + 0.5 * b.x, 0.5 * a.y + 0.5 * b.y});
}

}  // namespace mes
