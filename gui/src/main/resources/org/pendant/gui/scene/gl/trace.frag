#version 330 core
in vec3 paint;

uniform float opacity;

out vec4 colour;

void main() {
  colour = vec4(paint, opacity);
}
