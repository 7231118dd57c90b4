package org.pendant.desktop.scene.gl;

/** Shadow lookup: how a surface finds whether it is in the shadow; a shader is made for each. */
enum Shadows {
  /** There is none to look for. */
  NONE,
  /** One look. */
  HARD,
  /** Four looks around the place. */
  SOFT;

  /** What the shader is told. */
  String define() {
    return "SHADOW_" + name();
  }
}
