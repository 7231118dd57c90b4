package org.pendant.controller;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.pendant.controller.box.ArmChoice;
import org.pendant.controller.box.BoxCommand;
import org.pendant.controller.box.WorldCommand;
import org.pendant.controller.safety.SafetyCommand;
import org.pendant.controller.safety.SafetyMode;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;
import org.pendant.models.pose.Wrench;
import org.pendant.script.vm.ProgramState;

/** Programs in force mode, mostly with nothing to press on. */
@Tag("slow")
final class ForceModeProgramTest {
  /** Presses along y of the base with 20 N, at most 0.1 m/s. */
  private static final String ALONG_Y =
      "force_mode(p[0, 0, 0, 0, 0, 0], [0, 1, 0, 0, 0, 0], [0, 20, 0, 0, 0, 0], 2,"
          + " [0.1, 0.1, 0.1, 0.3, 0.3, 0.3])\n";

  /** Gives way along y of the base, wanting nothing. */
  private static final String FLOAT_Y = ALONG_Y.replace("20", "0");

  private final PressingArm free = new PressingArm();

  private void push(double fx, double fy, double mz) {
    free.running.done(new WorldCommand.PushTool(new Wrench(fx, fy, 0, 0, 0, mz)));
  }

  /** Speed of the target along y over a frame, m/s. */
  private double speedY() {
    double before = free.target().y();
    free.frames(1);
    return (free.target().y() - before) / 0.002;
  }

  private double fastestJoint() {
    return free.arm().targetSpeedRadPerS().maxAbsDifference(Joints.ZERO);
  }

  @Test
  void withNothingToPressOnTheToolReachesItsSpeedLimitAndNeverExceedsIt() {
    free.start(ALONG_Y + "sleep(10)\n");
    double fastest = 0;
    for (int i = 0; i < 1000; i++) {
      fastest = Math.max(fastest, speedY());
    }
    assertEquals(0.1, fastest, 1e-6);
    assertEquals(0.1, speedY(), 1e-6);
  }

  @Test
  void theOtherAxesDoNotMove() {
    free.start(ALONG_Y + "sleep(10)\n");
    free.frames(5);
    Pose before = free.target();
    free.frames(700);
    Pose after = free.target();
    assertTrue(after.y() > before.y() + 0.1);
    assertEquals(before.x(), after.x(), 1e-9);
    assertEquals(before.z(), after.z(), 1e-9);
    assertEquals(before.rx(), after.rx(), 1e-8);
    assertEquals(before.rz(), after.rz(), 1e-8);
  }

  @Test
  void theLimitIsThatOfTheToolWhateverAMoveAddsToIt() {
    free.start(
        "here = get_target_tcp_pose()\n"
            + ALONG_Y
            + "movel(pose_trans(p[0, 0.2, 0, 0, 0, 0], here), a=1, v=0.25)\nsleep(10)\n");
    double fastest = 0;
    for (int i = 0; i < 400; i++) {
      fastest = Math.max(fastest, speedY());
    }
    // the move begins by less than a frame's acceleration before it is answered
    assertEquals(0.1, fastest, 3e-3);
  }

  @Test
  void theSpeedSliderDoesNotSlowIt() {
    free.running.done(new BoxCommand.SetSpeedFraction(0.1));
    free.start(ALONG_Y + "sleep(10)\n");
    free.frames(500);
    assertEquals(0.1, speedY(), 1e-6);
  }

  @Test
  void aPauseHoldsTheArmAndTheProgramGoesOnPressing() {
    free.start(ALONG_Y + "sleep(10)\n");
    free.frames(500);
    free.running.done(new ProgramCommand.PauseProgram());
    free.frames(100);
    Pose held = free.target();
    free.frames(500);
    assertEquals(held, free.target());
    free.running.done(new ProgramCommand.ResumeProgram());
    free.frames(300);
    assertEquals(0.1, speedY(), 1e-6);
  }

  @Test
  void aProtectiveStopHoldsTheArmAndTheProgramGoesOnPressing() {
    free.start(ALONG_Y + "sleep(1)\nprotective_stop()\nsleep(20)\n");
    free.frames(700);
    assertEquals(SafetyMode.PROTECTIVE_STOP, free.running.state().safety().safetyMode());
    Pose held = free.target();
    free.frames(2600);
    assertEquals(held, free.target());
    free.running.done(new SafetyCommand.UnlockProtectiveStop(false));
    free.running.done(new ProgramCommand.ResumeProgram());
    free.frames(400);
    assertEquals(SafetyMode.NORMAL, free.running.state().safety().safetyMode());
    assertEquals(0.1, speedY(), 1e-6);
  }

  @Test
  void theEndOfTheProgramEndsIt() {
    free.start(ALONG_Y + "sleep(1)\n");
    free.frames(700);
    assertEquals(ProgramState.STOPPED, free.running.programState());
    assertEquals(0, fastestJoint());
    Pose rests = free.target();
    free.start("sleep(1)\n");
    free.frames(400);
    assertEquals(rests, free.target());
  }

  @Test
  void stoppingTheProgramDuringAMoveComesToRestWithinTheAccelerationOfStops() {
    free.start(
        "here = get_target_tcp_pose()\n"
            + ALONG_Y
            + "movel(pose_trans(p[0, 0, 0.1, 0, 0, 0], here))\nsleep(10)\n");
    free.frames(200);
    var _ = free.running.ask(new ProgramCommand.StopProgram());
    Joints before = free.arm().targetSpeedRadPerS();
    for (int i = 0; i < 300; i++) {
      free.frames(1);
      Joints now = free.arm().targetSpeedRadPerS();
      assertTrue(now.maxAbsDifference(before) < 15 * 0.002 + 1e-3);
      before = now;
    }
    assertEquals(0, fastestJoint());
  }

  @Test
  void endingItComesToRestAndTheNextMoveIsAbsolute() {
    free.start(
        """
        home = get_target_tcp_pose()
        force_mode(p[0, 0, 0, 0, 0, 0], [0, 1, 0, 0, 0, 1], [0, 20, 0, 0, 0, 0.5], 2,\
         [0.1, 0.1, 0.1, 0.3, 0.3, 0.3])
        sleep(1)
        end_force_mode()
        movel(home)
        textmsg(point_dist(home, get_target_tcp_pose()) < 0.000001)
        textmsg(norm(get_target_joint_speeds()) == 0)
        """);
    Joints before = free.arm().targetSpeedRadPerS();
    while (free.running.programState() == ProgramState.RUNNING) {
      free.frames(1);
      Joints now = free.arm().targetSpeedRadPerS();
      assertTrue(now.maxAbsDifference(before) < 0.05, () -> "jump to " + now);
      before = now;
    }
    assertEquals(List.of("True", "True"), free.running.said());
  }

  @Test
  void endingItDuringAnotherThreadsMoveKeepsTheDistanceUntilTheArmRests() {
    free.start(
        """
        home = get_target_tcp_pose()
        global goal = pose_trans(p[0, 0, 0.1, 0, 0, 0], home)
        global aside = home
        thread mover():
          movel(goal, a=0.5, v=0.05)
          aside = get_target_tcp_pose()
          movel(goal)
          textmsg("goal ", point_dist(get_target_tcp_pose(), goal) < 0.000001)
        end
        m = run mover()
        """
            + ALONG_Y
            + """
            sleep(1)
            end_force_mode()
            sleep(0.1)
            kept = pose_sub(get_target_tcp_pose(), home)
            join m
            moved = pose_sub(aside, goal)
            textmsg("kept ", norm(moved[1] - kept[1]) < 0.000001 and moved[1] > 0.05)
            """);
    free.running.finish();
    assertEquals(List.of("goal True", "kept True"), free.running.said());
  }

  @Test
  void typeThreeHasNoCompliantAxisBeforeThePathMoves() {
    free.start(
        """
        home = get_target_tcp_pose()
        force_mode(p[0, 0, 0, 0, 0, 0], [0, 1, 0, 0, 0, 0], [0, 20, 0, 0, 0, 0], 3,\
         [0.1, 0.1, 0.1, 0.3, 0.3, 0.3])
        sleep(1)
        movel(pose_trans(p[0, -0.1, 0, 0, 0, 0], home), a=0.5, v=0.05)
        sleep(10)
        """);
    free.frames(5);
    Pose home = free.target();
    free.frames(480);
    assertEquals(home, free.target());
    // the path goes along -y of the base, so the compliant axis y points along x of the base
    free.frames(900);
    assertTrue(free.target().x() > home.x() + 0.1, () -> free.target().toString());
    assertEquals(home.z(), free.target().z(), 1e-6);
    // the path has ended; its last direction stays
    double x = free.target().x();
    free.frames(500);
    assertTrue(free.target().x() > x + 0.02);
  }

  @Test
  void typeOneCirclesAboutThePoint() {
    free.start(
        """
        point = pose_trans(get_target_tcp_pose(), p[0.2, 0, 0, 0, 0, 0])
        force_mode(p[point[0], point[1], point[2], 0, 0, 0], [1, 0, 0, 0, 0, 0],\
         [20, 0, 0, 0, 0, 0], 1, [0.1, 0.1, 0.1, 0.3, 0.3, 0.3])
        sleep(10)
        """);
    free.frames(2);
    Pose start = free.target();
    free.frames(700);
    Pose now = free.target();
    assertTrue(Math.hypot(now.x() - start.x(), now.y() - start.y()) > 0.08);
    double turned = Math.hypot(now.x() - start.x(), now.y() - start.y()) / 0.2;
    assertTrue(turned < 1);
    assertEquals(start.z(), now.z(), 1e-4);
  }

  @Test
  void withFullDampingTheToolStopsWhereNobodyPushesIt() {
    free.start("force_mode_set_damping(1)\n" + FLOAT_Y + "sleep(10)\n");
    push(0, 30, 0);
    free.frames(500);
    push(0, 0, 0);
    free.frames(100);
    assertEquals(0, speedY(), 1e-4);
  }

  @Test
  void withoutDampingTheToolGoesOn() {
    free.start("force_mode_set_damping(0)\n" + FLOAT_Y + "sleep(10)\n");
    push(0, 15, 0);
    free.frames(100);
    push(0, 0, 0);
    free.frames(100);
    double speed = speedY();
    assertTrue(speed > 0.02 && speed < 0.1, () -> "speed " + speed);
    free.frames(300);
    assertEquals(speed, speedY(), 1e-3);
  }

  @Test
  void gainZeroDoesNotAnswerAtAll() {
    free.start("force_mode_set_gain_scaling(0)\n" + ALONG_Y + "sleep(10)\n");
    free.frames(5);
    Pose before = free.target();
    free.frames(500);
    assertEquals(before, free.target());
  }

  @Test
  void aRestingArmIsSteady() {
    free.start(FLOAT_Y + "sleep(2)\ntextmsg(is_steady())\n");
    free.running.finish();
    assertEquals(List.of("True"), free.running.said());
  }

  @Test
  void anotherToolDoesNotMoveTheArm() {
    free.start(
        """
        force_mode(p[0, 0, 0, 0, 0, 0], [0, 1, 0, 0, 0, 1], [0, 20, 0, 0, 0, 2], 2,\
         [0.1, 0.1, 0.1, 0.3, 0.3, 0.3])
        sleep(0.5)
        force_mode(p[0, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, 0], [0, 0, 0, 0, 0, 0], 2,\
         [1, 1, 1, 1, 1, 1])
        sleep(0.5)
        set_tcp(p[0.1, 0, 0.3, 0, 0, 0])
        sleep(10)
        """);
    free.frames(500);
    Joints before = free.arm().targetPositionRad();
    free.frames(100);
    assertEquals(0, free.arm().targetPositionRad().maxAbsDifference(before), 1e-9);
  }

  @Test
  void screwDrivingFollowsTheAxisOfTheTool() {
    free.start(
        """
        movel(pose_trans(get_target_tcp_pose(), p[0, 0, 0, 0.4, 0, 0]))
        screw_driving(10, 0.05)
        sleep(1)
        end_screw_driving()
        sleep(10)
        """);
    while (fastestJoint() == 0 || !free.arm().moving()) {
      free.frames(1);
    }
    while (free.arm().moving()) {
      free.frames(1);
    }
    Pose start = free.target();
    free.frames(1000);
    Pose moved = Poses.trans(Poses.inverse(start), free.target());
    assertEquals(0, moved.x(), 1e-6);
    assertEquals(0, moved.y(), 1e-6);
    assertTrue(moved.z() > 0.03 && moved.z() < 0.05, () -> moved.toString());
    assertEquals(0, fastestJoint());
  }

  @Test
  void freedriveTakesTheArmOver() {
    free.start(ALONG_Y + "sleep(0.5)\nfreedrive_mode()\nsleep(0.5)\n" + ALONG_Y);
    free.running.finish();
    assertTrue(
        free.running.reported().stream()
            .anyMatch(each -> each.contains("force_mode: the arm is in freedrive")),
        () -> free.running.reported().toString());
  }

  @Test
  void beforeASingularityTheToolSlowsDownInsteadOfFailing() {
    free.start(
        "force_mode(p[0, 0, 0, 0, 0, 0], [1, 0, 0, 0, 0, 0], [-60, 0, 0, 0, 0, 0], 2,"
            + " [0.25, 0.1, 0.1, 0.3, 0.3, 0.3])\nsleep(20)\n");
    free.frames(5000);
    assertEquals(SafetyMode.NORMAL, free.running.state().safety().safetyMode());
    assertEquals(ProgramState.RUNNING, free.running.programState());
    assertTrue(fastestJoint() < 0.05);
  }

  @Test
  void theIdealArmFollowsTheForceThroughEmptySpace() {
    PressingArm ideal = new PressingArm(ControllerOptions.headless().withArm(ArmChoice.IDEAL));
    ideal.start(ALONG_Y + "sleep(1)\nend_force_mode()\nsleep(1)\n");
    ideal.frames(5);
    double y = ideal.target().y();
    ideal.frames(1100);
    assertEquals(0.08, ideal.target().y() - y, 0.01);
    assertFalse(ideal.arm().moving());
  }
}
