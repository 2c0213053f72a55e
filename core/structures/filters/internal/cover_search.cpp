// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/structures/filters/internal/cover_search.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/geometry/double_pair.h"
#include "core/base/jobs/parallel.h"

namespace mes {
namespace {

/// Balls per leaf, in pairs that the processor handles at once.
constexpr std::uint32_t kLeaf = 8;
constexpr std::size_t kLeafPairs = kLeaf / 2;

/// Balls that search together: a few leaves.
constexpr std::uint32_t kBlockBalls = 32;
constexpr std::size_t kLeaves = kBlockBalls / kLeaf;
/// Number of blocks in one part of the searches.
constexpr std::size_t kPartBlocks = 64;
/// Largest depth of the tree, as nodes are halved.
constexpr std::size_t kDepth = 64;
/// Largest number of balls in a subtree that one core builds.
constexpr std::uint32_t kSubtree = 8192;
/// Largest number of balls fitted with a plane: in larger nodes radii do not change evenly.
constexpr std::uint32_t kMostOfPlane = 2048;

/// More than the rounding of the few operations on a plane adds up to, relative to the largest of their operands.
constexpr double kPlaneRounding = 0x1p-46;
/// Values and differences beyond this are not fitted with planes.
constexpr double kWide = 0x1p400;

/// True if the square root of `squared` is at least `reach`, beyond what rounding can do to a quotient of both. False
/// where squares would leave the range of doubles.
template <class Number>
auto is_beyond(Number squared, Number reach) {
  constexpr double kGivesWay = 1.0 - 0x1p-48;
  constexpr double kTiny = 0x1p-900;
  constexpr double kHuge = 0x1p1000;
  return (squared * kGivesWay - kTiny >= reach * reach) & (squared < kHuge);
}

double squared_gap(const Box2& a, const Box2& b) {
  const double x = std::max({a.low.x - b.high.x, b.low.x - a.high.x, 0.0});
  const double y = std::max({a.low.y - b.high.y, b.low.y - a.high.y, 0.0});
  return x * x + y * y;
}

}  // namespace

/// An upper bound of the dates of a group of balls.
struct CoverSearch::Bound {
  Bound() = default;
  explicit Bound(double most_) : most(most_), rate((1.0 - kPlaneRounding) * (1.0 - kPlaneRounding) / most_) {}

  double most = kNever;
  double rate = 0.0;  // a little less than its inverse
};

/// The balls of a leaf, and their least quotients so far.
struct CoverSearch::Lanes {
  std::array<DoublePair, kLeafPairs> x, y, radius;
  std::array<DoublePair, kLeafPairs> best;  // upper bounds of the dates
  std::array<double, kLeaf> date;
  // A ball that beats those behind `date`, up to rounding, and whose own date is not computed yet.
  std::array<double, kLeaf> quotient;
  std::array<std::uint32_t, kLeaf> pending;
  const Node* leaf = nullptr;
  Bound bound;

  void find_bound() {
    double most = 0.0;
    for (const DoublePair& pair : best) most = std::max({most, pair[0], pair[1]});
    bound = Bound(most);
  }
};

/// Slope from a group of balls to a box: only balls of the box that rise above it can swallow one of the group earlier.
struct CoverSearch::Direction {
  Vec2 up{};
  double way = 0.0;       // `up` times the vector from middle to middle
  double rounding = 0.0;  // error of all comparisons
  bool is_known = false;
};

/// Balls that swallow others nearby.
struct CoverSearch::Guesses {
  std::array<std::uint32_t, kLeaf> balls;
  std::size_t count = 0;

  void add(std::uint32_t ball) {
    if (std::find(balls.begin(), balls.begin() + count, ball) == balls.begin() + count) balls[count++] = ball;
  }
};

CoverSearch::CoverSearch(std::span<const Disk> balls, std::span<const Hints> hints) : hints_(hints) {
  const std::size_t count = balls.size();
  if (count == 0) return;
  balls_.resize(count);
  for (std::size_t i = 0; i < count; ++i)
    balls_[i] = {balls[i].center, balls[i].radius, static_cast<std::uint32_t>(i)};
  tree_.push_back({.last = static_cast<std::uint32_t>(count)});
  tree_.reserve(2 * (count / kLeaf + 1));
  split(tree_, 0, kSubtree);
  std::vector<std::uint32_t> roots;
  for (std::uint32_t i = 0; i < tree_.size(); ++i)
    if (tree_[i].child == 0) roots.push_back(i);
  std::vector<std::vector<Node>> below(roots.size());
  run_tasks(roots.size(), [&](std::size_t i) {
    below[i].push_back(tree_[roots[i]]);
    split(below[i], 0, kLeaf);
  });
  for (std::size_t i = 0; i < roots.size(); ++i) {
    // The root itself is in the tree already.
    const auto offset = static_cast<std::uint32_t>(tree_.size() - 1);
    for (Node& node : below[i])
      if (node.child != 0) node.child += offset;
    tree_[roots[i]] = below[i][0];
    tree_.insert(tree_.end(), below[i].begin() + 1, below[i].end());
  }
  const std::size_t room = count + kLeaf;
  x_.assign(room, 0.0);
  y_.assign(room, 0.0);
  radius_.assign(room, -kNever);
  place_of_.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Ball& ball = balls_[i];
    x_[i] = ball.center.x;
    y_[i] = ball.center.y;
    radius_[i] = ball.radius;
    place_of_[ball.number] = static_cast<std::uint32_t>(i);
  }
  find_blocks(0);
}

void CoverSearch::measure(Node& node) const {
  node.least = kNever;
  for (std::uint32_t i = node.first; i < node.last; ++i) {
    node.box.add(balls_[i].center);
    node.most = std::max(node.most, balls_[i].radius);
    node.least = std::min(node.least, balls_[i].radius);
  }
  // The middle is rounded: far from the origin it may lie on a side of its box.
  node.middle = node.box.center();
  node.half = {std::max(node.box.high.x - node.middle.x, node.middle.x - node.box.low.x),
               std::max(node.box.high.y - node.middle.y, node.middle.y - node.box.low.y)};
  node.low = node.least;
  node.high = node.most;
  if (node.last - node.first <= kMostOfPlane && node.half.x < kWide && node.half.y < kWide && node.most < kWide)
    fit_planes(node);
}

// Any slope is correct. The least-squares slope is good; where balls lie along an axis, so that the direction across is
// only noise, the least-squares slope along the axis is.
void CoverSearch::fit_planes(Node& node) const {
  const double count = node.last - node.first;
  Vec2 sum{};
  double sum_of_radii = 0.0;
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;
  Vec2 with_radius{};
  for (std::uint32_t i = node.first; i < node.last; ++i) {
    const Vec2 c = balls_[i].center - node.middle;
    const double r = balls_[i].radius - node.most;
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
  const double determinant = xx * yy - xy * xy;
  std::array<Vec2, 2> slopes{(dot(with_radius, along) / spread) * along,
                             Vec2{(yy * with_radius.x - xy * with_radius.y) / determinant,
                                  (xx * with_radius.y - xy * with_radius.x) / determinant}};
  for (Vec2& slope : slopes) {
    const double squared = dot(slope, slope);
    // Radii change no faster than centres. NaN gives no slope, too.
    if (!(squared < kWide))
      slope = {};
    else if (squared > 1.0)
      slope = (1.0 / std::sqrt(squared)) * slope;
  }
  std::array<double, 2> low{kNever, kNever};
  std::array<double, 2> high{-kNever, -kNever};
  for (std::uint32_t i = node.first; i < node.last; ++i) {
    const Vec2 c = balls_[i].center - node.middle;
    for (std::size_t k = 0; k < 2; ++k) {
      const double r = balls_[i].radius - dot(slopes[k], c);
      low[k] = std::min(low[k], r);
      high[k] = std::max(high[k], r);
    }
  }
  const std::size_t better = high[1] - low[1] < high[0] - low[0] ? 1 : 0;
  const double room = kPlaneRounding * (node.most + 2.0 * (node.half.x + node.half.y));
  node.slope = slopes[better];
  node.low = low[better] - room;
  node.high = high[better] + room;
}

// All leaves and blocks are full, except the last ones.
void CoverSearch::split(std::vector<Node>& nodes, std::uint32_t at, std::uint32_t down_to) {
  measure(nodes[at]);
  const Node node = nodes[at];
  if (node.last - node.first <= down_to) return;
  const std::uint32_t full = node.last - node.first > kBlockBalls ? kBlockBalls : kLeaf;
  const std::uint32_t half = (node.last - node.first) / 2;
  const std::uint32_t middle = node.first + (half + full - 1) / full * full;
  const auto split_by = [&](auto number_of) {
    std::nth_element(balls_.begin() + node.first, balls_.begin() + middle, balls_.begin() + node.last,
                     [number_of](const Ball& a, const Ball& b) { return number_of(a) < number_of(b); });
  };
  // Where radii differ, the bound assumes the largest at the nearest position: radii are split like positions.
  const double range = node.most - node.least;
  if (range >= node.box.width() && range >= node.box.height())
    split_by([](const Ball& ball) { return ball.radius; });
  else if (node.box.width() >= node.box.height())
    split_by([](const Ball& ball) { return ball.center.x; });
  else
    split_by([](const Ball& ball) { return ball.center.y; });
  const auto child = static_cast<std::uint32_t>(nodes.size());
  nodes[at].child = child;
  nodes.push_back({.first = node.first, .last = middle});
  nodes.push_back({.first = middle, .last = node.last});
  split(nodes, child, down_to);
  split(nodes, child + 1, down_to);
}

void CoverSearch::find_blocks(std::uint32_t at) {
  const Node& node = tree_[at];
  if (node.last - node.first <= kBlockBalls) {
    blocks_.push_back(at);
    return;
  }
  find_blocks(node.child);
  find_blocks(node.child + 1);
}

std::size_t CoverSearch::part_count() const {
  return (blocks_.size() + kPartBlocks - 1) / kPartBlocks;
}

/// The distance of the boxes over the largest difference of radii bounds every quotient from below.
bool CoverSearch::is_apart(const Node& asked, const Bound& bound, const Node& node) {
  const double more = node.most - asked.least;
  return !(more > 0.0) || is_beyond(squared_gap(asked.box, node.box), bound.most * more);
}

CoverSearch::Direction CoverSearch::towards(const Node& asked, const Bound& bound, const Node& node) {
  const Vec2 away = node.middle - asked.middle;
  const double squared = dot(away, away);
  Direction out;
  if (!(squared > 1.0 / (kWide * kWide) && squared < kWide * kWide)) return out;
  const double far = std::sqrt(squared);
  out.up = (bound.rate / far) * away;
  out.way = dot(out.up, away);
  out.rounding = kPlaneRounding * (std::abs(node.high) + std::abs(asked.low) +
                                   8.0 * (node.half.x + node.half.y + asked.half.x + asked.half.y + far));
  out.is_known = true;
  return out;
}

bool CoverSearch::is_below(const Node& asked, const Node& node, const Direction& direction) {
  if (!direction.is_known) return false;
  const auto most_of = [&](const Node& at) {
    return std::abs(at.slope.x - direction.up.x) * at.half.x + std::abs(at.slope.y - direction.up.y) * at.half.y;
  };
  return (node.high - asked.low) + most_of(node) + most_of(asked) + direction.rounding <= direction.way;
}

double CoverSearch::date_of(const Ball& ball, const Ball& by) const {
  return std::max(1.0, distance(ball.center, by.center) / (by.radius - ball.radius));
}

// Square roots and quotients tell the better ball, except within rounding; the date itself is computed once at the end.
void CoverSearch::take(Lanes& lanes, std::size_t lane, std::uint32_t by) const {
  if (lanes.pending[lane] == by) return;
  const Ball& ball = balls_[lanes.leaf->first + lane];
  const Ball& other = balls_[by];
  const Vec2 away = other.center - ball.center;
  const double squared = dot(away, away);
  const double quotient = std::sqrt(squared) / (other.radius - ball.radius);
  DoublePair& pair = lanes.best[lane / 2];
  const double best = pair[lane % 2];
  const bool is_clear = squared > 0x1p-900 && squared < 0x1p1000 && quotient > 1.0 + 0x1p-40;
  if (is_clear && quotient < lanes.quotient[lane] * (1.0 - 0x1p-46) && quotient < lanes.date[lane]) {
    lanes.quotient[lane] = quotient;
    lanes.pending[lane] = by;
    pair[lane % 2] = std::min(best, quotient * (1.0 + 0x1p-48));
  } else {
    lanes.date[lane] = std::min(lanes.date[lane], date_of(ball, other));
    pair[lane % 2] = std::min(best, lanes.date[lane]);
  }
}

bool CoverSearch::look_at(Lanes& lanes, std::uint32_t by) const {
  std::array<DoublePairMask, kLeafPairs> can_be_better;
  DoublePairMask all{};
  for (std::size_t i = 0; i < kLeafPairs; ++i) {
    const DoublePair more = radius_[by] - lanes.radius[i];
    const DoublePair x = x_[by] - lanes.x[i];
    const DoublePair y = y_[by] - lanes.y[i];
    can_be_better[i] = (more > 0.0) & ~is_beyond<DoublePair>(x * x + y * y, lanes.best[i] * more);
    all |= can_be_better[i];
  }
  if (!is_any_set(all)) return false;
  for (std::size_t lane = 0; lane < kLeaf; ++lane)
    if (can_be_better[lane / 2][lane % 2] != 0) take(lanes, lane, by);
  return true;
}

void CoverSearch::look_into(Lanes& lanes, const Node& leaf) const {
  const Node& own = *lanes.leaf;
  if (is_apart(own, lanes.bound, leaf)) return;
  const Direction direction = towards(own, lanes.bound, leaf);
  if (is_below(own, leaf, direction)) return;
  std::array<DoublePairMask, kLeafPairs> is_below{};
  if (direction.is_known) {
    const Vec2 up = direction.up;
    DoublePair least = kNever - DoublePair{};
    for (std::size_t i = 0; i < kLeafPairs; ++i) {
      const DoublePair height =
          lanes.radius[i] - (up.x * (lanes.x[i] - own.middle.x) + up.y * (lanes.y[i] - own.middle.y));
      least = height < least ? height : least;
    }
    const double limit = std::min(least[0], least[1]) + direction.way - direction.rounding;
    for (std::size_t i = 0; i < kLeafPairs; ++i) {
      const std::size_t at = leaf.first + 2 * i;
      const DoublePair x{x_[at], x_[at + 1]};
      const DoublePair y{y_[at], y_[at + 1]};
      const DoublePair radius{radius_[at], radius_[at + 1]};
      is_below[i] = radius - (up.x * (x - leaf.middle.x) + up.y * (y - leaf.middle.y)) <= limit;
    }
  }
  bool is_better = false;
  for (std::uint32_t i = 0; i < leaf.last - leaf.first; ++i)
    if (is_below[i / 2][i % 2] == 0) is_better = look_at(lanes, leaf.first + i) || is_better;
  if (is_better) lanes.find_bound();
}

// Balls that are close to each other are mostly swallowed by the same ones.
void CoverSearch::begin(Lanes& lanes, const Node& leaf, const Guesses& guesses) const {
  const std::uint32_t count = leaf.last - leaf.first;
  lanes.leaf = &leaf;
  lanes.date.fill(kNever);
  lanes.quotient.fill(kNever);
  lanes.pending.fill(kNone);
  for (std::uint32_t i = 0; i < kLeaf; ++i) {
    // Lanes behind the last ball are never swallowed.
    const bool is_there = i < count;
    const Ball& ball = balls_[is_there ? leaf.first + i : leaf.first];
    lanes.x[i / 2][i % 2] = ball.center.x;
    lanes.y[i / 2][i % 2] = ball.center.y;
    lanes.radius[i / 2][i % 2] = is_there ? ball.radius : kNever;
    lanes.best[i / 2][i % 2] = is_there ? kNever : 0.0;
  }
  for (std::size_t i = 0; i < guesses.count; ++i) look_at(lanes, guesses.balls[i]);
  if (!hints_.empty())
    for (std::uint32_t i = 0; i < count; ++i) {
      const Ball& ball = balls_[leaf.first + i];
      for (const std::uint32_t hint : hints_[ball.number]) {
        if (hint == kNone) continue;
        const Ball& other = balls_[place_of_[hint]];
        const double more = other.radius - ball.radius;
        const Vec2 away = other.center - ball.center;
        if (more > 0.0 && !is_beyond(dot(away, away), lanes.best[i / 2][i % 2] * more))
          take(lanes, i, place_of_[hint]);
      }
    }
  lanes.find_bound();
}

void CoverSearch::search_block(const Node& block, Guesses& guesses, std::span<double> dates) const {
  std::array<Lanes, kLeaves> leaves;
  std::size_t count = 0;
  std::array<std::uint32_t, kDepth> stack;
  std::size_t size = 0;
  const auto for_each_leaf = [&](std::uint32_t root, auto visit, auto passes) {
    stack[size++] = root;
    while (size > 0) {
      const Node& node = tree_[stack[--size]];
      if (!passes(node)) continue;
      if (node.child == 0) {
        visit(node);
      } else {
        stack[size++] = node.child + 1;
        stack[size++] = node.child;
      }
    }
  };
  for_each_leaf(
      static_cast<std::uint32_t>(&block - tree_.data()),
      [&](const Node& leaf) { begin(leaves[count++], leaf, guesses); }, [](const Node&) { return true; });
  Bound bound;
  const auto find_bound = [&] {
    double most = 0.0;
    for (std::size_t i = 0; i < count; ++i) most = std::max(most, leaves[i].bound.most);
    if (most != bound.most) bound = Bound(most);
  };
  find_bound();
  for_each_leaf(
      0,
      [&](const Node& leaf) {
        for (std::size_t i = 0; i < count; ++i) look_into(leaves[i], leaf);
        find_bound();
      },
      [&](const Node& node) {
        return !is_apart(block, bound, node) && !is_below(block, node, towards(block, bound, node));
      });
  for (std::size_t i = 0; i < count; ++i) {
    const Lanes& lanes = leaves[i];
    guesses.count = 0;
    for (std::uint32_t lane = 0; lane < lanes.leaf->last - lanes.leaf->first; ++lane) {
      const Ball& ball = balls_[lanes.leaf->first + lane];
      double& date = dates[ball.number];
      date = lanes.date[lane];
      if (lanes.pending[lane] == kNone) continue;
      date = std::min(date, date_of(ball, balls_[lanes.pending[lane]]));
      guesses.add(lanes.pending[lane]);
    }
  }
}

void CoverSearch::search(std::size_t part, std::span<double> dates, JobControl& job) const {
  Guesses guesses;
  for (std::size_t i = part * kPartBlocks; i < std::min((part + 1) * kPartBlocks, blocks_.size()); ++i) {
    job.checkpoint();
    search_block(tree_[blocks_[i]], guesses, dates);
  }
}

}  // namespace mes
