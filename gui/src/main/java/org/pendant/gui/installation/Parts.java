package org.pendant.gui.installation;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.pendant.controller.installation.BaseMounting;
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
import org.pendant.controller.io.WatchdogAction;
import org.pendant.controller.safety.SafetyConfiguration;
import org.pendant.models.arm.Joints;

/** The parts of an installation while another one is made from them. */
final class Parts {
  String robot;
  List<NamedTool> tools;
  String activeTool;
  List<NamedPayload> payloads;
  String activePayload;
  BaseMounting mounting;
  List<SignalUse> signals;
  Wiring wiring;
  List<Feature> features;
  Joints homeRad;
  List<InstallationVariable> variables;
  StartUp startUp;
  Optional<SafetyConfiguration> safety;
  List<ConveyorSetup> conveyors;
  List<ModbusSetup> modbus;
  Optional<WatchdogAction> ethernetIpLoss;
  double transitionHardness;

  private Parts(Installation from) {
    robot = from.robot();
    tools = from.tools();
    activeTool = from.activeTool();
    payloads = from.payloads();
    activePayload = from.activePayload();
    mounting = from.mounting();
    signals = from.signals();
    wiring = from.wiring();
    features = from.features();
    homeRad = from.homeRad();
    variables = from.variables();
    startUp = from.startUp();
    safety = from.safety();
    conveyors = from.conveyors();
    modbus = from.modbus();
    ethernetIpLoss = from.ethernetIpLoss();
    transitionHardness = from.transitionHardness();
  }

  /** The installation that comes of a change. */
  static Installation edit(Installation from, Consumer<Parts> change) {
    Parts parts = new Parts(from);
    change.accept(parts);
    return new Installation(
        parts.robot,
        parts.tools,
        parts.activeTool,
        parts.payloads,
        parts.activePayload,
        parts.mounting,
        parts.signals,
        parts.wiring,
        parts.features,
        parts.homeRad,
        parts.variables,
        parts.startUp,
        parts.safety,
        parts.conveyors,
        parts.modbus,
        parts.ethernetIpLoss,
        parts.transitionHardness);
  }
}
