package org.pendant.recording;

import java.util.List;
import java.util.Optional;
import org.pendant.controller.box.Mounting;
import org.pendant.controller.box.ToolCentre;
import org.pendant.controller.device.DeviceState;
import org.pendant.controller.eip.AssemblyImage;
import org.pendant.controller.encoder.Encoders;
import org.pendant.controller.freedrive.FreedriveState;
import org.pendant.controller.io.DigitalLevels;
import org.pendant.controller.io.SignalState;
import org.pendant.controller.message.LogLines;
import org.pendant.controller.message.Popup;
import org.pendant.controller.message.Question;
import org.pendant.controller.modbus.ModbusSignalState;
import org.pendant.controller.state.ArmGeometry;
import org.pendant.controller.state.ArmReadings;
import org.pendant.controller.state.ArmState;
import org.pendant.controller.state.ControllerState;
import org.pendant.controller.state.ProgramStatus;
import org.pendant.controller.state.SafetyStatus;
import org.pendant.controller.state.SupplyVoltages;
import org.pendant.controller.world.LinkDistances;
import org.pendant.controller.world.MovedObject;
import org.pendant.models.arm.ArmDescription;
import org.pendant.models.arm.Joints;
import org.pendant.models.dynamics.Payload;
import org.pendant.models.kinematics.ForwardKinematics;
import org.pendant.models.pose.Wrench;
import org.pendant.models.time.FrameTime;
import org.pendant.motion.MotionFailure;
import org.pendant.script.debug.DebugState;
import org.pendant.script.variables.TracedVariables;
import org.pendant.script.variables.VariableSamples;

/**
 * Snapshot decoder: makes snapshots again from the entries of a recording.
 *
 * @param arm the arm of the recording, which never changes
 * @param kinematics its kinematics
 */
@SuppressWarnings("unchecked") // each part is what the getter of its Part answers
record Snapshots(ArmDescription arm, ForwardKinematics kinematics) {
  /** Those of the same arm as {@code state}. */
  static Snapshots like(ControllerState state) {
    return new Snapshots(state.arm().description(), state.arm().kinematics());
  }

  /** The snapshot of frame {@code frame}, of which {@code at} stands at the last change. */
  ControllerState of(SegmentCursor at, long frame) {
    ArmState armState = armState(at);
    ArmReadings readings = readings(at);
    LinkDistances linkDistances =
        new LinkDistances(at.number(NumberGroup.LINKS, 0), at.number(NumberGroup.LINKS, 1));
    FrameDelta frameDelta = (FrameDelta) at.part(SnapshotPart.NEWS);
    if (at.frame() != frame || !at.changed(SnapshotPart.NEWS)) {
      frameDelta = frameDelta.old();
    }
    return new ControllerState(
        frame,
        frame / (double) FrameTime.FRAMES_PER_SECOND,
        at.number(NumberGroup.AMBIENT, 10),
        0,
        at.frame() != frame,
        armState,
        readings,
        new ArmGeometry(armState, readings, arm -> linkDistances),
        (SafetyStatus) at.part(SnapshotPart.SAFETY),
        (ProgramStatus) at.part(SnapshotPart.PROGRAM),
        (DebugState) at.part(SnapshotPart.DEBUG),
        (DigitalLevels) at.part(SnapshotPart.IO),
        (SignalState) at.part(SnapshotPart.SIGNALS),
        (List<ModbusSignalState>) at.part(SnapshotPart.MODBUS),
        (List<DeviceState>) at.part(SnapshotPart.DEVICES),
        (List<MovedObject>) at.part(SnapshotPart.MOVED),
        (AssemblyImage) at.part(SnapshotPart.ASSEMBLIES),
        (Encoders.Counts) at.part(SnapshotPart.ENCODERS),
        (FreedriveState) at.part(SnapshotPart.FREEDRIVE),
        (VariableSamples) at.part(SnapshotPart.VARIABLES),
        (TracedVariables) at.part(SnapshotPart.TRACED),
        (List<Popup>) at.part(SnapshotPart.POPUPS),
        (List<Question>) at.part(SnapshotPart.QUESTIONS),
        frameDelta.entries().isEmpty() ? LogLines.NONE : new LogLines.Listed(frameDelta.entries()),
        frameDelta.popups(),
        frameDelta.questions(),
        frameDelta.events(),
        frameDelta.newestEntry());
  }

  private ArmState armState(SegmentCursor at) {
    ControlStatus control = (ControlStatus) at.part(SnapshotPart.CONTROL);
    return new ArmState(
        joints(at, NumberGroup.TARGET_Q),
        joints(at, NumberGroup.TARGET_QD),
        joints(at, NumberGroup.TARGET_QDD),
        joints(at, NumberGroup.ACTUAL_Q),
        joints(at, NumberGroup.ACTUAL_QD),
        (ToolCentre) at.part(SnapshotPart.TOOL),
        arm,
        kinematics,
        control.mode(),
        control.moving(),
        control.steady(),
        at.number(NumberGroup.SPEED, 0),
        at.number(NumberGroup.SPEED, 1),
        (Optional<MotionFailure>) at.part(SnapshotPart.FAULT));
  }

  private static ArmReadings readings(SegmentCursor at) {
    return new ArmReadings(
        joints(at, NumberGroup.ACCELERATION),
        joints(at, NumberGroup.TORQUE),
        joints(at, NumberGroup.EXTERNAL_TORQUE),
        joints(at, NumberGroup.TARGET_TORQUE),
        joints(at, NumberGroup.CURRENT),
        joints(at, NumberGroup.TARGET_CURRENT),
        joints(at, NumberGroup.AMBIENT),
        at.number(NumberGroup.AMBIENT, 6),
        at.number(NumberGroup.AMBIENT, 7),
        at.number(NumberGroup.TOOL_CURRENT, 0),
        new ArmReadings.Acceleration(
            at.number(NumberGroup.TOOL_ACCELERATION, 0),
            at.number(NumberGroup.TOOL_ACCELERATION, 1),
            at.number(NumberGroup.TOOL_ACCELERATION, 2)),
        wrench(at, NumberGroup.FLANGE_WRENCH),
        wrench(at, NumberGroup.RAW_WRENCH),
        (Payload) at.part(SnapshotPart.PAYLOAD),
        (Mounting) at.part(SnapshotPart.MOUNTING),
        new SupplyVoltages(
            at.number(NumberGroup.SUPPLY, 4),
            at.number(NumberGroup.SUPPLY, 5),
            new Joints(
                at.number(NumberGroup.SUPPLY, 6),
                at.number(NumberGroup.SUPPLY, 7),
                at.number(NumberGroup.SUPPLY, 8),
                at.number(NumberGroup.SUPPLY, 9),
                at.number(NumberGroup.SUPPLY, 10),
                at.number(NumberGroup.SUPPLY, 11))),
        at.number(NumberGroup.SUPPLY, 0),
        at.number(NumberGroup.AMBIENT, 8),
        at.number(NumberGroup.AMBIENT, 9),
        at.number(NumberGroup.SUPPLY, 1),
        at.number(NumberGroup.SUPPLY, 2),
        at.number(NumberGroup.SUPPLY, 3));
  }

  private static Joints joints(SegmentCursor at, NumberGroup group) {
    return new Joints(
        at.number(group, 0),
        at.number(group, 1),
        at.number(group, 2),
        at.number(group, 3),
        at.number(group, 4),
        at.number(group, 5));
  }

  private static Wrench wrench(SegmentCursor at, NumberGroup group) {
    return new Wrench(
        at.number(group, 0),
        at.number(group, 1),
        at.number(group, 2),
        at.number(group, 3),
        at.number(group, 4),
        at.number(group, 5));
  }
}
