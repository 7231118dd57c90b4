package org.pendant.controller;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.pendant.controller.safety.RobotMode;
import org.pendant.controller.safety.SafetyCommand;
import org.pendant.controller.safety.SafetyMode;
import org.pendant.models.arm.Joints;
import org.pendant.script.vm.Ending;
import org.pendant.script.vm.ProgramState;

/** Programs that stop the arm, pause themselves or switch everything off. */
final class SafetyProgramTest {
  /** Frames of the 5 s that a protective stop lasts at least. */
  private static final int UNLOCK_FRAMES = 2500;

  private static final String MOVE = "movej([1, -1, -1, -1, 1, 1])\n";

  private final RunningProgram running = new RunningProgram();

  private void resume() {
    running.advance(UNLOCK_FRAMES);
    running.done(new SafetyCommand.UnlockProtectiveStop(false));
    running.done(new ProgramCommand.ResumeProgram());
  }

  private boolean moving() {
    return !running.state().arm().targetSpeedRadPerS().equals(Joints.ZERO);
  }

  @Test
  void aProtectiveStopHoldsTheProgramRightThere() {
    running.start(
        """
        textmsg("before")
        protective_stop()
        textmsg("after")
        """);
    running.finish();
    assertEquals(ProgramState.PAUSED, running.programState());
    assertEquals(SafetyMode.PROTECTIVE_STOP, running.state().safety().safetyMode());
    assertEquals(List.of("before"), running.said());
    resume();
    running.finish();
    assertEquals(ProgramState.STOPPED, running.programState());
    assertEquals(SafetyMode.NORMAL, running.state().safety().safetyMode());
    assertEquals(List.of("before", "after"), running.said());
  }

  /** Programs whose last statement is a protective stop, whatever is around it. */
  @ParameterizedTest
  @ValueSource(
      strings = {
        "textmsg(\"before\")\nprotective_stop()\n",
        """
        def last():
          if True:
            textmsg("before")
            protective_stop()
          else:
            textmsg("not")
          end
        end
        last()
        """,
        """
        while True:
          textmsg("before")
          protective_stop()
          break
        end
        """,
        """
        thread other():
          sleep(0.1)
          textmsg("not")
        end
        run other()
        textmsg("before")
        protective_stop()
        """
      })
  void aProtectiveStopEndsAProgramThatHasNothingLeftToDo(String program) {
    running.start(program);
    running.finish();
    assertEquals(ProgramState.STOPPED, running.programState());
    assertInstanceOf(Ending.Stopped.class, running.state().program().ending().orElseThrow());
    assertEquals(SafetyMode.PROTECTIVE_STOP, running.state().safety().safetyMode());
    running.advance(UNLOCK_FRAMES);
    running.done(new SafetyCommand.UnlockProtectiveStop(false));
    assertEquals(List.of("before"), running.said());
    running.run(MOVE);
  }

  @Test
  void aProtectiveStopInALoopHoldsTheProgram() {
    running.start("i = 0\nwhile i < 2:\n  i = i + 1\n  protective_stop()\nend\n");
    running.finish();
    assertEquals(ProgramState.PAUSED, running.programState());
    resume();
    running.finish();
    assertEquals(ProgramState.PAUSED, running.programState());
    resume();
    running.finish();
    assertEquals(ProgramState.STOPPED, running.programState());
  }

  @Test
  void aProtectiveStopThatEndsTheProgramStopsItsMoveToo() {
    running.run(
        """
        thread mover():
          movej([1, -1, -1, -1, 1, 1])
        end
        run mover()
        sleep(0.5)
        protective_stop()
        """);
    assertEquals(SafetyMode.PROTECTIVE_STOP, running.state().safety().safetyMode());
    assertTrue(moving());
    running.advance(200);
    assertFalse(moving());
    assertFalse(running.state().arm().moving());
  }

  @Test
  void aProtectiveStopOfOneThreadStopsTheMoveOfAnotherOnItsPath() {
    running.start(
        """
        thread stopper():
          sleep(0.5)
          protective_stop()
        end
        run stopper()
        """
            + MOVE
            + "textmsg(\"there\")\n");
    running.finish();
    assertEquals(ProgramState.PAUSED, running.programState());
    assertTrue(moving());
    running.advance(200);
    assertFalse(moving());
    resume();
    running.finish();
    assertEquals(List.of("there"), running.said());
    Joints goal = new Joints(1, -1, -1, -1, 1, 1);
    assertEquals(0, goal.maxAbsDifference(running.state().arm().targetPositionRad()), 1e-12);
  }

  @Test
  void aSecondaryProgramStopsThePrimaryOne() {
    running.start(MOVE);
    running.advance(200);
    running.done(
        new ProgramCommand.RunSecondary(
            running.program(
                """
                sec stop():
                  protective_stop()
                end
                """)));
    assertEquals(ProgramState.PAUSED, running.programState());
    assertEquals(SafetyMode.PROTECTIVE_STOP, running.state().safety().safetyMode());
  }

  @Test
  void powerdownEndsTheProgramAndTakesThePower() {
    running.run(
        """
        powerdown()
        textmsg("after")
        """);
    assertInstanceOf(Ending.Halted.class, running.state().program().ending().orElseThrow());
    assertTrue(running.state().safety().shutDown());
    assertEquals(RobotMode.POWER_OFF, running.state().safety().robotMode());
    assertEquals(List.of(), running.said());
  }

  @Test
  void deviationsAreReportedWhenAskedFor() {
    running.run(MOVE);
    assertEquals(List.of(), running.reported());
    running.run("position_deviation_warning(True, 0)\nmovej([0, -1, -1, -1, 1, 1])\n");
    assertTrue(
        running.reported().stream().anyMatch(line -> line.contains("C173")),
        () -> running.reported().toString());
  }

  @Test
  void aProgramIsPausedByTheErrorsThatItNames() {
    running.start("position_deviation_warning(True, 0)\npause_on_error_code(173)\n" + MOVE);
    running.finish();
    assertEquals(ProgramState.PAUSED, running.programState());
    assertEquals(SafetyMode.NORMAL, running.state().safety().safetyMode());
  }

  @Test
  void aProgramIsNotPausedByErrorsWithAnotherArgument() {
    running.run("position_deviation_warning(True, 0)\npause_on_error_code(173, 99)\n" + MOVE);
    assertTrue(running.reported().stream().anyMatch(line -> line.contains("C173")));
  }
}
