// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/density/feature_size.h"

#include <algorithm>
#include <limits>
#include <string>

#include "core/base/parallel.h"
#include "core/kernel/corner_angle.h"

namespace mes {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// When so much has come since a tree was made, it is made anew.
bool is_much(std::size_t recent, std::size_t in_tree) {
  return recent > 64 + in_tree / 64;
}

}  // namespace

FeatureSize::FeatureSize(Delaunay& delaunay, OneStepCrust& crust)
    : Structure("feature-size", {&delaunay, &crust}), delaunay_(delaunay), crust_(crust) {}

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

// Heights are half the edge times the cotangent of the angle opposite, as in `Delaunay::dual_length`: from differences
// of samples, not from centres, which may be far away.
FeatureSize::AxisLine FeatureSize::line_of(EdgeSlot edge) const {
  const EdgeRow& row = delaunay_.edge(edge);
  int first = 0;
  if (lexicographically_less(delaunay_.site_position(row.v[1]), delaunay_.site_position(row.v[0]))) first = 1;
  AxisLine out;
  out.edge = edge;
  out.stamp = stamp_[edge];
  out.q = delaunay_.site_position(row.v[first]);
  const Vec2 r = delaunay_.site_position(row.v[1 - first]);
  const double length = distance(out.q, r);
  out.along = {(r.x - out.q.x) / length, (r.y - out.q.y) / length};
  out.half = 0.5 * length;
  const auto height = [&](FaceSlot face) {
    const SiteSlot apex = delaunay_.apex(face, edge);
    return apex == kInfiniteSite ? kInfinity : out.half * cotangent_at(delaunay_.site_position(apex), out.q, r);
  };
  // A triangle lies on the left of q -> r, the other on the right; without one the bisector goes on.
  const double left = height(row.f[first]);
  const double right = height(row.f[1 - first]);
  out.high = std::max(left, -right);
  out.low = std::min(left, -right);
  return out;
}

Box2 FeatureSize::AxisLine::box() const {
  const Vec2 middle = q + half * along;
  const Vec2 up = perpendicular(along);
  const auto at = [](double from, double step, double height) {
    return step == 0.0 ? from : from + step * height;  // the height may be infinite
  };
  Box2 out;
  for (const double height : {low, high}) out.add(Vec2{at(middle.x, up.x, height), at(middle.y, up.y, height)});
  return out;
}

void FeatureSize::make_line_tree() {
  std::vector<EdgeSlot> edges;
  for (const EdgeSlot edge : is_line_.rows())
    if (is_line_[edge] != 0) edges.push_back(edge);
  std::vector<AxisLine> lines(edges.size());
  recent_lines_.clear();
  std::vector<Box2> boxes(edges.size());
  parallel_for(edges.size(), [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t i = begin; i < end; ++i) {
      lines[i] = line_of(edges[i]);
      boxes[i] = lines[i].box();
    }
  });
  line_tree_.build(boxes);
  lines_.clear();
  lines_.reserve(lines.size());
  for (const std::uint32_t item : line_tree_.order()) lines_.push_back(lines[item]);
  line_tree_.number_by_order();
}

void FeatureSize::make_ball_tree() {
  balls_.clear();
  recent_balls_.clear();
  std::vector<Box2> boxes;
  for (const SiteSlot site : squared_.rows()) {
    boxed_[site] = -1.0;
    if (!delaunay_.is_site(site) || !has_size(site)) continue;
    const Vec2 p = delaunay_.site_position(site);
    const double reach = size(site);
    boxed_[site] = squared_[site];
    balls_.push_back(site);
    boxes.push_back({{p.x - reach, p.y - reach}, {p.x + reach, p.y + reach}});
  }
  ball_tree_.build(boxes);
}

FeatureSize::Found FeatureSize::search(Vec2 p, const AxisLine* guess) const {
  Found best{kInfinity, {}};
  const auto look_at = [&](const AxisLine& line) {
    const double squared = line.squared_distance(p);
    if (!(squared < best.squared) || !is_current(line)) return;
    best = {squared, line.edge};
  };
  if (guess != nullptr) look_at(*guess);
  for (const AxisLine& line : recent_lines_) look_at(line);
  line_tree_.visit_near(p, best.squared, [&](std::uint32_t item) { look_at(lines_[item]); });
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

void FeatureSize::rebuild(JobControl& job) {
  clear_changes();
  squared_.assign(delaunay_.site_rows(), kInfinity);
  nearest_.assign(delaunay_.site_rows(), kNoSlot);
  links_.assign(delaunay_.site_rows(), {});
  boxed_.assign(delaunay_.site_rows(), -1.0);
  first_site_.assign(delaunay_.edge_rows(), kNoSlot);
  stamp_.assign(delaunay_.edge_rows(), 0);
  is_line_.assign(delaunay_.edge_rows(), 0);
  balls_.clear();
  recent_balls_.clear();
  ball_tree_.clear();
  line_count_ = 0;
  if (delaunay_.dimension() == 2) {
    for (const EdgeSlot edge : delaunay_.edge_slots()) {
      is_line_[edge] = is_axis(edge) ? 1 : 0;
      line_count_ += is_line_[edge];
    }
  }
  make_line_tree();
  job.checkpoint();
  std::vector<Found> found(delaunay_.site_rows());
  parallel_for(found.size(), [&](std::size_t begin, std::size_t end, std::size_t) {
    job.checkpoint();
    // The next site is often on the same part of the curve.
    AxisLine guess;
    bool has_guess = false;
    for (const SiteSlot site : slots_between<SiteSlot>(begin, end)) {
      if (!delaunay_.is_site(site)) continue;
      const Found& at = found[site.index()] = search(delaunay_.site_position(site), has_guess ? &guess : nullptr);
      has_guess = at.edge != kNoSlot;
      if (has_guess && guess.edge != at.edge) guess = line_of(at.edge);
    }
  });
  for (const SiteSlot site : squared_.rows())
    if (delaunay_.is_site(site)) attach(site, found[site.index()]);
}

void FeatureSize::search_anew(SiteSlot site) {
  const double before = squared_[site];
  detach(site);
  attach(site, search(delaunay_.site_position(site), nullptr));
  if (squared_[site] != before) site_recorder_.note(site, true);
  if (squared_[site] <= boxed_[site]) return;
  boxed_[site] = kInfinity;
  recent_balls_.push_back(site);
}

void FeatureSize::shrink_balls_at(const AxisLine& line) {
  const auto look_at = [&](SiteSlot site) {
    if (!delaunay_.is_site(site)) return;
    const double squared = line.squared_distance(delaunay_.site_position(site));
    if (!(squared < squared_[site])) return;
    detach(site);
    attach(site, {squared, line.edge});
    site_recorder_.note(site, true);
  };
  for (const SiteSlot site : recent_balls_) look_at(site);
  // A box that the line meets is within its half diagonal of it, about its centre.
  const auto may_hold = [&line](const Box2& box) {
    const double x = 0.5 * box.width();
    const double y = 0.5 * box.height();
    const Vec2 center = box.center();
    const double reach =
        std::sqrt(x * x + y * y) * (1.0 + 0x1p-40) + 0x1p-44 * std::max(std::abs(center.x), std::abs(center.y));
    return line.squared_distance(center) <= reach * reach;
  };
  ball_tree_.visit_where(may_hold, [&](std::uint32_t item) { look_at(balls_[item]); });
}

void FeatureSize::follow_edge(EdgeSlot edge, bool is_alive) {
  ++stamp_[edge];
  if (is_line_[edge] != 0) {
    --line_count_;
    for (SiteSlot site = first_site_[edge]; site != kNoSlot; site = links_[site].after) queue_search(site);
  }
  is_line_[edge] = is_alive && is_axis(edge) ? 1 : 0;
  if (is_line_[edge] == 0) return;
  ++line_count_;
  recent_lines_.push_back(line_of(edge));
}

bool FeatureSize::update(JobControl& job) {
  if (delaunay_.dimension() != 2 || line_count_ == 0) return false;
  squared_.resize(delaunay_.site_rows(), kInfinity);
  nearest_.resize(delaunay_.site_rows(), kNoSlot);
  links_.resize(delaunay_.site_rows());
  boxed_.resize(delaunay_.site_rows(), -1.0);
  first_site_.resize(delaunay_.edge_rows(), kNoSlot);
  stamp_.resize(delaunay_.edge_rows(), 0);
  is_line_.resize(delaunay_.edge_rows(), 0);
  if (ball_tree_.is_empty() || is_much(recent_balls_.size(), balls_.size())) make_ball_tree();
  job.checkpoint();
  site_recorder_.begin(delaunay_.site_rows());
  edge_recorder_.begin(delaunay_.edge_rows());
  to_search_.begin(delaunay_.site_rows());
  searches_.clear();
  const std::size_t old_lines = recent_lines_.size();
  for (const EdgeSlot edge : delaunay_.edge_changes().removed) follow_edge(edge, false);
  for (const EdgeSlot edge : delaunay_.edge_changes().touched) follow_edge(edge, true);
  for (const SiteSlot site : delaunay_.site_changes().removed) {
    detach(site);
    site_recorder_.note(site, true);
  }
  for (const SiteSlot site : delaunay_.site_changes().touched) {
    site_recorder_.note(site, true);
    boxed_[site] = -1.0;
    queue_search(site);
  }
  for (const SiteSlot site : searches_)
    if (delaunay_.is_site(site)) search_anew(site);
  for (std::size_t i = old_lines; i < recent_lines_.size(); ++i) shrink_balls_at(recent_lines_[i]);
  if (is_much(recent_lines_.size(), lines_.size())) make_line_tree();
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
    if (has_epsilon(edge)) epsilons.push_back(epsilon(edge));
  const auto above = std::ranges::count_if(epsilons, [](double value) { return value > kDenseEpsilon; });
  StatList out{{"samples", samples}, {"size_min", least}, {"size_max", most}};
  const double worst = epsilons.empty() ? kInfinity : *std::ranges::max_element(epsilons);
  out.push_back({"epsilon", worst});
  if (!epsilons.empty()) {
    const auto middle = epsilons.begin() + static_cast<std::ptrdiff_t>(epsilons.size() / 2);
    std::ranges::nth_element(epsilons, middle);
    out.push_back({"epsilon_median", *middle});
  }
  out.push_back({"curve_edges_above_0.25", static_cast<std::int64_t>(above)});
  out.push_back({"estimate", std::string("distance to the axis and between neighbours as the samples show them")});
  if (samples == 0) {
    out.push_back({"nothing_because",
                   std::string(delaunay_.dimension() < 2 ? "fewer than three samples, or all of them on a line"
                                                         : "all edges between samples are curve: there is no axis")});
  }
  return out;
}

}  // namespace mes
