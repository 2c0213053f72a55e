in vec2 v_offset;
flat in vec3 v_rim;
#if DASHED
flat in vec2 v_dash;

// Pixels along a circle of radius r from its point with outward normal n to the direction of p, seen from the centre.
float arc_to(vec2 p, vec2 n, float r) {
  float across = n.x * p.y - n.y * p.x;
  float out_of = dot(n, p);
#if REACH != 0
  out_of += r;
#endif
  float slope = across / max(out_of, 1e-6);
  // The inverse tangent of a driver is good to so many places after the point; a huge radius wants its leading digits.
  if (out_of > 0.0 && abs(slope) < 0.05) return r * slope * (1.0 - slope * slope / 3.0);
  return r * atan(across, out_of);
}
#endif
out vec4 color;

void main() {
  float sd = abs(rim_distance(v_offset, v_rim.xy, v_rim.z)) - shown_half_width();
  float cover = clamp(0.5 - sd, 0.0, 1.0);
#if DASHED
  cover *= dash_cover(v_dash.x + arc_to(v_offset, v_rim.xy, v_rim.z), v_dash.y);
#endif
  color = u_color * (cover * stroke_alpha());
}
