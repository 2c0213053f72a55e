// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/figure/internal/visible_part.h"

#include <algorithm>
#include <cmath>

#include "core/base/geometry/turn.h"

namespace mes::figure {
namespace {

/// Turns by +90 degrees on screen, where y points down: right becomes up.
Vec2 turned(Vec2 v) {
  return {v.y, -v.x};
}

}  // namespace

Stretch stretch_in(const Box2& box, Vec2 start, Vec2 direction, Stretch within) {
  const auto cut = [&](double from, double along, double low, double high) {
    if (along == 0.0) {
      if (from < low || from > high) within = {1.0, 0.0};
      return;
    }
    double enter = (low - from) / along;
    double leave = (high - from) / along;
    if (enter > leave) std::swap(enter, leave);
    within.low = std::max(within.low, enter);
    within.high = std::min(within.high, leave);
  };
  cut(start.x, direction.x, box.low.x, box.high.x);
  cut(start.y, direction.y, box.low.y, box.high.y);
  return within;
}

bool ring_meets(const Box2& box, Vec2 center, double inner, double outer) {
  const Vec2 nearest{std::clamp(center.x, box.low.x, box.high.x), std::clamp(center.y, box.low.y, box.high.y)};
  const Vec2 farthest{center.x < box.center().x ? box.high.x : box.low.x,
                      center.y < box.center().y ? box.high.y : box.low.y};
  return distance(center, nearest) <= outer && distance(center, farthest) >= inner;
}

HugeCircle::HugeCircle(const Box2& box, Vec2 center, double radius) : center_(center), radius_(radius) {
  const Vec2 middle = box.center();
  reach_ = 0.5 * std::hypot(box.width(), box.height());
  const double apart = distance(center, middle);
  outward_ = apart > 0.0 ? Vec2{(middle.x - center.x) / apart, (middle.y - center.y) / apart} : Vec2{1.0, 0.0};
  distance_ = radius - apart;
  nearest_ = middle + distance_ * outward_;
  // A little more than the chord of the circle around the box.
  half_ = std::asin(std::min(1.0, 1.01 * reach_ / radius));
}

Vec2 HugeCircle::at(double angle) const {
  const double half_sine = std::sin(0.5 * angle);
  return nearest_ + (radius_ * std::sin(angle)) * turned(outward_) -
         (2.0 * radius_ * half_sine * half_sine) * outward_;
}

Shape HugeCircle::piece(double low, double high) const {
  const double handle = 4.0 / 3.0 * std::tan(0.25 * (high - low)) * radius_;
  const auto forward = [&](double angle) { return std::cos(angle) * turned(outward_) - std::sin(angle) * outward_; };
  Shape out{.kind = ShapeKind::curve};
  out.p[0] = at(low);
  out.p[3] = at(high);
  out.p[1] = out.p[0] + handle * forward(low);
  out.p[2] = out.p[3] - handle * forward(high);
  return out;
}

std::optional<Shape> HugeCircle::rim() const {
  if (std::abs(distance_) > reach_) return std::nullopt;
  return piece(-half_, half_);
}

std::optional<Shape> HugeCircle::disk() const {
  if (distance_ < -reach_) return std::nullopt;
  // If the rim lies behind the box, a straight one there looks the same.
  Shape out{.kind = ShapeKind::rim};
  if (distance_ > reach_) {
    const Vec2 far = nearest_ - (distance_ - 1.01 * reach_) * outward_;
    const Vec2 along = 1.01 * reach_ * turned(outward_);
    out.p = {far - along, far - 1.0 / 3.0 * along, far + 1.0 / 3.0 * along, far + along, {}, {}};
  } else {
    out.p = piece(-half_, half_).p;
  }
  const Vec2 depth = 2.1 * reach_ * outward_;
  out.p[4] = out.p[3] - depth;
  out.p[5] = out.p[0] - depth;
  return out;
}

std::vector<Shape> HugeCircle::arc(Vec2 from, Vec2 to) const {
  if (std::abs(distance_) > reach_) return {};
  const auto angle_of = [&](Vec2 p) {
    const Vec2 offset = p - nearest_;
    return std::atan2(dot(offset, turned(outward_)), radius_ + dot(offset, outward_));
  };
  const double first = angle_of(from);
  double last = angle_of(to);
  if (last < first) last += kTurn;
  std::vector<Shape> out;
  for (const double turn : {0.0, kTurn}) {
    const double low = std::max(first - turn, -half_);
    const double high = std::min(last - turn, half_);
    if (low <= high) out.push_back(piece(low, high));
  }
  return out;
}

}  // namespace mes::figure
