package org.pendant.controller.jog;

import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;

/**
 * Jog direction: along which axis the tool moves, or about which it turns; a unit vector in some
 * {@link JogFrame}.
 */
public record JogDirection(Kind kind, double x, double y, double z) {

  /** What is done with the axis. */
  public enum Kind {
    /** The TCP moves along it. */
    ALONG,
    /** The tool turns about it, right-handed, and the TCP stays. */
    AROUND
  }

  /**
   * Scales the vector to length 1.
   *
   * @throws IllegalArgumentException if it has no direction
   */
  public JogDirection {
    double length = Math.sqrt(x * x + y * y + z * z);
    if (!(length > 0) || Double.isInfinite(length)) {
      throw new IllegalArgumentException(
          "direction is [" + x + ", " + y + ", " + z + "], must be finite and not zero");
    }
    x /= length;
    y /= length;
    z /= length;
  }

  /** Moves the TCP along this axis. */
  public static JogDirection along(double x, double y, double z) {
    return new JogDirection(Kind.ALONG, x, y, z);
  }

  /** Turns the tool about this axis. */
  public static JogDirection around(double x, double y, double z) {
    return new JogDirection(Kind.AROUND, x, y, z);
  }

  /**
   * What the TCP does, along the axes of the base: 1 m along or 1 rad about the axis.
   *
   * @param tcpInBase pose of the TCP when the move begins
   */
  Pose twistInBase(JogFrame frame, Pose tcpInBase) {
    Pose axis =
        switch (frame) {
          case JogFrame.Base base -> new Pose(x, y, z, 0, 0, 0);
          case JogFrame.Tool tool -> turned(tcpInBase);
          case JogFrame.Given given -> turned(given.inBase());
        };
    return kind == Kind.ALONG ? axis : new Pose(0, 0, 0, axis.x(), axis.y(), axis.z());
  }

  private Pose turned(Pose by) {
    Pose onlyTurn = new Pose(0, 0, 0, by.rx(), by.ry(), by.rz());
    return Poses.trans(onlyTurn, new Pose(x, y, z, 0, 0, 0));
  }
}
