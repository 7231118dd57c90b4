package org.pendant.controller;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.pendant.controller.box.ArmChoice;
import org.pendant.controller.box.WorldCommand;
import org.pendant.controller.freedrive.FreeAxes;
import org.pendant.controller.freedrive.FreedriveFrame;
import org.pendant.controller.freedrive.SingularityDistance;
import org.pendant.controller.safety.SafetyCommand;
import org.pendant.controller.safety.SafetyConfiguration;
import org.pendant.controller.safety.SafetyInput;
import org.pendant.controller.world.Vector3;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.JointLimits;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;
import org.pendant.models.pose.Wrench;

/** Where a guided arm does not go, and how fast it does not become. */
@Tag("slow")
final class FreedriveLimitsTest {
  private static final FreeAxes X_ONLY = new FreeAxes(true, false, false, false, false, false);

  private static GuidedArm ur5e(FreeAxes axes, FreedriveFrame frame) {
    return new GuidedArm(ControllerOptions.headless(), axes, frame);
  }

  private static void pulled(GuidedArm guided, int link, Vector3 point, Vector3 place) {
    guided.done(new WorldCommand.PullLink(link, point, place));
  }

  @ParameterizedTest
  @EnumSource
  void lockedAxesStayWithinAMillimetre(ArmChoice choice) {
    GuidedArm guided =
        new GuidedArm(ControllerOptions.headless().withArm(choice), X_ONLY, FreedriveFrame.BASE);
    guided.guide(0.1);
    Pose start = guided.tcp();
    guided.push(40, 40, -40);
    guided.guide(
        1.5,
        () -> {
          Pose now = guided.tcp();
          assertEquals(start.y(), now.y(), 1e-3);
          assertEquals(start.z(), now.z(), 1e-3);
        });
    assertTrue(guided.tcp().x() > start.x() + 0.05, "moved to " + guided.tcp());
    Pose turned = Poses.trans(Poses.inverse(start), guided.tcp());
    double angle = new Vector3(turned.rx(), turned.ry(), turned.rz()).length();
    assertTrue(angle < 2e-3, "turned by " + angle + " rad");
  }

  @Test
  void lockedAxesAreThoseOfTheFeature() {
    Pose feature = new Pose(0.3, 0.2, 0, 0, 0, Math.PI / 4);
    GuidedArm guided = ur5e(X_ONLY, new FreedriveFrame.Feature(feature));
    guided.guide(0.1);
    Pose start = guided.tcp();
    guided.push(0, 30, 0);
    guided.guide(1);
    double x = guided.tcp().x() - start.x();
    double y = guided.tcp().y() - start.y();
    assertTrue(y > 0.02, "along y by " + y);
    assertEquals(x, y, 1e-3, "at 45 degrees");
    assertEquals(start.z(), guided.tcp().z(), 1e-3);
  }

  @Test
  void lockedAxesAreThoseOfTheToolWhereItIsAtFirst() {
    // the tool points down: its z axis is that of the base, reversed
    GuidedArm guided =
        ur5e(new FreeAxes(false, false, true, false, false, false), FreedriveFrame.TOOL);
    guided.guide(0.1);
    Pose start = guided.tcp();
    guided.push(30, 30, 30);
    guided.guide(0.7);
    assertTrue(guided.tcp().z() > start.z() + 0.05, "up to " + guided.tcp());
    assertEquals(start.x(), guided.tcp().x(), 1e-3);
    assertEquals(start.y(), guided.tcp().y(), 1e-3);
  }

  @Test
  void aFreeAxisTurnsAboutTheToolCentrePoint() {
    GuidedArm guided =
        ur5e(new FreeAxes(false, false, false, false, false, true), FreedriveFrame.BASE);
    guided.guide(0.1);
    Pose start = guided.tcp();
    Joints from = guided.position();
    guided.done(new WorldCommand.PushTool(new Wrench(0, 0, 0, 0, 0, 4)));
    guided.guide(1);
    assertTrue(guided.distance(start) < 1e-3);
    assertTrue(guided.position().maxAbsDifference(from) > 0.5, "turned to " + guided.position());
  }

  @Test
  void withEverythingLockedItStays() {
    GuidedArm guided =
        ur5e(new FreeAxes(false, false, false, false, false, false), FreedriveFrame.BASE);
    guided.guide(0.1);
    Pose start = guided.tcp();
    guided.push(30, -30, 30);
    guided.guide(1, () -> assertTrue(guided.distance(start) < 1e-3));
  }

  @ParameterizedTest
  @ValueSource(strings = {"ur3e", "ur5e", "ur20"})
  void noJointIsPushedBeyondItsRange(String id) {
    ArmDescription arm = ArmLibrary.load(id);
    JointLimits elbow = arm.joints().get(2);
    Joints near = new Joints(0, -1.2, elbow.highestRad() - 0.4, -1.2, 1.4, 0);
    GuidedArm guided =
        new GuidedArm(
            ControllerOptions.headless().withRobot(id).withStart(near),
            FreeAxes.ALL,
            FreedriveFrame.BASE);
    guided.guide(0.1);
    // at the end of the forearm, across it: the elbow turns until its wall
    for (int i = 0; i < 40; i++) {
      Pose wrist = guided.arm().kinematics().flangePose(guided.position());
      double c = Math.cos(i * 0.3);
      double s = Math.sin(i * 0.3);
      pulled(guided, 2, new Vector3(0, 0, 0), new Vector3(wrist.x() + c, wrist.y(), wrist.z() + s));
      guided.guide(
          0.2,
          () -> {
            assertTrue(guided.position().q2() < elbow.highestRad(), "at " + guided.position());
            assertEquals(Optional.empty(), guided.state().safety().stop());
          });
    }
  }

  @Test
  void aJointThatIsAtTheEndMayGoBackAndIsNotMovedByItself() {
    Joints atTheEnd =
        new Joints(
            2 * Math.PI + Math.toRadians(3) - 0.01,
            -Math.PI / 2,
            -Math.PI / 2,
            -Math.PI / 2,
            Math.PI / 2,
            0);
    GuidedArm guided =
        new GuidedArm(
            ControllerOptions.headless().withStart(atTheEnd), FreeAxes.ALL, FreedriveFrame.BASE);
    guided.guide(0.5);
    assertEquals(atTheEnd, guided.position());
    guided.push(0, 40, 0);
    guided.guide(1);
    assertTrue(Math.abs(guided.position().q0() - atTheEnd.q0()) < 0.01, "kept from continuing");
    guided.push(0, -40, 0);
    guided.guide(0.5);
    assertTrue(Math.abs(guided.position().q0() - atTheEnd.q0()) > 0.05, "went back");
  }

  @Test
  void theArmGetsHarderToPushNearItsSpeedLimits() {
    GuidedArm guided = GuidedArm.free();
    guided.done(new SafetyCommand.SetSafetyInput(SafetyInput.REDUCED_MODE, true));
    guided.frames(300);
    double limit = SafetyConfiguration.standard(ArmLibrary.load("ur5e")).reduced().toolSpeedMPerS();
    guided.guide(0.1);
    double[] fastest = {0};
    double[] before = {0};
    Pose[] last = {guided.tcp()};
    guided.push(0, 60, 60);
    guided.guide(
        0.8,
        () -> {
          before[0] = guided.distance(last[0]) / 0.002;
          fastest[0] = Math.max(fastest[0], before[0]);
          last[0] = guided.tcp();
        });
    assertTrue(fastest[0] > 0.5 * limit && fastest[0] < limit, "at most " + fastest[0]);
    assertEquals(Optional.empty(), guided.state().safety().stop());
  }

  @Test
  void aSingularityIsReportedAndMakesALockedArmHarderToPush() {
    Joints far = new Joints(0, -1.57, -1.57, -1.57, 1.57, 0);
    Joints near = far.with(4, 0.15);
    Joints close = far.with(4, 0.01);
    assertEquals(SingularityDistance.NORMAL, distanceAt(far));
    assertEquals(SingularityDistance.NEAR, distanceAt(near));
    assertEquals(SingularityDistance.TOO_CLOSE, distanceAt(close));
    FreeAxes up = new FreeAxes(false, false, true, true, true, true);
    assertTrue(
        upwards(close, up) < 0.5 * upwards(far, up),
        "resists: " + upwards(close, up) + " and " + upwards(far, up));
  }

  private static SingularityDistance distanceAt(Joints q) {
    GuidedArm guided =
        new GuidedArm(ControllerOptions.headless().withStart(q), FreeAxes.ALL, FreedriveFrame.BASE);
    guided.frames(1);
    return guided.state().freedrive().distance();
  }

  private static double upwards(Joints from, FreeAxes axes) {
    GuidedArm guided =
        new GuidedArm(ControllerOptions.headless().withStart(from), axes, FreedriveFrame.BASE);
    guided.guide(0.1);
    double z = guided.tcp().z();
    guided.push(0, 0, 20);
    guided.guide(0.5);
    return guided.tcp().z() - z;
  }

  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14})
  void whateverAHandDoesTheArmStaysWithinItsLimits(long seed) {
    SplittableRandom random = new SplittableRandom(seed);
    List<String> ids = ArmLibrary.ids();
    ArmDescription arm = ArmLibrary.load(ids.get((int) seed % ids.size()));
    GuidedArm guided =
        new GuidedArm(
            ControllerOptions.headless()
                .withRobot(arm.id())
                .withArm(seed % 3 == 0 ? ArmChoice.IDEAL : ArmChoice.DYNAMIC),
            anyAxes(random),
            seed % 2 == 0 ? FreedriveFrame.BASE : FreedriveFrame.TOOL);
    guided.guide(0.02);
    for (int i = 0; i < 25; i++) {
      handDoesSomething(guided, random);
      for (int part = 0; part < 6; part++) {
        guided.guide(0.1, () -> assertWithin(arm, guided, seed));
      }
    }
  }

  private static FreeAxes anyAxes(SplittableRandom random) {
    FreeAxes axes = FreeAxes.ALL;
    if (random.nextInt(3) > 0) {
      for (int axis = 0; axis < FreeAxes.COUNT; axis++) {
        axes = axes.with(axis, random.nextBoolean());
      }
    }
    return axes;
  }

  private static void handDoesSomething(GuidedArm guided, SplittableRandom random) {
    int link = random.nextInt(6);
    Vector3 point = any(random, 0.1);
    switch (random.nextInt(3)) {
      case 0 -> guided.done(new WorldCommand.PushLink(link, point, any(random, 25)));
      case 1 -> pulled(guided, link, point, any(random, 1));
      default -> guided.done(new WorldCommand.LetGo());
    }
  }

  private static Vector3 any(SplittableRandom random, double most) {
    return new Vector3(
        random.nextDouble(-most, most),
        random.nextDouble(-most, most),
        random.nextDouble(-most, most));
  }

  private static void assertWithin(ArmDescription arm, GuidedArm guided, long seed) {
    Joints speed = guided.arm().actualSpeedRadPerS();
    assertTrue(guided.position().isFinite() && speed.isFinite(), "seed " + seed);
    assertTrue(
        arm.withinLimits(guided.position()), () -> "seed " + seed + " at " + guided.position());
    for (int i = 0; i < Joints.COUNT; i++) {
      assertTrue(
          Math.abs(speed.get(i)) <= arm.joints().get(i).maxSpeedRadPerS(),
          () -> "seed " + seed + " turns at " + speed);
    }
    assertEquals(Optional.empty(), guided.state().safety().stop(), "seed " + seed);
  }
}
