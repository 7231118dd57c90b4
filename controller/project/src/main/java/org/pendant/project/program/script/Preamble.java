package org.pendant.project.program.script;

import java.util.List;
import java.util.Optional;
import org.pendant.controller.box.Inertia;
import org.pendant.controller.external.ToolCommunication;
import org.pendant.controller.installation.BaseMounting;
import org.pendant.controller.installation.ConveyorSetup;
import org.pendant.controller.installation.FeaturePoses;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.installation.ModbusSetup;
import org.pendant.controller.installation.NamedPayload;
import org.pendant.controller.installation.SignalId;
import org.pendant.controller.installation.SignalUse;
import org.pendant.controller.installation.Wiring;
import org.pendant.controller.io.AnalogDomain;
import org.pendant.controller.io.InputAction;
import org.pendant.controller.io.RunStateAction;
import org.pendant.controller.io.ToolOutputMode;
import org.pendant.controller.world.Vector3;
import org.pendant.models.pose.Pose;
import org.pendant.models.pose.Poses;
import org.pendant.project.program.WaypointPosition;

/**
 * Preamble writer: writes what the installation sets up, and the variables that it and the places
 * give.
 */
final class Preamble {
  private static final NamedPayload NO_PAYLOAD =
      new NamedPayload("", 0, new Vector3(0, 0, 0), Inertia.NONE);

  /** In the order of their numbers. */
  private static final List<RunStateAction> RUN_STATE_ACTIONS = List.of(RunStateAction.values());

  private final ScriptContext context;
  private final ScriptLines lines;
  private final Installation installation;

  Preamble(ScriptContext context) {
    this.context = context;
    lines = context.lines();
    installation = context.installation();
  }

  /** All of it. */
  void write() {
    call("set_tcp", ScriptText.pose(installation.activeToolInFlange()));
    call("set_gravity", gravity(installation.mounting()));
    lines.line(
        ActionWriter.payload(
            installation.payload(installation.activePayload()).orElse(NO_PAYLOAD)));
    wiring(installation.wiring());
    call("set_input_actions_to_default");
    installation.signals().forEach(this::signal);
    installation.modbus().forEach(this::modbus);
    installation.conveyors().forEach(this::conveyor);
    variables();
    waypoints();
    if (context.survey().directs()) {
      DirectionWriter.define(lines, context.pointTowards());
    }
  }

  private void call(String function, Object... arguments) {
    List<String> texts = List.of(arguments).stream().map(String::valueOf).toList();
    lines.line(function + "(" + String.join(", ", texts) + ")");
  }

  private static String gravity(BaseMounting base) {
    Vector3 gravity = base.gravityInBaseMPerS2();
    return ScriptText.list(gravity.x(), gravity.y(), gravity.z());
  }

  private void wiring(Wiring wiring) {
    ToolCommunication serial = wiring.toolCommunication();
    call(
        "set_tool_communication",
        ScriptText.bool(serial.enabled()),
        serial.baudRate(),
        serial.parity().number(),
        serial.stopBits(),
        serial.rxIdleChars(),
        serial.txIdleChars());
    call("set_tool_output_mode", wiring.toolOutputMode() == ToolOutputMode.DIGITAL ? 0 : 1);
    for (int i = 0; i < wiring.toolPins().size(); i++) {
      call("set_tool_digital_output_mode", i, wiring.toolPins().get(i).number());
    }
    call("set_tool_voltage", wiring.toolVoltage());
    call("set_safety_mode_transition_hardness", Math.round(installation.transitionHardness()));
    domains("set_standard_analog_input_domain", wiring.analogIn());
    domains("set_tool_analog_input_domain", wiring.toolAnalogIn());
    domains("set_analog_outputdomain", wiring.analogOut());
  }

  private void domains(String function, List<AnalogDomain> domains) {
    for (int i = 0; i < domains.size(); i++) {
      call(function, i, domains.get(i).number());
    }
  }

  private void signal(SignalUse use) {
    Optional<SignalId> signal = SignalId.of(use.signal());
    if (use.input() == InputAction.FREEDRIVE) {
      signal
          .filter(SignalId::takesInputAction)
          .ifPresent(each -> lines.line(SignalCode.action(each, "freedrive")));
    }
    if (use.output() != RunStateAction.PRESERVE) {
      int action = RUN_STATE_ACTIONS.indexOf(use.output());
      signal
          .filter(SignalId::takesOutputAction)
          .ifPresent(each -> lines.line(SignalCode.runState(each, action)));
    }
  }

  private void modbus(ModbusSetup signal) {
    String name = ScriptText.string(signal.name());
    call(
        "modbus_add_signal",
        ScriptText.string(signal.device()),
        signal.unit(),
        signal.address(),
        signal.kind().number(),
        name,
        ScriptText.bool(false));
    call("modbus_set_signal_update_frequency", name, signal.updateHz());
  }

  private void conveyor(ConveyorSetup conveyor) {
    List<Integer> inputs = conveyor.inputs();
    if (conveyor.decoder() != 0 && !inputs.isEmpty()) {
      call(
          "encoder_enable_pulse_decode",
          conveyor.encoder(),
          conveyor.decoder(),
          inputs.getFirst(),
          inputs.getLast());
    }
  }

  private void variables() {
    installation
        .features()
        .forEach(
            feature ->
                FeaturePoses.pose(feature)
                    .ifPresent(pose -> global(feature.name(), ScriptText.pose(pose))));
    installation.variables().stream()
        .filter(each -> !each.name().isBlank() && !each.value().isBlank())
        .forEach(each -> global(each.name(), ScriptText.oneLine(each.value().strip())));
  }

  private void global(String name, String value) {
    lines.line("global " + context.names().variable(name) + " = " + value);
  }

  private void waypoints() {
    context
        .tree()
        .waypoints()
        .forEach(
            (name, position) -> {
              String pose = context.names().pose(name);
              String joints = context.names().joints(name);
              if (context.survey().waypoints().contains(name)
                  || context.survey().words().contains(pose)
                  || context.survey().words().contains(joints)) {
                lines.line("global " + pose + " = " + ScriptText.pose(inBase(position)));
                lines.line("global " + joints + " = " + ScriptText.joints(position.jointsRad()));
              }
            });
  }

  private Pose inBase(WaypointPosition position) {
    return installation
        .feature(position.feature())
        .flatMap(FeaturePoses::pose)
        .map(frame -> Poses.trans(frame, position.tcp()))
        .orElse(position.tcp());
  }
}
