package org.pendant.project.installation;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertInstanceOf;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.controller.Controller;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.InstallationCommand;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.RunningProgram;
import org.pendant.controller.command.Reply;
import org.pendant.controller.external.Connectors;
import org.pendant.controller.external.FakeModbus;
import org.pendant.controller.freedrive.FreedriveHolder;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.installation.InstallationVariable;
import org.pendant.controller.io.AnalogDomain;
import org.pendant.controller.io.IoCommand;
import org.pendant.controller.io.SignalText;
import org.pendant.controller.message.LogEntry;
import org.pendant.controller.modbus.ModbusSignalState;
import org.pendant.controller.safety.Applies;
import org.pendant.controller.safety.Axis;
import org.pendant.controller.safety.RobotMode;
import org.pendant.controller.safety.SafetyChecksum;
import org.pendant.controller.safety.SafetyCommand;
import org.pendant.controller.safety.SafetyConfiguration;
import org.pendant.controller.safety.SafetyMode;
import org.pendant.controller.safety.SafetyPlane;
import org.pendant.language.source.Source;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.project.installation.text.InstallationText;
import org.pendant.project.installation.text.ReadInstallation;
import org.pendant.script.vm.ProgramState;

class InstallationCommandsTest {
  private static final String WAIT = "def wait():\n  sleep(10)\nend\n";
  private static final SafetyConfiguration STANDARD =
      SafetyConfiguration.standard(ArmLibrary.load("ur5e"));

  private final FakeModbus devices = new FakeModbus();

  private static Installation installation(String lines) {
    ReadInstallation read = InstallationText.read("pendant installation 1\n" + lines);
    assertEquals(List.of(), read.problems());
    return read.installation();
  }

  private RunningProgram robot(String lines) {
    return new RunningProgram(options(lines));
  }

  private ControllerOptions options(String lines) {
    return ControllerOptions.headless()
        .withOutside(new Connectors(Connectors.NONE.sockets(), Connectors.NONE.rpc(), devices))
        .withInstallation(installation(lines));
  }

  private static String refusal(Reply reply) {
    return assertInstanceOf(Reply.Refused.class, reply).refusal().text();
  }

  private static List<String> values(RunningProgram robot, String... expressions) {
    StringBuilder program = new StringBuilder("def f():\n");
    for (String each : expressions) {
      program.append("  textmsg(").append(each).append(")\n");
    }
    int before = robot.said().size();
    robot.run(program.append("end\n").toString());
    return robot.said().subList(before, robot.said().size());
  }

  @Test
  void aControllerStartsAsItsInstallationSays() {
    RunningProgram robot =
        robot(
            """
            tool name="Gripper" in-flange=[0, 0, 0.12, 0, 0, 0]
            active-tool name="Gripper"
            payload name="Box" mass-kg=1.5 cog-m=[0, 0, 0.05] inertia-kg-m2=[0, 0, 0, 0, 0, 0]
            active-payload name="Box"
            mounting tilt-rad=3.141592653589793 rotation-rad=0
            analog in=[current, voltage] out=[voltage, current] tool-in=[voltage, voltage]
            tool-connector voltage-v=24 outputs=dual-pin-power pins=[sourcing, push-pull]
            tool-communication enabled=true baud-rate=9600 parity=even stop-bits=2 \
            rx-idle-chars=2 tx-idle-chars=3
            signal id="digital_out[0]" output=high-when-running
            signal id="tool_out[1]" output=low-when-not-running
            """);
    assertEquals(
        List.of("p[0, 0, 0.12, 0, 0, 0]", "1.5", "[0, 0, 0.05]", "True"),
        values(
            robot,
            "get_tcp_offset()",
            "get_target_payload()",
            "get_target_payload_cog()",
            "get_standard_digital_out(0)"));
    assertEquals(List.of("-9.82"), values(robot, "get_gravity()[2]"));
    assertEquals("Gripper", robot.state().arm().tool().name());
    assertEquals(AnalogDomain.CURRENT, robot.state().signals().analog().standardIn0().domain());
    assertEquals(AnalogDomain.VOLTAGE, robot.state().signals().analog().standardOut0().domain());
    assertEquals(24, robot.state().signals().tool().voltageV());
    assertEquals(9600, robot.state().signals().tool().communication().baudRate());
  }

  @Test
  void gravityFollowsTiltAndRotation() {
    RunningProgram tilted = robot("mounting tilt-rad=1.5707963267948966 rotation-rad=0\n");
    assertEquals(List.of("[-9.82, 0, 0]"), values(tilted, "get_gravity()"));
    RunningProgram turned =
        robot("mounting tilt-rad=1.5707963267948966 rotation-rad=1.5707963267948966\n");
    assertEquals(List.of("[0, 9.82, 0]"), values(turned, "get_gravity()"));
  }

  @Test
  void refusesWhatTheCheckRefuses() {
    IllegalArgumentException refused =
        assertThrows(
            IllegalArgumentException.class, () -> new Controller(options("robot id=\"ur10e\"\n")));
    assertEquals("installation: robot: it is for UR10e, the arm is UR5e", refused.getMessage());
    RunningProgram robot = robot("");
    assertEquals(
        "activeTool: there is no TCP x",
        refusal(
            robot.ask(
                new InstallationCommand.ApplyInstallation(
                    installation("active-tool name=\"x\"\n")))));
  }

  @Test
  void anotherInstallationTakesThePlaceOfTheFirst() {
    RunningProgram robot =
        robot(
            """
            tool name="Gripper" in-flange=[0, 0, 0.12, 0, 0, 0]
            active-tool name="Gripper"
            signal id="digital_out[0]" output=high-when-running
            signal id="digital_in[3]" input=freedrive
            """);
    Installation other = installation("signal id=\"digital_out[1]\" output=high-when-running\n");
    robot.done(new InstallationCommand.ApplyInstallation(other));
    robot.start(WAIT);
    robot.advance(2);
    assertEquals(0b10, robot.state().io().standardOut());
    assertEquals("", robot.state().arm().tool().name());
    assertEquals(RobotMode.RUNNING, robot.state().safety().robotMode());
    robot.done(new ProgramCommand.StopProgram());
    robot.done(new IoCommand.SetInput("digital_in[3]", true));
    robot.advance(10);
    assertFalse(robot.state().freedrive().heldBy(FreedriveHolder.INPUT));
  }

  @Test
  void nothingIsChangedWhileAProgramRuns() {
    RunningProgram robot = robot("");
    robot.start(WAIT);
    assertEquals(
        "program wait runs, stop it before the installation is changed",
        refusal(robot.ask(new InstallationCommand.ApplyInstallation(Installation.NONE))));
  }

  @Test
  void anotherSafetyConfigurationPowersTheArmOff() {
    RunningProgram robot = robot("");
    assertEquals(SafetyChecksum.of(STANDARD), robot.state().safety().checksum());
    SafetyConfiguration walled =
        STANDARD.withPlanes(
            new SafetyPlane("wall", 0, 0, 2, new Axis(0, 0, 1), Applies.BOTH, false));
    robot.done(
        new InstallationCommand.ApplyInstallation(
            Installation.NONE.withSafety(Optional.of(walled))));
    assertEquals(RobotMode.POWER_OFF, robot.state().safety().robotMode());
    assertEquals(SafetyChecksum.of(walled), robot.state().safety().checksum());
    robot.done(new SafetyCommand.ReleaseBrakes());
    robot.advance(5000);
    // the arm is beyond the plane that it has got
    assertEquals(SafetyMode.RECOVERY, robot.state().safety().safetyMode());
    robot.done(new InstallationCommand.ApplyInstallation(Installation.NONE));
    robot.done(new SafetyCommand.ReleaseBrakes());
    robot.advance(5000);
    assertEquals(SafetyMode.NORMAL, robot.state().safety().safetyMode());
    assertEquals(RobotMode.RUNNING, robot.state().safety().robotMode());
  }

  @Test
  void newReducedLimitsSlowTheArmDown() {
    SafetyConfiguration slow = STANDARD.withLimits(STANDARD.reduced(), STANDARD.reduced());
    RunningProgram robot = robot("");
    robot.done(
        new InstallationCommand.ApplyInstallation(Installation.NONE.withSafety(Optional.of(slow))));
    robot.done(new SafetyCommand.ReleaseBrakes());
    robot.advance(5000);
    robot.start("def f():\n  movej([1, -1.57, -1.57, -1.57, 1.57, 0], a=10, v=3)\nend\n");
    double fastest = 0;
    while (robot.programState() == ProgramState.RUNNING) {
      robot.advance(1);
      fastest = Math.max(fastest, robot.state().arm().targetSpeedRadPerS().get(0));
    }
    assertTrue(fastest > 0.5 && fastest < 0.5 * 1.06 * Math.PI, "" + fastest);
  }

  @Test
  void programsLeaveTheirValuesInTheVariables() {
    Controller controller =
        new Controller(
            options(
                """
                variable name="count" value="1"
                variable name="place" value="p[0, 0, 0, 0, 0, 0]" favourite=true
                variable name="other" value="True"
                """));
    Installation before = controller.installation();
    run(controller, "def f():\n  x = 1\nend\n");
    assertSame(before, controller.installation());
    run(
        controller,
        """
        def f():
          global count = 41
          count = count + 1
          global place = p[0.1, 0, 0, 0, 0, 0]
        end
        """);
    assertEquals(
        List.of(
            new InstallationVariable("count", "42", false),
            new InstallationVariable("place", "p[0.1, 0.0, 0.0, 0.0, 0.0, 0.0]", true),
            new InstallationVariable("other", "True", false)),
        controller.installation().variables());
  }

  @Test
  void aProgramThatIsStoppedOrFailsLeavesItsValuesToo() {
    Controller controller = new Controller(options("variable name=\"count\" value=\"1\"\n"));
    run(controller, "def f():\n  global count = 2\n  x = [1]\n  y = x[5]\nend\n");
    assertEquals("2", controller.installation().variables().getFirst().value());
  }

  private static void run(Controller controller, String text) {
    var program = controller.load(Source.of("t.script", text));
    var _ = controller.submit(new ProgramCommand.StartProgram(program.program().orElseThrow()));
    controller.advance();
    assertTrue(
        controller.runUntil(
            () -> controller.state().program().state() == ProgramState.STOPPED, 1000));
  }

  @Test
  void aValueThatCannotBeWrittenIsNotKept() {
    RunningProgram robot = robot("variable name=\"text\" value=\"1\"\n");
    robot.run("def f():\n  global text = 10.0 / 3\n  text = sqrt(2) * 1e308 * 10\nend\n");
    assertTrue(
        robot.reported().stream()
            .anyMatch(line -> line.startsWith("installation variable text keeps its value 1")),
        () -> robot.reported().toString());
  }

  @Test
  void anEdgeOfTheInputSwitchesTheArmOn() {
    RunningProgram robot =
        new RunningProgram(
            options("start-up power-input=\"digital_in[2]\" power-on=low\n").withPower(false));
    robot.done(new IoCommand.SetInput("digital_in[2]", true));
    robot.advance(5000);
    assertEquals(RobotMode.POWER_OFF, robot.state().safety().robotMode());
    robot.done(new IoCommand.SetInput("digital_in[2]", false));
    robot.advance(5000);
    assertEquals(RobotMode.RUNNING, robot.state().safety().robotMode());
  }

  @Test
  void anInputThatIsHighFromTheStartIsNoEdge() {
    RunningProgram robot =
        new RunningProgram(
            options("start-up power-input=\"digital_in[2]\" power-on=high\n")
                .withSignals(SignalText.input("digital_in[2]", "true"))
                .withPower(false));
    robot.advance(100);
    assertEquals(RobotMode.POWER_OFF, robot.state().safety().robotMode());
  }

  @Test
  void modbusSignalsAreExchangedFromTheStartOn() {
    String lamp =
        "modbus name=\"lamp\" device=\"10.0.0.1\" unit=3 kind=digital-output address=7"
            + " update-hz=20\n";
    RunningProgram robot = robot(lamp);
    robot.advance(1);
    ModbusSignalState shown = robot.state().modbus().getFirst();
    assertEquals("lamp", shown.name());
    assertEquals(20, shown.updateHz());
    assertEquals(7, shown.exchange().writeAddress());
    assertEquals(1, devices.points().size());
    robot.done(
        new InstallationCommand.ApplyInstallation(
            installation(lamp + lamp.replace("lamp", "door"))));
    assertEquals(2, devices.points().size(), "the first keeps its connection");
    robot.done(new InstallationCommand.ApplyInstallation(Installation.NONE));
    robot.advance(1);
    assertEquals(List.of(), robot.state().modbus());
  }

  @Test
  void aModbusSignalThatCannotBeExchangedIsNamedAndLeavesTheOthers() {
    String lamp =
        "modbus name=\"lamp\" device=\"10.0.0.1\" unit=3 kind=digital-output address=7"
            + " update-hz=20\n";
    devices.refuse("10.0.0.2");
    String door = lamp.replace("lamp", "door").replace("0.1", "0.2");
    Controller robot = new Controller(options(door + lamp + door.replace("door", "gate")));
    robot.advance();
    assertEquals(
        List.of("lamp"), robot.state().modbus().stream().map(ModbusSignalState::name).toList());
    assertEquals(
        List.of(
            "installation: Modbus signal door is not exchanged: 10.0.0.2 is refused",
            "installation: Modbus signal gate is not exchanged: 10.0.0.2 is refused"),
        robot.logSince(0).stream().map(LogEntry::text).toList());
  }

  @Test
  void pulsesOfAConveyorAreCounted() {
    RunningProgram robot =
        robot(
            """
            feature name="belt" kind=point
              point pose=[0, 0, 0, 0, 0, 0]
            conveyor number=1 encoder=1 feature="belt" ticks-per-unit=1 decoder=3 inputs=[9]
            """);
    robot.done(new IoCommand.SetInput("configurable_in[1]", true));
    robot.done(new IoCommand.SetInput("configurable_in[1]", false));
    robot.advance(2);
    assertEquals(1, robot.state().encoders().second());
  }

  @Test
  void aLostScannerHoldsTheProgramAsTheInstallationSays() {
    assertEquals(ProgramState.RUNNING, afterLoss(""));
    assertEquals(ProgramState.RUNNING, afterLoss("ethernet-ip on-loss=ignore\n"));
    assertEquals(ProgramState.PAUSED, afterLoss("ethernet-ip on-loss=pause\n"));
    assertEquals(ProgramState.STOPPED, afterLoss("ethernet-ip on-loss=stop\n"));
  }

  private ProgramState afterLoss(String lines) {
    RunningProgram robot = robot(lines);
    robot.start(WAIT);
    robot.advance(2);
    robot.done(new InstallationCommand.ScannerLost("PLC"));
    robot.advance(2);
    return robot.programState();
  }

  @Test
  void inputsOfTheOptionsComeAfterTheInstallation() {
    Controller controller =
        new Controller(
            options(
                    "analog in=[current, current] out=[current, current] tool-in=[voltage,"
                        + " voltage]\n")
                .withSignals(SignalText.input("analog_in[0]", "5V")));
    assertEquals(
        AnalogDomain.VOLTAGE, controller.state().signals().analog().standardIn0().domain());
  }
}
