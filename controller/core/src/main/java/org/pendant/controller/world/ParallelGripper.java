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
 * way; what lies between both and is pressed for a moment is held by friction.
 */
public final class ParallelGripper extends Gripper {
  /** Fingers are so thick, m. */
  private static final double THICK_M = 0.008;

  /** Where surfaces are looked for: so many rays in both directions of a pad. */
  private static final int RAYS = 5;

  /** Pads may be so deep in what they push, m. */
  private static final double MAX_DEPTH_M = 0.002;

  /** Pads press so deep on what they close on, to turn it straight, until they hold it, m. */
  private static final double SQUEEZE_M = 0.0003;

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

  /** Of the bodies between the fingers: from where to where they reach along y, m. */
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
    if (holds()) {
      // as in the frame before: what is held goes along
      fromM = heldFromM;
      toM = heldToM;
    } else if (!placed() || !look(openingM)) {
      return 0;
    }
    double widthM = toM - fromM;
    double depthM = Math.min(MAX_DEPTH_M, forceN / Material.DEFAULT.stiffnessNPerM());
    double pushes = 2 * (Math.max(toM, -fromM) - depthM);
    return Math.clamp(Math.max(widthM, pushes), 0, openingM);
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
      if (look(body, openingM)
          && fromM <= TOUCH_M - openingM / 2
          && toM >= openingM / 2 - TOUCH_M
          && !bodies.held(body)) {
        holds.add(bodies.hold(body, frame12, limits(body, forceN), arm.tools()));
        reachHeld();
      }
    }
  }

  private void reachHeld() {
    heldFromM = Math.min(heldFromM, fromM);
    heldToM = Math.max(heldToM, toM);
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
    double from = Double.POSITIVE_INFINITY;
    double to = Double.NEGATIVE_INFINITY;
    for (int body : candidates(openingM)) {
      if (look(body, openingM)) {
        from = Math.min(from, fromM);
        to = Math.max(to, toM);
      }
    }
    fromM = from;
    toM = to;
    return from < to;
  }

  /** Finds from where to where a body reaches between the fingers; whether it is there. */
  private boolean look(int body, double openingM) {
    double half = openingM / 2 + MAX_DEPTH_M + TOUCH_M;
    double[] along = axis(1);
    double[] back = minus(along);
    fromM = Double.POSITIVE_INFINITY;
    toM = Double.NEGATIVE_INFINITY;
    for (int i = 0; i < RAYS; i++) {
      double x = 0.9 * pads.widthM() * ((double) i / (RAYS - 1) - 0.5);
      for (int j = 0; j < RAYS; j++) {
        double z = 0.9 * pads.lengthM() * ((double) j / (RAYS - 1) - 0.5);
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
    double squeezeM = pressedFrames > 0 && !holds() ? SQUEEZE_M : 0;
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
