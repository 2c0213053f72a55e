// A rectangle of a picture.
uniform vec4 u_place;  // left, bottom, right, top in the area, from -1 to 1
uniform vec4 u_part;   // the same edges in the picture, from 0 to 1, top row first

out vec2 v_part;

void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  v_part = mix(u_part.xy, u_part.zw, corner);
  gl_Position = vec4(mix(u_place.xy, u_place.zw, corner), 0.0, 1.0);
}
