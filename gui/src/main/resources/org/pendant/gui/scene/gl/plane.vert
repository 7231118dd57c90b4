#version 330 core
// A square of a plane, made of no buffer at all.
uniform mat4 place;
uniform mat4 toClip;
uniform mat4 toLight;
uniform float halfSize;

out vec2 onPlane;
out vec3 worldPosition;
out vec3 lightPosition;

void main() {
  vec2 corner = vec2(gl_VertexID % 2, gl_VertexID / 2) * 2.0 - 1.0;
  onPlane = corner * halfSize;
  vec4 world = place * vec4(onPlane, 0.0, 1.0);
  worldPosition = world.xyz;
  lightPosition = (toLight * world).xyz;
  gl_Position = toClip * world;
}
