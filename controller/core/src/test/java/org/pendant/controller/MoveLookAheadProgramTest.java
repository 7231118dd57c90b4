package org.pendant.controller;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.pendant.controller.command.Reply;
import org.pendant.controller.io.IoCommand;
import org.pendant.controller.io.SignalBank;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;
import org.pendant.script.debug.Breakpoint;
import org.pendant.script.debug.Debugger;
import org.pendant.script.vm.ProgramState;

/** The controller looks along a program for the next moves, and that is all it does there. */
final class MoveLookAheadProgramTest {
  /** Waypoints on a line, 10 mm apart, that the arm could stop in only from 0.05 m/s. */
  private static final double CRUISING_M_PER_S = 0.2;

  private static final String BEGIN =
      """
      def along():
        movel(p[0.45, -0.15, 0.45, 2.2214, -2.2214, 0])
        textmsg("begin")
      """;

  private static final String END =
      """
        movel(p[0.45, 0.15, 0.45, 2.2214, -2.2214, 0])
      end
      """;

  /** The slowest that the tool goes in the middle of a line. */
  private static double slowest(String text) {
    RunningProgram running = new RunningProgram();
    running.start(text);
    double slowest = Double.POSITIVE_INFINITY;
    while (running.programState() == ProgramState.RUNNING) {
      Pose before = running.state().arm().targetTcpInBase();
      running.advance(1);
      Pose now = running.state().arm().targetTcpInBase();
      if (!running.said().isEmpty() && Math.abs(now.y()) < 0.09) {
        slowest = Math.min(slowest, Poses.pointDistance(before, now) / 0.002);
      }
    }
    assertEquals(0.15, running.state().arm().targetTcpInBase().y(), 1e-9, "ends elsewhere");
    return slowest;
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        """
          i = -14
          while i < 15:
            movel(p[0.45, i * 0.01, 0.45, 2.2214, -2.2214, 0], r=0.001)
            i = i + 1
          end
        """,
        """
          i = -14
          while i < 15:
            set_tcp(p[0, 0, 0, 0, 0, 0])
            movel(p[0.45, i * 0.01, 0.45, 2.2214, -2.2214, 0], r=0.001)
            i = i + 1
          end
        """,
        """
          def go(y):
            def deeper(y):
              movel(p[0.45, y, 0.45, 2.2214, -2.2214, 0], r=0.001)
              return y
            end
            return deeper(y) + 0.01
          end
          y = -0.14
          while y < 0.145:
            y = go(y)
          end
        """,
        """
          s = struct(where = p[0.45, -0.14, 0.45, 2.2214, -2.2214, 0], step = 0.01)
          i = 0
          while i < 29:
            movel(s.where, r=0.001)
            s.where = pose_add(s.where, p[0, s.step, 0, 0, 0, 0])
            i = i + 1
          end
        """,
        """
          global ys = make_list(0, 0.0, 40)
          i = -14
          while i < 15:
            ys.append(i * 0.01)
            i = i + 1
          end
          i = 0
          while i < 29:
            textmsg("at ", i)
            set_standard_digital_out(0, i % 2 == 0)
            if get_standard_digital_in(1):
              halt
            end
            movel(p[0.45, ys[i], 0.45, 2.2214, -2.2214, 0], r=0.001)
            i = i + 1
          end
        """,
        """
          thread mover():
            i = -14
            while i < 15:
              movel(p[0.45, i * 0.01, 0.45, 2.2214, -2.2214, 0], r=0.001)
              i = i + 1
            end
          end
          h = run mover()
          join h
        """,
        """
          i = -14
          movel(p[0.45, -0.145, 0.45, 2.2214, -2.2214, 0], r=0.001)
          while i < 15:
            movel(p[0.45, i * 0.01, 0.45, 2.2214, -2.2214, 0], r=0.02)
            movel(p[0.45, i * 0.01, 0.45, 2.2214, -2.2214, 0], r=0.001)
            i = i + 1
          end
        """
      })
  void keepsItsSpeedThroughWaypointsOnTheWay(String middle) {
    double slowest = slowest(BEGIN + middle + END);
    assertTrue(slowest > CRUISING_M_PER_S, "slowest " + slowest);
  }

  @ParameterizedTest
  @ValueSource(strings = {"random()", "get_actual_tcp_pose()[1]"})
  void doesNotGuessWhatWillBeAnotherNumberThen(String what) {
    double slowest =
        slowest(
            BEGIN
                + """
                  i = 0
                  while i < 20:
                    movel(p[0.45, -0.1 + 0.01 * i + %s * 0.0001, 0.45, 2.2214, -2.2214, 0], r=0.001)
                    i = i + 1
                  end
                """
                    .formatted(what)
                + END);
    assertTrue(slowest < 0.1, "slowest " + slowest);
  }

  @Test
  void aWaypointRelativeToTheOneOnTheWayIsForeseen() {
    double slowest =
        slowest(
            """
            def relative():
              movel(p[0.45, -0.15, 0.45, 2.2214, -2.2214, 0])
              textmsg("begin")
              movel(p[0.45, -0.05, 0.45, 2.2214, -2.2214, 0], r=0.002)
              movel(pose_add(get_target_waypoint(), p[0, 0.2, 0, 0, 0, 0]))
            end
            """);
    assertTrue(slowest > CRUISING_M_PER_S, "slowest " + slowest);
  }

  /** Whatever a program has to show, with moves that blend (and are foreseen) or not. */
  private static List<String> shown(String radius) {
    RunningProgram running = new RunningProgram();
    running.start(
        """
        def busy():
          global calls = 0
          global words = make_list(0, "", 50)
          def note(what):
            calls = calls + 1
            words.append(what)
            set_standard_digital_out(2, calls % 2 == 1)
            write_output_integer_register(3, calls)
            return calls
          end
          i = 0
          while i < 12:
            textmsg("random ", random())
            a = [1, 2, 3]
            a[i % 3] = note("turn")
            movel(p[0.45, -0.1 + 0.01 * i, 0.45, 2.2214, -2.2214, 0], r=RADIUS)
            textmsg(a)
            if i % 4 == 3:
              note("fourth")
              sleep(0.01)
            end
            i = i + 1
          end
          textmsg(calls, " calls")
          textmsg(words)
          textmsg(random())
        end
        """
            .replace("RADIUS", radius));
    int changes = 0;
    boolean level = false;
    while (running.programState() == ProgramState.RUNNING) {
      running.advance(1);
      boolean now = (running.state().io().bits(SignalBank.STANDARD_OUT) & 4) != 0;
      changes += now == level ? 0 : 1;
      level = now;
    }
    List<String> all = new ArrayList<>(running.said());
    all.addAll(running.reported());
    all.add(changes + " changes");
    return all;
  }

  @Test
  void leavesNoTrace() {
    List<String> stopping = shown("0");
    assertEquals(stopping, shown("0.003"));
    assertEquals("15 changes", stopping.getLast());
  }

  @Test
  void aProgramThatChangesItsMindWhereTheBlendBeginsStaysWithinItsLimits() {
    RunningProgram running = new RunningProgram();
    running.start(
        """
        def choice():
          movel(p[0.45, -0.15, 0.45, 2.2214, -2.2214, 0])
          textmsg("begin")
          movel(p[0.45, 0.05, 0.45, 2.2214, -2.2214, 0], r=0.005)
          if get_standard_digital_in(0):
            movel(p[0.45, -0.1, 0.5, 2.2214, -2.2214, 0])
          else:
            movel(p[0.45, 0.2, 0.45, 2.2214, -2.2214, 0])
          end
        end
        """);
    while (running.said().isEmpty() || running.state().arm().targetTcpInBase().y() < 0.04) {
      running.advance(1);
    }
    running.done(new IoCommand.SetInput("digital_in[0]", true));
    Joints before = running.state().arm().targetSpeedRadPerS();
    double hardest = 0;
    while (running.programState() == ProgramState.RUNNING) {
      running.advance(1);
      Joints now = running.state().arm().targetSpeedRadPerS();
      hardest = Math.max(hardest, now.maxAbsDifference(before) / 0.002);
      before = now;
    }
    assertEquals(List.of(), running.reported());
    assertEquals(-0.1, running.state().arm().targetTcpInBase().y(), 1e-9);
    // from 0.25 m/s to rest within 10 mm at that speed, in joints that turn 3 rad for a metre
    assertTrue(hardest < 3 * 0.25 / (0.01 / 0.25), "acceleration " + hardest);
  }

  @Test
  void holdsOfADebuggerChangeNoPointInTime() {
    String text =
        BEGIN
            + """
              i = -14
              while i < 15:
                y = i * 0.01
                movel(p[0.45, y, 0.45, 2.2214, -2.2214, 0], r=0.003)
                i = i + 1
              end
            """
            + END;
    RunningProgram held = new RunningProgram();
    held.done(new DebugCommand.Debug(debugger -> debugger.set(Breakpoint.at(6))));
    held.done(new DebugCommand.Debug(debugger -> debugger.set(Breakpoint.at(8))));
    assertEquals(targets(new RunningProgram(), text), targets(held, text));
  }

  /** The targets of all frames; a debugger that holds one lets it go. */
  private static List<Joints> targets(RunningProgram running, String text) {
    List<Joints> targets = new ArrayList<>();
    running.start(text);
    while (running.programState() != ProgramState.STOPPED) {
      running.advance(1);
      while (running.state().debug().held()) {
        running.ask(new DebugCommand.Debug(Debugger::resume));
      }
      targets.add(running.state().arm().targetPositionRad());
    }
    return targets;
  }

  @Test
  void aSecondaryProgramChangesNothing() {
    String text = BEGIN + "  movel(p[0.45, 0, 0.45, 2.2214, -2.2214, 0], r=0.05)\n" + END;
    RunningProgram free = new RunningProgram();
    free.start(text);
    RunningProgram beside = new RunningProgram();
    beside.start(text);
    while (free.programState() != ProgramState.STOPPED) {
      free.advance(1);
      beside.done(
          new ProgramCommand.RunSecondary(
              beside.program("sec s():\n  set_standard_digital_out(1, True)\nend\n")));
      Joints expected = free.state().arm().targetPositionRad();
      assertEquals(expected, beside.state().arm().targetPositionRad());
    }
  }

  @Test
  void interpretedMovesBlend() {
    RunningProgram running = new RunningProgram();
    running.start("def p():\n  interpreter_mode()\nend\n");
    running.advance(5);
    for (String line :
        List.of(
            "movel(p[0.45, -0.15, 0.45, 2.2214, -2.2214, 0])",
            "textmsg(\"begin\")",
            "movel(p[0.45, 0, 0.45, 2.2214, -2.2214, 0], r=0.05)",
            "textmsg(\"between\")",
            "movel(p[0.45, 0.15, 0.45, 2.2214, -2.2214, 0])",
            "textmsg(\"end\")")) {
      assertFalse(
          running.ask(new InterpreterCommand.Interpret(line)) instanceof Reply.Refused, line);
    }
    int atRest = 0;
    while (!running.said().contains("end")) {
      running.advance(1);
      boolean rests = running.state().arm().targetSpeedRadPerS().equals(Joints.ZERO);
      atRest += rests && running.said().contains("between") ? 1 : 0;
    }
    assertTrue(atRest < 3, atRest + " frames at rest");
  }

  @Test
  void interpretedMovesThatWaitAreForeseen() {
    RunningProgram running = new RunningProgram();
    running.start("def p():\n  interpreter_mode()\nend\n");
    running.advance(5);
    List<String> lines = new ArrayList<>();
    lines.add("movel(p[0.45, -0.15, 0.45, 2.2214, -2.2214, 0])");
    lines.add("textmsg(\"begin\")");
    lines.add("def go(y):\nmovel(p[0.45, y, 0.45, 2.2214, -2.2214, 0], r=0.001)\nend");
    lines.add("step = 0.01");
    for (int i = -14; i < 15; i++) {
      lines.add("go(step * " + i + ")");
    }
    lines.add("movel(p[0.45, 0.15, 0.45, 2.2214, -2.2214, 0])");
    lines.add("textmsg(\"end\")");
    for (String line : lines) {
      assertFalse(
          running.ask(new InterpreterCommand.Interpret(line)) instanceof Reply.Refused,
          "refused " + line);
    }
    double slowest = Double.POSITIVE_INFINITY;
    while (!running.said().contains("end")) {
      Pose before = running.state().arm().targetTcpInBase();
      running.advance(1);
      Pose now = running.state().arm().targetTcpInBase();
      if (running.said().contains("begin") && Math.abs(now.y()) < 0.09) {
        slowest = Math.min(slowest, Poses.pointDistance(before, now) / 0.002);
      }
    }
    assertTrue(slowest > CRUISING_M_PER_S, "slowest " + slowest);
    assertEquals(List.of(), running.reported());
  }
}
