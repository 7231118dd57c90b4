package org.pendant.recording;

import java.util.Objects;
import java.util.function.ToDoubleFunction;
import org.pendant.controller.io.DigitalLevels;
import org.pendant.controller.io.Signal;
import org.pendant.controller.io.SignalBank;
import org.pendant.controller.quantity.StateQuantities;
import org.pendant.controller.quantity.StateQuantity;
import org.pendant.controller.state.ControllerState;
import org.pendant.controller.state.ProgramStatus;
import org.pendant.script.value.BoolValue;
import org.pendant.script.value.FloatValue;
import org.pendant.script.value.IntValue;
import org.pendant.script.value.Value;
import org.pendant.script.variables.VariablePath;
import org.pendant.script.variables.VariableSample;
import org.pendant.script.variables.VariableSamples;

/** Column: a number that {@link Recording#scan} follows through a recording. */
public final class Column {
  private final Reading reading;

  private Column(Reading reading) {
    this.reading = reading;
  }

  /** How it is found. */
  sealed interface Reading {

    /**
     * A number that is kept as it is.
     *
     * @param group where it is kept
     * @param index its place there
     */
    record Kept(NumberGroup group, int index) implements Reading {}

    /**
     * A number of a part of the snapshots.
     *
     * @param part where it is
     * @param of reads it from the part's object
     */
    record OfPart(SnapshotPart part, ToDoubleFunction<Object> of) implements Reading {}

    /**
     * A number that has to be worked out.
     *
     * @param of works it out; looked at a few times in each stretch of time only
     */
    record OfState(ToDoubleFunction<ControllerState> of) implements Reading {}
  }

  Reading reading() {
    return reading;
  }

  /**
   * A number of the catalogue of state quantities. One that recordings do not keep as it is has to
   * be worked out: it is looked at a few times in each stretch of time only.
   *
   * @param quantity its name, such as {@code actual_q}
   * @param component which of its numbers, from 0
   * @throws IllegalArgumentException if there is no such quantity
   * @throws IndexOutOfBoundsException if it has no such component
   */
  public static Column of(String quantity, int component) {
    StateQuantity found = StateQuantities.of(quantity);
    Objects.checkIndex(component, found.size());
    return new Column(
        NumberGroup.keeping(found, component)
            .<Reading>map(kept -> kept)
            .orElseGet(() -> new Reading.OfState(found.getter().element(component))));
  }

  /** The line that the main thread has reached, from 1; 0 when no program runs. */
  public static Column line() {
    return new Column(
        new Reading.OfPart(SnapshotPart.PROGRAM, part -> ((ProgramStatus) part).line()));
  }

  /** Whether a program runs: 0 for stopped, 1 for running, 2 for paused. */
  public static Column programState() {
    return new Column(
        new Reading.OfPart(
            SnapshotPart.PROGRAM,
            part ->
                switch (((ProgramStatus) part).state()) {
                  case STOPPED -> 0;
                  case RUNNING -> 1;
                  case PAUSED -> 2;
                }));
  }

  /** The levels of a group of digital signals, as a number with signal 0 as its lowest bit. */
  public static Column digital(SignalBank bank) {
    return new Column(
        new Reading.OfPart(
            SnapshotPart.IO, part -> Integer.toUnsignedLong(((DigitalLevels) part).bits(bank))));
  }

  /** The level of a digital signal, 0 or 1. */
  public static Column digital(Signal signal) {
    return new Column(
        new Reading.OfPart(SnapshotPart.IO, part -> ((DigitalLevels) part).level(signal) ? 1 : 0));
  }

  /**
   * A variable or a part of one, as the snapshots have it: about 25 times a second. NaN where there
   * is none, or it is no number; 0 and 1 for a boolean.
   */
  public static Column variable(VariablePath path) {
    return new Column(
        new Reading.OfPart(
            SnapshotPart.VARIABLES,
            part ->
                ((VariableSamples) part)
                    .find(path)
                    .flatMap(VariableSample::value)
                    .map(Column::number)
                    .orElse(Double.NaN)));
  }

  private static double number(Value value) {
    return switch (value) {
      case BoolValue bool -> bool.value() ? 1 : 0;
      case IntValue number -> number.value();
      case FloatValue number -> number.value();
      default -> Double.NaN;
    };
  }
}
