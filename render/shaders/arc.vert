// Arcs: pieces of circles, with round ends.
layout(location = 0) in uvec4 a_center;
layout(location = 1) in uvec4 a_from;
layout(location = 2) in uvec4 a_to;
layout(location = 3) in uvec2 a_radius;
layout(location = 4) in uvec2 a_turn;

out vec2 v_offset;
flat out vec3 v_rim;    // outward normal, radius
flat out vec4 v_ends;   // both ends, from the anchor
flat out vec3 v_range;  // both ends in pixels along the rim; 1: the arc contains the opposite point, where angles jump
#if DASHED
flat out vec2 v_dash;
#endif

// Beyond every view: ends that far away are invisible.
const float kFar = 1e7;

void main() {
  paint();
  Rim rim = rim_of(a_center, a_radius);
  float r = min(rim.radius, 1e15);
  float h = shown_half_width() + 1.0;
  float view = u_view_radius + h;

  // In units of drawing space, which no zoom makes too large for a float.
  vec2 anchor = rim.anchor / u_pixels_per_unit;
  vec2 from = near_offset(a_from) - anchor;
  vec2 to = near_offset(a_to) - anchor;
  float unit_radius = near_number(a_radius);
  float low = rim_angle(from, rim.outward, unit_radius);
  float high = rim_angle(to, rim.outward, unit_radius);
  // Which of two close ends comes first, the encoder has decided. Elsewhere the order of the angles decides, also
  // where rounding moved an end across the jump.
  float half_turn = 0.5 * kTurn;
  float turn = near_number(a_turn);
  bool around = abs(high - low) < 1.0 ? turn > 0.5 : high < low;
  if (turn > 1.5) {
    low = -half_turn;
    high = half_turn;
    around = true;
  }
  v_range = vec3(clamp(r * vec2(low, high), -kFar, kFar), around ? 1.0 : 0.0);
  v_ends = clamp(vec4(from, to) * u_pixels_per_unit, -kFar, kFar);

  // The strip covers the visible part of the arc and its caps; if two pieces are visible, also the part between them.
  float limit = seen_angle(rim, r, view);
  float cap = r > 2.0 * h ? 2.0 * h / r : half_turn;
  bool crosses = limit >= half_turn && (low - cap < -half_turn || high + cap > half_turn);
  low = max(low - cap, -limit);
  high = min(high + cap, limit);
  if (around ? low < limit && high > -limit : crosses) {
    low = -limit;
    high = limit;
  } else if (around) {
    if (low < limit) {
      high = limit;
    } else {
      low = -limit;
    }
  }

  vec2 px = ring_corner(rim, r, h, low, high);
  v_offset = px - rim.anchor;
  v_rim = vec3(rim.outward, r);
#if DASHED
  v_dash = ring_dash(rim, r);
#endif
  gl_Position = !rim.shown || low >= high || abs(rim.depth) > view ? kHidden : place(px);
}
