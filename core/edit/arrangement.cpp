// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/edit/arrangement.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <numeric>

#include "core/base/geometry/box2.h"

namespace mes {
namespace {

double& coordinate_of(Vec2& p, Axis axis) {
  return axis == Axis::x ? p.x : p.y;
}
double coordinate_of(const Vec2& p, Axis axis) {
  return axis == Axis::x ? p.x : p.y;
}

Box2 box_around(std::span<const Vec2> places) {
  Box2 out;
  for (const Vec2 p : places) out.add(p);
  return out;
}

/// Avoids the errors of sine and cosine where their exact values are integers.
Vec2 direction(double degrees) {
  const double turn = std::remainder(degrees, 360.0);
  if (turn == 0.0) return {1.0, 0.0};
  if (turn == 90.0) return {0.0, 1.0};
  if (turn == -90.0) return {0.0, -1.0};
  if (std::abs(turn) == 180.0) return {-1.0, 0.0};
  const double radians = turn * std::numbers::pi / 180.0;
  return {std::cos(radians), std::sin(radians)};
}

template <class Move>
std::vector<Vec2> each(std::span<const Vec2> places, Move move) {
  std::vector<Vec2> out;
  out.reserve(places.size());
  for (const Vec2 p : places) out.push_back(move(p));
  return out;
}

}  // namespace

Vec2 middle_of(std::span<const Vec2> places) {
  if (places.empty()) return {};
  const Box2 box = box_around(places);
  return {0.5 * box.low.x + 0.5 * box.high.x, 0.5 * box.low.y + 0.5 * box.high.y};
}

std::vector<Vec2> turned(std::span<const Vec2> places, Vec2 about, double degrees) {
  const Vec2 u = direction(degrees);
  return each(places, [&](Vec2 p) {
    const Vec2 d = p - about;
    return about + Vec2{u.x * d.x - u.y * d.y, u.y * d.x + u.x * d.y};
  });
}

std::vector<Vec2> scaled(std::span<const Vec2> places, Vec2 about, double factor) {
  return each(places, [&](Vec2 p) { return about + factor * (p - about); });
}

std::vector<Vec2> mirrored(std::span<const Vec2> places, Vec2 about, Axis coordinate) {
  return each(places, [&](Vec2 p) {
    const double middle = coordinate_of(about, coordinate);
    double& value = coordinate_of(p, coordinate);
    value = middle - (value - middle);
    return p;
  });
}

std::vector<Vec2> aligned(std::span<const Vec2> places, Alignment where) {
  if (places.empty()) return {};
  const Box2 box = box_around(places);
  const Vec2 middle = middle_of(places);
  return each(places, [&](Vec2 p) {
    switch (where) {
      case Alignment::left: p.x = box.low.x; break;
      case Alignment::center: p.x = middle.x; break;
      case Alignment::right: p.x = box.high.x; break;
      case Alignment::bottom: p.y = box.low.y; break;
      case Alignment::middle: p.y = middle.y; break;
      case Alignment::top: p.y = box.high.y; break;
    }
    return p;
  });
}

std::vector<Vec2> distributed(std::span<const Vec2> places, Axis coordinate) {
  std::vector<Vec2> out(places.begin(), places.end());
  if (out.size() < 3) return out;
  std::vector<std::size_t> order(out.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, [&](std::size_t i) { return coordinate_of(places[i], coordinate); });
  const double low = coordinate_of(places[order.front()], coordinate);
  const double high = coordinate_of(places[order.back()], coordinate);
  const auto last = static_cast<double>(order.size() - 1);
  for (std::size_t k = 1; k + 1 < order.size(); ++k) {
    const double share = static_cast<double>(k) / last;
    coordinate_of(out[order[k]], coordinate) = (1.0 - share) * low + share * high;
  }
  return out;
}

}  // namespace mes
