in vec2 v_offset;
flat in vec3 v_rim;
flat in vec4 v_ends;
flat in vec3 v_range;
#if DASHED
flat in vec2 v_dash;
#endif
out vec4 color;

void main() {
  float s = v_rim.z * rim_angle(v_offset, v_rim.xy, v_rim.z);
  bool after = s >= v_range.x;
  bool before = s <= v_range.y;
  bool inside = v_range.z > 0.5 ? after || before : after && before;
  float to_end = min(length(v_offset - v_ends.xy), length(v_offset - v_ends.zw));
  float sd = (inside ? abs(rim_distance(v_offset, v_rim.xy, v_rim.z)) : to_end) - shown_half_width();
  float cover = clamp(0.5 - sd, 0.0, 1.0);
#if DASHED
  cover *= dash_cover(v_dash.x + s, v_dash.y);
#endif
  color = v_color * (cover * stroke_alpha());
}
