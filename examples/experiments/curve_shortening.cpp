// SPDX-License-Identifier: GPL-3.0-or-later
// Curve-shortening flow: each point of a curve moves along its normal at a speed equal to the curvature.
//
// Sources: M. Gage, R. S. Hamilton, The heat equation shrinking convex plane curves, J. Differential Geometry 23
// (1986); M. A. Grayson, The heat equation shrinks embedded plane curves to round points, ibid. 26 (1987). A simple
// closed curve stays simple, becomes convex, and shrinks to a round point; the area inside decreases by 2 pi in a unit
// of time.
//
// Scheme: K. Deckelnick, G. Dziuk, On the approximation of the curve shortening flow, 1995: x_t = x_uu / |x_u|^2. Its
// normal part is the flow, and its tangential part evens out the spacing, so that no samples have to be inserted. A
// step is semi-implicit: lengths are those before the step, and positions those after it. So x_i - a_i (x_(i-1) - 2 x_i
// + x_(i+1)) is the old position, with a_i the time over the squared mean length of the two links at i. Each new
// position is then a convex combination of old ones, and steps of any length are stable. Ends and crossings stay.
//
//   mesecina evolve shape.poff --with curve_shortening.cpp --evolution curve-shortening --steps 20 -o short.poff
#include <mesecina/experiment.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

using namespace mesecina;

namespace {

using Numbers = std::vector<double>;

double distance(Point a, Point b) {
  return std::hypot(b.x - a.x, b.y - a.y);
}

double length(const Contour& curve, std::span<const Point> at) {
  double sum = 0.0;
  for (std::size_t i = curve.is_closed ? 0 : 1; i < curve.points.size(); ++i)
    sum += distance(at[curve.points[i]], at[curve.points[i == 0 ? curve.points.size() - 1 : i - 1]]);
  return sum;
}

/// Solves -a_i x_(i-1) + (1 + 2 a_i + extra_i) x_i - a_i x_(i+1) = right_i. The terms before the first x and behind the
/// last one are zero. The matrix is diagonally dominant, so elimination needs no pivots.
Numbers solve_open(const Numbers& a, const Numbers& extra, Numbers right) {
  const std::size_t count = a.size();
  Numbers factor(count, 0.0);
  for (std::size_t i = 0; i < count; ++i) {
    const double pivot = 1.0 + 2.0 * a[i] + extra[i] - (i == 0 ? 0.0 : a[i] * factor[i - 1]);
    factor[i] = a[i] / pivot;
    right[i] = (right[i] + (i == 0 ? 0.0 : a[i] * right[i - 1])) / pivot;
  }
  for (std::size_t i = count - 1; i-- > 0;) right[i] += factor[i] * right[i + 1];
  return right;
}

/// Solves the same equations with the last x before the first one and the first after the last. The two corners of the
/// matrix are taken out as a product u v^T, and put back by the formula of Sherman and Morrison.
class ClosedSystem {
 public:
  explicit ClosedSystem(const Numbers& a) : a_(a), extra_(a.size(), 0.0), from_u_(a.size(), 0.0) {
    const double first = 1.0 + 2.0 * a.front();
    extra_.front() = first;
    extra_.back() = a.back() * a.front() / first;
    v_ = a.front() / first;  // v = (1, 0, ..., 0, v_)
    from_u_.front() = -first;
    from_u_.back() = -a.back();
    from_u_ = solve_open(a_, extra_, std::move(from_u_));
  }
  Numbers solve(Numbers right) const {
    Numbers x = solve_open(a_, extra_, std::move(right));
    const double factor = (x.front() + v_ * x.back()) / (1.0 + from_u_.front() + v_ * from_u_.back());
    for (std::size_t i = 0; i < x.size(); ++i) x[i] -= factor * from_u_[i];
    return x;
  }

 private:
  const Numbers& a_;
  Numbers extra_, from_u_;
  double v_ = 0.0;
};

std::vector<Point> shorten(const MovingSamples& samples, std::span<const double> values) {
  const std::span<const Point> at = samples.positions;
  std::vector<Point> next(at.begin(), at.end());
  double longest = 0.0;
  for (const Contour& curve : samples.curves) longest = std::max(longest, length(curve, at));
  // A circle of length L vanishes after the time L^2 / (8 pi^2).
  const double time = values[0] / (8.0 * std::numbers::pi * std::numbers::pi);  // in units of longest^2
  for (const Contour& curve : samples.curves) {
    const std::size_t count = curve.points.size();
    // A much shorter curve has vanished: it stays as a dot.
    if (count < 3 || length(curve, at) <= 1e-3 * longest) continue;
    const Point origin = at[curve.points.front()];
    Numbers a(count, 0.0), x(count), y(count);
    for (std::size_t i = 0; i < count; ++i) {
      const Point here = at[curve.points[i]];
      x[i] = here.x - origin.x;
      y[i] = here.y - origin.y;
      if (samples.may_move[curve.points[i]] == 0) continue;
      const Point before = at[curve.points[(i + count - 1) % count]], after = at[curve.points[(i + 1) % count]];
      const double links = 0.5 * (distance(before, here) + distance(here, after)) / longest;
      a[i] = links > 1e-8 ? time / (links * links) : 1e12;
    }
    if (curve.is_closed) {
      const ClosedSystem system(a);
      x = system.solve(std::move(x));
      y = system.solve(std::move(y));
    } else {
      const Numbers none(count, 0.0);
      x = solve_open(a, none, std::move(x));
      y = solve_open(a, none, std::move(y));
    }
    for (std::size_t i = 0; i < count; ++i) {
      if (samples.may_move[curve.points[i]] == 0) continue;
      next[curve.points[i]] = {origin.x + x[i], origin.y + y[i]};
      // Sums that should be zero are only nearly so, and a document has no room for them beside its large numbers.
      for (double* number : {&next[curve.points[i]].x, &next[curve.points[i]].y})
        if (std::abs(*number) < 1e-18 * longest) *number = 0.0;
    }
  }
  return next;
}

}  // namespace

MESECINA_EXPERIMENT(experiment) {
  experiment.add_evolution(
      {.id = "curve-shortening",
       .name = "Curve shortening",
       .description = "Curves move along their normals at a speed equal to their curvature",
       .parameters = {{.id = "curve-shortening-step",
                       .description = "Time of a step, as part of the life of a circle as long as the longest curve",
                       .low = 0.0,
                       .high = 0.1,
                       .default_value = 0.001}}},
      shorten);
}
