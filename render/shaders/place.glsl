// For vertex programs: from the bits of coordinates to offsets from the centre of the view.

// Far outside clip space: an instance there costs no fragments.
const vec4 kHidden = vec4(2.0, 2.0, 2.0, 1.0);
const float kTurn = 6.28318530717958648;

// The corner of a rectangle strip that this vertex is: (-1,-1), (1,-1), (-1,1), (1,1).
vec2 strip_corner() { return vec2((gl_VertexID & 1) * 2 - 1, (gl_VertexID & 2) - 1); }

// The corner of an equilateral triangle around the unit disk that this vertex is.
vec2 triangle_corner() { return vec2(float(gl_VertexID - 1) * 1.7320508, gl_VertexID == 1 ? 2.0 : -1.0); }

vec4 place(vec2 px) { return vec4(px / u_half_view, 0.0, 1.0); }

vec2 turned(vec2 v) { return vec2(-v.y, v.x); }

// The pieces of a double, given as its low and high word: 21, 16 and 16 bits, each an exact float. A double below
// 2^-106 counts as zero.
vec3 pieces(uvec2 bits) {
  uint exponent = (bits.y >> 20) & 0x7ffu;
  if (exponent < 918u) return vec3(0.0);
  float unit = uintBitsToFloat(((exponent - 916u) << 23) | (bits.y & 0x80000000u));
  uint high = (bits.y & 0xfffffu) | 0x100000u;
  return unit *
         vec3(float(high), float(bits.x >> 16) * (1.0 / 65536.0), float(bits.x & 0xffffu) * (1.0 / 4294967296.0));
}

// Coordinate minus centre. Pieces of point and centre are multiples of the same units, so differences and the first
// sum are exact if point and centre are close, and only the last sum rounds.
float near_offset(uvec2 bits, float c1, float c2, float c3) {
  vec3 p = pieces(bits);
  PRECISE float first = HOLD(p.x - c1);
  PRECISE float second = HOLD(p.y - c2);
  PRECISE float third = HOLD(p.z - c3);
  PRECISE float sum = HOLD(first + second);
  return sum + third;
}
vec2 near_offset(uvec4 bits) {
  return vec2(near_offset(bits.xy, u_center_1.x, u_center_2.x, u_center_3.x),
              near_offset(bits.zw, u_center_1.y, u_center_2.y, u_center_3.y));
}
float near_number(uvec2 bits) {
  vec3 p = pieces(bits);
  return p.x + (p.y + p.z);
}
vec2 near_vector(uvec4 bits) { return vec2(near_number(bits.xy), near_number(bits.zw)); }
