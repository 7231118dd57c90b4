#version 330 core
// Bodies as the light sees them.
layout(location = 0) in vec3 position;
layout(location = 2) in ivec2 placeAndFinish;

const int MOST_PLACES = 8;

uniform mat4 places[MOST_PLACES];
uniform mat4 toClip;

void main() {
  gl_Position = toClip * (places[placeAndFinish.x] * vec4(position, 1.0));
}
