in vec3 v_edges;
flat in vec3 v_corners;
out vec4 color;

// The part of a pixel behind two edges of which one covers a and the other b: the product at a right angle, a + b - 1
// at an angle of zero, where the edges are parallel, and the smaller one at a straight angle. `w` goes from -1 to 1
// between these, such that triangles around a common corner nearly cover its pixel together.
float corner_cover(float a, float b, float w) {
  return w < 0.0 ? mix(a * b, max(a + b - 1.0, 0.0), -w) : mix(a * b, min(a, b), w);
}

void main() {
  vec3 c = clamp(0.5 - v_edges, 0.0, 1.0);
  float cover;
  if (c.z >= c.x && c.z >= c.y) {
    cover = corner_cover(c.x, c.y, v_corners.x) * c.z;
  } else if (c.x >= c.y) {
    cover = corner_cover(c.y, c.z, v_corners.y) * c.x;
  } else {
    cover = corner_cover(c.z, c.x, v_corners.z) * c.y;
  }
  color = v_color * cover;
}
