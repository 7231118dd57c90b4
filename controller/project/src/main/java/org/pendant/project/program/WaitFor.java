package org.pendant.project.program;

/**
 * Wait condition: what a {@link ActionStep.Wait} waits for. Signals are such as {@code
 * digital_in[0]}.
 */
public sealed interface WaitFor {

  /** Nothing. */
  record Nothing() implements WaitFor {}

  /** Some time, s. */
  record Time(double timeS) implements WaitFor {}

  /** A level of a digital signal. */
  record Digital(String signal, boolean level) implements WaitFor {}

  /** An analog signal above or below a value, V or A. */
  record Analog(String signal, boolean above, double value) implements WaitFor {}

  /** An expression for true. */
  record Expression(String condition) implements WaitFor {}
}
