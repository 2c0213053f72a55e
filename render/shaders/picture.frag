uniform sampler2D u_picture;
uniform float u_opacity;

in vec2 v_part;
out vec4 color;

void main() { color = texture(u_picture, v_part) * u_opacity; }
