// SPDX-License-Identifier: GPL-3.0-or-later
// The uniform input of a draw call: one block, declared in `shaders/uniforms.glsl`.
#pragma once

#include <array>
#include <cstddef>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <type_traits>

#include "render/device/convert.h"
#include "render/device/std140.h"

namespace mes::render {

/// The centre of the view occurs twice, in drawing space: as three floats with 21, 16 and the remaining bits, which are
/// subtracted from the same pieces of an instance's coordinates (these differences are exact), and as the words of two
/// doubles a coordinate for programs that compute in double.
struct DrawUniforms {
  glm::vec2 center_1{};
  glm::vec2 center_2{};
  glm::vec2 center_3{};
  float pixels_per_unit = 1.0F;  ///< pixels per unit of drawing space
  float half_width_px = 0.5F;    ///< half the width of strokes, or the radius of points
  glm::vec2 half_view_px{};
  float view_radius_px = 0.0F;  ///< radius of the circle around the view
  float ring_px = 0.0F;         ///< half the stroke of hollow points; 0: filled
  PremultipliedColor color{};
  float dash_px = 0.0F;
  float dash_period_px = 0.0F;
  float arc_pieces = 0.0F;  ///< quads along a circle or parabola; 0: a square around a circle
  float one = 1.0F;         ///< always 1, unknown to the shader compiler
  // For programs with a colour map. Scalars are multiples of a power of two, so that any double is possible.
  glm::vec3 map_low{};          ///< pieces, like the centre's, of the scalar at the map's first colour
  float map_factor = 0.0F;      ///< maps scalars above map_low to [0, 1]
  float map_exponent = 0.0F;    ///< exponent of that power of two, as doubles store it
  float map_offset = 0.0F;      ///< added afterwards; a range of one value has its colour in the middle
  float map_row = 0.0F;         ///< row of the texture
  float map_categories = 0.0F;  ///< number of colours that whole numbers cycle through; 0: graded
  glm::uvec4 center_words{};    ///< low and high word of x, then of y
  glm::uvec4 center_low_words{};
};

/// The members in the order of the block, with their names in it.
inline constexpr std::array kDrawUniformMembers{
    std140_member<glm::vec2>("u_center_1", offsetof(DrawUniforms, center_1)),
    std140_member<glm::vec2>("u_center_2", offsetof(DrawUniforms, center_2)),
    std140_member<glm::vec2>("u_center_3", offsetof(DrawUniforms, center_3)),
    std140_member<float>("u_pixels_per_unit", offsetof(DrawUniforms, pixels_per_unit)),
    std140_member<float>("u_half_width", offsetof(DrawUniforms, half_width_px)),
    std140_member<glm::vec2>("u_half_view", offsetof(DrawUniforms, half_view_px)),
    std140_member<float>("u_view_radius", offsetof(DrawUniforms, view_radius_px)),
    std140_member<float>("u_ring", offsetof(DrawUniforms, ring_px)),
    std140_member<glm::vec4>("u_color", offsetof(DrawUniforms, color)),
    std140_member<float>("u_dash", offsetof(DrawUniforms, dash_px)),
    std140_member<float>("u_dash_period", offsetof(DrawUniforms, dash_period_px)),
    std140_member<float>("u_arc_pieces", offsetof(DrawUniforms, arc_pieces)),
    std140_member<float>("u_one", offsetof(DrawUniforms, one)),
    std140_member<glm::vec3>("u_map_low", offsetof(DrawUniforms, map_low)),
    std140_member<float>("u_map_factor", offsetof(DrawUniforms, map_factor)),
    std140_member<float>("u_map_exponent", offsetof(DrawUniforms, map_exponent)),
    std140_member<float>("u_map_offset", offsetof(DrawUniforms, map_offset)),
    std140_member<float>("u_map_row", offsetof(DrawUniforms, map_row)),
    std140_member<float>("u_map_categories", offsetof(DrawUniforms, map_categories)),
    std140_member<glm::uvec4>("u_center_words", offsetof(DrawUniforms, center_words)),
    std140_member<glm::uvec4>("u_center_low_words", offsetof(DrawUniforms, center_low_words)),
};
static_assert(std::is_standard_layout_v<DrawUniforms> && std::is_trivially_copyable_v<DrawUniforms>);
static_assert(is_std140(kDrawUniformMembers, sizeof(DrawUniforms)));

}  // namespace mes::render
