package org.pendant.controller.io;

/** The analog signals of the control box and the tool at one moment. */
public record AnalogLevels(
    AnalogSignal standardIn0,
    AnalogSignal standardIn1,
    AnalogSignal standardOut0,
    AnalogSignal standardOut1,
    AnalogSignal toolIn0,
    AnalogSignal toolIn1) {
  /**
   * One signal.
   *
   * @throws IllegalArgumentException if there is no such signal
   */
  public AnalogSignal signal(AnalogBank bank, int index) {
    bank.check(index);
    return switch (bank) {
      case STANDARD_IN -> index == 0 ? standardIn0 : standardIn1;
      case STANDARD_OUT -> index == 0 ? standardOut0 : standardOut1;
      case TOOL_IN -> index == 0 ? toolIn0 : toolIn1;
    };
  }

  /** The domains as RTDE and the primary interface pack them: inputs in bits 0, 1, outputs 2, 3. */
  public int standardDomainBits() {
    return standardIn0.domain().number()
        | standardIn1.domain().number() << 1
        | standardOut0.domain().number() << 2
        | standardOut1.domain().number() << 3;
  }

  /** The domains of the tool's inputs, one bit each. */
  public int toolDomainBits() {
    return toolIn0.domain().number() | toolIn1.domain().number() << 1;
  }
}
