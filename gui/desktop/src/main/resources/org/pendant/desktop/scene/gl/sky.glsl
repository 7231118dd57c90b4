// What is behind everything, at a height of the picture, 0 to 1.
uniform vec3 skyTop;
uniform vec3 skyBottom;

vec3 skyAt(float height) {
  return mix(skyBottom, skyTop, smoothstep(0.0, 1.0, height));
}
