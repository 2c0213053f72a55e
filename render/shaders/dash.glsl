// The part of a pixel at `s` pixels along a stroke that a dash covers; dashes are centred on multiples of the period.
float dash_cover(float s, float period) {
  float from_middle = abs(s - period * floor(s / period + 0.5));
  return clamp(0.5 + 0.5 * u_dash * (period / u_dash_period) - from_middle, 0.0, 1.0);
}
