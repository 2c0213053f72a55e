layout(location = 0) in uvec4 a_center;
layout(location = 1) in uvec2 a_radius;

out vec2 v_offset;
flat out vec4 v_rim;  // outward normal, radius, alpha

void main() {
  paint();
  Rim rim = rim_of(a_center, a_radius);
  float r = rim.radius;
  float q = soft_radius(r);
  if (r < 1e4) {
    rim.depth += r - q;
    rim.nearest = -rim.depth * rim.outward;
#if REACH != 0
    rim.anchor = rim.nearest;
#endif
  } else {
    // Of a larger disk squares overflow. Seen from as deep inside as its middle, it covers the view all the same.
    q = min(r, 1e15);
    rim.depth = max(rim.depth, -q);
    rim.nearest = -rim.depth * rim.outward;
#if REACH != 0
    rim.anchor = rim.nearest;
#endif
  }
  v_rim = vec4(rim.outward, q, soft_alpha(r));

  // The bounding square, cut to the view; for a huge disk the view itself.
  vec2 view = u_half_view + 1.0;
  vec2 corner = strip_corner();
  vec2 px = corner * view;
  if (r < 4.0 * u_view_radius) {
    vec2 center = rim.nearest - rim.outward * q;
    px = clamp(center + corner * (q + 1.0), -view, view);
  }
  v_offset = px - rim.anchor;
  gl_Position = !rim.shown || rim.depth > u_view_radius + 1.0 ? kHidden : place(px);
}
