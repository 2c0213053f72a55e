uniform sampler2D u_group;
uniform vec4 u_tint;
uniform ivec2 u_corner;  // lower left of the area in the target
uniform int u_channels;  // of the texture: 4, a colour; 1, the alpha of white; 2, the low and the high byte of that

out vec4 color;

void main() {
  vec4 texel = texelFetch(u_group, ivec2(gl_FragCoord.xy) - u_corner, 0);
  if (u_channels == 1) {
    texel = texel.rrrr;
  } else if (u_channels == 2) {
    texel = vec4((255.0 * texel.r + 65280.0 * texel.g) / 65535.0);
  }
  color = u_tint * texel;
}
