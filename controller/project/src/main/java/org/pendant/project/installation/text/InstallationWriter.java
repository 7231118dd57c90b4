package org.pendant.project.installation.text;

import java.util.List;
import org.pendant.controller.box.Inertia;
import org.pendant.controller.external.ToolCommunication;
import org.pendant.controller.installation.ControlHost;
import org.pendant.controller.installation.ConveyorSetup;
import org.pendant.controller.installation.Feature;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.installation.InstallationVariable;
import org.pendant.controller.installation.ModbusSetup;
import org.pendant.controller.installation.NamedPayload;
import org.pendant.controller.installation.NamedTool;
import org.pendant.controller.installation.SignalUse;
import org.pendant.controller.installation.StartUp;
import org.pendant.controller.installation.Wiring;
import org.pendant.controller.io.InputAction;
import org.pendant.controller.io.RunStateAction;
import org.pendant.controller.world.Vector3;

/**
 * Installation writer: writes an installation line by line; {@link InstallationReading} reads the
 * same lines.
 */
final class InstallationWriter {
  private final StringBuilder out = new StringBuilder();

  String write(Installation installation) {
    out.append(InstallationText.HEADING).append('\n');
    robot(installation);
    tools(installation);
    payloads(installation);
    line("mounting")
        .put("tilt-rad", installation.mounting().tiltRad())
        .put("rotation-rad", installation.mounting().rotationRad())
        .end();
    installation.signals().forEach(this::signal);
    wiring(installation.wiring());
    installation.features().forEach(this::feature);
    line("home").put("joints-rad", Words.of(installation.homeRad().toArray())).end();
    installation.variables().forEach(this::variable);
    startUp(installation.startUp());
    installation.conveyors().forEach(this::conveyor);
    installation.modbus().forEach(this::modbus);
    installation
        .ethernetIpLoss()
        .ifPresent(action -> line("ethernet-ip").put("on-loss", action).end());
    externalControl(installation.controlHost());
    line("transition").put("hardness", installation.transitionHardness()).end();
    installation.safety().ifPresent(safety -> SafetyLines.write(safety, out));
    return out.toString();
  }

  private LineWriter line(String word) {
    return LineWriter.begin(out, word);
  }

  private void robot(Installation installation) {
    boolean calibrated = !installation.calibration().isEmpty();
    if (calibrated) {
      line("robot")
          .text("id", installation.robot())
          .text("calibration", installation.calibration())
          .end();
    } else if (!installation.robot().isEmpty()) {
      line("robot").text("id", installation.robot()).end();
    }
  }

  private void tools(Installation installation) {
    for (NamedTool each : installation.tools()) {
      line("tool")
          .text("name", each.name())
          .put("in-flange", Words.of(each.inFlange().toArray()))
          .end();
    }
    if (!installation.activeTool().isEmpty()) {
      line("active-tool").text("name", installation.activeTool()).end();
    }
  }

  private void payloads(Installation installation) {
    for (NamedPayload each : installation.payloads()) {
      Vector3 cog = each.cogM();
      Inertia i = each.inertia();
      line("payload")
          .text("name", each.name())
          .put("mass-kg", each.massKg())
          .put("cog-m", Words.of(cog.x(), cog.y(), cog.z()))
          .put("inertia-kg-m2", Words.of(i.ixx(), i.iyy(), i.izz(), i.ixy(), i.ixz(), i.iyz()))
          .end();
    }
    if (!installation.activePayload().isEmpty()) {
      line("active-payload").text("name", installation.activePayload()).end();
    }
  }

  private void signal(SignalUse signal) {
    LineWriter line = line("signal").text("id", signal.signal()).textIfAny("name", signal.name());
    if (signal.input() != InputAction.DEFAULT) {
      line.put("input", signal.input());
    }
    if (signal.output() != RunStateAction.PRESERVE) {
      line.put("output", signal.output());
    }
    line.end();
  }

  private void wiring(Wiring wiring) {
    line("analog")
        .put("in", Words.of(wiring.analogIn()))
        .put("out", Words.of(wiring.analogOut()))
        .put("tool-in", Words.of(wiring.toolAnalogIn()))
        .end();
    line("tool-connector")
        .put("voltage-v", Integer.toString(wiring.toolVoltage()))
        .put("outputs", wiring.toolOutputMode())
        .put("pins", Words.of(wiring.toolPins()))
        .end();
    ToolCommunication serial = wiring.toolCommunication();
    line("tool-communication")
        .flag("enabled", serial.enabled())
        .put("baud-rate", Integer.toString(serial.baudRate()))
        .put("parity", serial.parity())
        .put("stop-bits", Integer.toString(serial.stopBits()))
        .put("rx-idle-chars", Words.of(serial.rxIdleChars()))
        .put("tx-idle-chars", Words.of(serial.txIdleChars()))
        .end();
  }

  private void feature(Feature feature) {
    line("feature")
        .text("name", feature.name())
        .put("kind", feature.kind())
        .flag("variable", feature.variable())
        .flag("joggable", feature.joggable())
        .end();
    feature.points().forEach(each -> line("  point").put("pose", Words.of(each.toArray())).end());
  }

  private void variable(InstallationVariable variable) {
    line("variable")
        .text("name", variable.name())
        .text("value", variable.value())
        .flag("favourite", variable.favourite())
        .end();
  }

  private void startUp(StartUp startUp) {
    if (startUp.equals(StartUp.NOTHING)) {
      return;
    }
    line("start-up")
        .textIfAny("program", startUp.program())
        .textIfAny("start-input", startUp.startInput())
        .put("start-on", startUp.startOnHigh() ? "high" : "low")
        .textIfAny("power-input", startUp.powerInput())
        .put("power-on", startUp.powerOnHigh() ? "high" : "low")
        .end();
  }

  private void externalControl(ControlHost host) {
    if (!host.equals(ControlHost.STANDARD)) {
      line("external-control")
          .text("host", host.host())
          .put("port", Integer.toString(host.port()))
          .end();
    }
  }

  private void conveyor(ConveyorSetup conveyor) {
    List<String> inputs = conveyor.inputs().stream().map(String::valueOf).toList();
    line("conveyor")
        .put("number", Integer.toString(conveyor.number()))
        .put("encoder", Integer.toString(conveyor.encoder()))
        .textIfAny("feature", conveyor.feature())
        .flag("circular", conveyor.circular())
        .put("ticks-per-unit", conveyor.ticksPerUnit())
        .flag("rotate-tool", conveyor.rotateTool())
        .put("decoder", Integer.toString(conveyor.decoder()))
        .put("inputs", "[" + String.join(", ", inputs) + "]")
        .end();
  }

  private void modbus(ModbusSetup signal) {
    line("modbus")
        .text("name", signal.name())
        .text("device", signal.device())
        .put("unit", Integer.toString(signal.unit()))
        .put("kind", signal.kind())
        .put("address", Integer.toString(signal.address()))
        .put("update-hz", Integer.toString(signal.updateHz()))
        .end();
  }
}
