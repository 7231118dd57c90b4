package org.pendant.controller;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.controller.safety.SafetyCommand;
import org.pendant.controller.safety.SafetyInput;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;
import org.pendant.script.vm.ProgramState;

/** Programs that lay an offset over their paths, from outside. */
final class PathOffsetProgramTest {
  private static final String READY = "movej([-0.4, -1.4, -1.7, -1.6, 1.57, 0])\n";

  private static Pose tcp(RunningProgram running) {
    return running.state().arm().targetTcpInBase();
  }

  /** Where the TCP is before and after an offset is applied. */
  private record Shift(Pose before, Pose after) {
    static Shift of(String offset, int type) {
      RunningProgram running = new RunningProgram();
      running.start(
          READY
              + "path_offset_enable()\npath_offset_set_alpha_filter(0.004)\ntextmsg(\"before\")\n"
              + "sync()\npath_offset_set("
              + offset
              + ", "
              + type
              + ")\nsleep(7)\ntextmsg(\"after\")\nsync()\n");
      running.until("before");
      Pose before = tcp(running);
      running.until("after");
      return new Shift(before, tcp(running));
    }
  }

  @Test
  void anOffsetInTheBaseShiftsAndTurnsAlongTheAxesOfTheBase() {
    Shift shift = Shift.of("p[0.01, -0.02, 0.03, 0, 0, 0.2]", 1);
    Pose from = shift.before();
    Pose turned =
        Poses.trans(
            new Pose(0, 0, 0, 0, 0, 0.2), new Pose(0, 0, 0, from.rx(), from.ry(), from.rz()));
    Pose expected =
        new Pose(
            from.x() + 0.01,
            from.y() - 0.02,
            from.z() + 0.03,
            turned.rx(),
            turned.ry(),
            turned.rz());
    assertEquals(0, Poses.distance(expected, shift.after()), 1e-6);
  }

  @Test
  void anOffsetInTheTcpIsMeantInItsFrame() {
    Shift shift = Shift.of("[0.01, -0.02, 0.03, 0.1, 0, 0.2]", 2);
    Pose expected = Poses.trans(shift.before(), new Pose(0.01, -0.02, 0.03, 0.1, 0, 0.2));
    assertEquals(0, Poses.distance(expected, shift.after()), 1e-6);
  }

  @Test
  void anOffsetInTheWorldIsThePoseOfTheBaseThere() {
    Shift shift = Shift.of("p[0.05, -0.02, 0.01, 0, 0.1, 0.2]", 4);
    Pose base = new Pose(0.05, -0.02, 0.01, 0, 0.1, 0.2);
    assertEquals(0, Poses.distance(shift.before(), Poses.trans(base, shift.after())), 1e-6);
  }

  @Test
  void anOffsetAlongThePathKeepsItsDirectionWhenTheToolRests() {
    RunningProgram running = new RunningProgram();
    running.start(
        READY
            + """
            path_offset_enable()
            path_offset_set_alpha_filter(0.01)
            path_offset_set(p[0.004, 0.01, 0.02, 0, 0, 0], 3)
            sleep(0.5)
            textmsg("rests")
            sync()
            movel(pose_add(get_target_tcp_pose_along_path(), p[0, 0.1, 0, 0, 0, 0]), 0.3, 0.05)
            sleep(0.5)
            textmsg("after")
            sync()
            """);
    running.until("rests");
    Pose start = tcp(running);
    running.until("after");
    Pose end = tcp(running);
    // forward is y; the tool points down but for 0.7 degrees, so across it is -x, and z is up
    assertEquals(-0.01, end.x() - start.x(), 4e-4);
    assertEquals(0.1 + 0.004, end.y() - start.y(), 1e-4);
    assertEquals(0.02, end.z() - start.z(), 4e-4);
  }

  @Test
  void theFilterGoesItsPartOfTheWayInEachFrame() {
    RunningProgram running = new RunningProgram();
    running.start(
        READY
            + """
            path_offset_enable()
            path_offset_set_alpha_filter(0.1)
            path_offset_set(p[0, 0, 0.001, 0, 0, 0], 1)
            textmsg("set")
            sleep(1)
            """);
    running.until("set");
    Pose first = tcp(running);
    double start = first.z() - 0.1 * 0.001;
    for (int k = 2; k < 40; k++) {
      running.advance(1);
      assertEquals(0.001 * (1 - Math.pow(0.9, k)), tcp(running).z() - start, 1e-9, "frame " + k);
    }
  }

  @Test
  void whatGoesBeyondTheLimitsIsCutOff() {
    RunningProgram running = new RunningProgram();
    running.start(
        READY
            + """
            path_offset_enable()
            path_offset_set_max_offset(0.01, 0.05)
            path_offset_set_alpha_filter(0.02)
            path_offset_set(p[0.2, -0.2, 0.005, 0, 0, 0.3], 1)
            sleep(3)
            applied = path_offset_get(1)
            i = 0
            while i < 6:
              textmsg(floor(1000000 * applied[i] + 0.5))
              i = i + 1
            end
            """);
    running.finish();
    assertEquals(
        List.of("10000", "-10000", "5000", "0", "0", "50000"),
        running.said(),
        () -> "" + running.reported());
  }

  @Test
  void theLimitsAtFirstAreATenthOfAMetreAndThirtyDegrees() {
    RunningProgram running = new RunningProgram();
    running.start(
        READY
            + """
            path_offset_enable()
            path_offset_set_alpha_filter(0.004)
            path_offset_set(p[0, 0.3, 0, 0, 0, 1], 1)
            sleep(8)
            applied = path_offset_get(1)
            textmsg(floor(1000000 * applied[1] + 0.5))
            textmsg(floor(1000000 * applied[5] + 0.5))
            """);
    running.finish();
    assertEquals(List.of("100000", "520000"), running.said(), () -> "" + running.reported());
  }

  @Test
  void tellsWhatIsAppliedInEveryFrame() {
    RunningProgram running = new RunningProgram();
    running.start(
        READY
            + """
            path_offset_enable()
            path_offset_set_alpha_filter(0.004)
            path_offset_set(p[0.01, -0.02, 0.03, 0.1, 0, 0.2], 2)
            sleep(7)
            sync()
            along = get_target_tcp_pose_along_path()
            here = get_target_tcp_pose()
            off = point_dist(pose_trans(along, path_offset_get(2)), here)
            textmsg(off < 0.000001)
            off = pose_dist(pose_trans(path_offset_get(4), here), along)
            textmsg(off < 0.000001)
            base = path_offset_get(1)
            textmsg(norm([here[0] - along[0] - base[0], here[1] - along[1] - base[1], here[2] - along[2] - base[2]]) < 0.000001)
            textmsg(path_offset_get(3))
            """);
    running.finish();
    assertEquals(
        List.of("True", "True", "True", "p[0, 0, 0, 0, 0, 0]"),
        running.said(),
        () -> "" + running.reported());
  }

  @Test
  void disablingStaysWhereTheToolIsAndTheNextMoveIsExact() {
    RunningProgram running = new RunningProgram();
    running.start(
        READY
            + """
            path_offset_enable()
            path_offset_set_alpha_filter(0.005)
            path_offset_set(p[0, 0, 0.05, 0, 0, 0], 1)
            sleep(5)
            textmsg("before")
            path_offset_disable(a=10)
            textmsg("after")
            sleep(0.1)
            textmsg(path_offset_get(1))
            goal = pose_add(get_target_tcp_pose(), p[0, 0, -0.05, 0, 0, 0])
            movel(goal)
            textmsg(pose_dist(goal, get_target_tcp_pose()) < 0.000001)
            path_offset_enable()
            sleep(0.2)
            textmsg(pose_dist(goal, get_target_tcp_pose()) < 0.000001)
            """);
    running.until("before");
    Pose before = tcp(running);
    running.until("after");
    assertEquals(0, Poses.distance(before, tcp(running)), 1e-5);
    assertEquals(Joints.ZERO, running.state().arm().targetSpeedRadPerS());
    running.finish();
    assertEquals(
        List.of("before", "after", "p[0, 0, 0, 0, 0, 0]", "True", "True"),
        running.said(),
        () -> "" + running.reported());
  }

  @Test
  void weavesOverALinearMoveAsTheManualsExampleDoes() {
    RunningProgram running = new RunningProgram();
    running.start(
        """
        thread weave():
          angle = 0
          while True:
            path_offset_set([0, 0, 0.005 * (cos(angle) - 1), 0, 0, 0], 1)
            angle = angle + 4 * 3.14159 / 500
            sync()
          end
        end
        def seam():
          movej([-0.4, -1.4, -1.7, -1.6, 1.57, 0])
          path_offset_enable()
          weaving = run weave()
          textmsg("weaves")
          movel(pose_add(get_target_tcp_pose(), p[0, 0.1, 0, 0, 0, 0]), 0.3, 0.05)
          kill weaving
          path_offset_disable()
          textmsg("done")
          sleep(0.1)
        end
        """);
    running.until("weaves");
    Pose start = tcp(running);
    double lowest = 0;
    double highest = -1;
    while (!running.said().contains("done")) {
      running.advance(1);
      assertEquals(ProgramState.RUNNING, running.programState(), () -> "" + running.reported());
      double z = tcp(running).z() - start.z();
      lowest = Math.min(lowest, z);
      highest = Math.max(highest, z);
      assertEquals(start.x(), tcp(running).x(), 1e-5);
    }
    assertEquals(-0.01, lowest, 1e-4);
    assertEquals(0, highest, 1e-4);
  }

  @Test
  void aJumpOfTheOffsetStopsTheProgramAndNotTheArmElsewhere() {
    RunningProgram running = new RunningProgram();
    running.start(
        READY
            + "path_offset_enable()\ntextmsg(\"on\")\nsync()\n"
            + "path_offset_set(p[0, 0, 0.09, 0, 0, 0], 1)\nsleep(5)\n");
    running.until("on");
    Pose before = tcp(running);
    running.finish();
    running.advance(500);
    assertTrue(
        running.reported().stream()
            .anyMatch(text -> text.contains("what carries the tool aside does so too suddenly")),
        () -> "" + running.reported());
    assertEquals(0, Poses.distance(before, tcp(running)), 1e-9);
  }

  @Test
  void aStopHoldsTheArmAndTheOffsetGoesOnAfterwards() {
    RunningProgram running = new RunningProgram();
    running.start(
        READY
            + """
            path_offset_enable()
            path_offset_set_alpha_filter(0.01)
            path_offset_set(p[0, 0, 0.05, 0, 0, 0], 1)
            sleep(0.2)
            textmsg("now")
            sleep(3)
            textmsg("end")
            sync()
            """);
    running.until("now");
    Pose path = tcp(running);
    running.done(new SafetyCommand.SetSafetyInput(SafetyInput.SAFEGUARD_STOP, true));
    running.advance(300);
    Pose held = tcp(running);
    running.advance(100);
    assertEquals(held, tcp(running));
    assertTrue(Poses.pointDistance(path, held) < 0.01);
    running.done(new SafetyCommand.SetSafetyInput(SafetyInput.SAFEGUARD_STOP, false));
    running.until("end");
    assertTrue(tcp(running).z() > held.z() + 0.005, () -> held + " then " + tcp(running));
  }
}
