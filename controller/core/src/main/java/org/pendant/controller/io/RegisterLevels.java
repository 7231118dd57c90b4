package org.pendant.controller.io;

import java.util.Arrays;

/**
 * The general-purpose registers of one direction at one moment (manual 18.32 to 18.37): 128
 * booleans, 48 32-bit integers and 48 doubles. Immutable.
 */
public final class RegisterLevels {
  /** False and zero. */
  public static final RegisterLevels ZERO =
      new RegisterLevels(
          0L, 0L, new int[RegisterKind.INTEGER.size()], new double[RegisterKind.FLOAT.size()]);

  private final long lowBits;
  private final long highBits;
  private final int[] integers;
  private final double[] floats;

  /** The arrays belong to this object from now on. */
  RegisterLevels(long lowBits, long highBits, int[] integers, double[] floats) {
    this.lowBits = lowBits;
    this.highBits = highBits;
    this.integers = integers;
    this.floats = floats;
  }

  /**
   * The registers of one moment.
   *
   * @param lowBits boolean registers 0 to 63, the lowest in bit 0
   * @param highBits boolean registers 64 to 127, the lowest in bit 0
   * @param integers 48 of them
   * @param floats 48 of them
   * @throws IllegalArgumentException if there are more or fewer
   */
  public static RegisterLevels of(long lowBits, long highBits, int[] integers, double[] floats) {
    if (integers.length != RegisterKind.INTEGER.size()
        || floats.length != RegisterKind.FLOAT.size()) {
      throw new IllegalArgumentException(
          "registers: has "
              + integers.length
              + " integers and "
              + floats.length
              + " floats, must have "
              + RegisterKind.INTEGER.size()
              + " and "
              + RegisterKind.FLOAT.size());
    }
    return new RegisterLevels(lowBits, highBits, integers.clone(), floats.clone());
  }

  /**
   * A boolean register, 0 to 127.
   *
   * @throws IllegalArgumentException if there is no such register
   */
  public boolean bool(int address) {
    RegisterKind.BOOLEAN.check(address);
    return ((address < Long.SIZE ? lowBits : highBits) >> address & 1) != 0;
  }

  /** Boolean registers 0 to 63, the lowest in bit 0. */
  public long lowBits() {
    return lowBits;
  }

  /** Boolean registers 64 to 127, the lowest in bit 0. */
  public long highBits() {
    return highBits;
  }

  /**
   * An integer register, 0 to 47.
   *
   * @throws IllegalArgumentException if there is no such register
   */
  public int integer(int address) {
    RegisterKind.INTEGER.check(address);
    return integers[address];
  }

  /**
   * A float register, 0 to 47.
   *
   * @throws IllegalArgumentException if there is no such register
   */
  public double floating(int address) {
    RegisterKind.FLOAT.check(address);
    return floats[address];
  }

  /**
   * Writes all registers of a kind to {@code out}, from {@code out[at]} on; booleans as 0 and 1.
   */
  public void read(RegisterKind kind, double[] out, int at) {
    switch (kind) {
      case BOOLEAN -> {
        for (int i = 0; i < Long.SIZE; i++) {
          out[at + i] = lowBits >>> i & 1;
          out[at + Long.SIZE + i] = highBits >>> i & 1;
        }
      }
      case INTEGER -> {
        for (int i = 0; i < integers.length; i++) {
          out[at + i] = integers[i];
        }
      }
      case FLOAT -> System.arraycopy(floats, 0, out, at, floats.length);
    }
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof RegisterLevels levels
        && lowBits == levels.lowBits
        && highBits == levels.highBits
        && Arrays.equals(integers, levels.integers)
        && Arrays.equals(floats, levels.floats);
  }

  @Override
  public int hashCode() {
    return 31 * (31 * Long.hashCode(lowBits) + Long.hashCode(highBits)) + Arrays.hashCode(integers);
  }
}
