package org.pendant.controller.io;

import static org.pendant.controller.io.SignalTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/**
 * Port map: what the addresses below 256 mean that scripts ({@code read_port_register}, {@code
 * write_port_bit} and their siblings, manual 18.38, 18.39, 18.70, 18.71) share with Modbus clients:
 * the box's signals at 0 to 47, memory of its own at 128 to 255.
 *
 * <p>Analog values are parts of their range: 0 for the low end, 65535 for the high one.
 */
public final class PortMap {
  private static final int FULL = 0xFFFF;

  /** The tool's signals stand above the eight of the box. */
  private static final int TOOL_SHIFT = SignalBank.STANDARD_IN.size();

  private static final int BITS = 16;

  private PortMap() {}

  /** The register at an address, 0 to 65535; empty where there is none. */
  public static Optional<Integer> register(
      int address, DigitalLevels digital, SignalState signals) {
    if (PortLevels.holds(address)) {
      return Optional.of(signals.ports().register(address) & FULL);
    }
    AnalogLevels analog = signals.analog();
    return switch (address) {
      case 0 -> Optional.of(digital.standardIn() | digital.toolIn() << TOOL_SHIFT);
      case 1 -> Optional.of(digital.standardOut() | digital.toolOut() << TOOL_SHIFT);
      // masks to set and to clear with: nothing to read
      case 2, 3, 32, 33 -> Optional.of(0);
      case 4 -> level(analog.standardIn0());
      case 5 -> domain(analog.standardIn0());
      case 6 -> level(analog.standardIn1());
      case 7 -> domain(analog.standardIn1());
      case 8 -> level(analog.toolIn0());
      case 9 -> domain(analog.toolIn0());
      case 10 -> level(analog.toolIn1());
      case 11 -> domain(analog.toolIn1());
      case 16 -> level(analog.standardOut0());
      case 17 -> domain(analog.standardOut0());
      case 18 -> level(analog.standardOut1());
      case 19 -> domain(analog.standardOut1());
      case 20 -> Optional.of(signals.tool().voltageV());
      case 21 -> Optional.of(digital.toolIn());
      case 22 -> Optional.of(digital.toolOut());
      // an injection moulding machine would be here, and is not
      case 24, 25, 26, 27, 28, 29 -> Optional.of(0);
      case 30 -> Optional.of(digital.configurableIn());
      case 31 -> Optional.of(digital.configurableOut());
      default -> Optional.empty();
    };
  }

  private static Optional<Integer> level(AnalogSignal signal) {
    return Optional.of((int) Math.round(signal.ratio() * FULL));
  }

  private static Optional<Integer> domain(AnalogSignal signal) {
    return Optional.of(signal.domain().number());
  }

  /** The bit at an address; empty where there is none. */
  public static Optional<Boolean> bit(int address, DigitalLevels digital, SignalState signals) {
    if (PortLevels.holds(address)) {
      return Optional.of(signals.ports().bit(address));
    }
    if (address < 0 || address >= 3 * BITS) {
      return Optional.empty();
    }
    int bits =
        switch (address / BITS) {
          case 0 -> digital.standardIn() | digital.toolIn() << TOOL_SHIFT;
          case 1 -> digital.standardOut() | digital.toolOut() << TOOL_SHIFT;
          default -> digital.configurableIn() | digital.configurableOut() << TOOL_SHIFT;
        };
    return Optional.of((bits >> address % BITS & 1) != 0);
  }

  /**
   * The changes that writing a register makes.
   *
   * @param value its 16 bits, 0 to 65535
   * @return none where the register can only be read; empty where there is no register
   * @throws IllegalArgumentException if the register does not take the value
   */
  public static Optional<List<SignalWrite>> writeRegister(int address, int value) {
    if (PortLevels.holds(address)) {
      return one(new SignalWrite.PortRegister(address, (short) value));
    }
    return switch (address) {
      case 1 -> Optional.of(boxOutputs(FULL, value));
      case 2 -> Optional.of(boxOutputs(value, FULL));
      case 3 -> Optional.of(boxOutputs(value, 0));
      case 5, 7 -> one(domain(AnalogBank.STANDARD_IN, address / 2 - 2, address, value));
      case 9, 11 -> one(domain(AnalogBank.TOOL_IN, address / 2 - 4, address, value));
      case 16, 18 -> one(new SignalWrite.AnalogOutput(address / 2 - 8, value / (double) FULL));
      case 17, 19 -> one(domain(AnalogBank.STANDARD_OUT, address / 2 - 8, address, value));
      case 20 -> one(new SignalWrite.ToolVoltage(value));
      case 22 -> Optional.of(outputs(SignalBank.TOOL_OUT, FULL, value));
      case 31 -> Optional.of(outputs(SignalBank.CONFIGURABLE_OUT, FULL, value));
      case 32 -> Optional.of(outputs(SignalBank.CONFIGURABLE_OUT, value, FULL));
      case 33 -> Optional.of(outputs(SignalBank.CONFIGURABLE_OUT, value, 0));
      case 0, 4, 6, 8, 10, 21, 24, 25, 26, 27, 28, 29, 30 -> Optional.of(List.of());
      default -> Optional.empty();
    };
  }

  private static Optional<List<SignalWrite>> one(SignalWrite write) {
    return Optional.of(List.of(write));
  }

  private static SignalWrite domain(AnalogBank bank, int index, int address, int value) {
    if (value != 0 && value != 1) {
      throw new IllegalArgumentException(text("portDomain", address, value));
    }
    return new SignalWrite.Domain(bank, index, AnalogDomain.of(value));
  }

  private static List<SignalWrite> boxOutputs(int mask, int levels) {
    List<SignalWrite> writes = new ArrayList<>(outputs(SignalBank.STANDARD_OUT, mask, levels));
    writes.addAll(outputs(SignalBank.TOOL_OUT, mask >> TOOL_SHIFT, levels >> TOOL_SHIFT));
    return writes;
  }

  private static List<SignalWrite> outputs(SignalBank bank, int mask, int levels) {
    List<SignalWrite> writes = new ArrayList<>();
    for (int i = 0; i < bank.size(); i++) {
      if ((mask >> i & 1) != 0) {
        writes.add(new SignalWrite.Digital(new Signal(bank, i), (levels >> i & 1) != 0));
      }
    }
    return writes;
  }

  /**
   * The changes that writing a bit makes.
   *
   * @return none where the bit can only be read; empty where there is no bit
   */
  public static Optional<List<SignalWrite>> writeBit(int address, boolean value) {
    if (PortLevels.holds(address)) {
      return one(new SignalWrite.PortBit(address, value));
    }
    if (address < 0 || address >= 3 * BITS) {
      return Optional.empty();
    }
    int mask = 1 << address % BITS;
    int levels = value ? mask : 0;
    return Optional.of(
        switch (address / BITS) {
          case 0 -> List.of();
          case 1 -> boxOutputs(mask, levels);
          default -> outputs(SignalBank.CONFIGURABLE_OUT, mask >> TOOL_SHIFT, levels >> TOOL_SHIFT);
        });
  }
}
