// Arcs of parabolas, as quadratic Bezier curves: a strip of u_arc_pieces quads along the visible part, with round ends.
layout(location = 0) in uvec4 a_from;
layout(location = 1) in uvec4 a_control;
layout(location = 2) in uvec4 a_to;

out vec2 v_place;      // along the curve from the beginning of the strip, and across
flat out vec2 v_ends;  // where along the curve the stroke begins and ends
#if DASHED
flat out float v_phase;
#endif

// Beyond every view: ends that far away are invisible.
const float kFar = 1e7;
// In each round the curve is cut to a part in view, down to so many halves. A float holds such parts of 1.
#if REACH == 0
const int kRounds = 1;
const int kHalvings = 12;
#else
const int kRounds = 2;
const int kHalvings = 20;
#endif

// The point from + t (2 edge + t bend), relative to the centre of the view.
WideVec2 g_from;
WideVec2 g_edge;
WideVec2 g_bend;
vec2 g_edge_px;
vec2 g_bend_px;

Wide curve_at(float t, Wide from, Wide edge, Wide bend) {
  Wide wide_t = wide_of(t);
  return wide_add(from, wide_mul(wide_t, wide_add(wide_add(edge, edge), wide_mul(wide_t, bend))));
}
vec2 curve_at(float t) {
  return vec2(narrow(curve_at(t, g_from.x, g_edge.x, g_bend.x)), narrow(curve_at(t, g_from.y, g_edge.y, g_bend.y))) *
         u_pixels_per_unit;
}

// False if the part between these parameters is nowhere within `view` of the centre of the view.
bool may_be_seen(float low, float high, float view) {
  vec2 a = curve_at(low);
  vec2 b = curve_at(high);
  float part = 0.5 * (high - low);
  vec2 reach = view + part * part * abs(g_bend_px);
  return all(lessThanEqual(min(a, b), reach)) && all(greaterThanEqual(max(a, b), -reach));
}

// The length between two parameters in pixels: see `length_of` in core/base/geometry/parabola_arc.h. All squares are of numbers
// relative to `size`.
float curve_length(float low, float high) {
  float size = max(max(abs(g_edge_px.x), abs(g_edge_px.y)), max(abs(g_bend_px.x), abs(g_bend_px.y)));
  if (size == 0.0) return 0.0;
  vec2 edge = g_edge_px / size;
  vec2 bend = g_bend_px / size;
  float across = abs(edge.x * bend.y - edge.y * bend.x);
  float square = dot(bend, bend);
  // Nearly straight: floats do not hold the slopes.
  if (square < 1e-6 * dot(edge, edge) || across < 1e-3 * square) return length(curve_at(high) - curve_at(low));
  float a = (dot(edge, bend) + low * square) / across;
  float b = (dot(edge, bend) + high * square) / across;
  float rise = (high - low) * square / across;
  float turn = a * b > 0.0 ? asinh(rise * ((a + b) / (b * sqrt(1.0 + a * a) + a * sqrt(1.0 + b * b))))
                           : asinh(b) - asinh(a);
  return size * across * across / (square * sqrt(square)) * (cosh(asinh(a) + asinh(b)) * sinh(turn) + turn);
}

// Leaves the part between two parameters, which then are 0 and 1.
void cut(float low, float high) {
  Wide part = wide_of(high - low);
  WideVec2 from =
      WideVec2(curve_at(low, g_from.x, g_edge.x, g_bend.x), curve_at(low, g_from.y, g_edge.y, g_bend.y));
  g_edge.x = wide_mul(part, wide_add(g_edge.x, wide_mul(wide_of(low), g_bend.x)));
  g_edge.y = wide_mul(part, wide_add(g_edge.y, wide_mul(wide_of(low), g_bend.y)));
  g_bend = WideVec2(wide_mul(part, wide_mul(part, g_bend.x)), wide_mul(part, wide_mul(part, g_bend.y)));
  g_from = from;
  g_edge_px = narrow(g_edge) * u_pixels_per_unit;
  g_bend_px = narrow(g_bend) * u_pixels_per_unit;
}

vec2 unit_or(vec2 v, vec2 other) {
  float size = max(abs(v.x), abs(v.y));
  return size > 0.0 ? normalize(v / size) : other;
}

void main() {
  paint();
  WideVec2 control = wide_offset(a_control);
  WideVec2 to = wide_offset(a_to);
  g_from = wide_offset(a_from);
  g_edge = wide_sub(control, g_from);
  g_bend = wide_sub(wide_sub(to, control), g_edge);
  g_edge_px = narrow(g_edge) * u_pixels_per_unit;
  g_bend_px = narrow(g_bend) * u_pixels_per_unit;

  float h = shown_half_width() + 1.0;
  float view = u_view_radius + h;
  if (!may_be_seen(0.0, 1.0, view)) {
    v_place = vec2(0.0);
    v_ends = vec2(0.0);
#if DASHED
    v_phase = 0.0;
#endif
    gl_Position = kHidden;
    return;
  }
  float left_out = 0.0;  // length before the part
  bool begins = true;
  bool ends = true;
  for (int round = 0; round < kRounds && max(length(g_edge_px), length(g_bend_px)) > view; ++round) {
    float low = 0.0;
    float high = 1.0;
    float step = 0.5;
    for (int i = 0; i < kHalvings; ++i) {
      if (low + step < high && !may_be_seen(low, low + step, view)) low += step;
      if (high - step > low && !may_be_seen(high - step, high, view)) high -= step;
      step *= 0.5;
    }
    left_out += curve_length(0.0, low);
    begins = begins && low == 0.0;
    ends = ends && high == 1.0;
    cut(low, high);
  }

  float t = float(gl_VertexID >> 1) / u_arc_pieces;
  vec2 along = unit_or(g_edge_px + t * g_bend_px, unit_or((t < 0.5 ? 1.0 : -1.0) * g_bend_px, vec2(1.0, 0.0)));
  float cap = t == 0.0 ? -h : t == 1.0 ? h : 0.0;
  float side = (gl_VertexID & 1) == 1 ? h : -h;
  v_place = vec2(curve_length(0.0, t) + cap, side);
  v_ends = vec2(begins ? 0.0 : -kFar, ends ? curve_length(0.0, 1.0) : kFar);
#if DASHED
  // Dashes of curves beyond 10^5 pixels may move with the view.
  v_phase = mod(left_out, u_dash_period);
#endif
  gl_Position = place(curve_at(t) + cap * along + side * turned(along));
}
