// Disks, circles and arcs are placed by the point of their rim that is nearest to the centre of the view.

struct Rim {
  bool shown;
  float radius;  // pixels
  float depth;   // signed distance of the view's centre from the rim, negative inside
  vec2 outward;  // unit vector from the centre of the disk to that of the view
  vec2 nearest;  // the nearest rim point, pixels from the centre of the view
  vec2 anchor;   // the origin of fragment programs: the centre, or for rims that may be huge the nearest rim point
#if DASHED && REACH == 2
  double turn;  // the direction of `outward` as a part of a whole turn
#endif
};

#if DASHED && REACH == 2
// atan(y, x) / (2 pi): turned by a multiple of an eighth of pi, so that the series is one of small numbers.
double wide_turn(double x, double y) {
  const double cosines[5] = double[5](1.0lf, 0.92387953251128675613lf, 0.70710678118654752440lf,
                                      0.38268343236508977173lf, 0.0lf);
  float step = floor(atan(float(y), float(x)) * (16.0 / kTurn) + 0.5);
  int at = int(abs(step));
  double c = at <= 4 ? cosines[at] : -cosines[8 - at];
  double s = step < 0.0 ? -cosines[abs(4 - at)] : cosines[abs(4 - at)];
  double t = (y * c - x * s) / (x * c + y * s);
  double q = t * t;
  double sum = 0.0lf;
  for (int i = 17; i > 0; i -= 2) sum = 1.0lf / double(i) - q * sum;
  return double(step) / 16.0lf + t * sum / 6.28318530717958647693lf;
}
#endif

Rim rim_of(uvec4 center_bits, uvec2 radius_bits) {
  Rim rim;
  float unit_radius = near_number(radius_bits);
  vec2 center = near_offset(center_bits);
  float reach = length(center);
  rim.shown = unit_radius >= 0.0;
  rim.radius = unit_radius * u_pixels_per_unit;
  rim.outward = reach > 0.0 ? -center / reach : vec2(1.0, 0.0);
#if REACH == 0
  rim.depth = (reach - unit_radius) * u_pixels_per_unit;
  rim.anchor = center * u_pixels_per_unit;
#else
  // |c| - r cancels if both are huge, so this is (c.c - r.r) / (|c| + r), with the difference in `Wide`.
  WideVec2 c = wide_offset(center_bits);
  Wide r = wide_number(radius_bits);
  Wide power = wide_sub(wide_add(wide_mul(c.x, c.x), wide_mul(c.y, c.y)), wide_mul(r, r));
  float both = reach + unit_radius;
  rim.depth = both > 0.0 ? narrow(power) / both * u_pixels_per_unit : 0.0;
#endif
#if DASHED && REACH == 2
  rim.turn = reach > 0.0 ? wide_turn(-c.x, -c.y) : 0.0lf;
#endif
  rim.nearest = -rim.depth * rim.outward;
#if REACH != 0
  rim.anchor = rim.nearest;
#endif
  return rim;
}

// Drivers may compute sine and its inverse with a fixed absolute error, which a huge radius magnifies. Small angles
// therefore use the series.
float steady_sin(float x) { return abs(x) < 0.25 ? x * (1.0 - x * x / 6.0 * (1.0 - x * x / 20.0)) : sin(x); }
float steady_asin(float x) { return x < 0.25 ? x * (1.0 + x * x * (1.0 / 6.0 + x * x * (3.0 / 40.0))) : asin(x); }
