// What a draw call tells its programs; filled from `DrawUniforms`, in the same order.

uniform vec4 u_real[7];
uniform uvec4 u_bits[2];

#define u_center_1 u_real[0].xy
#define u_center_2 u_real[0].zw
#define u_center_3 u_real[1].xy
#define u_pixels_per_unit u_real[1].z
#define u_half_width u_real[1].w
#define u_half_view u_real[2].xy
#define u_view_radius u_real[2].z
#define u_ring u_real[2].w
#define u_color u_real[3]
#define u_dash u_real[4].x
#define u_dash_period u_real[4].y
#define u_arc_pieces u_real[4].z
#define u_map_low u_real[5].xyz
#define u_map_factor u_real[5].w
#define u_map_exponent u_real[6].x
#define u_map_offset u_real[6].y
#define u_map_row u_real[6].z
#define u_map_categories u_real[6].w
#define u_nothing (floatBitsToUint(u_real[4].w) & 1u)

// Strokes thinner than a pixel keep that width and fade instead.
float shown_half_width() { return max(u_half_width, 0.5); }
float stroke_alpha() { return min(2.0 * u_half_width, 1.0); }

// A ramp one pixel wide around radius q covers pi (q^2 + 1/12). A disk of radius r is therefore drawn with a radius a
// little smaller, so that its area is right; below the radius where that fails, a cone of fixed size fades.
float soft_radius(float r) { return sqrt(max(r * r - 1.0 / 12.0, 0.25)); }
float soft_alpha(float r) { return min(3.0 * r * r, 1.0); }
