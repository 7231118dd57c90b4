#version 330 core
// Fine lines and, every few of them, stronger ones, fading out with the distance from the middle.
in vec2 onPlane;
in vec3 worldPosition;
in vec3 lightPosition;

uniform vec3 fill;
uniform vec3 line;
uniform float fillOpacity;
uniform float lineOpacity; // 1 for lines as strong as on the floor
uniform float shade; // how dark the shadow is
uniform float fineStep; // from one line to the next
uniform float strongStep;
uniform float reach; // fully there up to this distance from the middle, gone at the edge
uniform float halfSize;
uniform vec3 axisX;
uniform vec3 axisY;
uniform float axes; // 1 to colour the lines through the middle
uniform float pictureHeight; // above 0: fade into the sky; 0: leave the mixing to the caller

out vec4 colour;

#include shadow.glsl
#include sky.glsl

// How much of a pixel the lines of a grid cover, along both directions.
vec2 lines(vec2 width, float step, float wide) {
  vec2 away = abs(fract(onPlane / step - 0.5) - 0.5) * step;
  vec2 cover = 1.0 - smoothstep(vec2(0.0), width * wide, away);
  return cover * (1.0 - smoothstep(0.25, 0.6, width / step));
}

void main() {
  float far = length(onPlane);
  float there = 1.0 - smoothstep(reach, halfSize, far);
  if (there <= 0.0) {
    discard;
  }
  vec2 width = fwidth(onPlane);
  vec2 fine = lines(width, fineStep, 1.2);
  vec2 coarse = lines(width, strongStep, 1.5);
  float cover = lineOpacity * max(0.30 * max(fine.x, fine.y), 0.62 * max(coarse.x, coarse.y));
  float dark = far < reach ? shade * (1.0 - lit(lightPosition)) : 0.0;

  vec3 paint = mix(fill, line, cover);
  if (axes > 0.5) {
    vec2 onAxis = 1.0 - smoothstep(vec2(0.0), width * 1.8, abs(onPlane));
    paint = mix(paint, axisX, 0.75 * onAxis.y);
    paint = mix(paint, axisY, 0.75 * onAxis.x);
  }
  float opacity = max(max(fillOpacity, cover), dark);
  paint *= 1.0 - dark;
  if (pictureHeight > 0.0) {
    colour = vec4(mix(skyAt(1.0 - gl_FragCoord.y / pictureHeight), paint, opacity * there), 1.0);
  } else {
    colour = vec4(paint, opacity * there);
  }
}
