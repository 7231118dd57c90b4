package org.pendant.controller.io;

import static org.pendant.controller.io.SignalTexts.text;

import java.util.Arrays;

/**
 * The memory that scripts share with Modbus clients at one moment: 16-bit registers and bits at the
 * addresses 128 to 255. What the other addresses mean is in {@link PortMap}. Immutable.
 */
public final class PortLevels {
  /** The lowest address. */
  public static final int FIRST = 128;

  /** The highest address. */
  public static final int LAST = 255;

  /** Everything zero. */
  public static final PortLevels ZERO = new PortLevels(0L, 0L, new short[LAST - FIRST + 1]);

  private final long lowBits;
  private final long highBits;
  private final short[] registers;

  /** The array belongs to this object from now on. */
  PortLevels(long lowBits, long highBits, short[] registers) {
    this.lowBits = lowBits;
    this.highBits = highBits;
    this.registers = registers;
  }

  /**
   * The memory of one moment.
   *
   * @param lowBits bits at the addresses 128 to 191, the lowest in bit 0
   * @param highBits bits at the addresses 192 to 255, the lowest in bit 0
   * @param registers 128 of them
   * @throws IllegalArgumentException if there are more or fewer
   */
  public static PortLevels of(long lowBits, long highBits, short[] registers) {
    if (registers.length != LAST - FIRST + 1) {
      throw new IllegalArgumentException(
          "ports: has " + registers.length + " registers, must have " + (LAST - FIRST + 1));
    }
    return new PortLevels(lowBits, highBits, registers.clone());
  }

  /** Bits at the addresses 128 to 191, the lowest in bit 0. */
  public long lowBits() {
    return lowBits;
  }

  /** Bits at the addresses 192 to 255, the lowest in bit 0. */
  public long highBits() {
    return highBits;
  }

  /** Whether there is memory at this address. */
  public static boolean holds(int address) {
    return address >= FIRST && address <= LAST;
  }

  /**
   * Checks an address.
   *
   * @throws IllegalArgumentException if there is no memory
   */
  static void check(int address) {
    if (!holds(address)) {
      throw new IllegalArgumentException(text("portAddress", address, FIRST, LAST));
    }
  }

  /**
   * The register at an address of 128 to 255, -32768 to 32767.
   *
   * @throws IllegalArgumentException if there is none
   */
  public short register(int address) {
    check(address);
    return registers[address - FIRST];
  }

  /**
   * The bit at an address of 128 to 255; bits have memory of their own.
   *
   * @throws IllegalArgumentException if there is none
   */
  public boolean bit(int address) {
    check(address);
    int offset = address - FIRST;
    return ((offset < Long.SIZE ? lowBits : highBits) >> offset & 1) != 0;
  }

  PortLevels withRegister(int address, short value) {
    short[] changed = registers.clone();
    changed[address - FIRST] = value;
    return new PortLevels(lowBits, highBits, changed);
  }

  PortLevels withBit(int address, boolean value) {
    int offset = address - FIRST;
    long mask = bit(address) == value ? 0 : 1L << offset;
    return offset < Long.SIZE
        ? new PortLevels(lowBits ^ mask, highBits, registers)
        : new PortLevels(lowBits, highBits ^ mask, registers);
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof PortLevels levels
        && lowBits == levels.lowBits
        && highBits == levels.highBits
        && Arrays.equals(registers, levels.registers);
  }

  @Override
  public int hashCode() {
    return 31 * (31 * Long.hashCode(lowBits) + Long.hashCode(highBits))
        + Arrays.hashCode(registers);
  }
}
