package org.pendant.controller.world;

import java.util.List;
import org.pendant.cell.BodyDescription;
import org.pendant.cell.BodyHold;
import org.pendant.cell.BodyShape;
import org.pendant.cell.BodySurface;
import org.pendant.cell.HoldLimits;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Transforms;
import org.pendant.models.time.FrameTime;

/**
 * Finger gripper: two fingers that close along y. Their pads are bodies that push what is in their
 * way; what lies between both, or has walls outside both where they open, and is pressed for a
 * moment is held by friction.
 */
public final class ParallelGripper extends Gripper {
  private static final double THICK_M = GripperSetup.FINGER_M;

  /** Where surfaces are looked for: so many rays in both directions of a pad. */
  private static final int RAYS = 5;

  /** Pads may be so deep in what they push, m. */
  private static final double MAX_DEPTH_M = 0.002;

  /** Pads press so deep on what they close on, to turn it straight, until they hold it, m. */
  private static final double SQUEEZE_M = 0.0003;

  /** Walls around the fingers are looked for up to so far outside, m. */
  private static final double REACH_M = 0.05;

  /** A pad touches what is as near as that, m. */
  private static final double TOUCH_M = 0.001;

  /** After so many frames of pressing they hold what lies between them. */
  private static final int HOLD_FRAMES = 10;

  /** Uniform pressure on a disc, of its radius: lever of its friction against turning. */
  private static final double TURNING = 2.0 / 3;

  private final GripperSetup.Grip.Pads pads;
  private final int[] pad = new int[2];
  private final double[] pad12 = new double[Transforms.SIZE];
  private final double[] padTwist6 = new double[6];
  private final double[] padWrench6 = new double[6];
  private double openingM;
  private double closingMPerS;
  private int pressedFrames;

  /** Whether the fingers open, and press on walls around them. */
  private boolean inside;

  /**
   * Of the bodies between the fingers: from where to where they reach along y, m. Of those around
   * them: from where to where they leave room.
   */
  private double fromM;

  private double toM;

  /** The same of those that they hold. */
  private double heldFromM;

  private double heldToM;

  ParallelGripper(
      GripperSetup setup,
      GripperSetup.Grip.Pads pads,
      double strokeM,
      ArmBodies arm,
      FreeBodies among) {
    super(setup, arm, among);
    this.pads = pads;
    openingM = strokeM;
    for (int i = 0; i < 2; i++) {
      pad[i] =
          arm.addTool(
              BodyDescription.kinematic(
                  "pad\n" + among.bodies().size(),
                  new BodyShape.Box(pads.widthM(), THICK_M, pads.lengthM()),
                  Pose.ZERO,
                  new BodySurface(setup.friction(), 0, BodySurface.STIFFNESS.most())));
      bodies.setPresent(pad[i], false);
    }
  }

  /**
   * The opening at which fingers that close from here meet a body, m; 0 where none is between them.
   *
   * @param openingM how far they are open
   * @param forceN how hard they press
   */
  public double closesToM(double openingM, double forceN) {
    press(false);
    if (holds()) {
      // as in the frame before: what is held goes along
      fromM = heldFromM;
      toM = heldToM;
    } else if (!placed() || !look(openingM)) {
      return 0;
    }
    double widthM = toM - fromM;
    double pushes = 2 * (Math.max(toM, -fromM) - depthM(forceN));
    return Math.clamp(Math.max(widthM, pushes), 0, openingM);
  }

  /**
   * The opening at which fingers that open from here meet the walls of a body around them, m;
   * infinite where there is none.
   *
   * @param openingM how far they are open
   * @param forceN how hard they press
   */
  public double opensToM(double openingM, double forceN) {
    press(true);
    if (holds()) {
      fromM = heldFromM;
      toM = heldToM;
    } else if (!placed() || !look(openingM)) {
      return Double.POSITIVE_INFINITY;
    }
    double pushes = 2 * (Math.min(toM, -fromM) + depthM(forceN));
    return Math.max(openingM, Math.min(toM - fromM, pushes) - 2 * THICK_M);
  }

  /** They press on what is around them from now on, or on what is between them. */
  private void press(boolean outwards) {
    if (inside != outwards) {
      release();
      pressedFrames = 0;
      inside = outwards;
    }
  }

  private static double depthM(double forceN) {
    return Math.min(MAX_DEPTH_M, forceN / Material.DEFAULT.stiffnessNPerM());
  }

  /** The fingers are that far open in this frame, and press that hard on what they have met. */
  public void press(double openingM, double forceN) {
    closingMPerS = (this.openingM - openingM) / FrameTime.FRAME_S;
    this.openingM = openingM;
    pressedFrames = forceN > 0 ? pressedFrames + 1 : 0;
    if (pressedFrames == 0) {
      release();
    } else if (pressedFrames >= HOLD_FRAMES && placed()) {
      hold(forceN);
    }
  }

  private void hold(double forceN) {
    heldFromM = Double.POSITIVE_INFINITY;
    heldToM = Double.NEGATIVE_INFINITY;
    for (int i = holds.size() - 1; i >= 0; i--) {
      BodyHold hold = holds.get(i);
      if (look(hold.body(), openingM)) {
        hold.withstand(limits(hold.body(), forceN));
        reachHeld();
      } else {
        bodies.release(hold);
        holds.remove(i);
      }
    }
    if (!holds.isEmpty()) {
      return;
    }
    for (int body : candidates(openingM)) {
      if (look(body, openingM) && touch(openingM) && !bodies.held(body)) {
        holds.add(bodies.hold(body, frame12, limits(body, forceN), arm.tools()));
        reachHeld();
      }
    }
  }

  /** Whether both fingers touch what was looked at last. */
  private boolean touch(double openingM) {
    double half = openingM / 2;
    return inside
        ? fromM >= -half - THICK_M - TOUCH_M && toM <= half + THICK_M + TOUCH_M
        : fromM <= TOUCH_M - half && toM >= half - TOUCH_M;
  }

  private void reachHeld() {
    boolean first = heldFromM == Double.POSITIVE_INFINITY;
    heldFromM = first ? fromM : inside ? Math.max(heldFromM, fromM) : Math.min(heldFromM, fromM);
    heldToM = first ? toM : inside ? Math.min(heldToM, toM) : Math.max(heldToM, toM);
  }

  private HoldLimits limits(int body, double forceN) {
    double shearN = 2 * frictionWith(body) * forceN;
    double halfM = Math.min(pads.widthM(), pads.lengthM()) / 2;
    return new HoldLimits(
        1,
        Double.MAX_VALUE,
        Double.MAX_VALUE,
        shearN,
        TURNING * halfM * shearN,
        2 * halfM * forceN);
  }

  private List<Integer> candidates(double openingM) {
    double[] middle = at(0, 0, 0);
    return among.near(middle, openingM / 2 + pads.widthM() + pads.lengthM());
  }

  /** Finds from where to where all bodies between the fingers reach; whether there are any. */
  private boolean look(double openingM) {
    boolean any = false;
    double from = 0;
    double to = 0;
    for (int body : candidates(openingM)) {
      if (look(body, openingM)) {
        from = !any ? fromM : inside ? Math.max(from, fromM) : Math.min(from, fromM);
        to = !any ? toM : inside ? Math.min(to, toM) : Math.max(to, toM);
        any = true;
      }
    }
    fromM = from;
    toM = to;
    return any;
  }

  private boolean look(int body, double openingM) {
    return inside ? lookAround(body, openingM) : lookBetween(body, openingM);
  }

  /** Finds from where to where a body leaves room around the fingers; whether it has both walls. */
  private boolean lookAround(int body, double openingM) {
    double start = (openingM + THICK_M) / 2;
    double[] along = axis(1);
    double[] back = minus(along);
    fromM = Double.NEGATIVE_INFINITY;
    toM = Double.POSITIVE_INFINITY;
    for (int i = 0; i < RAYS; i++) {
      double x = across(i, pads.widthM());
      for (int j = 0; j < RAYS; j++) {
        double z = across(j, pads.lengthM());
        double forth = bodies.enters(body, at(x, start, z), along, REACH_M);
        double reverse = bodies.enters(body, at(x, -start, z), back, REACH_M);
        toM = Math.min(toM, start + forth);
        fromM = Math.max(fromM, -start - reverse);
      }
    }
    return toM < Double.POSITIVE_INFINITY && fromM > Double.NEGATIVE_INFINITY;
  }

  /** Where a ray is in a side of a pad, m. */
  private static double across(int ray, double sideM) {
    return 0.9 * sideM * ((double) ray / (RAYS - 1) - 0.5);
  }

  /** Finds from where to where a body reaches between the fingers; whether it is there. */
  private boolean lookBetween(int body, double openingM) {
    double half = openingM / 2 + MAX_DEPTH_M + TOUCH_M;
    double[] along = axis(1);
    double[] back = minus(along);
    fromM = Double.POSITIVE_INFINITY;
    toM = Double.NEGATIVE_INFINITY;
    for (int i = 0; i < RAYS; i++) {
      double x = across(i, pads.widthM());
      for (int j = 0; j < RAYS; j++) {
        double z = across(j, pads.lengthM());
        double forth = bodies.enters(body, at(x, -half, z), along, 2 * half);
        double reverse = bodies.enters(body, at(x, half, z), back, 2 * half);
        if (forth < 2 * half && reverse < 2 * half) {
          fromM = Math.min(fromM, forth - half);
          toM = Math.max(toM, half - reverse);
        }
      }
    }
    return fromM < toM;
  }

  @Override
  void moved() {
    double squeezeM = pressedFrames > 0 && !holds() ? inside ? -SQUEEZE_M : SQUEEZE_M : 0;
    for (int side = 0; side < 2; side++) {
      double sign = side == 0 ? -1 : 1;
      double[] at = at(0, sign * ((openingM + THICK_M) / 2 - squeezeM), 0);
      System.arraycopy(frame12, 0, pad12, 0, 9);
      System.arraycopy(at, 0, pad12, 9, 3);
      double armX = at[0] - frame12[9];
      double armY = at[1] - frame12[10];
      double armZ = at[2] - frame12[11];
      System.arraycopy(twist6, 0, padTwist6, 0, 6);
      padTwist6[0] += twist6[4] * armZ - twist6[5] * armY;
      padTwist6[1] += twist6[5] * armX - twist6[3] * armZ;
      padTwist6[2] += twist6[3] * armY - twist6[4] * armX;
      for (int k = 0; k < 3; k++) {
        padTwist6[k] -= sign * closingMPerS / 2 * frame12[3 * k + 1];
      }
      bodies.setPresent(pad[side], true);
      bodies.moveKinematic(pad[side], pad12, padTwist6);
    }
  }

  @Override
  void addWrench(double[] flange12, double[] felt6) {
    super.addWrench(flange12, felt6);
    for (int side = 0; side < 2; side++) {
      bodies.pose(pad[side], pad12);
      bodies.wrench(pad[side], padWrench6);
      add(padWrench6, pad12, flange12, felt6);
    }
  }

  @Override
  boolean busy() {
    return super.busy() || closingMPerS != 0;
  }
}
