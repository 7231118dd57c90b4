package org.pendant.project.program.script;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.pendant.project.program.script.TestTrees.body;
import static org.pendant.project.program.script.TestTrees.program;
import static org.pendant.project.program.script.TestTrees.script;
import static org.pendant.project.program.script.TestTrees.set;
import static org.pendant.project.program.script.TestTrees.sleep;
import static org.pendant.project.program.script.TestTrees.waitFor;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.pendant.controller.ProgramCommand;
import org.pendant.controller.box.Inertia;
import org.pendant.controller.box.Mounting;
import org.pendant.controller.external.ModbusKind;
import org.pendant.controller.external.ToolCommunication;
import org.pendant.controller.installation.BaseMounting;
import org.pendant.controller.installation.ControlHost;
import org.pendant.controller.installation.ConveyorSetup;
import org.pendant.controller.installation.Feature;
import org.pendant.controller.installation.FeatureKind;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.installation.InstallationVariable;
import org.pendant.controller.installation.ModbusSetup;
import org.pendant.controller.installation.NamedPayload;
import org.pendant.controller.installation.NamedTool;
import org.pendant.controller.installation.SignalUse;
import org.pendant.controller.installation.StartUp;
import org.pendant.controller.installation.Wiring;
import org.pendant.controller.io.AnalogDomain;
import org.pendant.controller.io.InputAction;
import org.pendant.controller.io.RunStateAction;
import org.pendant.controller.io.Signal;
import org.pendant.controller.io.SignalBank;
import org.pendant.controller.io.ToolConnector;
import org.pendant.controller.io.ToolOutputMode;
import org.pendant.controller.io.ToolPinMode;
import org.pendant.controller.world.Vector3;
import org.pendant.models.pose.Pose;
import org.pendant.project.program.Setting;
import org.pendant.project.program.WaitFor;

/** What the installation sets up at the start of each program. */
final class PreambleTest {
  private static final Pose GRIPPER = Pose.of(0, 0.01, 0.15, 0, 0, 0.5);
  private static final ToolCommunication SERIAL =
      new ToolCommunication(true, 9600, ToolCommunication.Parity.EVEN, 2, 1.5f, 3.5f);

  private static Installation installation(BaseMounting mounting, List<ModbusSetup> modbus) {
    return new Installation(
        "ur5e",
        "",
        List.of(new NamedTool("gripper", GRIPPER)),
        "gripper",
        List.of(
            new NamedPayload(
                "box", 2.5, new Vector3(0, 0.01, 0.05), new Inertia(0.02, 0.02, 0.01, 0, 0, 0))),
        "box",
        mounting,
        List.of(
            new SignalUse("digital_in[1]", "guide", InputAction.FREEDRIVE, RunStateAction.PRESERVE),
            new SignalUse(
                "digital_out[2]", "lamp", InputAction.DEFAULT, RunStateAction.HIGH_WHEN_RUNNING),
            new SignalUse(
                "tool_out[0]", "grip", InputAction.DEFAULT, RunStateAction.HIGH_WHEN_NOT_RUNNING),
            new SignalUse(
                "output_boolean_register[70]",
                "bit",
                InputAction.DEFAULT,
                RunStateAction.HIGH_WHEN_RUNNING),
            new SignalUse(
                "analog_out[1]", "flow", InputAction.DEFAULT, RunStateAction.HIGH_WHEN_NOT_RUNNING),
            new SignalUse(
                "input_boolean_register[9]",
                "guide too",
                InputAction.FREEDRIVE,
                RunStateAction.PRESERVE),
            new SignalUse("flag[3]", "mine", InputAction.DEFAULT, RunStateAction.PRESERVE)),
        new Wiring(
            List.of(AnalogDomain.CURRENT, AnalogDomain.VOLTAGE),
            List.of(AnalogDomain.VOLTAGE, AnalogDomain.CURRENT),
            List.of(AnalogDomain.VOLTAGE, AnalogDomain.CURRENT),
            24,
            ToolOutputMode.DUAL_PIN_POWER,
            List.of(ToolPinMode.PUSH_PULL, ToolPinMode.SOURCING),
            SERIAL),
        List.of(
            new Feature(
                "table", FeatureKind.POINT, List.of(Pose.of(0.4, 0.2, 0.1, 0, 0, 0)), true, true),
            new Feature("unfinished", FeatureKind.PLANE, List.of(), false, false)),
        Installation.NONE.homeRad(),
        List.of(
            new InstallationVariable("parts", "7", true),
            new InstallationVariable("sizes", "[1, 2]", false)),
        StartUp.NOTHING,
        Optional.empty(),
        List.of(new ConveyorSetup(1, 0, "table", false, 10000, false, 1, List.of(8, 9))),
        modbus,
        Optional.empty(),
        0,
        ControlHost.STANDARD);
  }

  private static TreeRun running() {
    TreeRun run =
        new TreeRun(
            program(script("textmsg(parts, sizes)", "textmsg(table)"), sleep(1)),
            installation(BaseMounting.FLOOR, List.of()));
    run.advance(20);
    return run;
  }

  @Test
  void toolAndPayloadAreThoseOfTheInstallation() {
    TreeRun run = running();
    assertEquals(GRIPPER, run.state().arm().tool().inFlange());
    assertEquals(2.5, run.state().readings().payload().massKg());
  }

  @Test
  void gravityFollowsTheMounting() {
    assertEquals(List.of(0.0, 0.0, 9.82), gravity(new BaseMounting(0, 1)));
    assertEquals(List.of(0.0, 0.0, -9.82), gravity(new BaseMounting(Math.PI, 0)));
    assertEquals(List.of(-9.82, 0.0, 0.0), gravity(new BaseMounting(Math.PI / 2, 0)));
    assertEquals(List.of(0.0, 9.82, 0.0), gravity(new BaseMounting(Math.PI / 2, Math.PI / 2)));
  }

  /** What the arm feels on such a base, along its axes, m/s². */
  private static List<Double> gravity(BaseMounting mounting) {
    Mounting base =
        TreeRun.of(program(), installation(mounting, List.of())).state().readings().mounting();
    return List.of(
        base.gravityXMPerS2() + 0.0, base.gravityYMPerS2() + 0.0, base.gravityZMPerS2() + 0.0);
  }

  @Test
  void signalsAreWiredAsTheInstallationSays() {
    TreeRun run = running();
    assertEquals(
        new ToolConnector(
            24, ToolOutputMode.DUAL_PIN_POWER, ToolPinMode.PUSH_PULL, ToolPinMode.SOURCING, SERIAL),
        run.state().signals().tool());
    assertEquals(AnalogDomain.CURRENT, run.state().signals().analog().standardIn0().domain());
    assertEquals(AnalogDomain.VOLTAGE, run.state().signals().analog().standardIn1().domain());
    assertEquals(AnalogDomain.VOLTAGE, run.state().signals().analog().standardOut0().domain());
    assertEquals(AnalogDomain.CURRENT, run.state().signals().analog().standardOut1().domain());
    assertEquals(AnalogDomain.CURRENT, run.state().signals().analog().toolIn1().domain());
  }

  @Test
  void inputsAndOutputsDoWhatTheInstallationSays() {
    TreeRun run = running();
    assertEquals(
        InputAction.FREEDRIVE,
        run.state().signals().actions().of(new Signal(SignalBank.STANDARD_IN, 1)));
    assertEquals(InputAction.FREEDRIVE, run.state().signals().actions().ofRegister(9));
    assertTrue(run.output(2));
    assertTrue(run.state().signals().outputs().bool(70));
    assertEquals(0, run.state().io().toolOut());
    run.submit(new ProgramCommand.StopProgram());
    run.advance(5);
    assertFalse(run.output(2));
    assertEquals(1, run.state().io().toolOut());
    assertEquals(1, run.state().signals().analog().standardOut1().ratio());
  }

  @Test
  void featuresAndVariablesAreThere() {
    assertEquals(List.of("7[1, 2]", "p[0.4, 0.2, 0.1, 0, 0, 0]"), running().said());
  }

  @Test
  void conveyorsAndDevicesAreConnected() {
    String text =
        ScriptGenerator.generate(
                "x",
                program(),
                installation(
                    BaseMounting.FLOOR,
                    List.of(
                        new ModbusSetup(
                            "gate", "127.0.0.1:1502", 255, ModbusKind.DIGITAL_OUTPUT, 16, 20))))
            .text();
    assertTrue(text.contains("  encoder_enable_pulse_decode(0, 1, 8, 9)\n"), text);
    assertTrue(
        text.contains(
            """
              modbus_add_signal("127.0.0.1:1502", 255, 16, 1, "gate", False)
              modbus_set_signal_update_frequency("gate", 20)
            """),
        text);
  }

  @Test
  void signalsOfDevicesAreReadAndSetByTheirName() {
    Installation devices =
        installation(
            BaseMounting.FLOOR,
            List.of(
                new ModbusSetup("gate", "plc", 1, ModbusKind.DIGITAL_OUTPUT, 0, 10),
                new ModbusSetup("level", "plc", 1, ModbusKind.REGISTER_OUTPUT, 0, 10),
                new ModbusSetup("lost", "plc", 1, ModbusKind.REGISTER_INPUT, 0, 10)));
    assertEquals(
        """
        $ 2 "Wait gate \u225f True"
        while (modbus_get_signal_status("gate") == False):
          sync()
        end
        $ 3 "Set gate = Off"
        modbus_set_output_signal("gate", False)
        $ 4 "Set level = n + 1"
        modbus_set_output_register("level", n + 1)
        $ 5 "Set lost = 1"
        # there is no such signal: lost
        """,
        body(
            devices,
            waitFor(new WaitFor.Digital("gate", true)),
            set(new Setting.Digital("gate", false)),
            set(new Setting.Expression("level", "n + 1")),
            set(new Setting.Expression("lost", "1"))));
  }

  @Test
  void withoutAnInstallationTheFlangeIsBare() {
    TreeRun run = TreeRun.of(program());
    assertEquals(Pose.ZERO, run.state().arm().tool().inFlange());
    assertEquals(0, run.state().readings().payload().massKg());
  }
}
