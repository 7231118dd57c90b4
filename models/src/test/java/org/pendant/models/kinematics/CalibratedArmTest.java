package org.pendant.models.kinematics;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Random;
import org.ejml.simple.SimpleMatrix;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Calibration;
import org.pendant.models.arm.DhDeltas;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;
import org.pendant.models.pose.StraightLine;
import org.pendant.models.pose.Transforms;

@Tag("slow")
class CalibratedArmTest {
  private static final int CASES = 200;

  private static final List<ArmDescription> SEVERAL =
      List.of(Arms.UR5E, ArmLibrary.load("ur3"), ArmLibrary.load("ur10e"), ArmLibrary.load("ur30"));

  @Test
  void withoutDeltasTheArmIsTheNominalOneToTheLastBit() {
    Random random = new Random(81);
    DhDeltas zero = new DhDeltas(Joints.ZERO, Joints.ZERO, Joints.ZERO, Joints.ZERO);
    for (int n = 0; n < CASES; n++) {
      Joints q = Arms.joints(random);
      Pose flange = new ForwardKinematics(Arms.UR5E).flangePose(q);
      assertEquals(flange, new ForwardKinematics(with(Arms.UR5E, zero)).flangePose(q));
      assertEquals(
          new InverseKinematics(Arms.UR5E).all(flange, q),
          new InverseKinematics(with(Arms.UR5E, zero)).all(flange, q));
    }
  }

  @Test
  void theFlangeIsTheProductOfDenavitHartenbergMatrices() {
    Random random = new Random(82);
    double[][] frames = new double[Joints.COUNT][Transforms.SIZE];
    double[] flange = new double[Transforms.SIZE];
    for (int n = 0; n < CASES; n++) {
      DhDeltas deltas = shifted(random);
      ForwardKinematics forward = new ForwardKinematics(with(Arms.UR5E, deltas));
      Joints q = Arms.joints(random);
      forward.frames(q.toArray(), frames);
      forward.flange(q.toArray(), flange);
      assertArrayEquals(frames[5], flange);
      SimpleMatrix expected = Arms.chain(Arms.UR5E.dh(), deltas, q, Joints.COUNT);
      for (int row = 0; row < 3; row++) {
        assertEquals(expected.get(row, 0), flange[3 * row], 2e-14, q::toString);
        assertEquals(expected.get(row, 1), flange[3 * row + 1], 2e-14, q::toString);
        assertEquals(expected.get(row, 2), flange[3 * row + 2], 2e-14, q::toString);
        assertEquals(expected.get(row, 3), flange[9 + row], 2e-14, q::toString);
      }
    }
  }

  @Test
  void linkFramesLieOnTheAxesOfTheJointsNearThoseOfTheModel() {
    Random random = new Random(90);
    ForwardKinematics model = new ForwardKinematics(Arms.UR5E);
    double[][] frames = new double[Joints.COUNT][Transforms.SIZE];
    double[][] nominal = new double[Joints.COUNT][Transforms.SIZE];
    for (int n = 0; n < CASES; n++) {
      DhDeltas deltas = shifted(random);
      Joints q = Arms.joints(random);
      new ForwardKinematics(with(Arms.UR5E, deltas)).frames(q.toArray(), frames);
      model.frames(q.toArray(), nominal);
      for (int i = 0; i < Joints.COUNT; i++) {
        SimpleMatrix expected = Arms.chain(Arms.UR5E.dh(), deltas, q, i + 1);
        SimpleMatrix axis = expected.extractMatrix(0, 3, 2, 3);
        SimpleMatrix point =
            new SimpleMatrix(3, 1, true, frames[i][9], frames[i][10], frames[i][11]);
        SimpleMatrix off = point.minus(expected.extractMatrix(0, 3, 3, 4));
        double along = off.dot(axis);
        assertEquals(0, off.minus(axis.scale(along)).normF(), 2e-14, q::toString);
        for (int row = 0; row < 3; row++) {
          assertEquals(axis.get(row), frames[i][3 * row + 2], 2e-14, q::toString);
          assertEquals(nominal[i][9 + row], frames[i][9 + row], 0.03, q::toString);
        }
      }
    }
  }

  @Test
  void jacobianAndItsDerivativeAreFiniteDifferences() {
    Random random = new Random(83);
    double step = 1e-5;
    double[] j = new double[Jacobian.SIZE];
    double[] before = new double[Jacobian.SIZE];
    double[] after = new double[Jacobian.SIZE];
    double[] derivative = new double[Jacobian.SIZE];
    for (int n = 0; n < CASES; n++) {
      DhDeltas deltas = shifted(random);
      ForwardKinematics forward = new ForwardKinematics(with(Arms.UR5E, deltas));
      Jacobian jacobian = new Jacobian(with(Arms.UR5E, deltas));
      Joints q = Arms.joints(random);
      Pose offset = Arms.tcp(random);
      jacobian.at(q.toArray(), offset, j);
      for (int i = 0; i < Joints.COUNT; i++) {
        Joints ahead = q.with(i, q.get(i) + step);
        Joints behind = q.with(i, q.get(i) - step);
        Pose difference =
            Poses.sub(forward.tcpPose(ahead, offset), forward.tcpPose(behind, offset));
        jacobian.at(ahead.toArray(), offset, after);
        jacobian.at(behind.toArray(), offset, before);
        jacobian.derivative(q.toArray(), Joints.ZERO.with(i, 1).toArray(), offset, derivative);
        for (int row = 0; row < Pose.SIZE; row++) {
          assertEquals(difference.get(row) / (2 * step), j[6 * row + i], 1e-8, q::toString);
        }
        for (int entry = 0; entry < Jacobian.SIZE; entry++) {
          double expected = (after[entry] - before[entry]) / (2 * step);
          assertEquals(expected, derivative[entry], 1e-8, q::toString);
        }
      }
    }
  }

  @Test
  void solutionsOfAnUsualCalibrationAreExactAndNoneIsMissing() {
    requireAllSolutions(new Random(84), CalibratedArmTest::usual, 0.05);
  }

  @Test
  void solutionsOfLinksShiftedByMetresAreExactAndNoneIsMissing() {
    requireAllSolutions(new Random(85), CalibratedArmTest::shifted, 0.05);
  }

  @Test
  void solutionsOfShiftedAndTiltedLinksAreExactAndNoneIsMissing() {
    requireAllSolutions(new Random(89), CalibratedArmTest::tilted, 0.2);
  }

  private static void requireAllSolutions(Random random, Draw calibration, double bound) {
    for (ArmDescription arm : SEVERAL) {
      for (int n = 0; n < CASES; n++) {
        DhDeltas deltas = calibration.draw(random);
        InverseKinematics inverse = new InverseKinematics(with(arm, deltas));
        Joints q = Arms.regularJoints(arm.dh(), bound, random);
        Pose flange = new ForwardKinematics(with(arm, deltas)).flangePose(q);
        List<Joints> solutions = inverse.all(flange, Arms.joints(random));
        String input = arm.id() + " at " + q + " with " + deltas + " gave " + solutions;
        assertTrue(Arms.contain(solutions, q, 1e-7), input);
        for (Joints solution : solutions) {
          assertTrue(inverse.poseError(solution, flange).within(1e-10, 1e-10), input);
          assertTrue(arm.withinLimits(solution), input);
        }
        for (int i = 0; i < solutions.size(); i++) {
          for (int k = 0; k < i; k++) {
            assertTrue(Arms.turnlessDifference(solutions.get(i), solutions.get(k)) > 1e-6, input);
          }
        }
      }
    }
  }

  @Test
  void jointsAtASingularityAreFoundAgainWhereTheyAre() {
    Random random = new Random(86);
    for (ArmDescription arm : SEVERAL) {
      for (int n = 0; n < CASES; n++) {
        DhDeltas deltas = shifted(random);
        Joints q =
            switch (n % 3) {
              case 0 -> Arms.joints(random).with(2, 0);
              case 1 -> Arms.joints(random).with(4, 0);
              default -> Arms.overTheShoulder(arm.dh(), random);
            };
        Pose flange = new ForwardKinematics(with(arm, deltas)).flangePose(q);
        Joints found = new InverseKinematics(with(arm, deltas)).closest(flange, q).orElseThrow();
        assertEquals(0, found.maxAbsDifference(q), 1e-9, () -> arm.id() + " with " + deltas);
      }
    }
  }

  @Test
  void trackingALineStaysOnItWithoutAJump() {
    Random random = new Random(87);
    double[] transform = new double[Transforms.SIZE];
    for (int n = 0; n < 20; n++) {
      DhDeltas deltas = shifted(random);
      InverseKinematics inverse = new InverseKinematics(with(Arms.UR5E, deltas));
      Joints start = new Joints(0.1, -1.5, 1.2, -1, -1.4, 0.3);
      Pose from = new ForwardKinematics(with(Arms.UR5E, deltas)).flangePose(start);
      Pose to = Poses.interpolate(from, Poses.trans(from, Arms.tcp(random)), 0.2);
      StraightLine line = new StraightLine(from, to);
      double[] q = start.toArray();
      for (int step = 0; step <= 100; step++) {
        Joints before = Joints.of(q);
        line.at(step / 100.0, transform);
        assertTrue(inverse.track(transform, q), to::toString);
        assertTrue(Joints.of(q).maxAbsDifference(before) < 0.1, () -> "jump towards " + to);
        assertTrue(
            inverse.poseError(Joints.of(q), line.at(step / 100.0)).within(1e-10, 1e-10),
            to::toString);
      }
    }
  }

  @Test
  void aPoseOutOfReachIsRefusedWithItsCause() {
    InverseKinematics inverse = new InverseKinematics(with(Arms.UR5E, usual(new Random(88))));
    InverseResult result = inverse.find(Pose.of(2, 0, 0.3, 0, 3.14, 0), Joints.ZERO, 1e-10, 1e-10);
    InverseResult.Unreachable none = assertInstanceOf(InverseResult.Unreachable.class, result);
    assertEquals(InverseResult.Cause.TOO_FAR, none.cause());
    assertTrue(none.leastError().positionM() > 0.5, none::toString);
  }

  private interface Draw {
    DhDeltas draw(Random random);
  }

  private static ArmDescription with(ArmDescription arm, DhDeltas deltas) {
    return arm.withCalibration(Calibration.of(deltas));
  }

  /** Every parameter within 1 mm or 1 mrad. */
  private static DhDeltas usual(Random random) {
    return new DhDeltas(
        within(1e-3, random), within(1e-3, random), within(1e-3, random), within(1e-3, random));
  }

  /** Links up to 5 m away along axes that are parallel to 1 mrad, and back at joint 4. */
  private static DhDeltas shifted(Random random) {
    return shifted(5, random);
  }

  private static DhDeltas shifted(double boundM, Random random) {
    DhDeltas usual = usual(random);
    double d2 = boundM * (2 * random.nextDouble() - 1);
    double d3 = boundM * (2 * random.nextDouble() - 1);
    Joints d = usual.dM();
    return new DhDeltas(
        usual.thetaRad(),
        usual.aM(),
        d.with(1, d2).with(2, d3).with(3, d.q3() - d2 - d3),
        usual.alphaRad());
  }

  /** Links up to 2 m away along axes parallel to 10 mrad only: nominal joints miss by 50 mm. */
  private static DhDeltas tilted(Random random) {
    DhDeltas shifted = shifted(2, random);
    return new DhDeltas(shifted.thetaRad(), shifted.aM(), shifted.dM(), within(1e-2, random));
  }

  private static Joints within(double bound, Random random) {
    double[] values = new double[Joints.COUNT];
    for (int i = 0; i < values.length; i++) {
      values[i] = bound * (2 * random.nextDouble() - 1);
    }
    return Joints.of(values);
  }
}
