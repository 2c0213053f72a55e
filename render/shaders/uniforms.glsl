// The uniforms of a draw call. `DrawUniforms` of draw_uniforms.h has the same members in the same order.
layout(std140) uniform DrawUniforms {
  vec2 u_center_1;
  vec2 u_center_2;
  vec2 u_center_3;
  float u_pixels_per_unit;
  float u_half_width;
  vec2 u_half_view;
  float u_view_radius;
  float u_ring;
  vec4 u_color;
  float u_dash;
  float u_dash_period;
  float u_arc_pieces;
  float u_one;
  vec3 u_map_low;
  float u_map_factor;
  float u_map_exponent;
  float u_map_offset;
  float u_map_row;
  float u_map_categories;
  uvec4 u_center_words;
  uvec4 u_center_low_words;
};

// Zero, which no compiler can know.
#define u_nothing (floatBitsToUint(u_one) & 1u)

// Strokes thinner than a pixel are drawn one pixel wide, and fainter.
float shown_half_width() { return max(u_half_width, 0.5); }
float stroke_alpha() { return min(2.0 * u_half_width, 1.0); }

// A ramp one pixel wide around radius q covers pi (q^2 + 1/12). A disk of radius r is therefore drawn with a slightly
// smaller radius, so that its area is right; disks too small for that are cones of a fixed size, and fainter.
float soft_radius(float r) { return sqrt(max(r * r - 1.0 / 12.0, 0.25)); }
float soft_alpha(float r) { return min(3.0 * r * r, 1.0); }
