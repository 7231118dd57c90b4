package org.pendant.script.value;

import java.util.Arrays;

/**
 * Registers: values in bulk, unboxed: number, tag and object of slot {@code i} stand at index
 * {@code i} of three arrays. Scalars live in {@code numbers} (booleans as 0 and 1), everything else
 * in {@code objects}. The arrays are replaced when they {@link #grow}; code that keeps one across a
 * call fetches it again.
 */
public final class Registers {
  /** Number tags first, so that an OR of tags up to {@link #FLOAT} means all are numbers. */
  public static final byte INT = 0;

  public static final byte FLOAT = 1;
  public static final byte BOOL = 2;
  public static final byte NONE = 4;
  public static final byte OBJECT = 8;

  /** A variable that nothing was assigned to yet, or an argument that was left out. */
  public static final byte UNASSIGNED = 16;

  private double[] numbers;
  private byte[] tags;
  private Value[] objects;

  public Registers(int size) {
    numbers = new double[size];
    tags = new byte[size];
    objects = new Value[size];
    Arrays.fill(tags, UNASSIGNED);
  }

  public double[] numbers() {
    return numbers;
  }

  public byte[] tags() {
    return tags;
  }

  public Value[] objects() {
    return objects;
  }

  public int size() {
    return tags.length;
  }

  /** Makes room for at least {@code size} slots; new ones are unassigned. */
  public void grow(int size) {
    int old = tags.length;
    if (size > old) {
      int larger = Math.max(size, old * 2);
      numbers = Arrays.copyOf(numbers, larger);
      tags = Arrays.copyOf(tags, larger);
      objects = Arrays.copyOf(objects, larger);
      Arrays.fill(tags, old, larger, UNASSIGNED);
    }
  }

  public boolean assigned(int slot) {
    return tags[slot] != UNASSIGNED;
  }

  public ValueKind kind(int slot) {
    return switch (tags[slot]) {
      case INT -> ValueKind.INT;
      case FLOAT -> ValueKind.FLOAT;
      case BOOL -> ValueKind.BOOL;
      case OBJECT -> objects[slot].kind();
      default -> ValueKind.NONE;
    };
  }

  /** The value in {@code slot}, boxed and not copied; NONE when unassigned. */
  public Value value(int slot) {
    return switch (tags[slot]) {
      case INT -> new IntValue((int) numbers[slot]);
      case FLOAT -> new FloatValue(numbers[slot]);
      case BOOL -> Value.of(numbers[slot] != 0);
      case OBJECT -> objects[slot];
      default -> NoneValue.NONE;
    };
  }

  /** Stores {@code value}, not copied. */
  public void set(int slot, Value value) {
    // not a pattern switch: it is several times slower here, and slow to start
    if (value instanceof IntValue number) {
      setInt(slot, number.value());
    } else if (value instanceof FloatValue number) {
      setFloat(slot, number.value());
    } else if (value instanceof BoolValue bool) {
      setBool(slot, bool.value());
    } else if (value == NoneValue.NONE) {
      tags[slot] = NONE;
    } else {
      setObject(slot, value);
    }
  }

  /** Stores a {@code value} that is no number, bool or NONE, not copied. */
  public void setObject(int slot, Value value) {
    tags[slot] = OBJECT;
    objects[slot] = value;
  }

  public void setInt(int slot, int value) {
    numbers[slot] = value;
    tags[slot] = INT;
  }

  public void setFloat(int slot, double value) {
    numbers[slot] = value;
    tags[slot] = FLOAT;
  }

  public void setBool(int slot, boolean value) {
    numbers[slot] = value ? 1 : 0;
    tags[slot] = BOOL;
  }

  public void clear(int slot) {
    tags[slot] = UNASSIGNED;
    objects[slot] = null;
  }
}
