in vec3 v_edges;
flat in vec3 v_corners;
out vec4 color;

// Of a pixel that two edges cover by a and b, how much lies behind both. For a right angle the product; towards a needle
// a + b - 1, which is exact for parallel edges; towards a straight angle the smaller one. `w` goes from -1 to 1 on that
// way, such that triangles around a common corner come close to covering its pixel together.
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
