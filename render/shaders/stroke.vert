// Segments, rays and lines: a piece of a line, with round ends.
layout(location = 0) in uvec4 a_first;
layout(location = 1) in uvec4 a_second;

out vec2 v_place;      // along the line from the point nearest to the view's centre, and across
flat out vec2 v_ends;  // where along the line the stroke begins and ends
#if DASHED
flat out float v_phase;
#endif

// Beyond every view: ends that far away are invisible.
const float kFar = 1e7;

void main() {
  paint();
  WideVec2 first = wide_offset(a_first);
#if KIND_SEGMENT
  // Measured from the nearer end, whose float is the more exact one.
  WideVec2 second = wide_offset(a_second);
  vec2 f = abs(narrow(first));
  vec2 s = abs(narrow(second));
  bool swapped = max(s.x, s.y) < max(f.x, f.y);
  Carrier line;
  if (swapped) {
    line = carrier(second, wide_sub(first, second));
  } else {
    line = carrier(first, wide_sub(second, first));
  }
  v_ends = clamp(line.start + vec2(0.0, line.size), -kFar, kFar);
#else
  Carrier line = carrier(first, wide_vector(a_second));
#if KIND_RAY
  v_ends = vec2(clamp(line.start, -kFar, kFar), kFar);
#else
  v_ends = vec2(-kFar, kFar);
#endif
#endif
  float h = shown_half_width() + 1.0;
  float view = u_view_radius + h;
  float low = max(v_ends.x - h, -view);
  float high = min(v_ends.y + h, view);
  vec2 corner = strip_corner();
  v_place = vec2(corner.x < 0.0 ? low : high, corner.y * h);
#if DASHED
  v_phase = line.phase;
#if KIND_SEGMENT
  // Dashes always count from the first end, whichever end the line is measured from.
  if (swapped) v_phase = carrier(first, wide_sub(first, second)).phase;
#endif
#endif
  vec2 px = (line.offset + v_place.y) * turned(line.direction) + v_place.x * line.direction;
  gl_Position = low > high || abs(line.offset) > view ? kHidden : place(px);
}
