in vec2 v_offset;
flat in vec4 v_rim;
out vec4 color;

void main() {
  float sd = rim_distance(v_offset, v_rim.xy, v_rim.z);
  color = v_color * (clamp(0.5 - sd, 0.0, 1.0) * v_rim.w);
}
