#version 330 core
// Rectangles of a plane, made of no buffer at all: a field of three by three around the middle one, which
// is the part that the shadow can reach.
uniform mat4 place;
uniform mat4 toClip;
uniform mat4 toLight;
uniform float halfSize;
uniform vec4 middle; // from x, y to x, y
uniform bool around; // the eight around the middle, else the middle alone

out vec2 onPlane;
out vec3 worldPosition;
out vec3 lightPosition;

void main() {
  int cell = around ? gl_InstanceID + (gl_InstanceID < 4 ? 0 : 1) : 4;
  float xs[4] = float[](-halfSize, middle.x, middle.z, halfSize);
  float ys[4] = float[](-halfSize, middle.y, middle.w, halfSize);
  onPlane = vec2(xs[cell % 3 + gl_VertexID % 2], ys[cell / 3 + gl_VertexID / 2]);
  vec4 world = place * vec4(onPlane, 0.0, 1.0);
  worldPosition = world.xyz;
  lightPosition = (toLight * world).xyz;
  gl_Position = toClip * world;
}
