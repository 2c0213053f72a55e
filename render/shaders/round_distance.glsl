// Signed distance to the rim of a disk of radius r. `p` is given from the anchor that `Rim` chose.
#if REACH == 0
float rim_distance(vec2 p, vec2 n, float r) { return length(p) - r; }
#else
// The anchor is a rim point with outward normal n. Nothing cancels, however large r is.
float rim_distance(vec2 p, vec2 n, float r) {
  float square = dot(p, p);
  float twice = 2.0 * r * dot(n, p);
  return (square + twice) / max(sqrt(max(r * r + twice + square, 0.0)) + r, 1e-6);
}
#endif
