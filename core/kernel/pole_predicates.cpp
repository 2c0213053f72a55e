// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/kernel/pole_predicates.h"

#include <CGAL/Exact_rational.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/kernel/internal/vector_of.h"

namespace mes {
namespace {

using Rational = CGAL::Exact_rational;
__extension__ typedef __int128 WideInteger;  // NOLINT(modernize-use-using): with -Wpedantic, only this

template <class Number>
int sign_of(const Number& x) {
  return x > 0 ? 1 : (x < 0 ? -1 : 0);
}

// A value in doubles with a sum of magnitudes: the true value differs by less than kSlack * magnitude. Counting
// roundings, the longest chain below (a term of the hull sign) takes 17 units, products of two N take 18; 32 leaves
// room for the rounding of the magnitudes.
constexpr double kSlack = 32.0 * 0x1p-53;
// Below `kLeast`, a product that underflowed may be off by more than the slack; above `kMost`, one may have overflowed.
constexpr double kLeast = 1e-190;
constexpr double kMost = 1e300;

std::optional<int> settled(double value, double magnitude) {
  if (!(magnitude > kLeast && magnitude < kMost)) return std::nullopt;
  if (std::abs(value) <= kSlack * magnitude) return std::nullopt;
  return value > 0.0 ? 1 : -1;
}

// N and D of a triangle in any ring, given u and v.
template <class Number>
struct Star {
  VectorOf<Number> u, v;

  Number d() const { return u.x * v.y - u.y * v.x; }
  VectorOf<Number> n() const {
    const Number uu = dot_of(u, u);
    const Number vv = dot_of(v, v);
    return {v.y * uu - u.y * vv, u.x * vv - v.x * uu};
  }
  /// |u|^2 |v|^2 |r - q|^2
  Number sides() const {
    const VectorOf<Number> w{v.x - u.x, v.y - u.y};
    return dot_of(u, u) * dot_of(v, v) * dot_of(w, w);
  }
};

struct StarMagnitude {
  double d = 0.0;
  VectorOf<double> n{};
};
Star<double> star_of(const StarTriangle& f) {
  const Vec2 u = f.q - f.p;
  const Vec2 v = f.r - f.p;
  return {{u.x, u.y}, {v.x, v.y}};
}
StarMagnitude magnitude_of(const Star<double>& s) {
  const double uu = dot_of(s.u, s.u);
  const double vv = dot_of(s.v, s.v);
  return {std::abs(s.u.x * s.v.y) + std::abs(s.u.y * s.v.x),
          {std::abs(s.v.y) * uu + std::abs(s.u.y) * vv, std::abs(s.u.x) * vv + std::abs(s.v.x) * uu}};
}

// Differences to p as integers of at most eleven bits, for points on a grid whose step is not much smaller than the
// triangles. Then N has 35 bits, D 23, and no polynomial here more than 118.
class GridDifferences {
 public:
  GridDifferences(Vec2 p, std::initializer_list<Vec2> others) : p_(p) {
    double largest = 0.0;
    for (const Vec2 a : others) largest = std::max({largest, std::abs(a.x - p.x), std::abs(a.y - p.y)});
    if (!(largest > 1e-100 && largest < 1e100)) return;
    steps_ = std::ldexp(1.0, 10 - std::ilogb(largest));
    is_on_grid_ = is_whole(p) && std::all_of(others.begin(), others.end(), [this](Vec2 a) { return is_whole(a); });
  }
  bool is_on_grid() const { return is_on_grid_; }
  VectorOf<WideInteger> to(Vec2 a) const {
    return {static_cast<WideInteger>(static_cast<long>((a.x - p_.x) * steps_)),
            static_cast<WideInteger>(static_cast<long>((a.y - p_.y) * steps_))};
  }

 private:
  // A coordinate of 2^53 steps or more is whole, and so is its exact difference to another whole one.
  bool is_whole(Vec2 a) const {
    const auto whole = [this](double x) {
      const double scaled = x * steps_;
      return scaled == std::trunc(scaled) && std::isfinite(scaled) && (scaled != 0.0 || x == 0.0);
    };
    return whole(a.x) && whole(a.y);
  }
  Vec2 p_;
  double steps_ = 0.0;
  bool is_on_grid_ = false;
};

// The sign that `polynomial` gives for two stars, exactly.
template <class Polynomial>
int exact_sign(const StarTriangle& f, const StarTriangle& g, Polynomial polynomial) {
  const GridDifferences grid(f.p, {f.q, f.r, g.q, g.r});
  if (grid.is_on_grid())
    return polynomial(Star<WideInteger>{grid.to(f.q), grid.to(f.r)}, Star<WideInteger>{grid.to(g.q), grid.to(g.r)});
  return polynomial(Star<Rational>{vector_between<Rational>(f.p, f.q), vector_between<Rational>(f.p, f.r)},
                    Star<Rational>{vector_between<Rational>(g.p, g.q), vector_between<Rational>(g.p, g.r)});
}

}  // namespace

RadiusKey radius_key(const StarTriangle& f) {
  const Star<double> s = star_of(f);
  const double d = s.d();
  const double least_d = d - kSlack * magnitude_of(s).d;
  const Vec2 w = f.r - f.q;
  const double sides = dot_of(s.u, s.u) * dot_of(s.v, s.v) * dot(w, w);
  constexpr double kNone = std::numeric_limits<double>::infinity();
  if (!(sides > 1e-140 && sides < 1e140 && least_d > 1e-70 && d < 1e70)) return {0.0, kNone};
  const double value = sides / (4.0 * d * d);
  // The sides carry 14 units, division and square four more; (d / least_d)^2 bounds what the error of D does.
  const double relative = d / least_d;
  return {value, value * (relative * relative * (1.0 + kSlack) - 1.0)};
}

int compare_pole_distance(const StarTriangle& f, const RadiusKey& key_f, const StarTriangle& g,
                          const RadiusKey& key_g) {
  const double gap = key_f.value - key_g.value;
  // Twice the errors leaves room for the rounding of this comparison.
  if (std::abs(gap) > 2.0 * (key_f.error + key_g.error)) return gap > 0.0 ? 1 : -1;
  return exact_sign(f, g, [](const auto& a, const auto& b) {
    const auto da = a.d();
    const auto db = b.d();
    // Operations on rationals return expressions, so name the number type.
    const std::decay_t<decltype(a.u.x)> left = a.sides() * db * db;
    const std::decay_t<decltype(a.u.x)> right = b.sides() * da * da;
    return left < right ? -1 : (right < left ? 1 : 0);
  });
}

int compare_circumcenters(const StarTriangle& f, const StarTriangle& g) {
  const Star<double> a = star_of(f);
  const Star<double> b = star_of(g);
  const StarMagnitude ma = magnitude_of(a);
  const StarMagnitude mb = magnitude_of(b);
  if (const auto sign = settled(a.n().x * b.d() - b.n().x * a.d(), ma.n.x * mb.d + mb.n.x * ma.d)) return *sign;
  return exact_sign(f, g, [](const auto& s, const auto& t) {
    using Number = std::decay_t<decltype(s.u.x)>;
    const auto ns = s.n();
    const auto nt = t.n();
    const Number ds = s.d();
    const Number dt = t.d();
    const int in_x = sign_of(Number(ns.x * dt - nt.x * ds));
    return in_x != 0 ? in_x : sign_of(Number(ns.y * dt - nt.y * ds));
  });
}

int sign_of_side(const StarTriangle& f, const StarTriangle& g) {
  const Star<double> a = star_of(f);
  const Star<double> b = star_of(g);
  const StarMagnitude ma = magnitude_of(a);
  const StarMagnitude mb = magnitude_of(b);
  if (const auto sign = settled(dot_of(a.n(), b.n()), dot_of(ma.n, mb.n))) return *sign;
  return exact_sign(f, g, [](const auto& s, const auto& t) {
    using Number = std::decay_t<decltype(s.u.x)>;
    return sign_of(Number(dot_of(s.n(), t.n())));
  });
}

namespace {

// n_1 and n_2 point to the right of the hull edges before -> p -> after; `b` and `c` are before - p and after - p.
template <class Number>
int hull_side(const Star<Number>& star, const VectorOf<Number>& b, const VectorOf<Number>& c) {
  const VectorOf<Number> n = star.n();
  const Number first = n.y * b.x - n.x * b.y;
  const Number second = n.x * c.y - n.y * c.x;
  const int sign_1 = sign_of(first);
  const int sign_2 = sign_of(second);
  if (sign_1 * sign_2 >= 0) return sign_1 != 0 ? sign_1 : sign_2;
  const Number left = first * first * dot_of(c, c);
  const Number right = second * second * dot_of(b, b);
  return left < right ? sign_2 : (right < left ? sign_1 : 0);
}

}  // namespace

int sign_of_hull_side(const StarTriangle& f, Vec2 before, Vec2 after) {
  const Star<double> s = star_of(f);
  const VectorOf<double> n = s.n();
  const VectorOf<double> mn = magnitude_of(s).n;
  const Vec2 b = before - f.p;
  const Vec2 c = after - f.p;
  const double length_b = std::sqrt(dot(b, b));
  const double length_c = std::sqrt(dot(c, c));
  if (length_b > 1e-100 && length_c > 1e-100 && length_b < 1e100 && length_c < 1e100) {
    const double value = (n.y * b.x - n.x * b.y) / length_b + (n.x * c.y - n.y * c.x) / length_c;
    const double magnitude = (mn.y * std::abs(b.x) + mn.x * std::abs(b.y)) / length_b +
                             (mn.x * std::abs(c.y) + mn.y * std::abs(c.x)) / length_c;
    if (const auto sign = settled(value, magnitude)) return *sign;
  }
  const GridDifferences grid(f.p, {f.q, f.r, before, after});
  if (grid.is_on_grid())
    return hull_side(Star<WideInteger>{grid.to(f.q), grid.to(f.r)}, grid.to(before), grid.to(after));
  return hull_side(Star<Rational>{vector_between<Rational>(f.p, f.q), vector_between<Rational>(f.p, f.r)},
                   vector_between<Rational>(f.p, before), vector_between<Rational>(f.p, after));
}

Vec2 hull_direction(Vec2 p, Vec2 before, Vec2 after) {
  const auto unit = [](Vec2 d) {
    if (!is_finite(d)) return Vec2{};
    const double size = length(d);
    return size > 0.0 ? Vec2{d.x / size, d.y / size} : Vec2{};
  };
  const Vec2 in = unit(p - before);
  const Vec2 on = unit(after - p);
  // Right-hand normals add up to that of the sum; at a spike, where the sum is zero, `in` points outward.
  const Vec2 d = unit(-perpendicular(in + on));
  return d == Vec2{} ? in : d;
}

}  // namespace mes
