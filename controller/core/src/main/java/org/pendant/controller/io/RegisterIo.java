package org.pendant.controller.io;

/**
 * The general-purpose registers of one direction, owned by the frame loop. They keep their values
 * when a program ends.
 */
public final class RegisterIo {
  private long lowBits;
  private long highBits;
  private int[] integers = new int[RegisterKind.INTEGER.size()];
  private double[] floats = new double[RegisterKind.FLOAT.size()];
  private RegisterLevels levels = RegisterLevels.ZERO;
  private boolean stale;

  /** Whether a snapshot holds the array, so that it must not be written any more. */
  private boolean integersShared;

  private boolean floatsShared;

  /**
   * A boolean register, 0 to 127.
   *
   * @throws IllegalArgumentException if there is no such register
   */
  public boolean bool(int address) {
    RegisterKind.BOOLEAN.check(address);
    return ((address < Long.SIZE ? lowBits : highBits) >> address & 1) != 0;
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
   * Writes a boolean register, 0 to 127.
   *
   * @throws IllegalArgumentException if there is no such register
   */
  public void setBool(int address, boolean value) {
    if (bool(address) != value) {
      long mask = 1L << address;
      if (address < Long.SIZE) {
        lowBits ^= mask;
      } else {
        highBits ^= mask;
      }
      stale = true;
    }
  }

  /**
   * Writes an integer register, 0 to 47.
   *
   * @throws IllegalArgumentException if there is no such register
   */
  public void setInteger(int address, int value) {
    if (integer(address) != value) {
      if (integersShared) {
        integers = integers.clone();
        integersShared = false;
      }
      integers[address] = value;
      stale = true;
    }
  }

  /**
   * Writes a float register, 0 to 47.
   *
   * @throws IllegalArgumentException if there is no such register
   */
  public void setFloating(int address, double value) {
    if (Double.compare(floating(address), value) != 0) {
      if (floatsShared) {
        floats = floats.clone();
        floatsShared = false;
      }
      floats[address] = value;
      stale = true;
    }
  }

  /** All registers now; the same object until one changes. */
  public RegisterLevels levels() {
    if (stale) {
      stale = false;
      integersShared = true;
      floatsShared = true;
      levels = new RegisterLevels(lowBits, highBits, integers, floats);
    }
    return levels;
  }
}
