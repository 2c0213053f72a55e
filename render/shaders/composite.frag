uniform sampler2D u_group;
uniform vec4 u_tint;
uniform ivec2 u_corner;  // lower left of the area in the target

out vec4 color;

void main() { color = u_tint * texelFetch(u_group, ivec2(gl_FragCoord.xy) - u_corner, 0); }
