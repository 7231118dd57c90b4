package org.pendant.models.kinematics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Calibration;
import org.pendant.models.arm.DhDeltas;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;

class CalibrationEstimateTest {
  private static Joints within(double bound, Random random) {
    double[] values = new double[Joints.COUNT];
    for (int i = 0; i < values.length; i++) {
      values[i] = bound * (2 * random.nextDouble() - 1);
    }
    return Joints.of(values);
  }

  private static ArmDescription drawn(ArmDescription arm, Random random) {
    DhDeltas deltas =
        new DhDeltas(
            within(2e-3, random),
            within(1e-3, random).with(5, 0),
            within(1e-3, random),
            within(2e-3, random).with(5, 0));
    return arm.withCalibration(Calibration.of(deltas));
  }

  private static List<MeasuredPose> measured(
      ArmDescription arm, int count, double noise, Random random) {
    ForwardKinematics forward = new ForwardKinematics(arm);
    List<MeasuredPose> measured = new ArrayList<>();
    for (int n = 0; n < count; n++) {
      Joints q = Arms.joints(random);
      Pose pose = forward.flangePose(q);
      measured.add(
          new MeasuredPose(
              q,
              new Pose(
                  pose.x() + noise * random.nextGaussian(),
                  pose.y() + noise * random.nextGaussian(),
                  pose.z() + noise * random.nextGaussian(),
                  pose.rx(),
                  pose.ry(),
                  pose.rz())));
    }
    return measured;
  }

  @Test
  void posesWithoutErrorsGiveTheArmThatTheyWereTakenFrom() {
    Random random = new Random(96);
    for (String id : List.of("ur3e", "ur5", "ur10e", "ur30")) {
      ArmDescription model = ArmLibrary.load(id);
      ArmDescription truth = drawn(model, random);
      CalibrationEstimate.Result.Estimated found =
          assertInstanceOf(
              CalibrationEstimate.Result.Estimated.class,
              CalibrationEstimate.of(model, measured(truth, 20, 0, random)));
      ArmDescription estimated = model.withCalibration(Calibration.of(found.deltas()));
      List<MeasuredPose> others = measured(truth, 200, 0, random);
      PoseResiduals before = PoseResiduals.of(model, others);
      PoseResiduals after = PoseResiduals.of(estimated, others);
      assertTrue(before.meanM() > 5e-4, () -> id + " " + before);
      assertTrue(after.maxM() < 1e-9 && after.maxRad() < 1e-9, () -> id + " " + after);
      assertTrue(found.condition() < 10, () -> id + " " + found.condition());
    }
  }

  @Test
  void errorsOfTheInstrumentAverageOut() {
    Random random = new Random(97);
    ArmDescription model = ArmLibrary.load("ur5e");
    ArmDescription truth = drawn(model, random);
    CalibrationEstimate.Result.Estimated found =
        assertInstanceOf(
            CalibrationEstimate.Result.Estimated.class,
            CalibrationEstimate.of(model, measured(truth, 200, 1e-4, random)));
    ArmDescription estimated = model.withCalibration(Calibration.of(found.deltas()));
    PoseResiduals after = PoseResiduals.of(estimated, measured(truth, 200, 0, random));
    assertTrue(after.meanM() < 5e-5, after::toString);
  }

  @Test
  void tooFewPosesAreRefused() {
    ArmDescription model = ArmLibrary.load("ur5e");
    CalibrationEstimate.Result.Refused refused =
        assertInstanceOf(
            CalibrationEstimate.Result.Refused.class,
            CalibrationEstimate.of(model, measured(model, 7, 0, new Random(98))));
    assertEquals("has 7 poses, must be at least 8", refused.reason());
  }

  @Test
  void posesThatLeaveAJointAloneAreRefused() {
    ArmDescription model = ArmLibrary.load("ur5e");
    ForwardKinematics forward = new ForwardKinematics(model);
    Random random = new Random(99);
    List<MeasuredPose> measured = new ArrayList<>();
    for (int n = 0; n < 50; n++) {
      Joints q = Arms.joints(random).with(2, 0.5).with(3, 0.2);
      measured.add(new MeasuredPose(q, forward.flangePose(q)));
    }
    CalibrationEstimate.Result.Refused refused =
        assertInstanceOf(
            CalibrationEstimate.Result.Refused.class, CalibrationEstimate.of(model, measured));
    assertTrue(
        refused
            .reason()
            .startsWith("its 50 poses leave some of the arm open: the condition number"),
        refused.reason());
  }
}
