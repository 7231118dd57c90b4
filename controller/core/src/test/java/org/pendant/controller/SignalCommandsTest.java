package org.pendant.controller;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.pendant.controller.command.Refusal;
import org.pendant.controller.command.Reply;
import org.pendant.controller.io.AnalogBank;
import org.pendant.controller.io.AnalogDomain;
import org.pendant.controller.io.IoCommand;
import org.pendant.controller.io.RegisterDirection;
import org.pendant.controller.io.Signal;
import org.pendant.controller.io.SignalBank;
import org.pendant.controller.io.SignalState;
import org.pendant.controller.io.SignalWrite;

class SignalCommandsTest {
  private static final SignalWrite OUTPUT =
      new SignalWrite.Digital(new Signal(SignalBank.STANDARD_OUT, 2), true);

  private final RunningProgram robot = new RunningProgram();

  private static SignalWrite integer(int address, int value) {
    return new SignalWrite.IntegerRegister(RegisterDirection.INPUT, address, value);
  }

  private Reply refused(String reason) {
    return refused(Refusal.Code.IN_USE, reason);
  }

  private Reply refused(Refusal.Code code, String reason) {
    return new Reply.Refused(code, reason);
  }

  @Test
  void programsReadWhatIsConnected() {
    robot.done(
        new IoCommand.WriteSignals(
            new SignalWrite.AnalogInput(AnalogBank.STANDARD_IN, 0, 2.5, AnalogDomain.VOLTAGE)));
    robot.done(new IoCommand.WriteSignals(integer(3, 42)));
    robot.run("textmsg(get_standard_analog_in(0))\ntextmsg(read_input_integer_register(3))\n");
    assertEquals(List.of("2.5", "42"), robot.said());
  }

  @Test
  void snapshotsShowWhatProgramsWriteAndStayTheSameOtherwise() {
    robot.run("write_output_float_register(7, 1.5)\nset_tool_voltage(24)\n");
    SignalState signals = robot.state().signals();
    assertEquals(1.5, signals.outputs().floating(7));
    assertEquals(24, signals.tool().voltageV());
    robot.advance(5);
    assertSame(signals, robot.state().signals());
  }

  @Test
  void registersFlagsAndOutputsOutliveTheProgram() {
    robot.run("set_flag(3, True)\nwrite_output_integer_register(1, 9)\nset_analog_out(0, 1)\n");
    robot.run(
        """
        textmsg(get_flag(3))
        textmsg(read_output_integer_register(1))
        textmsg(get_standard_analog_out(0))
        """);
    assertEquals(List.of("True", "9", "0.02"), robot.said());
  }

  @Test
  void outputsAreSetByHandOnlyWhileNoProgramRuns() {
    robot.done(new IoCommand.WriteSignals(OUTPUT));
    assertEquals(4, robot.state().io().standardOut());
    robot.start("def busy():\n  sleep(1)\nend\n");
    String refusal =
        "digital_out[2] belongs to program busy: outputs are set by hand only while none runs";
    assertEquals(
        refused(Refusal.Code.PROGRAM, refusal), robot.ask(new IoCommand.WriteSignals(OUTPUT)));
    robot.done(new ProgramCommand.PauseProgram());
    assertEquals(
        refused(Refusal.Code.PROGRAM, refusal), robot.ask(new IoCommand.WriteSignals(OUTPUT)));
    robot.done(new IoCommand.WriteSignals(integer(0, 1)));
    robot.done(new IoCommand.WriteSignals("RTDE client", List.of(OUTPUT)));
  }

  @Test
  void aSignalThatIsTakenIsWrittenByItsOwnerOnly() {
    robot.done(new IoCommand.ClaimSignal("PLC", "input_integer_register[0]"));
    assertEquals(
        refused("input_integer_register[0] is in use by PLC"),
        robot.ask(new IoCommand.ClaimSignal("RTDE client", "input_integer_register[0]")));
    assertEquals(
        refused("input_integer_register[0] is in use by PLC"),
        robot.ask(
            new IoCommand.WriteSignals("RTDE client", List.of(integer(1, 5), integer(0, 5)))));
    assertEquals(0, robot.state().signals().inputs().integer(1));
    robot.done(new IoCommand.WriteSignals("PLC", List.of(integer(1, 5), integer(0, 5))));
    assertEquals(5, robot.state().signals().inputs().integer(0));
    robot.done(new IoCommand.ReleaseSignals("PLC"));
    robot.done(new IoCommand.WriteSignals(integer(0, 6)));
    assertEquals(6, robot.state().signals().inputs().integer(0));
  }

  @Test
  void signalsMayBeSetFromTheStart() {
    Controller controller =
        new Controller(ControllerOptions.headless().withSignals(List.of(integer(9, 8), OUTPUT)));
    assertEquals(8, controller.state().signals().inputs().integer(9));
    assertEquals(4, controller.state().io().standardOut());
  }
}
