package org.pendant.controller;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.pendant.controller.io.IoCommand;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;
import org.pendant.script.vm.ProgramState;

/** What a program sees and does while one move blends into the next. */
final class InTheBlendProgramTest {
  private static final Pose CORNER = new Pose(0.45, 0.05, 0.45, 2.2214, -2.2214, 0);
  private static final double RADIUS_M = 0.05;

  /** Two lines with a right angle between them; something happens at the corner. */
  private static String corner(String between) {
    return """
    def corner():
      movel(p[0.45, -0.15, 0.45, 2.2214, -2.2214, 0])
      textmsg("begin")
      movel(p[0.45, 0.05, 0.45, 2.2214, -2.2214, 0], a=1.2, v=0.25, r=0.05)
      BETWEEN
      movel(p[0.3, 0.05, 0.45, 2.2214, -2.2214, 0], a=1.2, v=0.25)
      textmsg("end")
    end
    """
        .replace("BETWEEN", between);
  }

  private static Pose target(RunningProgram running) {
    return running.state().arm().targetTcpInBase();
  }

  private static boolean rests(RunningProgram running) {
    return running.state().arm().targetSpeedRadPerS().equals(Joints.ZERO);
  }

  /** Continues until the tool is in the sphere around the corner. */
  private static void enter(RunningProgram running) {
    while (Poses.pointDistance(target(running), CORNER) > RADIUS_M || running.said().isEmpty()) {
      running.advance(1);
    }
  }

  @Test
  void aPayloadThatChangesBetweenTwoMovesDoesNotKeepThemFromBlending() {
    RunningProgram running = new RunningProgram();
    running.start(corner("set_payload(1.5, [0, 0, 0.05])\n  textmsg(get_target_payload())"));
    enter(running);
    running.advance(2);
    assertTrue(running.said().contains("1.5"), "not declared in the blend");
    double nearest = Double.POSITIVE_INFINITY;
    int atRest = 0;
    while (!running.said().contains("end")) {
      running.advance(1);
      nearest = Math.min(nearest, Poses.pointDistance(target(running), CORNER));
      atRest += rests(running) ? 1 : 0;
    }
    assertTrue(atRest < 3, atRest + " frames at rest");
    assertTrue(nearest > 0.001, "met the corner");
    assertEquals(List.of(), running.reported());
  }

  @Test
  void conditionsAreDecidedWhereTheBlendBegins() {
    String text =
        corner(
            """
            if get_standard_digital_in(0):
              movel(p[0.45, -0.1, 0.5, 2.2214, -2.2214, 0])
              halt
            end
            """);
    RunningProgram before = new RunningProgram();
    before.start(text);
    while (target(before).y() < -0.01) {
      before.advance(1);
    }
    before.done(new IoCommand.SetInput("digital_in[0]", true));
    before.finish();
    assertEquals(-0.1, target(before).y(), 1e-9);

    RunningProgram behind = new RunningProgram();
    behind.start(text);
    enter(behind);
    behind.advance(3);
    assertTrue(target(behind).y() < 0.045, "the corner is still ahead");
    behind.done(new IoCommand.SetInput("digital_in[0]", true));
    behind.finish();
    assertEquals(0.3, target(behind).x(), 1e-9);
  }

  @Test
  void theTargetSpeedOfTheToolFollowsFromItsPositionsInABlend() {
    RunningProgram running = new RunningProgram();
    running.start(
        corner(
            """
            thread watch():
              while True:
                v = get_target_tcp_speed()
                textmsg("", sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]))
                sync()
              end
            end
            run watch()
            """));
    enter(running);
    int heard = 0;
    List<Double> moved = new ArrayList<>();
    while (!running.said().contains("end")) {
      Pose before = target(running);
      running.advance(1);
      moved.add(Poses.pointDistance(before, target(running)) / 0.002);
      List<String> said = running.said();
      if (said.size() > 1 && moved.size() > 2 && !said.contains("end")) {
        // what the program sees is the end of the frame before; the mean over it is a bit off
        double mean = 0.5 * (moved.get(moved.size() - 2) + moved.get(moved.size() - 1));
        assertEquals(mean, Double.parseDouble(said.getLast()), 1.2 * 0.002 * 2);
        heard++;
      }
    }
    assertTrue(heard > 300, heard + " frames");
  }

  @Test
  void theHistoryOfPositionsGoesOnThroughABlend() {
    RunningProgram running = new RunningProgram();
    running.start(
        corner(
            """
            thread watch():
              while True:
                q = get_actual_joint_positions_history(10)
                textmsg("", q[0])
                sync()
              end
            end
            run watch()
            """));
    enter(running);
    List<Double> actual = new ArrayList<>();
    int heard = 0;
    while (!running.said().contains("end")) {
      running.advance(1);
      actual.add(running.state().arm().actualPositionRad().get(0));
      String last = running.said().getLast();
      if (actual.size() > 12 && !last.equals("end")) {
        // the newest that the program knows is of the frame before
        assertEquals(actual.get(actual.size() - 12), Double.parseDouble(last), 1e-5);
        heard++;
      }
    }
    assertTrue(heard > 300, heard + " frames");
  }

  @ParameterizedTest
  @CsvSource({
    "movel, movep, false",
    "movep, movep, false",
    "movep, movel, true",
    "movej, movep, false",
    "movep, movej, true"
  })
  void onlyAMoveThatIsNoProcessMoveRestsBehindOne(String first, String second, boolean rests) {
    RunningProgram running = new RunningProgram();
    running.start(
        """
        def there_and_back():
          movel(p[0.45, -0.15, 0.45, 2.2214, -2.2214, 0])
          textmsg("begin")
          FIRST(p[0.45, 0.05, 0.45, 2.2214, -2.2214, 0], a=1.2, v=0.25, r=0.05)
          SECOND(p[0.3, 0.05, 0.45, 2.2214, -2.2214, 0], a=1.2, v=0.25, r=0.02)
          FIRST(p[0.3, -0.1, 0.45, 2.2214, -2.2214, 0], a=1.2, v=0.25)
        end
        """
            .replace("FIRST", first)
            .replace("SECOND", second));
    enter(running);
    int atRest = 0;
    double nearest = 1;
    while (target(running).x() > 0.37 && running.programState() == ProgramState.RUNNING) {
      running.advance(1);
      atRest += rests(running) ? 1 : 0;
      nearest = Math.min(nearest, Poses.pointDistance(target(running), CORNER));
    }
    assertEquals(rests, atRest > 0, atRest + " frames at rest");
    assertEquals(rests, nearest < 1e-9, "passes at " + nearest);
    running.finish();
    assertEquals(-0.1, target(running).y(), 1e-9);
    assertEquals(List.of(), running.reported());
  }

  @Test
  void anAccelerationThatNoArmHasIsThatOfTheArm() {
    for (int version = 1; version <= 2; version++) {
      RunningProgram running = new RunningProgram();
      running.run(
          """
          def hasty():
            motion_version_set(VERSION)
            movej([0, -1.2, -1.2, -1.57, 1.57, 0])
            movej([1, -1.2, -1.2, -1.57, 1.57, 0], a=1000, v=3)
            movel(p[0.4, 0.3, 0.4, 2.2, 2.2, 0], a=1000, v=2)
            movel(p[0.4, -0.3, 0.4, 2.2, 2.2, 0], a=1000, v=2, r=0.05)
            movej([0, -1.2, -1.2, -1.57, 1.57, 0], a=1000, v=3, r=0.1)
            movep(p[0.4, -0.3, 0.4, 2.2, 2.2, 0], a=1000, v=1, r=0.05)
            movep(p[0.4, 0.3, 0.4, 2.2, 2.2, 0], a=1000, v=1)
            textmsg("there")
          end
          """
              .replace("VERSION", "" + version));
      assertEquals(List.of("there"), running.said());
      assertEquals(List.of(), running.reported());
    }
  }

  @Test
  void speedlAtTheEndOfReachSaysSo() {
    RunningProgram running = new RunningProgram();
    running.run(
        """
        def reach():
          movej([0, -1.2, -1.2, -1.57, 1.57, 0])
          speedl([0.3, 0, 0.1, 0, 0, 0], 1.2, 5)
        end
        """);
    String reported = running.reported().getLast();
    assertTrue(
        reported.contains("the end of the arm's reach, where the elbow is straight"), reported);
    assertTrue(reported.contains("joint 2 would turn at more than 157.0"), reported);
  }

  @Test
  void whereAPathFailsTheStopBeginsAtTheSpeedThatThereIs() {
    RunningProgram running = new RunningProgram();
    running.start(
        """
        def fails():
          movej([0, -1.2, -1.2, -1.57, 1.57, 0])
          textmsg("begin")
          speedl([0.3, 0, 0.1, 0, 0, 0], 1.2, 5)
        end
        """);
    while (running.said().isEmpty()) {
      running.advance(1);
    }
    Joints q = running.state().arm().targetPositionRad();
    Joints qd = running.state().arm().targetSpeedRadPerS();
    for (int k = 0; k < 2000; k++) {
      running.advance(1);
      Joints now = running.state().arm().targetPositionRad();
      Joints speed = running.state().arm().targetSpeedRadPerS();
      for (int i = 0; i < Joints.COUNT; i++) {
        double mean = 0.5 * (qd.get(i) + speed.get(i)) * 0.002;
        double change = Math.abs(speed.get(i) - qd.get(i)) * 0.002;
        assertEquals(mean, now.get(i) - q.get(i), change + 1e-6, "frame " + k + ", joint " + i);
      }
      q = now;
      qd = speed;
    }
    assertEquals(ProgramState.STOPPED, running.programState());
  }
}
