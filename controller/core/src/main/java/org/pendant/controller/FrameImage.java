package org.pendant.controller;

import java.util.List;
import java.util.Optional;
import org.pendant.controller.box.ControlBox;
import org.pendant.controller.device.DeviceState;
import org.pendant.controller.eip.AssemblyImage;
import org.pendant.controller.encoder.Encoders;
import org.pendant.controller.freedrive.FreedriveMode;
import org.pendant.controller.freedrive.FreedriveState;
import org.pendant.controller.io.DigitalLevels;
import org.pendant.controller.io.SignalState;
import org.pendant.controller.message.LogLines;
import org.pendant.controller.message.Popup;
import org.pendant.controller.message.Question;
import org.pendant.controller.modbus.ModbusSignalState;
import org.pendant.controller.state.ArmGeometry;
import org.pendant.controller.state.ArmImage;
import org.pendant.controller.state.ArmReadings;
import org.pendant.controller.state.ArmState;
import org.pendant.controller.state.ControlMode;
import org.pendant.controller.state.ControllerState;
import org.pendant.controller.state.LinkDistance;
import org.pendant.controller.state.ProgramStatus;
import org.pendant.controller.state.SafetyStatus;
import org.pendant.controller.world.ArmNeighbours;
import org.pendant.controller.world.MovedObject;
import org.pendant.script.debug.DebugState;
import org.pendant.script.debug.Debugger;
import org.pendant.script.variables.TracedVariables;
import org.pendant.script.variables.VariableSampler;
import org.pendant.script.variables.VariableSamples;
import org.pendant.script.variables.VariableTracer;
import org.pendant.script.vm.Machine;
import org.pendant.script.vm.ProgramEvent;

/**
 * What the snapshot of a frame is made of. The thread that drives writes over it at the end of each
 * frame; the snapshot itself is made for the first who asks for it, and everybody after that gets
 * the same one. A frame that nobody looks at costs no memory.
 */
final class FrameImage {
  private final ControlBox box;
  private final Machine machine;
  private final Debugger debugger;
  private final VariableSampler sampler;
  private final VariableTracer tracer;
  private final ArmNeighbours neighbours;

  private boolean still;
  private boolean broughtMessages;

  /**
   * The snapshot of the frame that was taken last, once somebody has asked for it; written under
   * the lock, after all else, and read without it.
   */
  private volatile Optional<ControllerState> made = Optional.empty();

  // from here on all belongs to whoever holds this object's lock
  private final ArmImage arm;

  /** Where the joints of the other arms of the cell are, rad. */
  private final double[] othersRad;

  private long frame;
  private double timeS;
  private double executionTimeS;
  private double behindS;
  private boolean armRests;
  private SafetyStatus safety;
  private ProgramStatus program = ProgramStatus.NONE;
  private DebugState debug;
  private DigitalLevels io;
  private SignalState signals;
  private List<ModbusSignalState> modbus;
  private List<DeviceState> devices;
  private List<MovedObject> moved;
  private AssemblyImage assemblies;
  private Encoders.Counts encoders;
  private Optional<FreedriveMode> guidance = Optional.empty();
  private VariableSamples variables;
  private TracedVariables traced;
  private List<Popup> openPopups;
  private List<Question> openQuestions;
  private LogLines newLines;
  private List<Popup> newPopups;
  private List<Question> newQuestions;
  private List<ProgramEvent> newProgramEvents;
  private long newestEntry;

  FrameImage(ControlBox box, Machine machine, Debugger debugger, VariableTracer tracer) {
    this.box = box;
    this.machine = machine;
    this.debugger = debugger;
    this.tracer = tracer;
    sampler = new VariableSampler(machine);
    neighbours = box.arm().neighbours();
    othersRad = new double[neighbours.numbers()];
    arm = new ArmImage(box);
    safety = SafetyStatus.of(box, Optional.empty());
    devices = List.of();
    moved = List.of();
    encoders = box.offsets().encoders().counts();
  }

  /**
   * Takes what is so at the end of this frame.
   *
   * @param executionTimeS how long the computer worked at it, s
   * @param mode how the arm is controlled
   * @param safety as the safety system has it
   * @param program how far the program is
   */
  void take(double executionTimeS, ControlMode mode, SafetyStatus safety, ProgramStatus program) {
    List<Popup> popups = box.prompts().popups().takeNew();
    DebugState held = debugger.state();
    // outside of the lock, since a look at many variables takes longer than readers should wait
    VariableSamples samples = sampler.read(held.stop().map(DebugState.Stop::number).orElse(0L));
    TracedVariables numbers = tracer.read();
    synchronized (this) {
      this.executionTimeS = executionTimeS;
      this.safety = safety;
      this.program = program;
      debug = held;
      variables = samples;
      traced = numbers;
      newPopups = popups;
      arm.take(box, mode);
      takeBox();
      if (made.isPresent()) {
        made = Optional.empty();
      }
    }
  }

  private void takeBox() {
    frame = box.clock().frame();
    timeS = box.clock().timeS();
    behindS = box.clock().behindS();
    neighbours.read(othersRad);
    armRests = box.arm().simulated().rests() && neighbours.rest();
    io = box.signals().digital().levels();
    signals = box.signals().state();
    modbus = List.copyOf(box.links().modbus().state());
    takeCell();
    assemblies = box.links().assemblies().image();
    guidance = box.modes().freedrive().mode();
    openPopups = List.copyOf(box.prompts().popups().open());
    openQuestions = List.copyOf(box.prompts().questions().open());
    newLines = box.log().takeNew();
    broughtMessages = !newLines.equals(LogLines.NONE) || !newPopups.isEmpty();
    newQuestions = box.prompts().questions().takeNew();
    newProgramEvents = machine.takeEvents();
    newestEntry = box.log().newest();
  }

  private void takeCell() {
    List<DeviceState> devicesNow = List.copyOf(box.links().devices().states());
    List<MovedObject> movedNow = List.copyOf(box.arm().world().moved());
    Encoders.Counts encodersNow = box.offsets().encoders().counts();
    still =
        arm.rests()
            && encodersNow.equals(encoders)
            && devicesNow.equals(devices)
            && movedNow.equals(moved);
    devices = devicesNow;
    moved = movedNow;
    encoders = encodersNow;
  }

  /** The safety status that was taken last. */
  SafetyStatus safety() {
    return safety;
  }

  /** Whether there are new log lines or popups. */
  boolean broughtMessages() {
    return broughtMessages;
  }

  /** Whether neither the arm nor anything around it has moved since the frame before. */
  boolean still() {
    return still;
  }

  /** The snapshot of the frame that was taken last; any thread. */
  ControllerState state() {
    Optional<ControllerState> known = made;
    return known.isPresent() ? known.get() : makeState();
  }

  private synchronized ControllerState makeState() {
    Optional<ControllerState> known = made;
    if (known.isEmpty()) {
      known = Optional.of(snapshot());
      made = known;
    }
    return known.get();
  }

  /** How near links are to something, with the other arms where they are now. */
  private LinkDistance links() {
    double[] others = othersRad.clone();
    return of ->
        box.arm().surroundings().nearest(of.actualPositionRad(), of.tool().inFlange(), others);
  }

  private ControllerState snapshot() {
    ArmState armState = arm.state();
    ArmReadings readings = arm.readings();
    return new ControllerState(
        frame,
        timeS,
        executionTimeS,
        behindS,
        armRests,
        armState,
        readings,
        new ArmGeometry(armState, readings, links()),
        safety,
        program,
        debug,
        io,
        signals,
        modbus,
        devices,
        moved,
        assemblies,
        encoders,
        FreedriveState.at(armState.description().dh(), guidance, armState.actualPositionRad()),
        variables,
        traced,
        openPopups,
        openQuestions,
        newLines,
        newPopups,
        newQuestions,
        newProgramEvents,
        newestEntry);
  }
}
