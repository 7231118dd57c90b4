package org.pendant.controller;

import static org.pendant.controller.ControllerTexts.text;

import java.util.List;
import java.util.Optional;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.box.Inertia;
import org.pendant.controller.box.ToolCentre;
import org.pendant.controller.command.Refusal;
import org.pendant.controller.encoder.PulseDecoder;
import org.pendant.controller.external.ModbusAddress;
import org.pendant.controller.external.ModbusExchange;
import org.pendant.controller.installation.ConveyorSetup;
import org.pendant.controller.installation.Installation;
import org.pendant.controller.installation.InstallationCheck;
import org.pendant.controller.installation.InstallationVariable;
import org.pendant.controller.installation.ModbusSetup;
import org.pendant.controller.installation.NamedPayload;
import org.pendant.controller.installation.SignalId;
import org.pendant.controller.installation.StartUp;
import org.pendant.controller.io.Signal;
import org.pendant.controller.io.SignalBank;
import org.pendant.controller.io.WatchdogAction;
import org.pendant.controller.message.LogEntry.Level;
import org.pendant.controller.safety.FittedSafety;
import org.pendant.controller.safety.SafetyChecksum;
import org.pendant.controller.safety.SafetyConfiguration;
import org.pendant.controller.world.Vector3;
import org.pendant.language.source.ByteText;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.dynamics.Payload;
import org.pendant.script.value.ScriptError;
import org.pendant.script.vm.Machine;

/**
 * Installation handler: applies an installation to the control box, and runs what it does at
 * start-up and in each frame. Only for the frame loop; {@link #current} may be read by any thread.
 */
final class InstallationHandler {
  /** What the log calls a fieldbus that has gone. */
  private static final String FIELDBUS_LOST = "C207A0";

  private final ControlBox box;
  private final Machine machine;
  private final InstalledSignals signals;
  private volatile Installation current = Installation.NONE;
  private Optional<Signal> powerInput = Optional.empty();
  private boolean powerLevel;

  InstallationHandler(ControlBox box, Machine machine) {
    this.box = box;
    this.machine = machine;
    signals = new InstalledSignals(box);
  }

  /** What is set up, with the values that programs have left in its variables. */
  Installation current() {
    return current;
  }

  /**
   * Sets up everything but safety, which the box was made with.
   *
   * @throws IllegalArgumentException if the check finds something wrong with it
   */
  void begin(Installation installation) {
    InstallationCheck.refusal(installation, box.arm().description())
        .ifPresent(
            why -> {
              throw new IllegalArgumentException(text("installationProblem", why));
            });
    FittedSafety safety = fitted(installation);
    // the box may have been made with limits from elsewhere
    if (SafetyChecksum.of(safety.configuration()).equals(box.safety().checksum())) {
      tellChanges(safety);
    }
    apply(installation);
  }

  /** The limits that it sets, or those that are standard, as the arm can have them. */
  private FittedSafety fitted(Installation installation) {
    ArmDescription arm = box.arm().description();
    return FittedSafety.of(
        installation.safety().orElseGet(() -> SafetyConfiguration.standard(arm)), arm);
  }

  private void tellChanges(FittedSafety safety) {
    for (FittedSafety.Change each : safety.changes()) {
      box.log().safety(Level.WARNING, "", text("safetyTakenBack", each.field(), each.message()));
    }
  }

  /**
   * Sets everything up in place of what was. No program runs, the arm is at rest, and the check has
   * found nothing wrong. Where safety differs the arm is powered off.
   */
  void change(Installation installation) {
    followSafety(installation);
    apply(installation);
    box.log().info(text("installationChanged"));
  }

  private void followSafety(Installation installation) {
    FittedSafety wanted = fitted(installation);
    SafetyChecksum before = box.safety().checksum();
    SafetyChecksum after = SafetyChecksum.of(wanted.configuration());
    if (!after.equals(before)) {
      box.safety().configure(wanted.configuration());
      tellChanges(wanted);
      box.log().safety(Level.INFO, "", text("safetyChanged", after, before));
    }
  }

  private void apply(Installation next) {
    Installation before = current;
    box.flange()
        .setTool(new ToolCentre(next.activeToolInFlange(), ByteText.asBytes(next.activeTool())));
    box.flange()
        .declarePayload(
            next.payload(next.activePayload())
                .map(InstallationHandler::payload)
                .orElse(Payload.NONE),
            0);
    Vector3 gravity = next.mounting().gravityInBaseMPerS2();
    box.arm().setGravity(gravity.x(), gravity.y(), gravity.z());
    box.safety().setTransitionHardness(next.transitionHardness() < 0.5 ? 0 : 1);
    signals.apply(next);
    next.conveyors().forEach(this::decode);
    exchange(before.modbus(), next.modbus());
    watch(next.startUp());
    current = next;
  }

  private static Payload payload(NamedPayload payload) {
    Vector3 cog = payload.cogM();
    Inertia i = payload.inertia();
    return new Payload(
        payload.massKg(),
        cog.x(),
        cog.y(),
        cog.z(),
        i.ixx(),
        i.iyy(),
        i.izz(),
        i.ixy(),
        i.ixz(),
        i.iyz());
  }

  private void decode(ConveyorSetup conveyor) {
    if (conveyor.decoder() == 0) {
      return;
    }
    PulseDecoder.Kind kind = PulseDecoder.Kind.of(conveyor.decoder());
    Signal a = pulseInput(conveyor.inputs().getFirst());
    Signal b = pulseInput(conveyor.inputs().getLast());
    box.offsets()
        .encoders()
        .get(conveyor.encoder())
        .decode(new PulseDecoder(kind, a, b), box.signals().digital());
  }

  /** The numbers of the configurable inputs follow those of the eight standard ones. */
  private static Signal pulseInput(int number) {
    return new Signal(SignalBank.CONFIGURABLE_IN, number - SignalBank.STANDARD_IN.size());
  }

  /** Signals that stay the same keep their values and their connection. */
  private void exchange(List<ModbusSetup> before, List<ModbusSetup> wanted) {
    for (ModbusSetup each : before) {
      if (!wanted.contains(each)) {
        deleteModbus(each.name());
      }
    }
    for (ModbusSetup each : wanted) {
      if (!before.contains(each)) {
        addModbus(each);
      }
    }
  }

  private void addModbus(ModbusSetup setup) {
    String name = ByteText.asBytes(setup.name());
    try {
      box.links().modbus().add(name, exchange(setup));
      box.links().modbus().signal(name).setUpdateHz(setup.updateHz());
    } catch (ScriptError e) {
      box.log().warning(text("modbusNotExchanged", name, e.getMessage()));
    }
  }

  private void deleteModbus(String name) {
    try {
      box.links().modbus().delete(ByteText.asBytes(name));
    } catch (ScriptError e) {
      // a program has deleted it already
      box.log().info(text("modbusGone", name, e.getMessage()));
    }
  }

  private static ModbusExchange exchange(ModbusSetup signal) {
    return new ModbusExchange(
        ModbusAddress.parse(ByteText.asBytes(signal.device())),
        signal.unit(),
        signal.kind(),
        signal.address(),
        1,
        signal.address(),
        1,
        false);
  }

  private void watch(StartUp startUp) {
    powerInput = SignalId.digitalInput(startUp.powerInput());
    takeLevels();
  }

  /** What inputs are now they were before: no edge. */
  void takeLevels() {
    powerLevel = powerInput.isPresent() && level(powerInput.get());
  }

  private boolean level(Signal input) {
    return box.signals().digital().level(input.bank(), input.index());
  }

  /** Looks for the edge of an input that switches the arm on; in each frame. */
  void step() {
    if (powerInput.isEmpty()) {
      return;
    }
    boolean level = level(powerInput.get());
    if (level != powerLevel) {
      powerLevel = level;
      if (level == current.startUp().powerOnHigh()) {
        Optional<Refusal> refusal = box.safety().releaseBrakes();
        box.log()
            .info(
                refusal
                    .map(why -> text("inputPowerRefused", powerInput.get(), why.text()))
                    .orElseGet(() -> text("inputPowers", powerInput.get())));
      }
    }
  }

  /** A program has ended: its values of the installation's variables are kept. */
  void programEnded() {
    Installation now = current;
    if (now.variables().isEmpty()) {
      return;
    }
    List<InstallationVariable> left =
        InstalledVariables.after(now.variables(), machine.globals(), box.log());
    if (!left.equals(now.variables())) {
      current = now.withVariables(left);
    }
  }

  /**
   * A scanner that writes an EtherNet/IP assembly has gone.
   *
   * @param who and what it was
   */
  void scannerLost(String who) {

    switch (current.ethernetIpLoss().orElse(WatchdogAction.IGNORE)) {
      case IGNORE -> {}
      case PAUSE -> {
        box.log().safety(Level.ERROR, FIELDBUS_LOST, text("scannerLostPauses", who));
        machine.pause();
      }
      case STOP -> {
        box.log().safety(Level.ERROR, FIELDBUS_LOST, text("scannerLostEnds", who));
        machine.stop();
      }
    }
  }
}
