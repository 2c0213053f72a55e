in vec2 v_offset;
out vec4 color;

void main() {
  float r = u_half_width;
  float from_center = length(v_offset);
  if (u_ring > 0.0) {
    float sd = abs(from_center - r) - max(u_ring, 0.5);
    color = v_color * (clamp(0.5 - sd, 0.0, 1.0) * min(2.0 * u_ring, 1.0));
  } else {
    color = v_color * (clamp(0.5 - from_center + soft_radius(r), 0.0, 1.0) * soft_alpha(r));
  }
}
