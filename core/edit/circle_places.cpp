// SPDX-License-Identifier: GPL-3.0-or-later
#include <fmt/core.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <optional>

#include "core/edit/degenerate_places.h"
#include "core/edit/internal/common_grid.h"
#include "core/edit/internal/distinct_places.h"
#include "core/kernel/edge_predicates.h"

namespace mes {
namespace {

/// A Gaussian prime a + ib, where a^2 + b^2 is a prime that is 1 modulo 4. Multiplying a point by a + ib or by a - ib
/// rotates it by an angle that no other prime gives.
struct PrimeTurn {
  std::int64_t a = 0;
  std::int64_t b = 0;
  std::int64_t prime() const { return a * a + b * b; }
};

/// Primes below `limit`, in increasing order.
std::vector<PrimeTurn> prime_turns(std::int64_t limit) {
  const auto is_prime = [](std::int64_t n) {
    for (std::int64_t d = 3; d * d <= n; d += 2)
      if (n % d == 0) return false;
    return n % 2 != 0;
  };
  std::vector<PrimeTurn> out;
  for (std::int64_t a = 2; a * a < limit; ++a)
    for (std::int64_t b = 1; b < a; ++b)
      if (const std::int64_t n = a * a + b * b; n < limit && n % 4 == 1 && is_prime(n)) out.push_back({a, b});
  std::ranges::sort(out, {}, &PrimeTurn::prime);
  return out;
}

/// A circle x^2 + y^2 = N with many integer points: N is the product of the primes and the square of the factor.
struct RichCircle {
  std::vector<PrimeTurn> turns;  ///< a prime occurs as often as it divides N; increasing
  std::int64_t factor = 1;
  double radius = 0.0;
};

constexpr double kMostPoints = 1 << 15;  // on one quarter of the circle

/// Chooses primes whose product is at most 2^bits and which give many rotations.
std::vector<PrimeTurn> many_turns(std::span<const PrimeTurn> known, double bits) {
  std::vector<PrimeTurn> out;
  std::vector<double> exponent(known.size(), 0.0);
  double points = 1.0;
  for (;;) {
    std::size_t best = known.size();
    double best_gain = 0.0;
    for (std::size_t i = 0; i < known.size(); ++i) {
      const double cost = std::log2(static_cast<double>(known[i].prime()));
      const double gain = std::log2((exponent[i] + 2.0) / (exponent[i] + 1.0)) / cost;
      if (cost > bits || gain <= best_gain) continue;
      best = i;
      best_gain = gain;
    }
    if (best == known.size() || points * (exponent[best] + 2.0) / (exponent[best] + 1.0) > kMostPoints) return out;
    points *= (exponent[best] + 2.0) / (exponent[best] + 1.0);
    exponent[best] += 1.0;
    bits -= std::log2(static_cast<double>(known[best].prime()));
    out.push_back(known[best]);
  }
}

/// A circle with many integer points and a radius near the given one, which must be below 2^52.
RichCircle rich_circle(double radius) {
  constexpr std::int64_t kTurnLimit = 150;
  constexpr std::int64_t kTuningLimit = 2000;
  const std::vector<PrimeTurn> all = prime_turns(kTuningLimit);
  const auto tuning = std::ranges::find_if(all, [](const PrimeTurn& turn) { return turn.prime() >= kTurnLimit; });
  // Two more primes tune the radius; they take up to 22 bits of its square.
  constexpr double kBitsForTuning = 24.0;
  RichCircle best;
  best.turns = many_turns({all.begin(), tuning}, 2.0 * std::log2(std::max(1.0, radius)) - kBitsForTuning);
  double square = 1.0;
  for (const PrimeTurn& turn : best.turns) square *= static_cast<double>(turn.prime());
  double least = std::numeric_limits<double>::infinity();
  std::optional<std::array<PrimeTurn, 2>> pair;
  const auto consider = [&](double with, const std::optional<std::array<PrimeTurn, 2>>& turns) {
    const double unit = std::sqrt(square * with);
    const double factor = std::max(1.0, std::round(radius / unit));
    const double off = std::abs(factor * unit - radius);
    if (off >= least) return;
    least = off;
    best.factor = static_cast<std::int64_t>(factor);
    best.radius = factor * unit;
    pair = turns;
  };
  consider(1.0, std::nullopt);
  if (radius > 1e6)
    for (auto i = tuning; i != all.end(); ++i)
      for (auto j = i; j != all.end(); ++j)
        consider(static_cast<double>(i->prime() * j->prime()), std::array{*i, *j});
  if (pair) best.turns.insert(best.turns.end(), pair->begin(), pair->end());
  std::ranges::sort(best.turns, {}, &PrimeTurn::prime);
  return best;
}

/// All integer points of the circle, counter-clockwise, starting at the direction -pi.
struct CirclePoints {
  std::vector<GridPoint> points;
  std::vector<double> angles;
};

GridPoint turned(GridPoint p, PrimeTurn by, bool back) {
  const std::int64_t b = back ? -by.b : by.b;
  return {p.x * by.a - p.y * b, p.x * b + p.y * by.a};
}

CirclePoints points_of(const RichCircle& circle) {
  std::vector<GridPoint> quarter{{circle.factor, 0}};
  for (std::size_t i = 0; i < circle.turns.size();) {
    std::size_t end = i;
    while (end < circle.turns.size() && circle.turns[end].prime() == circle.turns[i].prime()) ++end;
    const std::size_t times = end - i;
    std::vector<GridPoint> next;
    next.reserve(quarter.size() * (times + 1));
    for (const GridPoint p : quarter) {
      for (std::size_t back = 0; back <= times; ++back) {
        GridPoint q = p;
        for (std::size_t k = 0; k < times; ++k) q = turned(q, circle.turns[i], k < back);
        next.push_back(q);
      }
    }
    quarter = std::move(next);
    i = end;
  }
  struct Keyed {
    double angle;
    GridPoint point;
  };
  std::vector<Keyed> keyed;
  keyed.reserve(4 * quarter.size());
  for (const GridPoint p : quarter)
    for (const GridPoint q : {p, GridPoint{-p.y, p.x}, GridPoint{-p.x, -p.y}, GridPoint{p.y, -p.x}})
      keyed.push_back({std::atan2(static_cast<double>(q.y), static_cast<double>(q.x)), q});
  std::ranges::sort(keyed, {}, &Keyed::angle);
  CirclePoints out;
  for (const Keyed& k : keyed) {
    out.angles.push_back(k.angle);
    out.points.push_back(k.point);
  }
  return out;
}

/// Free slots around the circle. Finds the next one in a direction in nearly constant time (disjoint sets).
class FreePlaces {
 public:
  FreePlaces(std::size_t count, std::size_t step) : next_(count), step_(step) {
    std::iota(next_.begin(), next_.end(), std::size_t{0});
  }
  void take(std::size_t i) { next_[i] = (i + step_) % next_.size(); }
  std::size_t from(std::size_t i) {
    while (next_[i] != i) {
      next_[i] = next_[next_[i]];
      i = next_[i];
    }
    return i;
  }

 private:
  std::vector<std::size_t> next_;
  std::size_t step_;
};

/// A distinct point of the circle for each direction: the nearest one that is still free.
std::optional<std::vector<GridPoint>> chosen(const CirclePoints& circle, std::span<const double> directions) {
  const std::size_t count = circle.points.size();
  if (directions.size() > count) return std::nullopt;
  FreePlaces upwards(count, 1);
  FreePlaces downwards(count, count - 1);
  std::vector<GridPoint> out;
  const auto turn_between = [](double a, double b) {
    return std::abs(std::remainder(a - b, 2.0 * std::numbers::pi));
  };
  for (const double direction : directions) {
    const auto above = std::ranges::lower_bound(circle.angles, direction);
    const std::size_t begin = static_cast<std::size_t>(above - circle.angles.begin()) % count;
    const std::size_t up = upwards.from(begin);
    const std::size_t down = downwards.from((begin + count - 1) % count);
    const bool goes_up = turn_between(circle.angles[up], direction) < turn_between(circle.angles[down], direction);
    const std::size_t best = goes_up ? up : down;
    out.push_back(circle.points[best]);
    // The last point needs no successor; if all points are taken, a search for a free one would not end.
    if (out.size() == directions.size()) break;
    upwards.take(best);
    downwards.take(best);
  }
  return out;
}

/// The algebraic least-squares circle of |p - c|^2 - r^2 (Kasa 1976), for points around the origin of size about 1.
/// Nothing for collinear points, or too few.
std::optional<Disk> algebraic_circle(std::span<const Vec2> places) {
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;
  double xz = 0.0;
  double yz = 0.0;
  for (const Vec2 p : places) {
    const double z = dot(p, p);
    xx += p.x * p.x;
    xy += p.x * p.y;
    yy += p.y * p.y;
    xz += p.x * z;
    yz += p.y * z;
  }
  const double determinant = xx * yy - xy * xy;
  if (determinant <= 1e-12 * (xx + yy) * (xx + yy)) return std::nullopt;
  const Vec2 center{0.5 * (xz * yy - yz * xy) / determinant, 0.5 * (yz * xx - xz * xy) / determinant};
  const double square = dot(center, center) + (xx + yy) / static_cast<double>(places.size());
  return Disk{center, std::sqrt(square)};
}

/// One Gauss-Newton step towards the least squares of distances.
void improve(Disk& circle, std::span<const Vec2> places) {
  // Normal equations for (dx, dy, dr) with rows (ux, uy, 1), where u points from the sample to the centre.
  double xx = 0.0;
  double xy = 0.0;
  double yy = 0.0;
  double x = 0.0;
  double y = 0.0;
  double bx = 0.0;
  double by = 0.0;
  double b = 0.0;
  double count = 0.0;
  for (const Vec2 p : places) {
    const Vec2 d = circle.center - p;
    const double far = length(d);
    if (far == 0.0) return;
    const Vec2 u = (1.0 / far) * d;
    const double off = circle.radius - far;
    xx += u.x * u.x;
    xy += u.x * u.y;
    yy += u.y * u.y;
    x += u.x;
    y += u.y;
    bx += u.x * off;
    by += u.y * off;
    b += off;
    count += 1.0;
  }
  xx -= x * x / count;
  xy -= x * y / count;
  yy -= y * y / count;
  bx -= x * b / count;
  by -= y * b / count;
  const double determinant = xx * yy - xy * xy;
  if (determinant <= 1e-12 * (xx + yy) * (xx + yy)) return;
  const Vec2 step{(bx * yy - by * xy) / determinant, (by * xx - bx * xy) / determinant};
  if (length(step) > 0.5 * circle.radius) return;
  circle.center = circle.center + step;
  double sum = 0.0;
  for (const Vec2 p : places) sum += distance(p, circle.center);
  circle.radius = sum / count;
}

/// True if all later points lie exactly on the circle through the first three, or if all are on one line.
bool are_cocircular(std::span<const Vec2> places) {
  FilterCounts counts;
  return std::ranges::all_of(places.subspan(3), [&](Vec2 p) {
    return classify_edge({places[0], places[1], places[2], p}, counts).is_cocircular;
  });
}

std::unexpected<Error> refuse(const char* why) {
  return std::unexpected(Error{ErrorCode::bad_input, why});
}

std::unexpected<Error> no_room(std::span<const Vec2> places, const Disk& circle) {
  double off = 0.0;
  for (const Vec2 p : places) off = std::max(off, std::abs(distance(p, circle.center) - circle.radius));
  return std::unexpected(
      Error{ErrorCode::bad_input,
            fmt::format("no circle of doubles has room for all {} places: it is too small for its distance from the "
                        "origin; they stay within {:.3g} of the nearest circle",
                        places.size(), off)});
}

}  // namespace

Expected<Disk> nearest_circle(std::span<const Vec2> places) {
  constexpr double kMostOfExtent = 100.0;
  constexpr int kSteps = 20;
  if (places.size() < 3) return refuse("three places are needed for a circle");
  const Vec2 mean = mean_of(places);
  double extent = 0.0;
  for (const Vec2 p : places) extent = std::max(extent, distance(p, mean));
  if (extent == 0.0) return refuse("the places are all the same");
  std::vector<Vec2> scaled;
  scaled.reserve(places.size());
  for (const Vec2 p : places) scaled.push_back((1.0 / extent) * (p - mean));
  auto circle = algebraic_circle(scaled);
  for (int i = 0; circle && i < kSteps; ++i) improve(*circle, scaled);
  if (!circle || circle->radius > kMostOfExtent)
    return refuse("the places are nearly on a line; there is no circle for them");
  return Disk{mean + extent * circle->center, extent * circle->radius};
}

Expected<DegeneratePlaces> on_one_circle(std::span<const Vec2> places) {
  if (const auto twice = repeated_place(places)) return refuse_repeated(*twice);
  if (places.size() < 4) return DegeneratePlaces{{places.begin(), places.end()}, 0.0};
  const auto circle = nearest_circle(places);
  if (!circle) return std::unexpected(circle.error());
  if (are_cocircular(places)) return DegeneratePlaces{{places.begin(), places.end()}, 0.0};
  const Vec2 c = circle->center;
  const CommonGrid grid(std::max(std::abs(c.x), std::abs(c.y)) + circle->radius);
  const GridPoint center = grid.rounded(c);
  const CirclePoints on_circle = points_of(rich_circle(std::max(1.0, circle->radius / grid.step())));
  std::vector<double> directions;
  directions.reserve(places.size());
  for (const Vec2 p : places) directions.push_back(std::atan2(p.y - c.y, p.x - c.x));
  const auto points = chosen(on_circle, directions);
  DegeneratePlaces out;
  if (points)
    for (const GridPoint p : *points) out.places.push_back(grid.place({center.x + p.x, center.y + p.y}));
  if (!points || !are_distinct(out.places)) return no_room(places, *circle);
  out.largest_shift = largest_shift(places, out.places);
  return out;
}

}  // namespace mes
