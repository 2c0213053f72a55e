layout(location = 0) in uvec4 a_center;
layout(location = 1) in uvec2 a_radius;

out vec2 v_offset;
flat out vec3 v_rim;  // outward normal, radius
#if DASHED
flat out vec2 v_dash;  // pixels along the circle of the rim point nearest to the view's centre; period of dashes
#endif

// A ring of u_arc_pieces quads along the part of the circle that can be seen; where all circles are small (no pieces)
// simply a square.
void main() {
  Rim rim = rim_of(a_center, a_radius);
  float r = min(rim.radius, 1e15);
  float h = shown_half_width() + 1.0;
  float view = u_view_radius + h;

  // Half the angle of the arc within the circle around the view: from the triangle of both centres and a point where
  // the circles meet, by half angles, so that the angle of a huge circle does not drown. A little more does no harm.
  float product = 4.0 * max(rim.depth + r, 0.0) * r;
  float square = product > 0.0 ? (view - rim.depth) * ((view + rim.depth) / product) : 1.0;
  float limit = square >= 1.0 ? 0.5 * kTurn : min(2.02 * steady_asin(sqrt(max(square, 0.0))), 0.5 * kTurn);

  float pieces = max(u_arc_pieces, 1.0);
  float angle = limit * (2.0 * float(gl_VertexID >> 1) / pieces - 1.0);
  float sine = steady_sin(angle);
  float half_sine = steady_sin(0.5 * angle);
  vec2 tangent = turned(rim.outward);
  vec2 on_rim = rim.nearest - (2.0 * r * half_sine * half_sine) * rim.outward + (r * sine) * tangent;
  vec2 radial = (1.0 - 2.0 * half_sine * half_sine) * rim.outward + sine * tangent;
  // Outer corners lie where tangents at the outer edge meet; the inner edges are chords and need no more room.
  float step_sine = steady_sin(0.5 * limit / pieces);
  float bulge = (r + h) * (2.0 * step_sine * step_sine / cos(limit / pieces)) + h;
  vec2 px = on_rim + ((gl_VertexID & 1) == 1 ? bulge : -min(h, r)) * radial;

  if (u_arc_pieces == 0.0) px = rim.nearest - rim.outward * r + strip_corner() * (r + h);

  v_offset = px - rim.anchor;
  v_rim = vec3(rim.outward, r);
#if DASHED
  // A whole number of dashes around the circle, counted from its rightmost point, so that they neither break where the
  // circle closes nor crawl when the view moves.
  float count = max(1.0, floor(kTurn * r / u_dash_period + 0.5));
  float period = kTurn * r / count;
  float from_right = atan(rim.outward.y, rim.outward.x) / kTurn;
  v_dash = vec2(fract(from_right * count) * period, period);
#endif
  gl_Position = !rim.shown || abs(rim.depth) > view ? kHidden : place(px);
}
