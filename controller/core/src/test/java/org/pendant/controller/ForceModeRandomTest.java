package org.pendant.controller;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.stream.LongStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import org.pendant.controller.box.ArmChoice;
import org.pendant.controller.box.WorldCommand;
import org.pendant.controller.safety.SafetyMode;
import org.pendant.controller.world.Material;
import org.pendant.controller.world.Scene;
import org.pendant.controller.world.SceneObject;
import org.pendant.controller.world.Vector3;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Wrench;

/** Random wrenches, frames, selections, limits, moves and pushes in force mode. */
@Tag("slow")
final class ForceModeRandomTest {
  private static final List<String> ROBOTS = List.of("ur3e", "ur5e", "ur10e", "ur20");
  private static final int FRAMES = 3000;

  private record Case(long seed, String robot, ControllerOptions options, String program) {}

  private static double random(SplittableRandom random, double largest) {
    return largest * (2 * random.nextDouble() - 1);
  }

  private static String list(SplittableRandom random, double force, double torque) {
    return String.format(
        Locale.ROOT,
        "[%.4f, %.4f, %.4f, %.4f, %.4f, %.4f]",
        random(random, force),
        random(random, force),
        random(random, force),
        random(random, torque),
        random(random, torque),
        random(random, torque));
  }

  private static String limits(SplittableRandom random) {
    StringBuilder text = new StringBuilder("[");
    for (int i = 0; i < 6; i++) {
      text.append(i > 0 ? ", " : "")
          .append(String.format(Locale.ROOT, "%.4f", Math.pow(10, -3 + 4 * random.nextDouble())));
    }
    return text.append("]").toString();
  }

  private static String program(SplittableRandom random) {
    StringBuilder text = new StringBuilder();
    text.append(
        String.format(
            Locale.ROOT,
            "set_tcp(p%s)%nforce_mode_set_damping(%.4f)%nforce_mode_set_gain_scaling(%.4f)%n",
            list(random, 0.2, 2),
            random.nextDouble() * random.nextDouble() * random.nextDouble(),
            2 * random.nextDouble()));
    for (int i = 0; i < 8; i++) {
      switch (random.nextInt(8)) {
        case 0 -> text.append("end_force_mode()\n");
        case 1 -> text.append("screw_driving(").append(random(random, 100)).append(", 0.3)\n");
        case 2 ->
            text.append("movel(pose_trans(get_target_tcp_pose(), p")
                .append(list(random, 0.05, 0.2))
                .append("), a=1, v=0.3)\n");
        default ->
            text.append("force_mode(p")
                .append(list(random, 0.5, 2))
                .append(", ")
                .append(selection(random))
                .append(", ")
                .append(list(random, 200, 20))
                .append(", ")
                .append(2 + random.nextInt(2))
                .append(", ")
                .append(limits(random))
                .append(")\n");
      }
      text.append(String.format(Locale.ROOT, "sleep(%.3f)%n", random.nextDouble()));
    }
    return text.toString();
  }

  private static String selection(SplittableRandom random) {
    StringBuilder text = new StringBuilder("[");
    for (int i = 0; i < 6; i++) {
      text.append(i > 0 ? ", " : "").append(random.nextInt(2));
    }
    return text.append("]").toString();
  }

  private static Case of(long seed) {
    SplittableRandom random = new SplittableRandom(seed);
    String robot = ROBOTS.get(random.nextInt(ROBOTS.size()));
    Vector3 below = new Vector3(0, 0, -0.05 - 0.2 * random.nextDouble());
    Material material = new Material(1e3 + 4e4 * random.nextDouble(), 0.2, 0.5);
    Scene scene =
        new Scene(
            List.of(new SceneObject.Plane("table", below, new Vector3(0.1, 0, 1), material)),
            Optional.empty(),
            List.of());
    Joints start =
        new Joints(
            random(random, 3),
            -1.5 + random(random, 0.4),
            1.4 + random(random, 0.7),
            -1.5 + random(random, 1),
            1.5 + random(random, 1),
            random(random, 3));
    ControllerOptions options =
        ControllerOptions.headless()
            .withRobot(robot)
            .withStart(start)
            .withScene(scene)
            .withArm(seed % 4 == 0 ? ArmChoice.IDEAL : ArmChoice.DYNAMIC);
    return new Case(seed, robot, options, program(random));
  }

  @TestFactory
  Stream<DynamicTest> targetsStayFiniteAndWithinTheSpeedsOfTheJoints() {
    return LongStream.range(0, 40)
        .mapToObj(ForceModeRandomTest::of)
        .map(each -> DynamicTest.dynamicTest("seed " + each.seed(), () -> check(each)));
  }

  private static void check(Case each) {
    RunningProgram running = new RunningProgram(each.options());
    SplittableRandom random = new SplittableRandom(~each.seed());
    ArmDescription arm = ArmLibrary.load(each.robot());
    running.start(each.program());
    Joints before = running.state().arm().targetPositionRad();
    for (int frame = 0; frame < FRAMES; frame++) {
      if (random.nextInt(200) == 0) {
        Wrench push =
            new Wrench(random(random, 10), random(random, 10), random(random, 10), 0, 0, 0);
        running.done(new WorldCommand.PushTool(push));
      } else {
        running.advance(1);
      }
      Joints now = running.state().arm().targetPositionRad();
      assertTrue(now.isFinite());
      assertTrue(running.state().arm().actualPositionRad().isFinite());
      SafetyMode mode = running.state().safety().safetyMode();
      assertTrue(
          mode == SafetyMode.NORMAL || mode == SafetyMode.PROTECTIVE_STOP,
          () -> each + ": " + running.reported());
      // a stopped arm that has been pushed aside gets its target where it is
      for (int i = 0; i < Joints.COUNT && mode == SafetyMode.NORMAL; i++) {
        double speed = Math.abs(now.get(i) - before.get(i)) / 0.002;
        double most = arm.joints().get(i).maxSpeedRadPerS();
        assertTrue(speed <= 1.01 * most, () -> each + ": " + speed + running.reported());
        assertTrue(arm.joints().get(i).contains(now.get(i)));
      }
      before = now;
    }
  }

  @Test
  void theSameProgramGivesTheSameTargetsToTheLastBit() {
    Case each = of(7);
    RunningProgram one = new RunningProgram(each.options());
    RunningProgram other = new RunningProgram(each.options());
    one.start(each.program());
    other.start(each.program());
    for (int i = 0; i < FRAMES; i++) {
      one.advance(1);
      other.advance(1);
      assertEquals(one.state().arm().targetPositionRad(), other.state().arm().targetPositionRad());
    }
  }
}
