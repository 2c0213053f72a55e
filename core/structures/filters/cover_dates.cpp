// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/filters/cover_dates.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "core/base/parallel.h"

namespace mes {
namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();
constexpr double kNoNode = -1.0;
constexpr std::uint32_t kLeaf = 8;  // balls
constexpr std::size_t kDepth = 64;  // of the tree at most, as nodes are halved

/// Squared, from a place to a box; 0 inside.
double squared_distance_to(const Box2& box, Vec2 p) {
  const double x = std::max({box.low.x - p.x, p.x - box.high.x, 0.0});
  const double y = std::max({box.low.y - p.y, p.y - box.high.y, 0.0});
  return x * x + y * y;
}

/// Whether the square root of `squared` is `reach` or more, beyond what rounding can do to a quotient of both. False where
/// squares leave the range of doubles.
bool is_beyond(double squared, double reach) {
  constexpr double kGivesWay = 1.0 - 0x1p-48;
  return squared * kGivesWay >= reach * reach && squared > 0x1p-900 && squared < 0x1p900;
}

/// More than what rounding adds up to in the few operations on a plane, relative to the largest of their operands.
constexpr double kRounding = 0x1p-46;

}  // namespace

CoverDates::CoverDates(Delaunay& delaunay, InnerBalls& balls)
    : Structure("cover-dates", {&delaunay, &balls}), delaunay_(delaunay), balls_(balls) {}

// Any slope is right, and the one of the balls near to each other in one direction is good: radii go up and down along
// the axis, and across it is nothing but noise.
void CoverDates::put_plane_above(Node& node) const {
  const Vec2 middle = node.box.center();
  const double count = node.last - node.first;
  Vec2 sum{};
  double sum_of_radii = 0.0;
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;
  Vec2 with_radius{};
  for (std::uint32_t i = node.first; i < node.last; ++i) {
    const Vec2 c = sorted_[i].center - middle;
    const double r = sorted_[i].radius - node.most;
    sum = sum + c;
    sum_of_radii += r;
    xx += c.x * c.x;
    xy += c.x * c.y;
    yy += c.y * c.y;
    with_radius = with_radius + r * c;
  }
  xx -= sum.x * sum.x / count;
  xy -= sum.x * sum.y / count;
  yy -= sum.y * sum.y / count;
  with_radius = with_radius - (sum_of_radii / count) * sum;
  // The longer axis of their ellipse of inertia, from the half angle of (xx - yy, 2 xy).
  const double across = xx - yy;
  const double length = std::sqrt(across * across + 4.0 * xy * xy);
  const Vec2 along = across >= 0.0 ? Vec2{length + across, 2.0 * xy} : Vec2{2.0 * xy, length - across};
  const double spread = xx * along.x * along.x + 2.0 * xy * along.x * along.y + yy * along.y * along.y;
  const Vec2 slope = (dot(with_radius, along) / spread) * along;
  node.slope = dot(slope, slope) <= 4.0 ? slope : Vec2{};  // NaN gives no slope, too
  double height = -kNever;
  for (std::uint32_t i = node.first; i < node.last; ++i)
    height = std::max(height, sorted_[i].radius - dot(node.slope, sorted_[i].center - middle));
  node.height = height + kRounding * (node.most + node.box.width() + node.box.height());
}

void CoverDates::build(std::uint32_t at) {
  Box2 box;
  double most = 0.0;
  double least = kNever;
  const std::uint32_t first = tree_[at].first;
  const std::uint32_t last = tree_[at].last;
  for (std::uint32_t i = first; i < last; ++i) {
    box.add(sorted_[i].center);
    most = std::max(most, sorted_[i].radius);
    least = std::min(least, sorted_[i].radius);
  }
  tree_[at].box = box;
  tree_[at].most = most;
  if (last - first <= kLeaf) return;
  put_plane_above(tree_[at]);
  // A node whose balls differ in radius promises the largest at the nearest place: radii are split as places are.
  const std::uint32_t middle = first + (last - first) / 2;
  const auto split_by = [&](auto number_of) {
    std::nth_element(sorted_.begin() + first, sorted_.begin() + middle, sorted_.begin() + last,
                     [number_of](const Ball& a, const Ball& b) { return number_of(a) < number_of(b); });
  };
  const double range = most - least;
  if (range >= box.width() && range >= box.height())
    split_by([](const Ball& ball) { return ball.radius; });
  else if (box.width() >= box.height())
    split_by([](const Ball& ball) { return ball.center.x; });
  else
    split_by([](const Ball& ball) { return ball.center.y; });
  const auto child = static_cast<std::uint32_t>(tree_.size());
  tree_[at].child = child;
  tree_.push_back({.first = first, .last = middle});
  tree_.push_back({.first = middle, .last = last});
  build(child);
  build(child + 1);
}

// Nodes are passed over when no ball in them can do better: the distance to their box over the largest difference of radii
// bounds every quotient. Where radii change evenly, that bound is off by as much as the box is large, and the balls a long
// way up an even slope have nearly the same quotient, so too many boxes would be looked into. The plane's is off by the
// square of it. With u the direction to the middle of the box, d the distance to it, and t the way from there to a centre
// in the box, that centre is at least d + u * t away, and its radius at most height + slope * t; so no ball does better
// than `best` if height - radius + (slope - u / best) * t <= d / best for all t.
// As the first quotients are mostly near the least, nodes need no order but the better of two first, and are compared by
// squares, without roots and quotients.
double CoverDates::search(const Ball& ball, std::uint32_t& guess) const {
  double best = kNever;
  const auto look_at = [&](Vec2 center, double radius) {
    const double more = radius - ball.radius;
    if (!(more > 0.0)) return false;
    const Vec2 away = center - ball.center;
    if (is_beyond(dot(away, away), best * more)) return false;
    // No inner ball lies inside another, as samples are on both and in neither: less than 1 is rounding.
    const double date = std::max(1.0, distance(ball.center, center) / more);
    if (!(date < best)) return false;
    best = date;
    return true;
  };
  // Balls near to each other are mostly swallowed by the same one.
  look_at(sorted_[guess].center, sorted_[guess].radius);
  for (const EdgeSlot edge : delaunay_.face(ball.face).e) {
    if (edge == kNoSlot) continue;
    for (const FaceSlot face : delaunay_.edge(edge).f) {
      if (face == kNoSlot || !balls_.is_ball(face)) continue;
      const FaceSlot other = balls_.ball(face);
      look_at(delaunay_.circumcenter(other), delaunay_.circumradius(other));
    }
  }
  const auto is_below = [&](const Node& node) {
    const Vec2 middle = node.box.center();
    const Vec2 away = middle - ball.center;
    const double squared = dot(away, away);
    if (!(squared > 0x1p-900 && squared < 0x1p900 && ball.radius > 0x1p-900)) return false;
    // Where radii hardly change on the way, the plane knows no more than the largest radius.
    const double on_the_way = best * dot(node.slope, away);
    if (!(on_the_way > 0.0 && on_the_way * on_the_way > 0.25 * squared)) return false;
    const double rate = (1.0 - kRounding) / best;
    const double far = std::sqrt(squared);
    const Vec2 up = (rate * (1.0 - kRounding) / far) * away;
    // The middle is rounded: far from the origin it may be at a side of its box.
    const double width = std::max(node.box.high.x - middle.x, middle.x - node.box.low.x);
    const double height = std::max(node.box.high.y - middle.y, middle.y - node.box.low.y);
    const double more =
        node.height - ball.radius + std::abs(node.slope.x - up.x) * width + std::abs(node.slope.y - up.y) * height;
    const double rounding =
        kRounding * (std::abs(node.height) + ball.radius + 4.0 * (width + height) + 4.0 * rate * far);
    return more + rounding <= rate * far;
  };
  struct Waiting {
    double squared;  // distance to the box
    double more;     // the largest radius in it than the ball's
    std::uint32_t node;
  };
  const auto waiting = [&](std::uint32_t node) {
    return Waiting{squared_distance_to(tree_[node].box, ball.center), tree_[node].most - ball.radius, node};
  };
  const auto can_be_better = [&](const Waiting& at) {
    return at.more > 0.0 && !is_beyond(at.squared, best * at.more);
  };
  std::array<Waiting, kDepth> stack;
  std::size_t size = 0;
  stack[size++] = waiting(0);
  while (size > 0 && best > 1.0) {
    const Waiting next = stack[--size];
    if (!can_be_better(next)) continue;
    const Node& node = tree_[next.node];
    if (node.child == 0) {
      for (std::uint32_t i = node.first; i < node.last; ++i)
        if (look_at(sorted_[i].center, sorted_[i].radius)) guess = i;
      continue;
    }
    if (is_below(node)) continue;
    Waiting first = waiting(node.child);
    Waiting second = waiting(node.child + 1);
    if (second.squared * (first.more * first.more) < first.squared * (second.more * second.more))
      std::swap(first, second);
    if (can_be_better(second)) stack[size++] = second;
    if (can_be_better(first)) stack[size++] = first;
  }
  return best;
}

void CoverDates::rebuild(JobControl& job) {
  date_.assign(delaunay_.face_rows(), kNoNode);
  sorted_.clear();
  tree_.clear();
  for (const FaceSlot face : delaunay_.face_slots()) {
    if (!delaunay_.is_finite_face(face) || !is_node(face)) continue;
    const Ball ball{delaunay_.circumcenter(face), delaunay_.circumradius(face), face};
    // What no double can hold swallows nothing that can be shown.
    if (is_finite(ball.center) && std::isfinite(ball.radius)) sorted_.push_back(ball);
  }
  if (sorted_.empty()) return;
  tree_.push_back({.last = static_cast<std::uint32_t>(sorted_.size())});
  build(0);
  job.checkpoint();
  parallel_for(sorted_.size(), [&](std::size_t begin, std::size_t end, std::size_t) {
    auto guess = static_cast<std::uint32_t>(begin);
    for (std::size_t i = begin; i < end; ++i) {
      if ((i & 0x3ffU) == 0) job.checkpoint();
      date_[sorted_[i].face] = search(sorted_[i], guess);
    }
  });
}

bool CoverDates::update(JobControl&) {
  return balls_.changes().is_empty();
}

StatList CoverDates::statistics() const {
  std::vector<double> dates;
  std::int64_t never = 0;
  for (const FaceSlot face : date_.rows()) {
    if (!has_date(face)) continue;
    if (date_[face] == kNever)
      ++never;
    else
      dates.push_back(date_[face]);
  }
  StatList out{{"balls", static_cast<std::int64_t>(dates.size()) + never}, {"never_covered", never}};
  if (dates.empty()) return out;
  const auto middle = dates.begin() + static_cast<std::ptrdiff_t>(dates.size() / 2);
  std::ranges::nth_element(dates, middle);
  out.push_back({"date_median", *middle});
  out.push_back({"date_largest", *std::ranges::max_element(dates)});
  return out;
}

}  // namespace mes
