uniform sampler2D u_coverage;
uniform vec4 u_tint;
uniform ivec2 u_corner;  // lower left of the area in the target

out vec4 color;

void main() { color = u_tint * texelFetch(u_coverage, ivec2(gl_FragCoord.xy) - u_corner, 0).r; }
