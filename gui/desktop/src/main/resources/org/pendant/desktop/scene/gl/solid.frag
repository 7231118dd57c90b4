#version 330 core
// One directional light with a shadow, light from the sky and from the floor, and a weak one at the eye.
in vec3 worldPosition;
in vec3 worldNormal;
in vec3 lightPosition;
flat in vec4 finish;

uniform vec3 eye;
uniform vec3 toSun;
uniform float sunlight;
uniform vec3 sky;
uniform vec3 ground;
uniform vec4 tint; // mixed into the colour by its alpha
uniform float opacity;
uniform float floorHeight;

out vec4 colour;

#include shadow.glsl

// To the power of 1 / 2.2 within a step of a screen: roots are cheap without a GPU, powers are not.
vec3 onScreen(vec3 light) {
  vec3 root = sqrt(light);
  return 0.9658 * root + 0.0891 * sqrt(root) - 0.0549 * light;
}

void main() {
  vec3 n = normalize(worldNormal);
  vec3 toEye = normalize(eye - worldPosition);
  float facing = dot(n, toSun);
  float sun = facing > 0.0 ? facing * lit(lightPosition) : 0.0;
  vec3 albedo = mix(finish.rgb, tint.rgb, tint.a);

  // what lies close over the floor sees less of the surroundings
  float height = worldPosition.z - floorHeight;
  float open = mix(0.62, 1.0, clamp(0.5 + 0.5 * n.z + 3.0 * max(height, 0.0), 0.0, 1.0));
  vec3 ambient = mix(ground, sky, 0.5 + 0.5 * n.z) * open;
  float atEye = max(dot(n, toEye), 0.0);
  vec3 light = ambient + vec3(1.0, 0.975, 0.94) * (sunlight * sun) + vec3(0.10 * atEye);

  vec3 middle = normalize(toSun + toEye);
  float gloss = max(finish.a, 0.0);
  float shine = gloss * pow(max(dot(n, middle), 0.0), mix(24.0, 80.0, gloss)) * min(sun * 3.0, 1.0);
  float side = 1.0 - atEye;
  float rim = 0.10 * side * side * side * side;

  if (finish.a < 0.0) {
    light = vec3(0.55 + 0.45 * atEye); // marks shine by themselves
    shine = 0.0;
  }
  vec3 linear = albedo * light + vec3(shine * 0.45) + sky * rim;
  colour = vec4(onScreen(linear), opacity);
}
