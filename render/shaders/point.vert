layout(location = 0) in uvec4 a_position;

out vec2 v_offset;
flat out vec2 v_shape;  // radius, alpha

void main() {
  vec2 center = near_offset(a_position) * u_pixels_per_unit;
  float r = u_half_width;
  // A ramp one pixel wide around radius q covers pi (q^2 + 1/12): corrected, so that the area is that of the disk. Below
  // the radius where that fails, a cone of fixed size fades.
  float faint = min(3.0 * r * r, 1.0);
  float q = sqrt(max(r * r - 1.0 / 12.0, 0.25));
  if (u_ring > 0.0) {
    q = r;
    faint = min(2.0 * u_ring, 1.0);
  }
  float reach = q + max(u_ring, 0.5) + 1.0;
  v_offset = strip_corner() * reach;
  v_shape = vec2(q, faint);
  gl_Position = any(greaterThan(abs(center), u_half_view + reach)) ? kHidden : place(center + v_offset);
}
