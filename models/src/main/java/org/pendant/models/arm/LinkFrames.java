package org.pendant.models.arm;

import java.util.List;

/**
 * Link frames of one arm, from the shoulder to the third wrist: whole frames, as ROS keeps a
 * calibration, where Denavit-Hartenberg parameters have four numbers a joint.
 *
 * <p>The flange is {@code F_1 Rz(q_1) F_2 Rz(q_2) ... F_6 Rz(q_6)} in the controller's base frame,
 * of which the axis of the first joint is the z axis; the axes of the flange are those of the last
 * frame.
 *
 * @param frames six, in the order of {@link #NAMES}
 */
public record LinkFrames(List<LinkFrame> frames) implements LinkGeometry {
  /** Names of the frames in ROS. */
  public static final List<String> NAMES =
      List.of("shoulder", "upper_arm", "forearm", "wrist_1", "wrist_2", "wrist_3");

  /**
   * Checks the frames and copies the list.
   *
   * @throws IllegalArgumentException if there are not six, or the first joint does not turn about
   *     the z axis of the base
   */
  public LinkFrames {
    frames = List.copyOf(frames);
    if (frames.size() != Joints.COUNT) {
      throw new IllegalArgumentException(
          "link frames: has " + frames.size() + " frames, must have " + Joints.COUNT);
    }
    LinkFrame shoulder = frames.getFirst();
    requireZero("x", shoulder.xM(), "m");
    requireZero("y", shoulder.yM(), "m");
    requireZero("roll", shoulder.rollRad(), "rad");
    requireZero("pitch", shoulder.pitchRad(), "rad");
  }

  /** Frames of a model without a calibration, as ROS chooses them. */
  public static LinkFrames of(DhLengths dh) {
    double quarter = Math.PI / 2;
    return new LinkFrames(
        List.of(
            new LinkFrame(0, 0, dh.d1(), 0, 0, 0),
            new LinkFrame(0, 0, 0, quarter, 0, 0),
            new LinkFrame(dh.a2(), 0, 0, 0, 0, 0),
            new LinkFrame(dh.a3(), 0, dh.d4(), 0, 0, 0),
            new LinkFrame(0, -dh.d5(), 0, quarter, 0, 0),
            new LinkFrame(0, dh.d6(), 0, quarter, Math.PI, Math.PI)));
  }

  private static void requireZero(String name, double value, String unit) {
    if (value != 0) {
      throw new IllegalArgumentException(
          "shoulder: "
              + name
              + " is "
              + value
              + " "
              + unit
              + ", must be 0: the first joint turns about the z axis of the base");
    }
  }
}
