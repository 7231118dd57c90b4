#version 330 core
// Each piece of a line is drawn as a strip of an even width in pixels.
layout(location = 0) in vec4 from; // position, 1 where a line begins
layout(location = 1) in vec4 to;
layout(location = 2) in vec4 fromColour;
layout(location = 3) in vec4 toColour;

uniform mat4 toClip;
uniform vec2 halfPixels; // half the size of the picture
uniform float width; // in pixels

out vec4 paint;

void main() {
  bool second = gl_VertexID >= 2;
  float side = gl_VertexID % 2 == 0 ? -1.0 : 1.0;
  vec4 a = toClip * vec4(from.xyz, 1.0);
  vec4 b = toClip * vec4(to.xyz, 1.0);
  paint = second ? toColour : fromColour;
  if (to.w > 0.5 || a.w <= 0.0 || b.w <= 0.0) {
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0); // outside: nothing is drawn
    return;
  }
  vec2 way = (b.xy / b.w - a.xy / a.w) * halfPixels;
  vec2 along = length(way) > 1e-4 ? normalize(way) : vec2(1.0, 0.0);
  vec2 across = vec2(-along.y, along.x);
  vec4 end = second ? b : a;
  vec2 shift = (across * side + along * (second ? 0.5 : -0.5)) * 0.5 * width / halfPixels;
  gl_Position = end + vec4(shift * end.w, -2e-4 * end.w, 0.0);
}
