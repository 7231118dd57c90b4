package org.pendant.project.program;

import org.pendant.models.pose.Pose;

/** Setting that a {@link ActionStep.SetAction} sets. Signals are such as {@code digital_out[0]}. */
public sealed interface Setting {

  /** Nothing. */
  record Nothing() implements Setting {}

  /** A digital output. */
  record Digital(String signal, boolean level) implements Setting {}

  /** An analog output, V or A. */
  record Analog(String signal, double value) implements Setting {}

  /** A digital output that is high for a time, s. */
  record Pulse(String signal, double timeS) implements Setting {}

  /** Any output, to what an expression gives. */
  record Expression(String signal, String expression) implements Setting {}

  /**
   * A payload of the installation.
   *
   * @param name of it
   */
  record NamedPayload(String name) implements Setting {}

  /**
   * A payload.
   *
   * @param massKg what hangs on the flange
   * @param cogXM of its centre of gravity in the flange frame
   */
  record Payload(double massKg, double cogXM, double cogYM, double cogZM) implements Setting {}

  /**
   * The TCP.
   *
   * @param name in the installation; empty for {@code inFlange}
   */
  record Tcp(String name, Pose inFlange) implements Setting {}

  /** One more than before in a variable of the installation. */
  record Increment(String variable) implements Setting {}
}
