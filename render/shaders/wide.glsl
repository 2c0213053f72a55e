// Numbers with more bits than a float, for the few sums where everything large cancels:
// how far a line or a circle passes from the centre of the view. `Wide` is
//   REACH 0  a float
//   REACH 1  an unevaluated sum of two floats, about 48 bits
//   REACH 2  a double
// Each variant offers the same functions.

#if REACH == 0

#define Wide float
Wide wide_offset(uvec2 bits, int axis) {
  return axis == 0 ? near_offset(bits, u_center_1.x, u_center_2.x, u_center_3.x)
                   : near_offset(bits, u_center_1.y, u_center_2.y, u_center_3.y);
}
Wide wide_number(uvec2 bits) { return near_number(bits); }
Wide wide_of(float a) { return a; }
Wide wide_sub(Wide a, Wide b) { return a - b; }
Wide wide_add(Wide a, Wide b) { return a + b; }
Wide wide_mul(Wide a, Wide b) { return a * b; }
float narrow(Wide a) { return a; }

#elif REACH == 1

#define Wide vec2
// Sum and its rounding error (Knuth's two-sum).
Wide two_sum(float a, float b) {
  PRECISE float sum = HOLD(a + b);
  PRECISE float part = HOLD(sum - a);
  PRECISE float rest = HOLD((a - (sum - part)) + (b - part));
  return vec2(sum, rest);
}
Wide quick_two_sum(float a, float b) {
  PRECISE float sum = HOLD(a + b);
  PRECISE float rest = HOLD(b - (sum - a));
  return vec2(sum, rest);
}
// Product and its rounding error. A mask splits the factors into halves of 12 bits, so that a fused multiply-add does
// not change the result.
Wide two_product(float a, float b) {
  float a1 = uintBitsToFloat(floatBitsToUint(a) & 0xfffff000u);
  float b1 = uintBitsToFloat(floatBitsToUint(b) & 0xfffff000u);
  PRECISE float a2 = HOLD(a - a1);
  PRECISE float b2 = HOLD(b - b1);
  PRECISE float product = HOLD(a * b);
  PRECISE float rest = HOLD(HOLD(HOLD(a1 * b1 - product) + HOLD(a1 * b2)) + HOLD(a2 * b1)) + HOLD(a2 * b2);
  return vec2(product, rest);
}
Wide wide_add(Wide a, Wide b) {
  Wide high = two_sum(a.x, b.x);
  Wide low = two_sum(a.y, b.y);
  Wide sum = quick_two_sum(high.x, high.y + low.x);
  return quick_two_sum(sum.x, sum.y + low.y);
}
Wide wide_sub(Wide a, Wide b) { return wide_add(a, -b); }
Wide wide_mul(Wide a, Wide b) {
  Wide product = two_product(a.x, b.x);
  return quick_two_sum(product.x, product.y + (a.x * b.y + a.y * b.x));
}
Wide wide_sum(float a, float b, float c) {
  Wide first = two_sum(a, b);
  Wide second = two_sum(first.x, c);
  return quick_two_sum(second.x, second.y + first.y);
}
Wide wide_offset(uvec2 bits, int axis) {
  vec3 p = pieces(bits);
  return axis == 0 ? wide_sum(p.x - u_center_1.x, p.y - u_center_2.x, p.z - u_center_3.x)
                   : wide_sum(p.x - u_center_1.y, p.y - u_center_2.y, p.z - u_center_3.y);
}
Wide wide_number(uvec2 bits) {
  vec3 p = pieces(bits);
  return wide_sum(p.x, p.y, p.z);
}
Wide wide_of(float a) { return vec2(a, 0.0); }
float narrow(Wide a) { return a.x; }

#else

#define Wide double
Wide wide_number(uvec2 bits) { return packDouble2x32(bits); }
Wide wide_of(float a) { return double(a); }
Wide wide_offset(uvec2 bits, int axis) {
  PRECISE double high = packDouble2x32(bits) - packDouble2x32(axis == 0 ? u_center_words.xy : u_center_words.zw);
  return high - packDouble2x32(axis == 0 ? u_center_low_words.xy : u_center_low_words.zw);
}
Wide wide_sub(Wide a, Wide b) { return a - b; }
Wide wide_add(Wide a, Wide b) { return a + b; }
Wide wide_mul(Wide a, Wide b) { return a * b; }
float narrow(Wide a) { return float(a); }

#endif

struct WideVec2 {
  Wide x;
  Wide y;
};
WideVec2 wide_offset(uvec4 bits) { return WideVec2(wide_offset(bits.xy, 0), wide_offset(bits.zw, 1)); }
WideVec2 wide_vector(uvec4 bits) { return WideVec2(wide_number(bits.xy), wide_number(bits.zw)); }
WideVec2 wide_sub(WideVec2 a, WideVec2 b) { return WideVec2(wide_sub(a.x, b.x), wide_sub(a.y, b.y)); }
float wide_cross(WideVec2 a, WideVec2 b) {
  return narrow(wide_sub(wide_mul(a.x, b.y), wide_mul(a.y, b.x)));
}
vec2 narrow(WideVec2 a) { return vec2(narrow(a.x), narrow(a.y)); }

#if DASHED && REACH == 2
// What is left of a length in pixels when whole periods of dashes are taken away.
float wide_phase(double s) {
  double period = double(u_dash_period);
  return float(s - period * floor(s / period));
}
#endif

// A straight line in the view, in pixels: the points `offset` * turned(direction) + s * direction.
struct Carrier {
  vec2 direction;  // of unit length
  float offset;    // signed distance of the line from the centre of the view
  float start;     // s of the anchor
  float size;      // length of `along`
#if DASHED
  float phase;     // of dashes that count from the anchor, at s = 0: in [0, u_dash_period)
#endif
};

// The line through an anchor. `along` may have any length. The result is the more exact, the nearer the anchor is and
// the more bits `Wide` has.
Carrier carrier(WideVec2 anchor, WideVec2 along) {
  Carrier line;
  vec2 d = narrow(along);
  float unit = max(abs(d.x), abs(d.y));
  // Scaled, as a product of an anchor and a vector of very different sizes might underflow.
  vec2 scaled = unit > 0.0 ? d / unit : vec2(1.0, 0.0);
  float norm = length(scaled);
  line.direction = scaled / norm;
  line.size = unit * norm * u_pixels_per_unit;
  vec2 a = narrow(anchor) * u_pixels_per_unit;
  line.start = dot(a, line.direction);
  line.offset = unit > 0.0 ? wide_cross(along, anchor) / unit / norm * u_pixels_per_unit : a.y;
#if DASHED
#if REACH == 2
  // A float would not hold a fraction of the period of an anchor that is far away.
  double exact_unit = unit > 0.0 ? double(unit) : 1.0lf;
  double x = unit > 0.0 ? along.x / exact_unit : 1.0lf;
  double y = unit > 0.0 ? along.y / exact_unit : 0.0lf;
  double start = (anchor.x * x + anchor.y * y) / sqrt(x * x + y * y) * double(u_pixels_per_unit);
  line.phase = wide_phase(-start);
#else
  line.phase = mod(-line.start, u_dash_period);
#endif
#endif
  return line;
}
