// Rectangles of the area, one an instance.
uniform vec4 u_parts[128];  // left, bottom, right, top, from -1 to 1

void main() {
  vec4 part = u_parts[gl_InstanceID];
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  gl_Position = vec4(mix(part.xy, part.zw, corner), 0.0, 1.0);
}
