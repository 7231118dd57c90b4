package org.pendant.project.program;

import java.util.OptionalDouble;

/** Until rule: what ends a move early. */
public sealed interface UntilRule {

  /**
   * The tool has come so far.
   *
   * @param blendRadiusM of the corner there; empty for a stop
   */
  record Distance(double distanceM, OptionalDouble blendRadiusM) implements UntilRule {
    /** With a stop there. */
    public Distance(double distanceM) {
      this(distanceM, OptionalDouble.empty());
    }
  }

  /**
   * The tool touches something.
   *
   * @param retractM how far it goes back from where it touched; 0 to stay there, negative to
   *     continue
   * @param stopDecelerationMPerS2 of the stop
   */
  record Contact(double retractM, double stopDecelerationMPerS2) implements UntilRule {}

  /** An expression holds. */
  record Expression(String condition) implements UntilRule {}

  /** A digital input has a level; {@code signal} such as {@code digital_in[0]}. */
  record DigitalInput(String signal, boolean level) implements UntilRule {}
}
