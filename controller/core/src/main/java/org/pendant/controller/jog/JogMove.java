package org.pendant.controller.jog;

import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;

/** Goal of a jog: where the arm moves as long as a button is held. */
public sealed interface JogMove {

  /**
   * Turns one joint, at most to the end of its range.
   *
   * @param joint 0 for the base to 5 for wrist 3
   * @param direction 1 or -1
   */
  record TurnJoint(int joint, int direction) implements JogMove {
    /**
     * Checks the numbers.
     *
     * @throws IllegalArgumentException if one is another
     */
    public TurnJoint {
      if (joint < 0 || joint >= Joints.COUNT) {
        throw new IllegalArgumentException("joint is " + joint + ", must be 0 to 5");
      }
      if (direction != 1 && direction != -1) {
        throw new IllegalArgumentException("direction is " + direction + ", must be 1 or -1");
      }
    }
  }

  /** Moves the TCP in a straight line, or turns the tool about an axis through the TCP. */
  record MoveTool(JogDirection direction, JogFrame frame) implements JogMove {}

  /**
   * Moves all joints in proportion to a goal.
   *
   * @param goalRad joint positions, rad
   */
  record ToJoints(Joints goalRad) implements JogMove {}

  /** Moves all joints in proportion to the nearest joint positions with this pose of the TCP. */
  record ToPose(Pose tcpInBase) implements JogMove {}

  /** Moves the TCP to a pose in a straight line, turning evenly. */
  record StraightTo(Pose tcpInBase) implements JogMove {}
}
