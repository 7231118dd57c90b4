package org.pendant.controller.installation;

import java.util.List;
import java.util.Optional;
import org.pendant.controller.io.WatchdogAction;
import org.pendant.controller.safety.SafetyConfiguration;
import org.pendant.models.arm.Joints;

/**
 * Installation parts while another installation is made from them, named and counted as the
 * components of {@link Installation}.
 */
public final class InstallationParts {
  public String robot;
  public String calibration;
  public List<NamedTool> tools;
  public String activeTool;
  public List<NamedPayload> payloads;
  public String activePayload;
  public BaseMounting mounting;
  public List<SignalUse> signals;
  public Wiring wiring;
  public List<Feature> features;
  public Joints homeRad;
  public List<InstallationVariable> variables;
  public StartUp startUp;
  public Optional<SafetyConfiguration> safety;
  public List<ConveyorSetup> conveyors;
  public List<ModbusSetup> modbus;
  public Optional<WatchdogAction> ethernetIpLoss;
  public double transitionHardness;
  public ControlHost controlHost;

  InstallationParts(Installation from) {
    robot = from.robot();
    calibration = from.calibration();
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
    controlHost = from.controlHost();
  }

  Installation installation() {
    return new Installation(
        robot,
        calibration,
        tools,
        activeTool,
        payloads,
        activePayload,
        mounting,
        signals,
        wiring,
        features,
        homeRad,
        variables,
        startUp,
        safety,
        conveyors,
        modbus,
        ethernetIpLoss,
        transitionHardness,
        controlHost);
  }
}
