// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/draw/instance_difference.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <unordered_map>
#include <utility>

#include "core/base/geometry/vec2.h"

namespace mes {
namespace {

// Tolerance for directions, which are compared as unit vectors.
constexpr double kDirectionTolerance = 1e-7;

Vec2 at(const double* values, std::size_t i) {
  return {values[i], values[i + 1]};
}

/// A point of the instance that does not depend on the order of its points.
Vec2 anchor(PrimitiveKind kind, const double* v) {
  switch (kind) {
    case PrimitiveKind::segment: return 0.5 * at(v, 0) + 0.5 * at(v, 2);
    case PrimitiveKind::parabola: return 0.5 * at(v, 0) + 0.5 * at(v, 4);
    case PrimitiveKind::triangle: return 1.0 / 3.0 * at(v, 0) + 1.0 / 3.0 * at(v, 2) + 1.0 / 3.0 * at(v, 4);
    default: return at(v, 0);
  }
}

class Alike {
 public:
  Alike(PrimitiveKind kind, double tolerance) : kind_(kind), tolerance_(tolerance) {}

  bool operator()(const double* a, const double* b) const {
    switch (kind_) {
      case PrimitiveKind::point: return near(a, b, 0, 0);
      case PrimitiveKind::disk:
      case PrimitiveKind::circle: return near(a, b, 0, 0) && near(a[2], b[2]);
      case PrimitiveKind::segment:
        return (near(a, b, 0, 0) && near(a, b, 2, 2)) || (near(a, b, 0, 2) && near(a, b, 2, 0));
      case PrimitiveKind::ray: return near(a, b, 0, 0) && between_directions(a, b, 1.0) <= kDirectionTolerance;
      case PrimitiveKind::line:
        return near(a, b, 0, 0) &&
               std::min(between_directions(a, b, 1.0), between_directions(a, b, -1.0)) <= kDirectionTolerance;
      case PrimitiveKind::triangle: return triangles(a, b);
      case PrimitiveKind::arc: return near(a, b, 0, 0) && near(a[2], b[2]) && near(a, b, 3, 3) && near(a, b, 5, 5);
      case PrimitiveKind::parabola:
        return near(a, b, 2, 2) && ((near(a, b, 0, 0) && near(a, b, 4, 4)) || (near(a, b, 0, 4) && near(a, b, 4, 0)));
    }
    return false;
  }

 private:
  bool near(double a, double b) const { return std::abs(a - b) <= tolerance_; }
  bool near(const double* a, const double* b, std::size_t i, std::size_t k) const {
    return near(a[i], b[k]) && near(a[i + 1], b[k + 1]);
  }
  static double between_directions(const double* a, const double* b, double sign) {
    const double length_a = std::hypot(a[2], a[3]);
    const double length_b = sign * std::hypot(b[2], b[3]);
    return std::max(std::abs(a[2] / length_a - b[2] / length_b), std::abs(a[3] / length_a - b[3] / length_b));
  }
  bool triangles(const double* a, const double* b) const {
    constexpr std::array<std::array<std::size_t, 3>, 6> kOrders{
        {{0, 2, 4}, {2, 4, 0}, {4, 0, 2}, {4, 2, 0}, {2, 0, 4}, {0, 4, 2}}};
    return std::ranges::any_of(kOrders, [&](const std::array<std::size_t, 3>& order) {
      return near(a, b, 0, order[0]) && near(a, b, 2, order[1]) && near(a, b, 4, order[2]);
    });
  }

  PrimitiveKind kind_;
  double tolerance_;
};

/// Grid squares wider than the distance of matching anchors, so that these lie in neighbouring squares.
struct Square {
  double column = 0.0;
  double row = 0.0;
  friend bool operator==(const Square&, const Square&) = default;
};
struct HashOfSquare {
  std::size_t operator()(const Square& square) const {
    const std::uint64_t x = std::bit_cast<std::uint64_t>(square.column + 0.0);
    const std::uint64_t y = std::bit_cast<std::uint64_t>(square.row + 0.0);
    return static_cast<std::size_t>((x * 0x9E3779B97F4A7C15U) ^ std::rotl(y * 0xC2B2AE3D27D4EB4FU, 31));
  }
};

}  // namespace

std::vector<std::uint32_t> without_counterpart(PrimitiveKind kind, std::span<const double> a,
                                               std::span<const double> b, double tolerance) {
  constexpr double kSide = 4.0;
  constexpr std::uint32_t kNone = 0xffffffffU;
  const std::size_t stride = stride_of(kind);
  const auto square_of = [&](const double* values) {
    const Vec2 p = anchor(kind, values);
    return Square{std::floor(p.x / (kSide * tolerance)), std::floor(p.y / (kSide * tolerance))};
  };
  std::unordered_map<Square, std::uint32_t, HashOfSquare> first;
  std::vector<std::uint32_t> next(b.size() / stride, kNone);
  first.reserve(next.size());
  for (std::uint32_t i = 0; i < next.size(); ++i) {
    const auto [place, is_new] = first.try_emplace(square_of(b.data() + i * stride), i);
    if (!is_new) next[i] = std::exchange(place->second, i);
  }
  const Alike alike(kind, tolerance);
  const auto is_there = [&](const double* values) {
    const Square middle = square_of(values);
    for (const double dx : {0.0, -1.0, 1.0})
      for (const double dy : {0.0, -1.0, 1.0}) {
        const auto found = first.find({middle.column + dx, middle.row + dy});
        if (found == first.end()) continue;
        for (std::uint32_t i = found->second; i != kNone; i = next[i])
          if (alike(values, b.data() + i * stride)) return true;
      }
    return false;
  };
  std::vector<std::uint32_t> out;
  for (std::uint32_t i = 0; i < a.size() / stride; ++i)
    if (!is_there(a.data() + i * stride)) out.push_back(i);
  return out;
}

}  // namespace mes
