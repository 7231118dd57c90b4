package org.pendant.desktop.scene.mesh;

/**
 * Link bodies: the seven bodies of an arm, from the table to the tool; the frame that each is
 * described in is the one {@link org.pendant.models.shape.ArmShape} names.
 */
public enum Link {
  BASE,
  SHOULDER,
  UPPER_ARM,
  FOREARM,
  WRIST_1,
  WRIST_2,
  WRIST_3
}
