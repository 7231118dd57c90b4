package org.pendant.controller;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.pendant.controller.io.IoCommand;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;
import org.pendant.script.vm.ProgramState;

/** Programs whose moves blend, from outside. */
@Tag("slow")
final class BlendedProgramTest {
  private static final String CHAIN =
      """
      def chain():
        movej([0.2, -1.5, -1.6, -1.6, 1.6, 0], a=2, v=1.2, r=0.03)
        movel(p[0.45, -0.05, 0.45, 2.2214, -2.2214, 0], a=1.2, v=0.3, r=0.02)
        textmsg("half way")
        movel(p[0.45, 0.15, 0.45, 2.2214, -2.2214, 0], a=1.2, v=0.3, r=0.04)
        movej([0.3, -1.4, -1.7, -1.6, 1.5, 0.2], a=2, v=1.2, r=0.02)
        movej([-0.3, -1.4, -1.7, -1.6, 1.5, 0.2], a=2, v=1.2)
        textmsg("there")
      end
      """;

  @Test
  void arrivesWithoutStoppingOnTheWay() {
    RunningProgram running = new RunningProgram();
    running.start(CHAIN);
    int atRest = 0;
    while (running.programState() == ProgramState.RUNNING) {
      running.advance(1);
      boolean rests = running.state().arm().targetSpeedRadPerS().equals(Joints.ZERO);
      atRest += rests ? 1 : 0;
    }
    assertEquals(List.of("half way", "there"), running.said());
    assertTrue(atRest < 5, atRest + " frames at rest");
    assertTrue(running.reported().isEmpty(), running.reported().toString());
  }

  @Test
  void keepsItsSpeedThroughShallowCornersThatTheProgramLeadsTo() {
    RunningProgram running = new RunningProgram();
    running.start(
        """
        def arc():
          movel(p[0.45, -0.15, 0.45, 2.2214, -2.2214, 0])
          i = 1
          while i < 30:
            y = -0.15 + i * 0.01
            movel(p[0.45 + 0.5 * (0.0225 - y * y), y, 0.45, 2.2214, -2.2214, 0], r=0.002)
            textmsg(i)
            i = i + 1
          end
          movel(p[0.45, 0.15, 0.45, 2.2214, -2.2214, 0])
        end
        """);
    while (running.said().size() < 5) {
      running.advance(1);
    }
    double slowest = 1;
    while (running.said().size() < 25) {
      Pose before = running.state().arm().targetTcpInBase();
      running.advance(1);
      double moved = Poses.pointDistance(before, running.state().arm().targetTcpInBase());
      slowest = Math.min(slowest, moved / 0.002);
    }
    assertTrue(slowest > 0.2, "slowest " + slowest);
  }

  @Test
  void theArmGoesToTheLastWaypointWhateverItsRadius() {
    RunningProgram running = new RunningProgram();
    running.run(
        """
        def last():
          movel(p[0.45, -0.15, 0.45, 2.2214, -2.2214, 0])
          movel(p[0.45, 0.05, 0.45, 2.2214, -2.2214, 0], r=0.05)
          textmsg(get_target_tcp_pose()[1] < 0.01)
        end
        """);
    assertEquals(List.of("True"), running.said());
    assertEquals(0.05, running.state().arm().targetTcpInBase().y(), 1e-9);
    assertEquals(Joints.ZERO, running.state().arm().targetSpeedRadPerS());
  }

  @Test
  void aConditionAfterABlendedMoveIsEvaluatedWhereTheBlendBegins() {
    RunningProgram running = new RunningProgram();
    running.start(
        """
        def choice():
          movel(p[0.45, -0.15, 0.45, 2.2214, -2.2214, 0])
          textmsg("begin")
          movel(p[0.45, 0.05, 0.45, 2.2214, -2.2214, 0], r=0.05)
          textmsg(get_target_tcp_pose()[1] - 0.05)
          textmsg(is_steady())
          textmsg(get_target_waypoint()[1])
          if get_standard_digital_in(0):
            movel(p[0.55, 0.05, 0.45, 2.2214, -2.2214, 0])
          else:
            movel(p[0.35, 0.05, 0.45, 2.2214, -2.2214, 0])
          end
          textmsg(get_target_waypoint()[0])
        end
        """);
    while (running.said().isEmpty() || running.state().arm().targetTcpInBase().y() < -0.05) {
      running.advance(1);
    }
    running.done(new IoCommand.SetInput("digital_in[0]", true));
    running.finish();
    double before = Double.parseDouble(running.said().get(1));
    assertEquals(-0.05, before, 0.25 * 0.002);
    assertEquals(List.of("False", "0.05", "0.55"), running.said().subList(2, 5));
  }

  @Test
  void theNextWaypointIsTheOneOfTheMoveThatIsBlendedInto() {
    RunningProgram running = new RunningProgram();
    running.start(
        """
        def relative():
          global waypoints = []
          thread look():
            while True:
              textmsg(get_target_waypoint()[1])
              sleep(0.05)
            end
          end
          movel(p[0.45, -0.15, 0.45, 2.2214, -2.2214, 0])
          h = run look()
          movel(p[0.45, 0.05, 0.45, 2.2214, -2.2214, 0], r=0.05)
          movel(pose_add(get_target_waypoint(), p[0, 0.1, 0, 0, 0, 0]), r=0.02)
          movel(pose_add(get_target_waypoint(), p[0.1, 0, 0, 0, 0, 0]))
          kill h
        end
        """);
    running.finish();
    assertTrue(running.said().contains("0.05"), () -> running.said().toString());
    assertEquals("0.15", running.said().getLast());
    assertEquals(0.55, running.state().arm().targetTcpInBase().x(), 1e-9);
    assertEquals(0.15, running.state().arm().targetTcpInBase().y(), 1e-9);
  }

  @Test
  void movesToTheSamePlaceAreNoReasonToStop() {
    RunningProgram running = new RunningProgram();
    running.start(
        """
        def twice():
          movel(p[0.45, -0.15, 0.45, 2.2214, -2.2214, 0])
          textmsg("begin")
          movel(p[0.45, 0, 0.45, 2.2214, -2.2214, 0], r=0.03)
          movel(p[0.45, 0, 0.45, 2.2214, -2.2214, 0], r=0.03)
          movel(p[0.45, 0.15, 0.45, 2.2214, -2.2214, 0])
        end
        """);
    while (running.said().isEmpty()) {
      running.advance(1);
    }
    running.advance(10);
    int atRest = 0;
    while (running.programState() == ProgramState.RUNNING) {
      running.advance(1);
      boolean rests = running.state().arm().targetSpeedRadPerS().equals(Joints.ZERO);
      atRest += rests ? 1 : 0;
    }
    assertTrue(atRest < 3, atRest + " frames at rest");
    assertEquals(List.of(), running.reported());
  }

  @Test
  void aDurationThatIsTooShortIsReportedOnceForEachMoveThatIsMade() {
    RunningProgram running = new RunningProgram();
    running.run(
        """
        def hasty():
          movej([0, -1.5, -1.6, -1.6, 1.6, 0])
          movej([0.5, -1.5, -1.6, -1.6, 1.6, 0], r=0.02)
          movej([1, -1.2, -1.6, -1.6, 1.6, 0], t=0.05, r=0.02)
          movej([0, -1.5, -1.6, -1.6, 1.6, 0], t=0.05)
        end
        """);
    long warnings = running.reported().stream().filter(text -> text.contains("longer")).count();
    assertEquals(2, warnings, () -> running.reported().toString());
    assertEquals(2, running.reported().size(), () -> running.reported().toString());
  }

  @Test
  void abortBlendsIntoTheNextMoveRightAway() {
    RunningProgram running = new RunningProgram();
    running.start(
        """
        def aborted():
          movel(p[0.45, -0.3, 0.45, 2.2214, -2.2214, 0])
          textmsg("begin")
          movel(p[0.45, 0.3, 0.45, 2.2214, -2.2214, 0], r=0.05)
          textmsg(get_target_tcp_pose()[1] < 0)
          movel(p[0.55, -0.1, 0.45, 2.2214, -2.2214, 0])
        end
        """);
    while (running.said().isEmpty() || running.state().arm().targetTcpInBase().y() < -0.15) {
      running.advance(1);
    }
    running.done(new ProgramCommand.AbortMove());
    while (running.programState() == ProgramState.RUNNING) {
      assertTrue(running.state().arm().targetTcpInBase().y() < 0, "continues far");
      running.advance(1);
    }
    assertEquals(List.of("begin", "True"), running.said());
    assertEquals(-0.1, running.state().arm().targetTcpInBase().y(), 1e-9);
  }
}
