// Signed distance of p from the rim of a disk of radius r. `p` is relative to the anchor of `Rim`.
#if REACH == 0
float rim_distance(vec2 p, vec2 n, float r) { return length(p) - r; }
#else
// The anchor is a rim point with outward normal n. There is no cancellation, however large r is.
float rim_distance(vec2 p, vec2 n, float r) {
  float square = dot(p, p);
  float twice = 2.0 * r * dot(n, p);
  return (square + twice) / max(sqrt(max(r * r + twice + square, 0.0)) + r, 1e-6);
}
#endif

// Angle at the centre of a rim of radius r, from its point with outward normal n to the direction of p.
float rim_angle(vec2 p, vec2 n, float r) {
  float across = n.x * p.y - n.y * p.x;
  float out_of = dot(n, p);
#if REACH != 0
  out_of += r;
#endif
  float slope = across / max(out_of, 1e-30);
  // A driver's inverse tangent has a fixed absolute error, which a huge radius magnifies.
  if (out_of > 0.0 && abs(slope) < 0.05) return slope * (1.0 - slope * slope / 3.0);
  return atan(across, out_of);
}
