package org.pendant.recording.compare;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.pendant.controller.quantity.StateQuantity;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.kinematics.ForwardKinematics;

class RunComparisonTest {
  private static final double SPEED_RAD_PER_S = 1.05;
  private static final double ACCELERATION_RAD_PER_S2 = 2.1;
  private static final double MOVE_RAD = 1.2;
  private static final ForwardKinematics KINEMATICS =
      new ForwardKinematics(ArmLibrary.load("ur3e"));
  private static final List<StateQuantity> QUANTITIES =
      List.of(
          SampledQuantity.TARGET_Q,
          SampledQuantity.TARGET_QD,
          SampledQuantity.ACTUAL_Q,
          SampledQuantity.ACTUAL_QD,
          SampledQuantity.TARGET_CURRENT,
          SampledQuantity.CURRENT,
          SampledQuantity.TCP_OFFSET);

  /** Position on a trapezoid that starts at 0, in rad. */
  private static double position(double timeS) {
    double rampS = SPEED_RAD_PER_S / ACCELERATION_RAD_PER_S2;
    double wholeS = rampS + MOVE_RAD / SPEED_RAD_PER_S;
    double t = Math.clamp(timeS, 0, wholeS);
    if (t < rampS) {
      return 0.5 * ACCELERATION_RAD_PER_S2 * t * t;
    }
    if (t < wholeS - rampS) {
      return SPEED_RAD_PER_S * (t - rampS / 2);
    }
    double left = wholeS - t;
    return MOVE_RAD - 0.5 * ACCELERATION_RAD_PER_S2 * left * left;
  }

  private static double speed(double timeS) {
    double rampS = SPEED_RAD_PER_S / ACCELERATION_RAD_PER_S2;
    double wholeS = rampS + MOVE_RAD / SPEED_RAD_PER_S;
    double flank = Math.min(timeS, wholeS - timeS) * ACCELERATION_RAD_PER_S2;
    return Math.clamp(flank, 0, SPEED_RAD_PER_S);
  }

  /** A move that begins at {@code startS}, with drives that lag by {@code lagS}. */
  private static Samples move(
      double periodS, double firstS, double endS, double startS, double lagS) {
    Samples.Builder builder = new Samples.Builder(QUANTITIES);
    double[] row = new double[QUANTITIES.stream().mapToInt(StateQuantity::size).sum()];
    int rows = (int) Math.round((endS - firstS) / periodS);
    for (int i = 0; i <= rows; i++) {
      double timeS = firstS + i * periodS;
      double t = timeS - startS;
      for (int joint = 0; joint < 6; joint++) {
        double scale = joint == 5 ? 0 : 1 - 0.15 * joint;
        row[joint] = scale * position(t);
        row[6 + joint] = scale * speed(t);
        row[12 + joint] = scale * (position(t) - lagS * speed(t));
        row[18 + joint] = scale * speed(t);
        row[24 + joint] = 0.2;
        row[30 + joint] = 0.2 + lagS;
      }
      builder.add(timeS, row);
    }
    return builder.build();
  }

  private static Difference.Figure figure(RunComparison comparison, String name) {
    return comparison.differences().stream()
        .filter(each -> each.name().equals(name))
        .map(Difference.Figure.class::cast)
        .findFirst()
        .orElseThrow();
  }

  @Test
  void anyShiftIsRecoveredWhateverTheSampling() {
    long seed = 5;
    Random random = new Random(seed);
    for (int i = 0; i < 40; i++) {
      double periodS = List.of(0.002, 0.008, 0.01, 0.02, 0.04).get(random.nextInt(5));
      double startS = 0.2 + random.nextDouble();
      double shiftS = 20 * random.nextDouble() - 10;
      Samples recorded = move(periodS, 0, 3.2, startS, 0);
      Samples pendant = move(0.002, shiftS, shiftS + 4, startS + shiftS, 0);

      RunComparison comparison = RunComparison.of(recorded, pendant, KINEMATICS);

      String input = "seed " + seed + ", case " + i + ", every " + periodS + " s";
      assertEquals(shiftS, comparison.shiftS(), 1e-4, input);
      assertEquals(0, figure(comparison, "duration").error(), 1e-3, input);
      assertEquals(0, comparison.size("path-max").orElseThrow(), 1e-3, input);
    }
  }

  @Test
  void aRecordingThatBeginsInMotionIsAlignedAsWell() {
    Samples pendant = move(0.002, 0, 4, 1, 0);
    Samples recorded = move(0.04, 0.8, 3, 0, 0);

    RunComparison comparison = RunComparison.of(recorded, pendant, KINEMATICS);

    assertEquals(1, comparison.shiftS(), 1e-4);
    assertTrue(comparison.size("duration").isEmpty());
    assertTrue(comparison.notes().toString().contains("begins in motion"));
  }

  @Test
  void speedsAreWorkedOutWhereThereAreNone() {
    Samples whole = move(0.002, 0, 3, 0.5, 0);
    Samples.Builder positions = new Samples.Builder(List.of(SampledQuantity.ACTUAL_Q));
    Random noise = new Random(3);
    for (int row = 0; row < whole.rows(); row++) {
      double[] q = whole.values(SampledQuantity.ACTUAL_Q, row);
      for (int i = 0; i < q.length; i++) {
        q[i] += 15e-6 * noise.nextGaussian();
      }
      positions.add(whole.timeS(row), q);
    }
    Samples recorded = StartOfRun.withSpeeds(positions.build());

    RunComparison comparison = RunComparison.of(recorded, move(0.002, 0, 4, 1, 0), KINEMATICS);

    assertEquals(0.5, comparison.shiftS(), 1e-3);
    assertEquals(0, figure(comparison, "duration").error(), 0.01);
    assertEquals(0, comparison.size("actual_qd").orElseThrow(), 0.01);
  }

  @Test
  void aRecordingThatBeginsWithTheFirstFrameOfAMoveBeginsWhereTheArmWas() {
    Samples recorded = move(0.002, 0.502, 3, 0.5, 0);

    assertTrue(StartOfRun.atRest(recorded));
    assertEquals(
        recorded.value(SampledQuantity.TARGET_Q, 0, 0), StartOfRun.positionRad(recorded).get(0));
  }

  @Test
  void lagAndCurrentErrorOfBothAreTold() {
    RunComparison comparison =
        RunComparison.of(move(0.008, 0, 3, 0.5, 0.0005), move(0.002, 0, 4, 1, 0.002), KINEMATICS);

    Difference.Figure lag = figure(comparison, "lag_1");
    assertEquals(0.5, lag.recorded(), 1e-3);
    assertEquals(2, lag.pendant(), 1e-3);
    assertEquals(1.5, lag.error(), 1e-3);
    assertEquals(0.0005, figure(comparison, "current-error_0").recorded(), 1e-9);
    assertEquals(1.5, comparison.size("lag").orElseThrow(), 1e-3);
    assertTrue(comparison.size("lag_5").isEmpty(), "a joint that does not move has no lag");
  }

  @Test
  void aLongerMoveIsALongerDuration() {
    Samples pendant = move(0.002, 0, 4, 1, 0);
    Samples.Builder slower = new Samples.Builder(QUANTITIES);
    Samples original = move(0.002, 0, 3, 0.5, 0);
    double stretch = 1.05;
    for (int row = 0; row < original.rows(); row++) {
      double[] all =
          QUANTITIES.stream()
              .flatMapToDouble(
                  each -> java.util.Arrays.stream(original.values(each, original.rowBefore(0))))
              .toArray();
      int at = 0;
      for (StateQuantity each : QUANTITIES) {
        for (double value : original.values(each, row)) {
          all[at++] = each.equals(SampledQuantity.TARGET_QD) ? value / stretch : value;
        }
      }
      slower.add(stretch * original.timeS(row), all);
    }

    RunComparison comparison = RunComparison.of(slower.build(), pendant, KINEMATICS);

    double wholeS = MOVE_RAD / SPEED_RAD_PER_S + SPEED_RAD_PER_S / ACCELERATION_RAD_PER_S2;
    Difference.Figure duration = figure(comparison, "duration");
    assertEquals(wholeS * stretch, duration.recorded(), 0.01);
    assertTrue(duration.error() < -0.03, duration.toString());
  }
}
