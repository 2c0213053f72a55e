// SPDX-License-Identifier: GPL-3.0-or-later
// Conversions between core's colours and points and those of GLM; no other file converts them.
//
// Core computes with `Vec2` and knows colours as `Rgb`; drawing computes with GLM. Cost: a few operations each.
// Threads: any.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>

#include "core/base/color.h"
#include "core/base/geometry/vec2.h"

namespace mes::render {

/// Colour with alpha, each channel multiplied by it, in [0, 1].
using PremultipliedColor = glm::vec4;

/// Red, green and blue in [0, 1].
inline glm::vec3 to_vec3(Rgb color) {
  return glm::vec3(color.r, color.g, color.b) / 255.0F;
}

/// The nearest colour; channels outside [0, 1] are clamped.
inline Rgb to_rgb(const glm::vec3& color) {
  const auto byte = [](float value) {
    return static_cast<std::uint8_t>(std::lround(255.0F * std::clamp(value, 0.0F, 1.0F)));
  };
  return {byte(color.r), byte(color.g), byte(color.b)};
}

/// An opacity outside [0, 1] is clamped; one that is not finite counts as 1.
inline PremultipliedColor premultiplied(Rgb color, double opacity) {
  const double alpha = std::isfinite(opacity) ? std::clamp(opacity, 0.0, 1.0) : 1.0;
  return PremultipliedColor(glm::dvec4(alpha * (glm::dvec3(color.r, color.g, color.b) / 255.0), alpha));
}

/// The initial fill of a picture; transparent without a background.
inline PremultipliedColor clear_color(const std::optional<Rgb>& background) {
  return background ? premultiplied(*background, 1.0) : PremultipliedColor(0.0F);
}

constexpr glm::dvec2 to_dvec2(Vec2 v) {
  return {v.x, v.y};
}

}  // namespace mes::render
