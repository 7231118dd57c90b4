// How much of the light arrives, 0 to 1. Each look is smoothed over four pixels by the hardware.
#ifdef SHADOW_NONE
float lit(vec3 at) {
  return 1.0;
}
#else
uniform sampler2DShadow shadowMap;

float lit(vec3 at) {
  if (any(lessThan(at, vec3(0.0))) || any(greaterThan(at, vec3(1.0)))) {
    return 1.0;
  }
#ifdef SHADOW_SOFT
  vec2 pixel = 1.0 / vec2(textureSize(shadowMap, 0));
  float sum = texture(shadowMap, vec3(at.xy + pixel * vec2(1.5, 0.5), at.z));
  sum += texture(shadowMap, vec3(at.xy + pixel * vec2(-0.5, 1.5), at.z));
  sum += texture(shadowMap, vec3(at.xy + pixel * vec2(-1.5, -0.5), at.z));
  sum += texture(shadowMap, vec3(at.xy + pixel * vec2(0.5, -1.5), at.z));
  return sum / 4.0;
#else
  return texture(shadowMap, at);
#endif
}
#endif
