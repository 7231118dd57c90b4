package org.pendant.models.kinematics;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Calibration;
import org.pendant.models.arm.DhDeltas;
import org.pendant.models.arm.DhParameters;
import org.pendant.models.arm.Joints;
import org.pendant.models.arm.LinkFrame;
import org.pendant.models.arm.LinkFrames;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;
import org.pendant.models.pose.Transforms;

class LinkFramesTest {
  private static final ArmDescription UR10E = ArmLibrary.load("ur10e");

  private static final Joints ALPHA = UR10E.dh().parameters().alphaRad();

  /** The calibration of a UR10e as its controller has it: sums of model and deltas. */
  private static final ArmDescription OF_DELTAS =
      UR10E.withCalibration(
          Calibration.of(
              DhDeltas.between(
                  UR10E.dh(),
                  new DhParameters(
                      new Joints(
                          -2.41e-07,
                          1.60233952386695,
                          -1.68607190752171,
                          0.0837331147700119,
                          -1.01e-07,
                          3.9e-08),
                      new Joints(
                          2.122e-05,
                          0.0193171326277006,
                          -0.569251663611088,
                          -4.614e-05,
                          -6.393e-05,
                          0),
                      new Joints(
                          0.180539811714259,
                          439.140974079901,
                          -446.027059806332,
                          7.0603368964236,
                          0.119811341150314,
                          0.115670917257426),
                      new Joints(
                          1.57014608044242,
                          0.0013941666682559,
                          0.00693818880325995,
                          1.56998468543761,
                          -1.57038520649543,
                          0)))));

  /** That of another one as ROS has it. */
  private static final ArmDescription OF_FRAMES =
      UR10E.withCalibration(
          Calibration.of(
              new LinkFrames(
                  List.of(
                      new LinkFrame(0, 0, 0.1810949508145422, -0.0, 0, 1.04e-07),
                      new LinkFrame(-1.66e-05, 0, 0, 1.570008587286171, 0, 1.08e-06),
                      new LinkFrame(
                          -0.6125194958024353,
                          0,
                          0,
                          3.140726981885666,
                          3.139773859813499,
                          -3.141591402263981),
                      new LinkFrame(
                          -0.5713063516014969,
                          0.0002174,
                          0.1745231697557756,
                          3.1403,
                          -3.1407,
                          -3.1416),
                      new LinkFrame(
                          -2.4e-05, -0.1197882240806239, 7.4e-05, 1.570175415778306, 0, -3.1e-07),
                      new LinkFrame(
                          8.4e-05,
                          0.1156939974082344,
                          1.5e-05,
                          1.5709,
                          3.141592653589793,
                          3.1416)))));

  private static final List<ArmDescription> CALIBRATED = List.of(OF_DELTAS, OF_FRAMES);

  @Test
  void framesOfAModelAreItsDenavitHartenbergChain() {
    Random random = new Random(91);
    double[] expected = new double[Transforms.SIZE];
    double[] found = new double[Transforms.SIZE];
    for (String id : ArmLibrary.ids()) {
      ArmDescription arm = ArmLibrary.load(id);
      ForwardKinematics nominal = new ForwardKinematics(arm);
      ForwardKinematics ofFrames =
          new ForwardKinematics(arm.withCalibration(Calibration.of(LinkFrames.of(arm.dh()))));
      for (int n = 0; n < 100; n++) {
        Joints q = Arms.joints(random);
        nominal.flange(q.toArray(), expected);
        ofFrames.flange(q.toArray(), found);
        assertArrayEquals(expected, found, 2e-15, () -> id + " at " + q);
      }
    }
  }

  /** Mean and largest distance of the flange from the model's, mm. */
  private static double[] apartMm(ArmDescription arm) {
    Random random = new Random(92);
    ForwardKinematics calibrated = new ForwardKinematics(arm);
    ForwardKinematics nominal = new ForwardKinematics(UR10E);
    double sum = 0;
    double max = 0;
    int count = 5000;
    for (int n = 0; n < count; n++) {
      Joints q = Arms.joints(random);
      double apart = Poses.pointDistance(calibrated.flangePose(q), nominal.flangePose(q));
      sum += apart;
      max = Math.max(max, apart);
    }
    return new double[] {1000 * sum / count, 1000 * max};
  }

  @Test
  void aCalibrationMovesTheFlangeByAFewMillimetres() {
    assertEquals(1.9, apartMm(OF_DELTAS)[0], 0.1);
    assertEquals(3.8, apartMm(OF_DELTAS)[1], 0.2);
    assertEquals(1.5, apartMm(OF_FRAMES)[0], 0.1);
    assertEquals(3.8, apartMm(OF_FRAMES)[1], 0.2);
  }

  @Test
  void jointsAreFoundAgainFromThePoseThatTheyGive() {
    Random random = new Random(93);
    for (ArmDescription arm : CALIBRATED) {
      ForwardKinematics forward = new ForwardKinematics(arm);
      InverseKinematics inverse = new InverseKinematics(arm);
      for (int n = 0; n < 500; n++) {
        Joints q = Arms.regularJoints(arm.dh(), 0.05, random);
        Pose flange = forward.flangePose(q);
        Joints found = inverse.closest(flange, q).orElseThrow();
        assertEquals(0, found.maxAbsDifference(q), 1e-9, q::toString);
        List<Joints> all = inverse.all(flange, Arms.joints(random));
        assertTrue(Arms.contain(all, q, 1e-9), () -> q + " is not among " + all);
        for (Joints each : all) {
          assertTrue(Poses.pointDistance(forward.flangePose(each), flange) < 1e-9, each::toString);
        }
      }
    }
  }

  @Test
  void theJacobianIsTheDerivativeOfThePose() {
    Random random = new Random(94);
    double step = 1e-5;
    double[] jacobian = new double[Jacobian.SIZE];
    for (ArmDescription arm : CALIBRATED) {
      ForwardKinematics forward = new ForwardKinematics(arm);
      for (int n = 0; n < 200; n++) {
        Joints q = Arms.joints(random);
        Pose offset = Arms.tcp(random);
        new Jacobian(arm).at(q.toArray(), offset, jacobian);
        for (int i = 0; i < Joints.COUNT; i++) {
          Pose ahead = forward.tcpPose(q.with(i, q.get(i) + step), offset);
          Pose behind = forward.tcpPose(q.with(i, q.get(i) - step), offset);
          Pose difference = Poses.sub(ahead, behind);
          for (int row = 0; row < Pose.SIZE; row++) {
            assertEquals(
                difference.get(row) / (2 * step), jacobian[6 * row + i], 1e-8, q::toString);
          }
        }
      }
    }
  }

  @Test
  void framesBecomeParametersThatMakeTheSameArm() {
    Random random = new Random(95);
    DhParameters found = DhConversion.parameters(OF_FRAMES);
    assertTrue(Math.abs(found.dM().q1()) > 100, found::toString);
    ForwardKinematics ofFrames = new ForwardKinematics(OF_FRAMES);
    ForwardKinematics ofParameters =
        new ForwardKinematics(
            UR10E.withCalibration(Calibration.of(DhDeltas.between(UR10E.dh(), found))));
    for (int n = 0; n < 500; n++) {
      Joints q = Arms.joints(random);
      Pose expected = ofFrames.flangePose(q);
      assertTrue(Poses.distance(expected, ofParameters.flangePose(q)) < 1e-11, q::toString);
    }
  }

  @Test
  void parametersOfAnArmWithDeltasAreTheSumsAndThoseOfAModelItsOwn() {
    DhParameters sums = DhConversion.parameters(OF_DELTAS);
    assertEquals(439.140974079901, sums.dM().q1());
    assertEquals(0.0193171326277006, sums.aM().q1(), 1e-15);
    assertEquals(1.57014608044242, sums.alphaRad().q0(), 1e-15);
    for (String id : ArmLibrary.ids()) {
      ArmDescription arm = ArmLibrary.load(id);
      DhParameters model = arm.dh().parameters();
      assertEquals(model, DhConversion.parameters(arm));
      ArmDescription ofFrames = arm.withCalibration(Calibration.of(LinkFrames.of(arm.dh())));
      DhParameters found = DhConversion.parameters(ofFrames);
      for (int i = 0; i < Joints.COUNT; i++) {
        assertEquals(0, found.thetaRad().get(i), 1e-15, id);
        assertEquals(model.aM().get(i), found.aM().get(i), 1e-15, id);
        assertEquals(model.dM().get(i), found.dM().get(i), 1e-15, id);
        assertEquals(ALPHA.get(i), found.alphaRad().get(i), 1e-15, id);
      }
    }
  }

  @Test
  void aRealCalibrationIsNotRefused() {
    for (ArmDescription arm : CALIBRATED) {
      assertEquals(Optional.empty(), NominalDeviation.refusal(arm));
    }
  }

  @Test
  void aForearmThatFoldsBackIsRefusedByName() {
    ArmDescription ur5e = ArmLibrary.load("ur5e");
    List<LinkFrame> frames = new ArrayList<>(LinkFrames.of(ur5e.dh()).frames());
    frames.set(2, new LinkFrame(ur5e.dh().a2(), 0, 0, 3.1415, 3.1396, 0.0000016));
    frames.set(3, new LinkFrame(ur5e.dh().a3(), 0, ur5e.dh().d4(), Math.PI, Math.PI, 0));
    ArmDescription spoilt = ur5e.withCalibration(Calibration.of(new LinkFrames(frames)));
    assertEquals(
        Optional.of(
            "puts the flange up to 784.5 mm (mean 784.3 mm) from where a UR5e has it, must be at"
                + " most 20 mm; its frame forearm is 0.0 mm and 180.00 degrees from its place"),
        NominalDeviation.refusal(spoilt));
  }

  @Test
  void theCalibrationOfASmallerArmIsRefused() {
    ArmDescription ur3e = ArmLibrary.load("ur3e");
    ArmDescription wrong = UR10E.withCalibration(Calibration.of(LinkFrames.of(ur3e.dh())));
    String reason = NominalDeviation.refusal(wrong).orElseThrow();
    assertTrue(
        reason.endsWith("its frame shoulder is 28.8 mm and 0.00 degrees from its place"), reason);
  }

  @Test
  void aShoulderBesideTheAxisOfTheBaseIsRefused() {
    List<LinkFrame> frames = new ArrayList<>(LinkFrames.of(UR10E.dh()).frames());
    frames.set(0, new LinkFrame(0.001, 0, 0.18, 0, 0, 0));
    String message =
        assertThrows(IllegalArgumentException.class, () -> new LinkFrames(frames)).getMessage();
    assertEquals(
        "shoulder: x is 0.001 m, must be 0: the first joint turns about the z axis of the base",
        message);
  }
}
