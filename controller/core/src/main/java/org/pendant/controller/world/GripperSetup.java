package org.pendant.controller.world;

import java.util.Optional;
import org.pendant.models.json.Range;
import org.pendant.models.pose.Pose;

/**
 * Gripper setup: the part of a gripper that touches what it grips.
 *
 * @param atInFlange where its middle is, in the flange's frame: z goes on to what it grips, fingers
 *     close along y; empty for the active tool centre point
 * @param grip what it grips with
 * @param friction its coefficient of friction, 0 to 2; with a body it is the geometric mean of both
 */
public record GripperSetup(Optional<Pose> atInFlange, Grip grip, double friction) {
  /** What friction may be. */
  public static final Range FRICTION = Material.FRICTION;

  /** Rubber. */
  public static final double RUBBER = 0.8;

  /** Fingers are so thick, m. */
  public static final double FINGER_M = 0.008;

  /** What a gripper grips with. */
  public sealed interface Grip {
    /** What lengths of a gripper may be. */
    Range LENGTH = new Range(0.001, 0.5, "m");

    /** How hard a cup may hold. */
    Range FORCE = new Range(1, 1000, "N");

    /**
     * Two fingers with flat pads.
     *
     * @param widthM of a pad across the way of the fingers, along x, m
     * @param lengthM of a pad along z, m
     */
    record Pads(double widthM, double lengthM) implements Grip {
      /** Those of a common gripper. */
      public static final Pads DEFAULT = new Pads(0.022, 0.022);

      /** Checks the numbers. */
      public Pads {
        LENGTH.require("width", widthM);
        LENGTH.require("length", lengthM);
      }
    }

    /**
     * A vacuum cup.
     *
     * @param radiusM of its lip, m
     * @param reachM how far from it a surface may be that it seals on, m
     * @param forceN how hard it holds, N
     */
    record Cup(double radiusM, double reachM, double forceN) implements Grip {
      /** That of a common gripper. */
      public static final Cup DEFAULT = new Cup(0.015, 0.005, 60);

      /** Checks the numbers. */
      public Cup {
        LENGTH.require("radius", radiusM);
        LENGTH.require("reach", reachM);
        FORCE.require("force", forceN);
      }
    }
  }

  /** Checks the friction. */
  public GripperSetup {
    FRICTION.require("friction", friction);
  }

  /** Fingers at the tool centre point. */
  public static final GripperSetup FINGERS =
      new GripperSetup(Optional.empty(), Grip.Pads.DEFAULT, RUBBER);

  /** A cup at the tool centre point. */
  public static final GripperSetup CUP =
      new GripperSetup(Optional.empty(), Grip.Cup.DEFAULT, RUBBER);
}
