package org.pendant.controller.installation;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.pendant.controller.box.BoxSetup;
import org.pendant.controller.io.WatchdogAction;
import org.pendant.controller.safety.SafetyConfiguration;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;

/**
 * Installation: everything that an installation file says; immutable.
 *
 * @param robot id of the arm that it is for; empty for any
 * @param calibration name of the file with the calibration of the arm, beside that of the
 *     installation; empty for an arm as its model says
 * @param tools TCPs, in the order in which they are shown
 * @param activeTool name of the one that is active when a program starts; empty for the flange
 * @param payloads in the order in which they are shown
 * @param activePayload name of the one that is active when a program starts; empty for none
 * @param mounting of the base
 * @param signals names and uses of signals
 * @param wiring of analog signals and the tool connector
 * @param features besides base and tool, in the order in which they are shown
 * @param homeRad where home is
 * @param variables that programs share
 * @param startUp what happens when the robot is switched on
 * @param safety limits and planes; empty for those that are standard for the arm
 * @param conveyors at most two
 * @param modbus signals at other devices
 * @param ethernetIpLoss what happens to the program when a scanner is lost; empty while EtherNet/IP
 *     is off
 * @param transitionHardness of set_safety_mode_transition_hardness, 0 to 1
 * @param controlHost where External Control nodes get their script from
 */
public record Installation(
    String robot,
    String calibration,
    List<NamedTool> tools,
    String activeTool,
    List<NamedPayload> payloads,
    String activePayload,
    BaseMounting mounting,
    List<SignalUse> signals,
    Wiring wiring,
    List<Feature> features,
    Joints homeRad,
    List<InstallationVariable> variables,
    StartUp startUp,
    Optional<SafetyConfiguration> safety,
    List<ConveyorSetup> conveyors,
    List<ModbusSetup> modbus,
    Optional<WatchdogAction> ethernetIpLoss,
    double transitionHardness,
    ControlHost controlHost) {
  /** Nothing is set up: bare flange, upright, no names. */
  public static final Installation NONE =
      new Installation(
          "",
          "",
          List.of(),
          "",
          List.of(),
          "",
          BaseMounting.FLOOR,
          List.of(),
          Wiring.STANDARD,
          List.of(),
          BoxSetup.START_RAD,
          List.of(),
          StartUp.NOTHING,
          Optional.empty(),
          List.of(),
          List.of(),
          Optional.empty(),
          1,
          ControlHost.STANDARD);

  /** Copies the lists. */
  public Installation {
    tools = List.copyOf(tools);
    payloads = List.copyOf(payloads);
    signals = List.copyOf(signals);
    features = List.copyOf(features);
    variables = List.copyOf(variables);
    conveyors = List.copyOf(conveyors);
    modbus = List.copyOf(modbus);
  }

  /** What comes of a change of some parts. */
  public Installation with(Consumer<InstallationParts> change) {
    InstallationParts parts = new InstallationParts(this);
    change.accept(parts);
    return parts.installation();
  }

  /** The same with other limits and planes; empty for those that are standard for the arm. */
  public Installation withSafety(Optional<SafetyConfiguration> others) {
    return with(parts -> parts.safety = others);
  }

  /** The same with other variables, or other values in them. */
  public Installation withVariables(List<InstallationVariable> others) {
    return with(parts -> parts.variables = others);
  }

  /** The same with other features. */
  public Installation withFeatures(List<Feature> others) {
    return with(parts -> parts.features = others);
  }

  /** The same with other TCPs. */
  public Installation withTools(List<NamedTool> others) {
    return with(parts -> parts.tools = others);
  }

  /** The same with another home. */
  public Installation withHome(Joints otherRad) {
    return with(parts -> parts.homeRad = otherRad);
  }

  /** The same with other names and uses of signals. */
  public Installation withSignals(List<SignalUse> others) {
    return with(parts -> parts.signals = others);
  }

  /** The TCP of a name. */
  public Optional<NamedTool> tool(String name) {
    return tools.stream().filter(each -> each.name().equals(name)).findFirst();
  }

  /** The TCP that is active when a program starts, in the flange frame. */
  public Pose activeToolInFlange() {
    return tool(activeTool).map(NamedTool::inFlange).orElse(Pose.ZERO);
  }

  /** The payload of a name. */
  public Optional<NamedPayload> payload(String name) {
    return payloads.stream().filter(each -> each.name().equals(name)).findFirst();
  }

  /** The feature of a name. */
  public Optional<Feature> feature(String name) {
    return features.stream().filter(each -> each.name().equals(name)).findFirst();
  }
}
