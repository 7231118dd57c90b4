package org.pendant.cell;

/** Body motion: what moves a body. */
public enum BodyMotion {
  /** Nothing. */
  FIXED,
  /** Weight and contacts. */
  FREE,
  /**
   * Whoever says where it is, step by step; contacts do not move it, but are felt. They give way a
   * little, as {@link BodySurface#stiffnessNPerM} says, so that forces stay finite.
   */
  KINEMATIC
}
