package org.pendant.recording;

import java.util.function.ToDoubleFunction;
import org.pendant.controller.io.DigitalLevels;
import org.pendant.controller.io.Signal;
import org.pendant.controller.io.SignalBank;
import org.pendant.controller.state.ControllerState;
import org.pendant.controller.state.ProgramStatus;
import org.pendant.models.arm.Joints;
import org.pendant.models.pose.Pose;
import org.pendant.script.value.BoolValue;
import org.pendant.script.value.FloatValue;
import org.pendant.script.value.IntValue;
import org.pendant.script.value.Value;
import org.pendant.script.variables.TracedVariables;
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

  /** Where joint 0 to 5 should be, rad. */
  public static Column targetPosition(int joint) {
    return joint(NumberGroup.TARGET_Q, joint);
  }

  /** How fast joint 0 to 5 should turn, rad/s. */
  public static Column targetSpeed(int joint) {
    return joint(NumberGroup.TARGET_QD, joint);
  }

  /** Where joint 0 to 5 is, rad. */
  public static Column actualPosition(int joint) {
    return joint(NumberGroup.ACTUAL_Q, joint);
  }

  /** How fast joint 0 to 5 turns, rad/s. */
  public static Column actualSpeed(int joint) {
    return joint(NumberGroup.ACTUAL_QD, joint);
  }

  /** Motor current of joint 0 to 5, A. */
  public static Column current(int joint) {
    return joint(NumberGroup.CURRENT, joint);
  }

  private static Column joint(NumberGroup group, int joint) {
    if (joint < 0 || joint >= Joints.COUNT) {
      throw new IndexOutOfBoundsException("joint is " + joint + ", must be 0 to 5");
    }
    return new Column(new Reading.Kept(group, joint));
  }

  /** The speed slider, 0 to 1. */
  public static Column speedSlider() {
    return new Column(new Reading.Kept(NumberGroup.SPEED, 0));
  }

  /** How fast motion time runs against the clock, 0 to 1. */
  public static Column speedScaling() {
    return new Column(new Reading.Kept(NumberGroup.SPEED, 1));
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

  /** A variable that was traced, in every frame; NaN where it was not. */
  public static Column traced(VariablePath path) {
    String name = path.text();
    return new Column(
        new Reading.OfPart(SnapshotPart.TRACED, part -> ((TracedVariables) part).value(name)));
  }

  /** How fast the TCP moves, m/s. */
  public static Column tcpSpeed() {
    return new Column(
        new Reading.OfState(
            state -> {
              Pose speed = state.geometry().actual().speed();
              return Math.sqrt(
                  speed.x() * speed.x() + speed.y() * speed.y() + speed.z() * speed.z());
            }));
  }

  /** Any number of the snapshots; looked at a few times in each stretch of time only. */
  public static Column of(ToDoubleFunction<ControllerState> reading) {
    return new Column(new Reading.OfState(reading));
  }
}
