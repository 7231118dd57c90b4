package org.pendant.cell;

/**
 * Contact row: one direction at a place where two bodies touch: how fast the first leaves the
 * second along it, and what an impulse along it does to both. All is reckoned once a step, since
 * the solver asks many times.
 */
final class ContactRow {
  /** The direction. */
  private double x;

  private double y;
  private double z;

  /** Levers of both bodies: from the origin to the place, across the direction, m. */
  private double lever1X;

  private double lever1Y;
  private double lever1Z;
  private double lever2X;
  private double lever2Y;
  private double lever2Z;

  /** Turns that an impulse of 1 Ns gives to both, rad/s. */
  private double turn1X;

  private double turn1Y;
  private double turn1Z;
  private double turn2X;
  private double turn2Y;
  private double turn2Z;

  private double[] twist1;
  private double[] twist2;
  private double inverseMass1;
  private double inverseMass2;
  private boolean secondMoves;

  /** Takes a direction of length 1 at a place, {@code arm1} and {@code arm2} from the origins. */
  void set(CellBody first, double[] arm1, CellBody second, double[] arm2, double[] along) {
    x = along[0];
    y = along[1];
    z = along[2];
    twist1 = first.twist;
    twist2 = second.twist;
    inverseMass1 = first.inverseMass;
    inverseMass2 = second.inverseMass;
    secondMoves = second.description.motion() != BodyMotion.FIXED;
    lever1X = arm1[1] * z - arm1[2] * y;
    lever1Y = arm1[2] * x - arm1[0] * z;
    lever1Z = arm1[0] * y - arm1[1] * x;
    double[] inverse = first.inverseInertia;
    turn1X = inverse[0] * lever1X + inverse[1] * lever1Y + inverse[2] * lever1Z;
    turn1Y = inverse[3] * lever1X + inverse[4] * lever1Y + inverse[5] * lever1Z;
    turn1Z = inverse[6] * lever1X + inverse[7] * lever1Y + inverse[8] * lever1Z;
    if (secondMoves) {
      lever2X = arm2[1] * z - arm2[2] * y;
      lever2Y = arm2[2] * x - arm2[0] * z;
      lever2Z = arm2[0] * y - arm2[1] * x;
      inverse = second.inverseInertia;
      turn2X = inverse[0] * lever2X + inverse[1] * lever2Y + inverse[2] * lever2Z;
      turn2Y = inverse[3] * lever2X + inverse[4] * lever2Y + inverse[5] * lever2Z;
      turn2Z = inverse[6] * lever2X + inverse[7] * lever2Y + inverse[8] * lever2Z;
    }
  }

  /** How fast the first body leaves the second one here, m/s. */
  double speed() {
    double[] one = twist1;
    double speed =
        x * one[0]
            + y * one[1]
            + z * one[2]
            + lever1X * one[3]
            + lever1Y * one[4]
            + lever1Z * one[5];
    if (secondMoves) {
      double[] other = twist2;
      speed -=
          x * other[0]
              + y * other[1]
              + z * other[2]
              + lever2X * other[3]
              + lever2Y * other[4]
              + lever2Z * other[5];
    }
    return speed;
  }

  /** The part of a speed along this direction, m/s. */
  double part(double vx, double vy, double vz) {
    return x * vx + y * vy + z * vz;
  }

  /** Gives both bodies impulses along the rows of a place, Ns, which push them apart. */
  static void hit(
      ContactRow a, double impulseA, ContactRow b, double impulseB, ContactRow c, double impulseC) {
    double x = impulseA * a.x + impulseB * b.x + impulseC * c.x;
    double y = impulseA * a.y + impulseB * b.y + impulseC * c.y;
    double z = impulseA * a.z + impulseB * b.z + impulseC * c.z;
    double[] one = a.twist1;
    double light = a.inverseMass1;
    one[0] += light * x;
    one[1] += light * y;
    one[2] += light * z;
    one[3] += impulseA * a.turn1X + impulseB * b.turn1X + impulseC * c.turn1X;
    one[4] += impulseA * a.turn1Y + impulseB * b.turn1Y + impulseC * c.turn1Y;
    one[5] += impulseA * a.turn1Z + impulseB * b.turn1Z + impulseC * c.turn1Z;
    double heavy = a.inverseMass2;
    if (heavy > 0) {
      double[] other = a.twist2;
      other[0] -= heavy * x;
      other[1] -= heavy * y;
      other[2] -= heavy * z;
      other[3] -= impulseA * a.turn2X + impulseB * b.turn2X + impulseC * c.turn2X;
      other[4] -= impulseA * a.turn2Y + impulseB * b.turn2Y + impulseC * c.turn2Y;
      other[5] -= impulseA * a.turn2Z + impulseB * b.turn2Z + impulseC * c.turn2Z;
    }
  }

  /** The speed along this direction that an impulse of 1 Ns along another one gives, m/s. */
  double yielding(ContactRow other) {
    double yielding =
        (x * other.x + y * other.y + z * other.z) * (inverseMass1 + inverseMass2)
            + lever1X * other.turn1X
            + lever1Y * other.turn1Y
            + lever1Z * other.turn1Z;
    return inverseMass2 > 0
        ? yielding + lever2X * other.turn2X + lever2Y * other.turn2Y + lever2Z * other.turn2Z
        : yielding;
  }
}
