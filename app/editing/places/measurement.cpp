// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/editing/places/measurement.h"

#include <fmt/core.h>
#include <cmath>
#include <numbers>

#include "core/kernel/circumcircle.h"

namespace mes {
namespace {

std::string number(double value) {
  return fmt::format("{:.6g}", value);
}

std::string degrees(double radians) {
  return number(radians * 180.0 / std::numbers::pi) + "\u00b0";
}

}  // namespace

std::optional<Disk> measured_circle(std::span<const Vec2> places) {
  if (places.size() != 3) return std::nullopt;
  const Circle circle = circumcircle(places[0], places[1], places[2]);
  if (!std::isfinite(circle.radius)) return std::nullopt;
  return Disk{circle.center, circle.radius};
}

std::vector<std::string> measured_words(std::span<const Vec2> places) {
  if (places.size() < 2) return {};
  const Vec2 step = places.back() - places[places.size() - 2];
  std::vector<std::string> out{"distance " + number(length(step))};
  if (places.size() == 2) {
    out.push_back("dx " + number(step.x) + ", dy " + number(step.y));
    if (step != Vec2{}) out.push_back("direction " + degrees(std::atan2(step.y, step.x)));
    return out;
  }
  const Vec2 back = places[0] - places[1];
  if (step != Vec2{} && back != Vec2{})
    out.push_back("angle " + degrees(std::atan2(std::abs(cross(back, step)), dot(back, step))));
  if (const auto circle = measured_circle(places)) {
    out.push_back("circle of radius " + number(circle->radius));
    out.push_back("around " + number(circle->center.x) + ", " + number(circle->center.y));
  } else {
    out.push_back("on one line");
  }
  return out;
}

}  // namespace mes
