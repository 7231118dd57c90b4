#version 330 core
in vec4 paint;

uniform float opacity;

out vec4 colour;

void main() {
  colour = vec4(paint.rgb, opacity * paint.a);
}
