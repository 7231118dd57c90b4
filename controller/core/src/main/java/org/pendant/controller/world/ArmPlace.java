package org.pendant.controller.world;

import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Transforms;

/**
 * Arm place: where the base of an arm stands in the frame of its cell. One that stands at the
 * origin changes no number. What it answers is overwritten by the next call; for one thread.
 */
final class ArmPlace {
  private final boolean origin;
  private final double[] base12 = new double[Transforms.SIZE];
  private final double[] toBase12 = new double[Transforms.SIZE];
  private final double[] transform12 = new double[Transforms.SIZE];
  private final double[][] frames = new double[Joints.COUNT][Transforms.SIZE];
  private final double[] twist6 = new double[6];

  ArmPlace(Pose baseInCell) {
    origin = baseInCell.equals(Pose.ZERO);
    Transforms.of(baseInCell, base12);
    Transforms.invert(base12, toBase12);
  }

  /** Whether the frame of the base is that of the cell. */
  boolean origin() {
    return origin;
  }

  /** The base in the cell. */
  double[] baseInCell12() {
    return base12;
  }

  /** A transformation of the base frame in that of the cell. */
  double[] inCell(double[] inBase12) {
    if (origin) {
      return inBase12;
    }
    Transforms.multiply(base12, inBase12, transform12);
    return transform12;
  }

  /** Frames of links in that of the cell. */
  double[][] inCell(double[][] inBase) {
    if (origin) {
      return inBase;
    }
    for (int i = 0; i < frames.length; i++) {
      Transforms.multiply(base12, inBase[i], frames[i]);
    }
    return frames;
  }

  /** A velocity and an angular velocity along the axes of the cell. */
  double[] twistInCell(double[] inBase6) {
    if (origin) {
      return inBase6;
    }
    turn(base12, inBase6, 0, twist6);
    turn(base12, inBase6, 3, twist6);
    return twist6;
  }

  /** Turns a force and a torque along the axes of the cell to those of the base, in place. */
  void turnToBase(double[] wrench6) {
    if (origin) {
      return;
    }
    turn(toBase12, wrench6, 0, twist6);
    turn(toBase12, wrench6, 3, twist6);
    System.arraycopy(twist6, 0, wrench6, 0, 6);
  }

  /** Takes a transformation in the cell to the base frame, in place. */
  void takeToBase(double[] inCell12) {
    if (!origin) {
      Transforms.multiply(toBase12, inCell12, transform12);
      System.arraycopy(transform12, 0, inCell12, 0, Transforms.SIZE);
    }
  }

  private static void turn(double[] by12, double[] vector, int at, double[] to) {
    for (int row = 0; row < 3; row++) {
      to[at + row] =
          by12[3 * row] * vector[at]
              + by12[3 * row + 1] * vector[at + 1]
              + by12[3 * row + 2] * vector[at + 2];
    }
  }

  /** A pose in the cell as it is in the base frame. */
  Pose inBase(Pose inCell) {
    if (origin) {
      return inCell;
    }
    double[] of = new double[Transforms.SIZE];
    double[] seen = new double[Transforms.SIZE];
    Transforms.of(inCell, of);
    Transforms.multiply(toBase12, of, seen);
    return Transforms.toPose(seen);
  }

  /** A point in the base frame as it is in the cell, m. */
  Vector3 inCell(Vector3 inBaseM) {
    if (origin) {
      return inBaseM;
    }
    Pose at = inCell(new Pose(inBaseM.x(), inBaseM.y(), inBaseM.z(), 0, 0, 0));
    return new Vector3(at.x(), at.y(), at.z());
  }

  /** A pose in the base frame as it is in the cell. */
  Pose inCell(Pose inBase) {
    if (origin) {
      return inBase;
    }
    double[] of = new double[Transforms.SIZE];
    double[] seen = new double[Transforms.SIZE];
    Transforms.of(inBase, of);
    Transforms.multiply(base12, of, seen);
    return Transforms.toPose(seen);
  }
}
