in vec2 v_offset;
flat in vec2 v_shape;
out vec4 color;

void main() {
  float sd = length(v_offset) - v_shape.x;
  if (u_ring > 0.0) sd = abs(sd) - max(u_ring, 0.5);
  color = u_color * (clamp(0.5 - sd, 0.0, 1.0) * v_shape.y);
}
