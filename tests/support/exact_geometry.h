// SPDX-License-Identifier: GPL-3.0-or-later
// A second crust test, in integers of any size and from the definition: the reference for the predicates.
//
// This shares no code with core/kernel. Doubles become integers through a common power of two, angles are cotangents as
// fractions, and an edge is judged by the rule "both angles at most 90 degrees, cot(alpha) cot(beta) >= 1".
//
// Smallest use:
//     const ExactEdge edge = exact_edge({p, q, r, s});
//     CHECK(edge.is_crust() == classify_edge({p, q, r, s}, counts).is_crust);
//
// Cost: microseconds at ordinary sizes, some hundred microseconds at the ends of the range of doubles.
#pragma once

#include <gmpxx.h>

#include <cmath>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "core/base/geometry/vec2.h"
#include "core/kernel/edge_predicates.h"

namespace mes::test {

struct ExactPoint {
  mpz_class x, y;
};

inline ExactPoint operator-(const ExactPoint& a, const ExactPoint& b) {
  return {a.x - b.x, a.y - b.y};
}
inline mpz_class dot(const ExactPoint& a, const ExactPoint& b) {
  return a.x * b.x + a.y * b.y;
}
inline mpz_class cross(const ExactPoint& a, const ExactPoint& b) {
  return a.x * b.y - a.y * b.x;
}

/// The largest e such that every coordinate is an integer times 2^e; 0 when all are zero.
inline int common_exponent(std::span<const Vec2> points) {
  int least = std::numeric_limits<int>::max();
  for (const Vec2 p : points) {
    for (const double value : {p.x, p.y}) {
      if (value == 0.0) continue;
      int exponent = 0;
      std::frexp(value, &exponent);
      least = std::min(least, exponent - 53);
    }
  }
  return least == std::numeric_limits<int>::max() ? 0 : least;
}

/// `value` / 2^e; the quotient must be an integer.
inline mpz_class as_integer(double value, int e) {
  if (value == 0.0) return {};
  int exponent = 0;
  const double fraction = std::frexp(value, &exponent);
  mpz_class out(std::ldexp(fraction, 53));
  out <<= static_cast<unsigned>(exponent - 53 - e);
  return out;
}

/// The points multiplied by one power of two.
inline std::vector<ExactPoint> as_integers(std::span<const Vec2> points) {
  const int e = common_exponent(points);
  std::vector<ExactPoint> out;
  out.reserve(points.size());
  for (const Vec2 p : points) out.push_back({as_integer(p.x, e), as_integer(p.y, e)});
  return out;
}

inline mpq_class fraction(const mpz_class& numerator, const mpz_class& denominator) {
  mpq_class out(numerator, denominator);
  out.canonicalize();
  return out;
}

/// A fraction or infinity, for cotangents.
using ExactCot = std::optional<mpq_class>;

/// -1, 0 or 1; infinity is above all and equal to itself.
inline int compare(const ExactCot& a, const ExactCot& b) {
  if (!a || !b) return (a ? 0 : 1) - (b ? 0 : 1);
  return *a < *b ? -1 : (*b < *a ? 1 : 0);
}

/// A Delaunay edge with the angles at its two apexes.
struct ExactEdge {
  mpq_class cot_left;
  ExactCot cot_right;  ///< none on the hull, where the angle is 0

  /// Whether some circle through both ends, centred on the dual, has neither end of the dual inside.
  bool is_crust() const {
    if (cot_left < 0) return false;
    return !cot_right || (*cot_right >= 0 && cot_left * *cot_right >= 1);
  }
  bool is_cocircular() const { return cot_right && cot_left + *cot_right == 0; }
  bool is_delaunay() const { return !cot_right || cot_left + *cot_right >= 0; }
  /// cot(alpha + beta); none when alpha + beta = 180 degrees.
  ExactCot cot_of_sum() const {
    if (!cot_right) return cot_left;
    if (is_cocircular()) return {};
    return mpq_class((cot_left * *cot_right - 1) / (cot_left + *cot_right));
  }
  /// |cot(alpha + beta)|, none when infinite.
  ExactCot certainty() const {
    ExactCot out = cot_of_sum();
    if (out && *out < 0) *out = -*out;
    return out;
  }
};

/// Cotangent of the angle at `apex` from `from` to `to`, counter-clockwise; they must not be collinear.
inline mpq_class exact_cot(const ExactPoint& apex, const ExactPoint& from, const ExactPoint& to) {
  const ExactPoint u = from - apex;
  const ExactPoint v = to - apex;
  return fraction(dot(u, v), cross(u, v));
}

inline ExactEdge exact_edge(const EdgeCorners& corners) {
  std::vector<Vec2> points{corners.p, corners.q, corners.r};
  if (corners.s) points.push_back(*corners.s);
  const std::vector<ExactPoint> exact = as_integers(points);
  ExactEdge edge{exact_cot(exact[0], exact[1], exact[2]), {}};
  if (corners.s) edge.cot_right = exact_cot(exact[3], exact[2], exact[1]);
  return edge;
}

/// 1 when c lies left of a -> b, -1 when right, 0 on the line.
inline int exact_side(Vec2 a, Vec2 b, Vec2 c) {
  const std::vector<Vec2> points{a, b, c};
  const std::vector<ExactPoint> exact = as_integers(points);
  return sgn(cross(exact[1] - exact[0], exact[2] - exact[0]));
}

/// 1 when d lies inside the circle through a, b, c (counter-clockwise), -1 outside, 0 on it: the lifted determinant.
inline int exact_in_circle(const ExactPoint& a, const ExactPoint& b, const ExactPoint& c, const ExactPoint& d) {
  const ExactPoint u = a - d;
  const ExactPoint v = b - d;
  const ExactPoint w = c - d;
  const mpz_class determinant = dot(u, u) * cross(v, w) + dot(v, v) * cross(w, u) + dot(w, w) * cross(u, v);
  return sgn(determinant);
}

}  // namespace mes::test
