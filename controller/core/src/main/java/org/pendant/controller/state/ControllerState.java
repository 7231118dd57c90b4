package org.pendant.controller.state;

import java.util.List;
import org.pendant.controller.device.DeviceState;
import org.pendant.controller.eip.AssemblyImage;
import org.pendant.controller.encoder.Encoders;
import org.pendant.controller.freedrive.FreedriveState;
import org.pendant.controller.io.DigitalLevels;
import org.pendant.controller.io.SignalState;
import org.pendant.controller.message.LogEntry;
import org.pendant.controller.message.LogLines;
import org.pendant.controller.message.Popup;
import org.pendant.controller.message.Question;
import org.pendant.controller.modbus.ModbusSignalState;
import org.pendant.controller.world.MovedObject;
import org.pendant.models.arm.Joints;
import org.pendant.script.debug.DebugState;
import org.pendant.script.variables.TracedVariables;
import org.pendant.script.variables.VariableSamples;
import org.pendant.script.vm.ProgramEvent;

/**
 * Controller state: everything about a controller at the end of one frame. Immutable: take the
 * reference and keep it.
 *
 * <p>The lists of new messages hold those of this frame only; who looks less often than once a
 * frame sees gaps in their numbers and asks the log.
 *
 * @param frame number of the frame, 0 before the first
 * @param timeS controller time at its end, s
 * @param executionTimeS how long the computer worked at this frame, s; in virtual time 0, or with
 *     measured readings as long as a recorded control box does
 * @param behindS by how much robot time has fallen behind the wall clock since the controller was
 *     switched on, s: delays that the computer was too slow to catch up; not part of recordings
 * @param armRests whether readings of the arm differ from those of the frame before, and by their
 *     noise alone; no other arm of its cell moves then. A recording may say so of frames whose
 *     readings it has left out
 * @param geometry what follows from the joints, worked out on demand
 * @param debug whether a debugger has paused the program, and where its threads are then; snapshots
 *     of a held frame repeat its number
 * @param io levels of the digital signals
 * @param signals all other signals: analog ones, registers, the tool connector
 * @param devices the devices of the cell
 * @param moved where the objects of the scene are that have a mass; recordings have it once in some
 *     frames
 * @param assemblies data that are exchanged by EtherNet/IP, without those built in
 * @param modbus the signals at Modbus devices that programs have added
 * @param encoders what the encoders of conveyors count
 * @param freedrive whether the arm is guided by hand
 * @param variables of the running or last program, taken now and then
 * @param traced numbers among them that are wanted in every frame
 * @param openPopups on the screen, oldest first
 * @param openQuestions to the operator, oldest first
 * @param newLines log lines of this frame, as long as the log keeps them
 * @param newPopups popups shown in this frame, those already answered included
 * @param newQuestions asked in this frame, those already answered included
 * @param newProgramEvents programs that started and ended in this frame, in order
 * @param newestEntry number of the newest log line, 0 for none
 */
public record ControllerState(
    long frame,
    double timeS,
    double executionTimeS,
    double behindS,
    boolean armRests,
    ArmState arm,
    ArmReadings readings,
    ArmGeometry geometry,
    SafetyStatus safety,
    ProgramStatus program,
    DebugState debug,
    DigitalLevels io,
    SignalState signals,
    List<ModbusSignalState> modbus,
    List<DeviceState> devices,
    List<MovedObject> moved,
    AssemblyImage assemblies,
    Encoders.Counts encoders,
    FreedriveState freedrive,
    VariableSamples variables,
    TracedVariables traced,
    List<Popup> openPopups,
    List<Question> openQuestions,
    LogLines newLines,
    List<Popup> newPopups,
    List<Question> newQuestions,
    List<ProgramEvent> newProgramEvents,
    long newestEntry) {
  /** Copies the lists. */
  public ControllerState {
    modbus = List.copyOf(modbus);
    devices = List.copyOf(devices);
    moved = List.copyOf(moved);
    openPopups = List.copyOf(openPopups);
    openQuestions = List.copyOf(openQuestions);
    newPopups = List.copyOf(newPopups);
    newQuestions = List.copyOf(newQuestions);
    newProgramEvents = List.copyOf(newProgramEvents);
  }

  /** The same with the arm read elsewhere, and all that follows from where it is. */
  public ControllerState withActualPosition(Joints positionRad) {
    ArmState read = arm.withActualPosition(positionRad);
    return new ControllerState(
        frame,
        timeS,
        executionTimeS,
        behindS,
        armRests,
        read,
        readings,
        geometry.of(read),
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
        freedrive,
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

  /**
   * The log lines of this frame. A reader that takes longer than some frames may find that the log
   * keeps the first of them no longer; {@link #newestEntry} tells.
   */
  public List<LogEntry> newEntries() {
    return newLines.entries();
  }
}
