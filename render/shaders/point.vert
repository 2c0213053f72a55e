layout(location = 0) in uvec4 a_position;

out vec2 v_offset;

void main() {
  paint();
  vec2 center = near_offset(a_position) * u_pixels_per_unit;
  float reach = max(u_half_width, 0.5) + max(u_ring, 0.5) + 1.0;
  v_offset = triangle_corner() * reach;
  gl_Position = any(greaterThan(abs(center), u_half_view + reach)) ? kHidden : place(center + v_offset);
}
