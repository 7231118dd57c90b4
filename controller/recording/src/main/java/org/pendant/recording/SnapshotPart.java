package org.pendant.recording;

import java.util.List;
import java.util.function.Function;
import org.pendant.controller.state.ControllerState;

/**
 * Snapshot part that changes now and then: the object is kept when another one takes its place. The
 * order is that of the file.
 */
final class SnapshotPart {
  static final SnapshotPart TOOL =
      new SnapshotPart(0, "tool", state -> state.arm().tool(), ArmForms.TOOL);
  static final SnapshotPart CONTROL =
      new SnapshotPart(1, "control", state -> ControlStatus.of(state.arm()), ArmForms.CONTROL);
  static final SnapshotPart FAULT =
      new SnapshotPart(2, "fault", state -> state.arm().fault(), ArmForms.FAULT);
  static final SnapshotPart PAYLOAD =
      new SnapshotPart(3, "payload", state -> state.readings().payload(), ArmForms.PAYLOAD);
  static final SnapshotPart MOUNTING =
      new SnapshotPart(4, "mounting", state -> state.readings().mounting(), ArmForms.MOUNTING);
  static final SnapshotPart SAFETY =
      new SnapshotPart(5, "safety", ControllerState::safety, SafetyForms.STATUS);
  static final SnapshotPart PROGRAM =
      new SnapshotPart(6, "program", ControllerState::program, ProgramForms.STATUS);
  static final SnapshotPart DEBUG =
      new SnapshotPart(7, "debug", ControllerState::debug, ProgramForms.DEBUG);
  static final SnapshotPart IO =
      new SnapshotPart(8, "io", ControllerState::io, SignalForms.DIGITAL);
  static final SnapshotPart SIGNALS =
      new SnapshotPart(9, "signals", ControllerState::signals, SignalForms.SIGNALS);
  static final SnapshotPart MODBUS =
      new SnapshotPart(10, "modbus", ControllerState::modbus, OutsideForms.MODBUS);
  static final SnapshotPart ASSEMBLIES =
      new SnapshotPart(11, "assemblies", ControllerState::assemblies, OutsideForms.ASSEMBLIES);
  static final SnapshotPart ENCODERS =
      new SnapshotPart(12, "encoders", ControllerState::encoders, SignalForms.ENCODERS);
  static final SnapshotPart FREEDRIVE =
      new SnapshotPart(13, "freedrive", ControllerState::freedrive, ArmForms.FREEDRIVE);
  static final SnapshotPart VARIABLES =
      new SnapshotPart(14, "variables", ControllerState::variables, VariableForms.SAMPLES);
  static final SnapshotPart TRACED =
      new SnapshotPart(15, "traced", ControllerState::traced, VariableForms.TRACED);
  static final SnapshotPart POPUPS =
      new SnapshotPart(16, "popups", ControllerState::openPopups, MessageForms.POPUPS);
  static final SnapshotPart QUESTIONS =
      new SnapshotPart(17, "questions", ControllerState::openQuestions, MessageForms.QUESTIONS);
  static final SnapshotPart NEWS = new SnapshotPart(18, "news", FrameDelta::of, MessageForms.NEWS);

  static final SnapshotPart MOVED =
      new SnapshotPart(19, "moved", ControllerState::moved, CellForms.MOVED);
  static final SnapshotPart DEVICES =
      new SnapshotPart(20, "devices", ControllerState::devices, CellForms.DEVICES);

  /** Where bodies are is kept once in so many frames. */
  static final int MOVED_FRAMES = 5;

  /** All parts, each at its index. */
  static final List<SnapshotPart> PARTS =
      List.of(
          TOOL,
          CONTROL,
          FAULT,
          PAYLOAD,
          MOUNTING,
          SAFETY,
          PROGRAM,
          DEBUG,
          IO,
          SIGNALS,
          MODBUS,
          ASSEMBLIES,
          ENCODERS,
          FREEDRIVE,
          VARIABLES,
          TRACED,
          POPUPS,
          QUESTIONS,
          NEWS,
          MOVED,
          DEVICES);

  static final int COUNT = PARTS.size();

  /** A bit for each part. */
  static final int ALL = (1 << COUNT) - 1;

  private final int index;
  private final String column;
  private final Function<ControllerState, ?> getter;
  private final Form<?> form;

  private <T> SnapshotPart(
      int index, String column, Function<ControllerState, T> getter, Form<T> form) {
    this.index = index;
    this.column = column;
    this.getter = getter;
    this.form = form;
  }

  static SnapshotPart of(int index) {
    return PARTS.get(index);
  }

  /** Its place among the parts, from 0. */
  int index() {
    return index;
  }

  /** What the header of a file calls it. */
  String column() {
    return column;
  }

  /** Its bit in a mask. */
  int bit() {
    return 1 << index;
  }

  /** This part of a snapshot. */
  Object in(ControllerState state) {
    return getter.apply(state);
  }

  /** How it stands in a file. */
  Form<?> form() {
    return form;
  }
}
