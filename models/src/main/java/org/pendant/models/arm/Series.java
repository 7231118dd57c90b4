package org.pendant.models.arm;

/** The generations of arms. */
public enum Series {
  /** UR3, UR5, UR10: without force/torque sensor of their own. */
  CB3("CB3"),
  /** With a force/torque sensor at the flange. */
  E_SERIES("e-Series"),
  /** As the e-Series, with a light around the base. */
  UR_SERIES("UR-Series");

  private final String displayName;

  Series(String displayName) {
    this.displayName = displayName;
  }

  /** The name for people. */
  public String displayName() {
    return displayName;
  }
}
