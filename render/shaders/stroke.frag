in vec2 v_place;
flat in vec2 v_ends;
#if DASHED
flat in float v_phase;
#endif
out vec4 color;

void main() {
  float beyond = max(max(v_ends.x - v_place.x, v_place.x - v_ends.y), 0.0);
  float sd = length(vec2(beyond, v_place.y)) - shown_half_width();
  float cover = clamp(0.5 - sd, 0.0, 1.0);
#if DASHED
  cover *= dash_cover(v_place.x + v_phase, u_dash_period);
#endif
  color = v_color * (cover * stroke_alpha());
}
