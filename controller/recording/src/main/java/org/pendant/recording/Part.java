package org.pendant.recording;

import java.util.List;
import java.util.function.Function;
import org.pendant.controller.state.ControllerState;

/**
 * A part of a snapshot that changes now and then: the object is kept when another one takes its
 * place. The order is that of the file.
 */
final class Part {
  static final Part TOOL = new Part(0, "tool", state -> state.arm().tool(), ArmForms.TOOL);
  static final Part CONTROL =
      new Part(1, "control", state -> Control.of(state.arm()), ArmForms.CONTROL);
  static final Part FAULT = new Part(2, "fault", state -> state.arm().fault(), ArmForms.FAULT);
  static final Part PAYLOAD =
      new Part(3, "payload", state -> state.readings().payload(), ArmForms.PAYLOAD);
  static final Part MOUNTING =
      new Part(4, "mounting", state -> state.readings().mounting(), ArmForms.MOUNTING);
  static final Part SAFETY = new Part(5, "safety", ControllerState::safety, SafetyForms.STATUS);
  static final Part PROGRAM = new Part(6, "program", ControllerState::program, ProgramForms.STATUS);
  static final Part DEBUG = new Part(7, "debug", ControllerState::debug, ProgramForms.DEBUG);
  static final Part IO = new Part(8, "io", ControllerState::io, SignalForms.DIGITAL);
  static final Part SIGNALS = new Part(9, "signals", ControllerState::signals, SignalForms.SIGNALS);
  static final Part MODBUS = new Part(10, "modbus", ControllerState::modbus, OutsideForms.MODBUS);
  static final Part ASSEMBLIES =
      new Part(11, "assemblies", ControllerState::assemblies, OutsideForms.ASSEMBLIES);
  static final Part ENCODERS =
      new Part(12, "encoders", ControllerState::encoders, SignalForms.ENCODERS);
  static final Part FREEDRIVE =
      new Part(13, "freedrive", ControllerState::freedrive, ArmForms.FREEDRIVE);
  static final Part VARIABLES =
      new Part(14, "variables", ControllerState::variables, VariableForms.SAMPLES);
  static final Part TRACED = new Part(15, "traced", ControllerState::traced, VariableForms.TRACED);
  static final Part POPUPS =
      new Part(16, "popups", ControllerState::openPopups, MessageForms.POPUPS);
  static final Part QUESTIONS =
      new Part(17, "questions", ControllerState::openQuestions, MessageForms.QUESTIONS);
  static final Part NEWS = new Part(18, "news", FrameDelta::of, MessageForms.NEWS);

  /** All parts, each at its index. */
  static final List<Part> PARTS =
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
          NEWS);

  static final int COUNT = PARTS.size();

  /** A bit for each part. */
  static final int ALL = (1 << COUNT) - 1;

  private final int index;
  private final String column;
  private final Function<ControllerState, ?> getter;
  private final Form<?> form;

  private <T> Part(int index, String column, Function<ControllerState, T> getter, Form<T> form) {
    this.index = index;
    this.column = column;
    this.getter = getter;
    this.form = form;
  }

  static Part of(int index) {
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
