package org.pendant.controller;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.pendant.controller.world.Material;
import org.pendant.controller.world.Scene;
import org.pendant.controller.world.SceneObject;
import org.pendant.controller.world.Vector3;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;
import org.pendant.script.vm.ProgramState;

/** Moves with all that the arm can do, by an arm that has mass and drives. */
@Tag("slow")
final class OptimoveProgramTest {
  private final RunningProgram running = new RunningProgram();

  /** How fast the tool was in the last move, m/s. */
  private double fastestTool;

  @Test
  void anArmWithALoadFollowsFullSharesWithoutAnyStop() {
    running.run(
        """
        set_target_payload(3, [0, 0, 0.1], [0, 0, 0, 0, 0, 0])
        optimovej([1.5, -1.2, -1.2, -1.5708, 1.5708, 0], a=1, v=1)
        optimovej([-2.5, -1.5, -1.8, -1.0, 1.5708, 3], a=1, v=1)
        optimovej([0, -1.5708, -1.5708, -1.5708, 1.5708, 0], a=1, v=1, r=0.05)
        optimovel(struct(pose=p[0.1, 0.2, 0.1, 0, 0, 0], frame="tcp"), a=1, v=1)
        optimovej([1.2, -0.3, -0.5, -1, 1, 1], a=1, v=1)
        textmsg("there")
        """);
    assertEquals(List.of("there"), running.said());
    assertEquals(List.of(), running.reported());
  }

  @Test
  void leadsToAnObjectOfTheSceneAndToAPoseInItsFrame() {
    Pose pose = new Pose(-0.3, -0.4, 0.3, 0, Math.PI, 0);
    SceneObject box =
        new SceneObject.Box("shelf", pose, new Vector3(0.01, 0.01, 0.01), new Material(10, 0, 0));
    Scene scene = new Scene(List.of(box), Optional.empty(), List.of());
    RunningProgram onScene = new RunningProgram(ControllerOptions.headless().withScene(scene));
    onScene.run("optimovej(struct(pose=p[0, 0, -0.1, 0, 0, 0], frame=\"shelf\"))\n");
    Pose above = onScene.state().arm().targetTcpInBase();
    assertEquals(0, Poses.distance(new Pose(-0.3, -0.4, 0.4, 0, Math.PI, 0), above), 1e-9);
    onScene.run("tool_wrench_limit_disable()\noptimovel(\"shelf\", v=0.1)\n");
    assertEquals(0, Poses.distance(pose, onScene.state().arm().targetTcpInBase()), 1e-9);
  }

  /** Long moves of a stretched arm, whose tool would be faster than it may be. */
  @Test
  void aMoveThatTheSpeedOfTheToolLimitsKeepsItsJerk() {
    jerkKept(
        "optimovej([0, -0.4, -0.4, -1, 1.5, 0])",
        "optimovej([3, -0.4, -0.4, -1, 1.5, 0], a=1, v=1)");
    assertTrue(fastestTool > 1.3, "it is limited at all: " + fastestTool + " m/s");
    jerkKept(
        "optimovej([0, -2.5, 0.3, -1, 1.5, 0])", "optimovej([1, -0.4, 0.3, 2, -1, 2], a=1, v=1)");
    assertTrue(fastestTool > 1.3, "it is limited at all: " + fastestTool + " m/s");
  }

  @Test
  void noRandomMoveChangesItsAccelerationFasterThanAtItsBegin() {
    long seed = 41;
    SplittableRandom random = new SplittableRandom(seed);
    int limited = 0;
    for (int run = 0; run < 60; run++) {
      String share = ", a=" + random.nextDouble(0.2, 1) + ", v=" + random.nextDouble(0.2, 1) + ")";
      jerkKept("optimovej(" + place(random) + ")", "optimovej(" + place(random) + share);
      limited += fastestTool > 1.3 ? 1 : 0;
    }
    assertTrue(limited > 10, "only " + limited + " of them were limited by the speed of the tool");
  }

  /** Lines of the tool that joints or the speed of the elbow limit somewhere on their way. */
  @Test
  void noRandomLineChangesItsAccelerationFasterThanAtItsBegin() {
    long seed = 43;
    SplittableRandom random = new SplittableRandom(seed);
    for (int run = 0; run < 60; run++) {
      running.run("movej([0, -1.5708, -1.5708, -1.5708, 1.5708, 0], v=3, a=9)\nsleep(0.1)\n");
      Pose start = running.state().arm().targetTcpInBase();
      String line =
          "optimovel(pose_add(get_target_tcp_pose(), p["
              + random.nextDouble(-0.2, 0.15)
              + ", "
              + random.nextDouble(-0.4, 0.4)
              + ", "
              + random.nextDouble(-0.25, 0.15)
              + ", 0, 0, 0]), a=1, v=1)";
      running.start(line);
      List<Double> ways = new ArrayList<>();
      while (running.programState() == ProgramState.RUNNING) {
        assertEquals(1, running.state().arm().speedScaling(), line);
        ways.add(Poses.pointDistance(start, running.state().arm().targetTcpInBase()));
        running.advance(1);
      }
      assertEquals(List.of(), running.reported(), line);
      double first = largestThirdDifference(ways.subList(0, 10));
      double most = largestThirdDifference(ways);
      assertTrue(most <= first * 1.001, line + ": " + most + " after " + first + " m");
    }
  }

  private static double largestThirdDifference(List<Double> ways) {
    double largest = 0;
    for (int i = 3; i < ways.size(); i++) {
      double third = ways.get(i) - 3 * ways.get(i - 1) + 3 * ways.get(i - 2) - ways.get(i - 3);
      largest = Math.max(largest, Math.abs(third));
    }
    return largest;
  }

  private static String place(SplittableRandom random) {
    return "["
        + IntStream.range(0, Joints.COUNT)
            .mapToObj(
                i ->
                    String.valueOf(
                        i == 1 ? random.nextDouble(-2.5, -0.4) : random.nextDouble(-2.5, 2.5)))
            .collect(Collectors.joining(", "))
        + "]";
  }

  /** The path of joints is straight, so each joint shows the law of the path. */
  private void jerkKept(String before, String move) {
    running.run(before + "\nsleep(0.1)\n");
    running.start(move);
    double most = 0;
    double first = 0;
    fastestTool = 0;
    Joints last = Joints.ZERO;
    while (running.programState() == ProgramState.RUNNING) {
      Joints now = running.state().arm().targetAccelerationRadPerS2();
      double change = now.maxAbsDifference(last);
      // the mean of the first frame, in which the acceleration rises from 0
      first = first == 0 ? 2 * change : first;
      most = Math.max(most, change);
      last = now;
      Pose tcp = running.state().arm().targetTcpInBase();
      running.advance(1);
      double moved = Poses.pointDistance(tcp, running.state().arm().targetTcpInBase());
      fastestTool = Math.max(fastestTool, moved / 0.002);
      assertEquals(1, running.state().arm().speedScaling(), move);
    }
    assertTrue(
        most <= first * (1 + 1e-6), move + ": " + most + " after " + first + " rad/s² in a frame");
    assertEquals(List.of(), running.reported());
  }

  @Test
  void aBlendOfProcessMovesIsPausedAndGoesOnOnItsPath() {
    running.start(
        """
        home = get_target_tcp_pose()
        movep(pose_add(p[-0.1, 0, 0, 0, 0, 0], home), r=0.03)
        movep(pose_add(p[-0.1, 0.1, 0, 0, 0, 0], home), r=0.03)
        movec(pose_add(p[-0.05, 0.15, 0, 0, 0, 0], home), pose_add(p[0, 0.1, 0, 0, 0, 0], home))
        textmsg("there")
        """);
    running.advance(300);
    running.done(new ProgramCommand.PauseProgram());
    running.advance(300);
    assertEquals(Joints.ZERO, running.state().arm().targetSpeedRadPerS());
    running.done(new ProgramCommand.ResumeProgram());
    running.finish();
    assertEquals(List.of("there"), running.said());
    assertTrue(running.reported().isEmpty(), () -> running.reported().toString());
  }
}
