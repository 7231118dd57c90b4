package org.pendant.controller.installation;

/** Feature kind: what a {@link Feature} is taught by. */
public enum FeatureKind {
  /** A pose. */
  POINT(1),
  /** Two points: y points from the first to the second. */
  LINE(2),
  /** Three points. */
  PLANE(3);

  private final int points;

  FeatureKind(int points) {
    this.points = points;
  }

  /** How many points it needs. */
  public int points() {
    return points;
  }
}
