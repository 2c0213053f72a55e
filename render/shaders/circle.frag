in vec2 v_offset;
flat in vec3 v_rim;
#if DASHED
flat in vec2 v_dash;
#endif
out vec4 color;

void main() {
  float sd = abs(rim_distance(v_offset, v_rim.xy, v_rim.z)) - shown_half_width();
  float cover = clamp(0.5 - sd, 0.0, 1.0);
#if DASHED
  cover *= dash_cover(v_dash.x + v_rim.z * rim_angle(v_offset, v_rim.xy, v_rim.z), v_dash.y);
#endif
  color = v_color * (cover * stroke_alpha());
}
