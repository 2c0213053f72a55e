layout(location = 0) in uvec4 a_center;
layout(location = 1) in uvec2 a_radius;

out vec2 v_offset;
flat out vec3 v_rim;  // outward normal, radius
#if DASHED
flat out vec2 v_dash;
#endif

void main() {
  paint();
  Rim rim = rim_of(a_center, a_radius);
  float r = min(rim.radius, 1e15);
  float h = shown_half_width() + 1.0;
  float view = u_view_radius + h;
  float limit = seen_angle(rim, r, view);
  vec2 px = ring_corner(rim, r, h, -limit, limit);
  v_offset = px - rim.anchor;
  v_rim = vec3(rim.outward, r);
#if DASHED
  v_dash = ring_dash(rim, r);
#endif
  gl_Position = !rim.shown || abs(rim.depth) > view ? kHidden : place(px);
}
