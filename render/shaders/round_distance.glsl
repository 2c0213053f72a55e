// Signed distance to the rim of a disk of radius r, at `p` from a rim point whose outward normal is n. Nothing cancels,
// however large r is.
float rim_distance(vec2 p, vec2 n, float r) {
  float along = dot(n, p);
  float square = dot(p, p);
  float twice = 2.0 * r * along;
  return (square + twice) / max(sqrt(max(r * r + twice + square, 0.0)) + r, 1e-6);
}
