package org.pendant.controller;

import static org.junit.jupiter.api.Assertions.assertEquals;

import org.junit.jupiter.api.Test;
import org.pendant.controller.io.IoCommand;
import org.pendant.controller.io.Signal;
import org.pendant.controller.io.SignalBank;
import org.pendant.controller.io.SignalWrite;
import org.pendant.controller.safety.SafetyCommand;
import org.pendant.controller.safety.SafetyInput;
import org.pendant.controller.safety.SafetyMode;
import org.pendant.script.vm.ProgramState;

/** Outputs 0 to 7 follow the program by the choices 0 to 7 (manual 19.9). */
class RunStateTest {
  private static final String CHOOSE =
      """
      def choose():
        i = 0
        while i < 8:
          set_runstate_standard_digital_output_to_value(i, i)
          set_runstate_configurable_digital_output_to_value(i, i)
          set_runstate_gp_boolean_output_to_value(120 + i, i)
          i = i + 1
        end
        set_runstate_standard_analog_output_to_value(0, 3)
        set_runstate_tool_digital_output_to_value(1, 2)
        sleep(1)
      end
      """;
  private static final String WAIT = "def wait():\n  sleep(1)\nend\n";

  private final RunningProgram robot = new RunningProgram();

  /** Levels of outputs 7 to 0. */
  private void outputsAre(int bits) {
    String expected = binary(bits);
    assertEquals(expected, binary(robot.state().io().standardOut()), "standard");
    assertEquals(expected, binary(robot.state().io().configurableOut()), "configurable");
    assertEquals(
        expected,
        binary((int) (robot.state().signals().outputs().highBits() >>> 56)),
        "boolean registers");
  }

  private static String binary(int bits) {
    return Integer.toBinaryString(0x100 | bits).substring(1);
  }

  private void setAll(boolean level) {
    for (int i = 0; i < 8; i++) {
      robot.done(
          new IoCommand.WriteSignals(
              new SignalWrite.Digital(new Signal(SignalBank.STANDARD_OUT, i), level)));
    }
  }

  @Test
  void aProgramRunsAndEndsAsPlanned() {
    robot.start(CHOOSE);
    outputsAre(0b0110_1000);
    assertEquals(0.02, robot.state().signals().analog().standardOut0().value());
    assertEquals(0, robot.state().io().toolOut());
    robot.finish();
    outputsAre(0b0110_0100);
    assertEquals(0.004, robot.state().signals().analog().standardOut0().value());
    assertEquals(2, robot.state().io().toolOut());
  }

  @Test
  void theChoicesHoldForLaterPrograms() {
    robot.run(CHOOSE);
    setAll(true);
    robot.start(WAIT);
    assertEquals("11111111", binary(robot.state().io().standardOut()));
    robot.finish();
    assertEquals("11110101", binary(robot.state().io().standardOut()));
  }

  @Test
  void aPausedProgramDoesNotRun() {
    robot.start(CHOOSE);
    robot.done(new ProgramCommand.PauseProgram());
    outputsAre(0b0110_0100);
    robot.done(new ProgramCommand.ResumeProgram());
    outputsAre(0b0110_1100);
  }

  @Test
  void stoppingByHandIsAPlannedEnd() {
    robot.start(CHOOSE);
    robot.done(new ProgramCommand.StopProgram());
    outputsAre(0b0110_0100);
  }

  @Test
  void anErrorIsAnUnexpectedEnd() {
    robot.run(CHOOSE);
    setAll(true);
    robot.start("def broken():\n  sleep(0.1)\n  set_standard_digital_out(9, True)\nend\n");
    robot.finish();
    assertEquals("11000101", binary(robot.state().io().standardOut()));
  }

  @Test
  void aProtectiveStopIsAnUnexpectedEndUntilTheProgramGoesOn() {
    robot.run(CHOOSE);
    setAll(true);
    robot.start("def stops():\n  sleep(0.1)\n  protective_stop()\n  sleep(1)\nend\n");
    robot.finish();
    assertEquals(ProgramState.PAUSED, robot.programState());
    assertEquals(SafetyMode.PROTECTIVE_STOP, robot.state().safety().safetyMode());
    assertEquals("11000101", binary(robot.state().io().standardOut()));
    robot.advance(3000);
    robot.done(new SafetyCommand.UnlockProtectiveStop(false));
    robot.done(new ProgramCommand.ResumeProgram());
    assertEquals("11101101", binary(robot.state().io().standardOut()));
  }

  @Test
  void aProtectiveStopThatEndsTheProgramIsAnUnexpectedEnd() {
    robot.run(CHOOSE);
    setAll(true);
    robot.start("def stops():\n  sleep(0.1)\n  protective_stop()\nend\n");
    robot.finish();
    assertEquals(ProgramState.STOPPED, robot.programState());
    assertEquals("11000101", binary(robot.state().io().standardOut()));
  }

  @Test
  void aSafeguardStopIsNotUnexpected() {
    robot.run(CHOOSE);
    setAll(true);
    robot.start(WAIT);
    robot.done(new SafetyCommand.SetSafetyInput(SafetyInput.SAFEGUARD_STOP, true));
    robot.finish();
    assertEquals("11110101", binary(robot.state().io().standardOut()));
  }

  @Test
  void outputsFollowThePowerOfTheArm() {
    robot.run(CHOOSE);
    robot.done(new SafetyCommand.PowerOff());
    robot.advance(1);
    outputsAre(0b1010_0100);
    robot.done(new SafetyCommand.PowerOn());
    robot.advance(1);
    outputsAre(0b0110_0100);
  }
}
