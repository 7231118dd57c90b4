package org.pendant.controller.world;

import java.util.OptionalInt;
import org.pendant.cell.HoldLimits;

/** Cup gripper: a vacuum cup, which holds what it is sealed on. */
public final class VacuumGripper extends Gripper {
  /** Rays begin so far inside the cup, m: what it is pressed on may be there. */
  private static final double INSIDE_M = 0.004;

  /** Where rays look, of the radius: near the lip. */
  private static final double LIP = 0.8;

  /** More than it withstands for so many steps, and what it holds comes off. */
  private static final int COMES_OFF_STEPS = 5;

  /** Uniform pressure on a disc, of its radius: lever of its friction against turning. */
  private static final double TURNING = 2.0 / 3;

  private final GripperSetup.Grip.Cup cup;

  VacuumGripper(GripperSetup setup, GripperSetup.Grip.Cup cup, ArmBodies arm, FreeBodies among) {
    super(setup, arm, among);
    this.cup = cup;
  }

  /** Whether there is a body that it seals on. */
  public boolean seals() {
    return placed() && (holds() || sealed().isPresent());
  }

  /** Holds what it seals on. */
  public void grip() {
    OptionalInt body = holds() || !placed() ? OptionalInt.empty() : sealed();
    if (body.isPresent()) {
      double forceN = cup.forceN();
      double shearN = frictionWith(body.getAsInt()) * forceN;
      holds.add(
          bodies.hold(
              body.getAsInt(),
              frame12,
              new HoldLimits(
                  2,
                  forceN,
                  Double.MAX_VALUE,
                  shearN,
                  TURNING * cup.radiusM() * shearN,
                  cup.radiusM() * forceN),
              arm.tools()));
    }
  }

  /** Lets go what is drawn at with more than it withstands; answers whether it did. */
  public boolean losesWhatIsTooMuch() {
    if (holds() && holds.getFirst().overloadedSteps() >= COMES_OFF_STEPS) {
      release();
      return true;
    }
    return false;
  }

  private OptionalInt sealed() {
    double[] along = axis(2);
    double r = LIP * cup.radiusM();
    int first = among.firstAlong(at(0, 0, -INSIDE_M), along, INSIDE_M + cup.reachM());
    if (first < 0) {
      return OptionalInt.empty();
    }
    for (int i = 0; i < 4; i++) {
      double[] from = at(r * (i % 2 == 0 ? i - 1 : 0), r * (i % 2 == 1 ? i - 2 : 0), -INSIDE_M);
      if (bodies.enters(first, from, along, INSIDE_M + cup.reachM()) > INSIDE_M + cup.reachM()) {
        return OptionalInt.empty();
      }
    }
    return OptionalInt.of(first);
  }
}
