layout(location = 0) in uvec4 a_first;
layout(location = 1) in uvec4 a_second;
layout(location = 2) in uvec4 a_third;

out vec3 v_edges;         // signed distances to the edges, negative inside
flat out vec3 v_corners;  // the weights of `corner_cover`, for edges 0-1, 1-2, 2-0

// Outward normal of the edge from a to b of a counter-clockwise triangle, and the edge's signed distance from the
// view's centre.
vec3 edge(WideVec2 a, WideVec2 b) {
  vec2 na = abs(narrow(a));
  vec2 nb = abs(narrow(b));
  if (max(nb.x, nb.y) < max(na.x, na.y)) {
    Carrier line = carrier(b, wide_sub(a, b));
    return vec3(turned(line.direction), line.offset);
  }
  Carrier line = carrier(a, wide_sub(b, a));
  return -vec3(turned(line.direction), line.offset);
}

float weight(vec3 a, vec3 b) {
  float cosine = dot(a.xy, b.xy);
  return cosine * abs(cosine);
}

void main() {
  paint();
  WideVec2 a = wide_offset(a_first);
  WideVec2 b = wide_offset(a_second);
  WideVec2 c = wide_offset(a_third);
  float area = wide_cross(wide_sub(b, a), wide_sub(c, a));
  float turn = area < 0.0 ? -1.0 : 1.0;
  vec3 ab = edge(a, b) * turn;
  vec3 bc = edge(b, c) * turn;
  vec3 ca = edge(c, a) * turn;

  // The bounding box, cut to the view.
  vec2 pa = narrow(a) * u_pixels_per_unit;
  vec2 pb = narrow(b) * u_pixels_per_unit;
  vec2 pc = narrow(c) * u_pixels_per_unit;
  vec2 view = u_half_view + 1.0;
  vec2 low = clamp(min(pa, min(pb, pc)) - 1.0, -view, view);
  vec2 high = clamp(max(pa, max(pb, pc)) + 1.0, -view, view);
  vec2 px = mix(low, high, 0.5 * strip_corner() + 0.5);

  v_edges = vec3(dot(ab.xy, px) - ab.z, dot(bc.xy, px) - bc.z, dot(ca.xy, px) - ca.z);
  v_corners = vec3(weight(ab, bc), weight(bc, ca), weight(ca, ab));
  gl_Position = area == 0.0 ? kHidden : place(px);
}
