// For vertex programs: the colour of an instance from its scalar.
#if MAPPED

layout(location = 5) in uvec2 a_scalar;
uniform sampler2D u_maps;
flat out vec4 v_color;

// A scalar beyond 2^60 times the range counts as infinite, and one below 2^-90 times the range as zero.
const int kFarAbove = 60;
const int kFarBelow = -90;
// Categories from 2^22 on count as infinite: floats hold no halves beyond.
const int kMostCategories = 21;

vec4 map_color(int index) {
  vec4 color = texelFetch(u_maps, ivec2(index, int(u_map_row)), 0);
  return vec4(color.rgb, 1.0) * u_color.a;
}

// Sets the colour of the instance; NaN has the plain one.
void paint() {
  int exponent = int((a_scalar.y >> 20) & 0x7ffu);
  if (exponent == 0x7ff && ((a_scalar.y & 0xfffffu) | a_scalar.x) != 0u) {
    v_color = u_color;
    return;
  }
  int above = exponent - int(u_map_exponent);
  bool negative = (a_scalar.y & 0x80000000u) != 0u;
  float t = negative ? 0.0 : 1.0;
  if (exponent == 0x7ff || above > (u_map_categories > 0.0 ? kMostCategories : kFarAbove)) {
    if (u_map_categories > 0.0) t *= u_map_categories - 1.0;
  } else {
    // The three pieces of the scalar, as in `pieces`, in units of the range's power of two. The pieces of the low end
    // are multiples of the same units, so differences close to it are exact.
    vec3 p = vec3(0.0);
    if (above >= kFarBelow && exponent > 0) {
      float unit = uintBitsToFloat((uint(above + 107) << 23) | (a_scalar.y & 0x80000000u));
      p = vec3(float((a_scalar.y & 0xfffffu) | 0x100000u), float(a_scalar.x >> 16) * (1.0 / 65536.0),
               float(a_scalar.x & 0xffffu) * (1.0 / 4294967296.0)) * unit;
    }
    PRECISE float first = HOLD(p.x - u_map_low.x);
    PRECISE float second = HOLD(p.y - u_map_low.y);
    PRECISE float third = HOLD(p.z - u_map_low.z);
    PRECISE float sum = HOLD(first + second);
    t = (sum + third) * u_map_factor + u_map_offset;
  }
  if (u_map_categories > 0.0) {
    float number = floor(t + 0.5);
    v_color = map_color(int(number - u_map_categories * floor(number / u_map_categories)));
    return;
  }
  // Interpolates the two nearest colours of the row.
  float last = float(textureSize(u_maps, 0).x - 1);
  float place = clamp(t, 0.0, 1.0) * last;
  float first = min(floor(place), last - 1.0);
  v_color = mix(map_color(int(first)), map_color(int(first) + 1), place - first);
}

#else
void paint() {}
#endif
