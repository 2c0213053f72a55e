// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/curves/internal/arc_length.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/base/power_of_two.h"

#ifdef __SSE2__
#include <emmintrin.h>
#endif

namespace mes {
namespace {

constexpr double kLengthTolerance = 1e-12;
// Halving narrows a cusp down to 2^-40 of its piece.
constexpr int kMostDepth = 40;

/// Range of squared lengths in which a plain square root is accurate.
constexpr double kLeastSquare = 0x1p-900;
constexpr double kMostSquare = 0x1p900;

/// Like `length`, but ten times as fast while squares are normal doubles.
double speed_of(Vec2 v) {
  const double squared = dot(v, v);
  return squared > kLeastSquare && squared < kMostSquare ? std::sqrt(squared) : length(v);
}

/// Quadrature nodes and weights. Nodes lie in pairs about the middle; one of each pair is listed.
constexpr std::array<std::pair<double, double>, 4> kNodes{{{0.183434642495649805, 0.362683783378361983},
                                                           {0.525532409916328986, 0.313706645877887287},
                                                           {0.796666477413626740, 0.222381034453374471},
                                                           {0.960289856497536232, 0.101228536290376259}}};

/// The weighted sum of speeds at the nodes about `middle`. Computes both nodes of a pair at once, with the same
/// roundings as one by one. Negative if a square leaves its range, and on machines without SSE2.
double sum_of_speeds([[maybe_unused]] const std::array<Vec2, 3>& velocity, [[maybe_unused]] double middle,
                     [[maybe_unused]] double half) {
#ifdef __SSE2__
  const __m128d signs = _mm_set_pd(half, -half);
  const auto value_at = [](double a, double b, double c, __m128d t) {
    const __m128d inner = _mm_add_pd(_mm_set1_pd(b), _mm_mul_pd(t, _mm_set1_pd(c)));
    return _mm_add_pd(_mm_set1_pd(a), _mm_mul_pd(t, inner));
  };
  __m128d speeds[kNodes.size()];
  __m128d are_in_range = _mm_castsi128_pd(_mm_set1_epi32(-1));
  for (std::size_t i = 0; i < kNodes.size(); ++i) {
    const __m128d t = _mm_add_pd(_mm_set1_pd(middle), _mm_mul_pd(signs, _mm_set1_pd(kNodes[i].first)));
    const __m128d x = value_at(velocity[0].x, velocity[1].x, velocity[2].x, t);
    const __m128d y = value_at(velocity[0].y, velocity[1].y, velocity[2].y, t);
    const __m128d squared = _mm_add_pd(_mm_mul_pd(x, x), _mm_mul_pd(y, y));
    are_in_range = _mm_and_pd(are_in_range, _mm_and_pd(_mm_cmpgt_pd(squared, _mm_set1_pd(kLeastSquare)),
                                                       _mm_cmplt_pd(squared, _mm_set1_pd(kMostSquare))));
    speeds[i] = _mm_sqrt_pd(squared);
  }
  constexpr int kBoth = 3;
  if (_mm_movemask_pd(are_in_range) != kBoth) return -1.0;
  double sum = 0.0;
  for (std::size_t i = 0; i < kNodes.size(); ++i)
    sum += kNodes[i].second * (_mm_cvtsd_f64(speeds[i]) + _mm_cvtsd_f64(_mm_unpackhi_pd(speeds[i], speeds[i])));
  return sum;
#else
  return -1.0;
#endif
}

double polygon_length(const Piece& piece) {
  if (piece.kind == PieceKind::arc) return std::abs(piece.arc.sweep) * (length(piece.arc.u) + length(piece.arc.v));
  const std::size_t count = piece.kind == PieceKind::cubic ? 4 : 3;
  double sum = 0.0;
  for (std::size_t i = 1; i < count; ++i) sum += distance(piece.points[i - 1], piece.points[i]);
  return sum;
}

/// The parameter between `low` and `high` at which a function changes from negative to nonnegative.
template <class Function>
double root_between(const Function& function, double low, double high) {
  for (;;) {
    const double middle = 0.5 * (low + high);
    if (!(middle > low && middle < high)) return high;
    (function(middle) < 0.0 ? low : high) = middle;
  }
}

/// Calls `use(t)` at each minimum of the squared speed within the piece, in order.
template <class Use>
void for_each_slowest_place(const std::array<Vec2, 3>& velocity, Use use) {
  // Half the derivative of the squared speed is a cubic polynomial. It has at most one root between its turning points.
  auto [a, b, c] = velocity;
  double size = 0.0;
  for (const Vec2 v : {a, b, c}) size = std::max({size, std::abs(v.x), std::abs(v.y)});
  if (!(size > 0.0) || !std::isfinite(size)) return;
  const int exponent = std::ilogb(size);
  for (Vec2* const v : {&a, &b, &c}) *v = {times_power_of_two(v->x, -exponent), times_power_of_two(v->y, -exponent)};
  const std::array<double, 4> k{dot(a, b), dot(b, b) + 2.0 * dot(a, c), 3.0 * dot(b, c), 2.0 * dot(c, c)};
  const auto slope = [&k](double t) { return k[0] + t * (k[1] + t * (k[2] + t * k[3])); };
  std::array<double, 4> ends{0.0, 1.0, 1.0, 1.0};
  std::size_t count = 1;
  const double inner = k[2] * k[2] - 3.0 * k[1] * k[3];
  if (inner > 0.0) {
    const double q = -(k[2] + std::copysign(std::sqrt(inner), k[2]));
    std::array turns{q / (3.0 * k[3]), k[1] / q};
    std::ranges::sort(turns);
    for (const double turn : turns)
      if (turn > ends[count - 1] && turn < 1.0) ends[count++] = turn;
  }
  ends[count++] = 1.0;
  for (std::size_t i = 1; i < count; ++i) {
    if (!(slope(ends[i - 1]) < 0.0 && slope(ends[i]) >= 0.0)) continue;
    const double root = root_between(slope, ends[i - 1], ends[i]);
    if (root < 1.0) use(root);
  }
}

}  // namespace

PieceLength::PieceLength(const Piece& piece) : piece_(piece) {
  if (piece.kind == PieceKind::line) {
    total_ = distance(piece.from(), piece.to());
    return;
  }
  const auto& p = piece.points;
  const Vec2 first = p[1] - p[0];
  const Vec2 second = p[2] - p[1];
  if (piece.kind == PieceKind::quadratic) {
    velocity_ = {2.0 * first, 2.0 * (second - first), Vec2{}};
  } else if (piece.kind == PieceKind::cubic) {
    const Vec2 third = p[3] - p[2];
    velocity_ = {3.0 * first, 6.0 * (second - first), 3.0 * ((third - second) - (second - first))};
  }
  const double tolerance = kLengthTolerance * polygon_length(piece);
  constexpr std::size_t kUsual = 4;
  intervals_.reserve(kUsual);
  double begin = 0.0;
  const auto go_to = [&](double end) {
    halve(begin, end, quadrature(begin, end), tolerance, 0);
    begin = end;
  };
  if (piece.kind == PieceKind::arc) {
    for (const double place : slowest_places_of_arc()) go_to(place);
  } else {
    for_each_slowest_place(velocity_, go_to);
  }
  go_to(1.0);
}

// The squared speed is |u|^2 sin^2 w + |v|^2 cos^2 w - 2 uv sin w cos w, a wave in 2 w.
std::vector<double> PieceLength::slowest_places_of_arc() const {
  std::vector<double> out;
  const EllipticArc& arc = piece_.arc;
  const double cosine = dot(arc.v, arc.v) - dot(arc.u, arc.u);
  const double sine = -2.0 * dot(arc.u, arc.v);
  const double slowest = 0.5 * (std::atan2(sine, cosine) + std::numbers::pi);
  const double low = std::min(arc.start, arc.start + arc.sweep);
  const double high = std::max(arc.start, arc.start + arc.sweep);
  // Counts turns, because adding one to a large number of turns may not change it.
  const double first = std::ceil((low - slowest) / std::numbers::pi);
  for (double turn = 0.0; turn <= std::abs(arc.sweep) / std::numbers::pi + 1.0; ++turn) {
    const double place = slowest + (first + turn) * std::numbers::pi;
    if (!(place < high)) break;
    const double t = (place - arc.start) / arc.sweep;
    if (t > 0.0 && t < 1.0) out.push_back(t);
  }
  std::ranges::sort(out);
  return out;
}

Vec2 PieceLength::velocity_at(double t) const {
  if (piece_.kind == PieceKind::arc) return piece_.derivative(t);
  return velocity_[0] + t * (velocity_[1] + t * velocity_[2]);
}

// Length between two parameters. Source of nodes and weights: Abramowitz and Stegun, table 25.4.
double PieceLength::quadrature(double begin, double end) const {
  const double middle = 0.5 * (begin + end);
  const double half = 0.5 * (end - begin);
  if (piece_.kind != PieceKind::arc)
    if (const double sum = sum_of_speeds(velocity_, middle, half); sum >= 0.0) return half * sum;
  double sum = 0.0;
  for (const auto& [node, weight] : kNodes)
    sum += weight * (speed_of(velocity_at(middle - half * node)) + speed_of(velocity_at(middle + half * node)));
  return half * sum;
}

void PieceLength::halve(double begin, double end, double whole, double tolerance, int depth) {
  const double middle = 0.5 * (begin + end);
  const double first = quadrature(begin, middle);
  const double second = quadrature(middle, end);
  // Written so that NaN ends the recursion too.
  const bool is_rough = std::abs(first + second - whole) > tolerance;
  if (depth < kMostDepth && is_rough) {
    halve(begin, middle, first, tolerance, depth + 1);
    halve(middle, end, second, tolerance, depth + 1);
    return;
  }
  intervals_.push_back({middle, total_ + first});
  total_ += first + second;
  intervals_.push_back({end, total_});
}

double PieceLength::parameter_at(double wanted) const {
  if (!(wanted > 0.0)) return 0.0;
  if (wanted >= total_) return 1.0;
  if (piece_.kind == PieceKind::line) return wanted / total_;
  const auto interval = std::ranges::upper_bound(intervals_, wanted, {}, [](const Interval& i) { return i.length; });
  if (interval == intervals_.end()) return 1.0;
  const bool is_first = interval == intervals_.begin();
  const double begin = is_first ? 0.0 : std::prev(interval)->end;
  const double reached = is_first ? 0.0 : std::prev(interval)->length;

  // Newton's method within bounds that bisection narrows; starts from a cubic through both ends with their speeds.
  double low = begin;
  double high = interval->end;
  const double width = high - begin;
  const double share = (wanted - reached) / (interval->length - reached);
  const double mean = (interval->length - reached) / width;
  const double at_begin = mean / speed_of(velocity_at(begin));
  const double at_end = mean / speed_of(velocity_at(high));
  double t =
      begin + width * (share + share * (1.0 - share) * ((1.0 - share) * (at_begin - 1.0) - share * (at_end - 1.0)));
  if (!(t > low && t < high)) t = begin + width * share;
  constexpr int kMostSteps = 60;
  constexpr double kReached = 1e-14;  // relative to the total length: smaller differences are rounding
  // After a step of this share of the interval, the next one would be about its square, which is rounding.
  constexpr double kLast = 1e-10;
  for (int step = 0; step < kMostSteps; ++step) {
    const double error = reached + quadrature(begin, t) - wanted;
    if (std::abs(error) <= kReached * total_) return t;
    (error > 0.0 ? high : low) = t;
    const double speed = speed_of(velocity_at(t));
    double next = t - error / speed;
    const bool is_inside = next > low && next < high;
    if (!is_inside) next = 0.5 * (low + high);
    const double moved = std::abs(next - t);
    if (moved <= 1e-16 || next == t || (is_inside && moved <= kLast * width)) return next;
    t = next;
  }
  return t;
}

}  // namespace mes
