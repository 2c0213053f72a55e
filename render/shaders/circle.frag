in vec2 v_offset;
flat in vec3 v_rim;
#if DASHED
in float v_arc;
flat in float v_gap;
#endif
out vec4 color;

void main() {
  float sd = abs(rim_distance(v_offset, v_rim.xy, v_rim.z)) - shown_half_width();
  float cover = clamp(0.5 - sd, 0.0, 1.0);
#if DASHED
  cover = min(cover, dash_cover(v_arc, v_gap));
#endif
  color = u_color * (cover * stroke_alpha());
}
