#version 330 core
// Bodies: every vertex says which place of the list moves it.
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in ivec2 placeAndFinish;
layout(location = 3) in uint paint; // a bit for whether it has a colour, then five each for red, green and blue

const int MOST_PLACES = 8;
const int FINISHES = 11;

uniform mat4 places[MOST_PLACES];
uniform mat4 toClip;
uniform mat4 toLight;
uniform float shadowOffset; // m
uniform int hit; // a bit for each place: what moves with it has hit something
uniform vec3 hitColour;
uniform vec4 finishes[FINISHES]; // linear colour, gloss; gloss below 0 for what shines by itself

out vec3 worldPosition;
out vec3 worldNormal;
out vec3 lightPosition;
flat out vec4 finish;

void main() {
  mat4 place = places[placeAndFinish.x];
  vec4 world = place * vec4(position, 1.0);
  worldPosition = world.xyz;
  worldNormal = mat3(place) * normal;
  // looked up a little outside the surface, or it would throw shadows on itself
  lightPosition = (toLight * (world + vec4(worldNormal * shadowOffset, 0.0))).xyz;
  finish = finishes[placeAndFinish.y];
  if ((paint & 0x8000u) != 0u) {
    vec3 screen = vec3(paint >> 10 & 31u, paint >> 5 & 31u, paint & 31u) / 31.0;
    finish.rgb = pow(screen, vec3(2.2));
  }
  if ((hit >> placeAndFinish.x & 1) != 0) {
    finish.rgb = mix(finish.rgb, hitColour, 0.75);
  }
  gl_Position = toClip * world;
}
