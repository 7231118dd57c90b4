#version 330 core
in float height;

out vec4 colour;

#include sky.glsl

void main() {
  colour = vec4(skyAt(height), 1.0);
}
