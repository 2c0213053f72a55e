// For vertex programs of circles and arcs: a strip of u_arc_pieces quads along a rim. Angles count from the rim point
// nearest to the centre of the view, where rounding errors are smallest.

// Half the angle of the part of the rim within the circle around the view, or a little more. It follows from the
// triangle of both centres and an intersection of the circles, by half angles, which are exact for huge circles too.
float seen_angle(Rim rim, float r, float view) {
  float product = 4.0 * max(rim.depth + r, 0.0) * r;
  float square = product > 0.0 ? (view - rim.depth) * ((view + rim.depth) / product) : 1.0;
  return square >= 1.0 ? 0.5 * kTurn : min(2.02 * steady_asin(sqrt(max(square, 0.0))), 0.5 * kTurn);
}

// This vertex of the strip from angle `low` to `high`, h pixels to both sides; if all rims are small (no pieces), a
// corner of a square around the circle.
vec2 ring_corner(Rim rim, float r, float h, float low, float high) {
  if (u_arc_pieces == 0.0) return rim.nearest - rim.outward * r + strip_corner() * (r + h);
  float angle = low + (high - low) * (float(gl_VertexID >> 1) / u_arc_pieces);
  float sine = steady_sin(angle);
  float half_sine = steady_sin(0.5 * angle);
  vec2 tangent = turned(rim.outward);
  vec2 on_rim = rim.nearest - (2.0 * r * half_sine * half_sine) * rim.outward + (r * sine) * tangent;
  vec2 radial = (1.0 - 2.0 * half_sine * half_sine) * rim.outward + sine * tangent;
  // Outer corners are intersections of tangents at the outer edge; inner edges are chords and need no more room.
  float step = 0.5 * (high - low) / u_arc_pieces;
  float step_sine = steady_sin(0.5 * step);
  float bulge = (r + h) * (2.0 * step_sine * step_sine / cos(step)) + h;
  return on_rim + ((gl_VertexID & 1) == 1 ? bulge : -min(h, r)) * radial;
}

#if DASHED
// The rim point nearest to the view's centre in pixels along the circle, and the period of dashes. Dashes count from
// the rightmost point of the circle and are a whole number, so they neither break where the circle closes nor move
// with the view; without doubles, those of circles beyond 10^5 pixels do move.
vec2 ring_dash(Rim rim, float r) {
  float count = max(1.0, floor(kTurn * r / u_dash_period + 0.5));
  float period = kTurn * r / count;
#if REACH == 2
  return vec2(float(fract(rim.turn * double(count))) * period, period);
#else
  float from_right = atan(rim.outward.y, rim.outward.x) / kTurn;
  return vec2(fract(from_right * count) * period, period);
#endif
}
#endif
