package org.pendant.script.value;

import java.util.Arrays;

/**
 * A list of numbers or of booleans, unboxed. Numbers are all int or all float: storing a float into
 * a list of ints turns the whole list into floats, which changes no value and no printed text.
 */
public final class NumberList extends Container implements ListValue {
  /** Lists up to this capacity are copied at once: sharing would cost more than it saves. */
  private static final int MAX_COPIED = 32;

  private double[] elements;
  private int length;
  private ValueKind kind;
  private int tag;

  private NumberList(double[] elements, int length, ValueKind kind) {
    this.elements = elements;
    this.length = length;
    this.kind = kind;
    this.tag =
        switch (kind) {
          case INT -> Registers.INT;
          case FLOAT -> Registers.FLOAT;
          default -> Registers.BOOL;
        };
  }

  /** A list of floats that owns {@code elements}. */
  public static NumberList of(double... elements) {
    return new NumberList(elements, elements.length, ValueKind.FLOAT);
  }

  /** A list of ints. */
  public static NumberList ofInts(int... elements) {
    double[] numbers = new double[elements.length];
    for (int i = 0; i < numbers.length; i++) {
      numbers[i] = elements[i];
    }
    return new NumberList(numbers, numbers.length, ValueKind.INT);
  }

  /** A list of booleans. */
  public static NumberList ofBools(boolean... elements) {
    double[] numbers = new double[elements.length];
    for (int i = 0; i < numbers.length; i++) {
      numbers[i] = elements[i] ? 1 : 0;
    }
    return new NumberList(numbers, numbers.length, ValueKind.BOOL);
  }

  /**
   * A list that owns {@code elements}, of which the first {@code length} are in use; its capacity
   * is the array's length.
   *
   * @param kind INT, FLOAT or BOOL
   */
  public static NumberList owning(double[] elements, int length, ValueKind kind) {
    return new NumberList(elements, length, kind);
  }

  /** Whether there is a number, and no boolean, at {@code index}. */
  public boolean hasNumberAt(int index) {
    return index >= 0 && index < length && tag <= Registers.FLOAT;
  }

  /** The element at {@code index} as a number, unchecked beyond the array's own bounds. */
  public double numberAt(int index) {
    return elements[index];
  }

  /**
   * The elements, for loops: not a copy, longer than {@link #length}, and another array after a
   * change of what is {@code shared}.
   */
  public double[] elements() {
    return elements;
  }

  /**
   * Replaces the element at {@code index}, which the caller knows to be in range and of kind; not
   * while the elements are {@code shared}.
   */
  public void setNumberAt(int index, double number) {
    elements[index] = number;
  }

  @Override
  Object array() {
    return elements;
  }

  private double[] own() {
    if (shared()) {
      elements = elements.clone();
      setShared(false);
    }
    return elements;
  }

  /** The {@link Registers} tag of the elements. */
  public int tag() {
    return tag;
  }

  /** Turns a list of ints into one of floats. */
  public void widenToFloat() {
    if (kind == ValueKind.INT) {
      kind = ValueKind.FLOAT;
      tag = Registers.FLOAT;
    }
  }

  @Override
  public int length() {
    return length;
  }

  @Override
  public int capacity() {
    return elements.length;
  }

  @Override
  public ValueKind elementKind() {
    return kind;
  }

  @Override
  public Value get(int index) throws ScriptError {
    ListChecks.index(index, length);
    return switch (kind) {
      case INT -> new IntValue((int) elements[index]);
      case BOOL -> Value.of(elements[index] != 0);
      default -> new FloatValue(elements[index]);
    };
  }

  @Override
  public void set(int index, Value element) throws ScriptError {
    ListChecks.index(index, length);
    double number = number(element);
    own()[index] = number;
  }

  @Override
  public void append(Value element) throws ScriptError {
    double number = number(element);
    ListChecks.room(length + 1, elements.length);
    own()[length++] = number;
  }

  /**
   * As {@link #append}, unboxed.
   *
   * @param element INT or FLOAT, the kind of {@code number}
   */
  public void appendNumber(double number, ValueKind element) throws ScriptError {
    if (!kind.accepts(element)) {
      throw ListChecks.elementType(kind, element);
    }
    ListChecks.room(length + 1, elements.length);
    if (element == ValueKind.FLOAT) {
      widenToFloat();
    }
    own()[length++] = number;
  }

  @Override
  public void extend(ListValue source) throws ScriptError {
    int added = source.length();
    if (added == 0) {
      return;
    }
    if (!(source instanceof NumberList other && kind.accepts(other.kind))) {
      throw ListChecks.elementType(kind, source.elementKind());
    }
    ListChecks.room(length + added, elements.length);
    if (other.kind == ValueKind.FLOAT) {
      widenToFloat();
    }
    System.arraycopy(other.elements, 0, own(), length, added);
    length += added;
  }

  @Override
  public void insert(int index, Value element) throws ScriptError {
    ListChecks.index(index, length + 1);
    double number = number(element);
    ListChecks.room(length + 1, elements.length);
    double[] mine = own();
    System.arraycopy(mine, index, mine, index + 1, length - index);
    mine[index] = number;
    length++;
  }

  @Override
  public void remove(int index) throws ScriptError {
    ListChecks.index(index, length);
    double[] mine = own();
    System.arraycopy(mine, index + 1, mine, index, length - index - 1);
    length--;
  }

  @Override
  public void clear() {
    length = 0;
  }

  @Override
  public NumberList slice(int begin, int end) throws ScriptError {
    ListChecks.range(begin, end, length);
    return new NumberList(Arrays.copyOfRange(elements, begin, end), end - begin, kind);
  }

  @Override
  public void assign(ListValue source) throws ScriptError {
    if (source instanceof NumberList other && kind.accepts(other.kind)) {
      ListChecks.room(other.length, elements.length);
      if (other.kind == ValueKind.FLOAT) {
        widenToFloat();
      }
      if (other.elements.length == elements.length && elements.length > MAX_COPIED) {
        elements = other.elements;
        other.setShared(true);
        setShared(true);
      } else {
        System.arraycopy(other.elements, 0, emptied(), 0, other.length);
      }
      length = other.length;
    } else if (source.length() == 0) {
      length = 0;
    } else {
      throw ListChecks.elementType(kind, source.elementKind());
    }
  }

  /** Elements of the same capacity that may be overwritten. */
  private double[] emptied() {
    if (shared()) {
      elements = new double[elements.length];
      setShared(false);
    }
    return elements;
  }

  @Override
  public NumberList copy() {
    if (elements.length <= MAX_COPIED) {
      return new NumberList(elements.clone(), length, kind);
    }
    NumberList copy = new NumberList(elements, length, kind);
    copy.setShared(true);
    setShared(true);
    return copy;
  }

  @Override
  public long sizeBytes() {
    return HEADER_BYTES + (long) Double.BYTES * elements.length;
  }

  /** The number to store for {@code element}, after widening this list if that is needed. */
  private double number(Value element) throws ScriptError {
    if (!kind.accepts(element.kind())) {
      throw ListChecks.elementType(kind, element.kind());
    }
    return switch (element) {
      case IntValue i -> i.value();
      case FloatValue f -> {
        widenToFloat();
        yield f.value();
      }
      case BoolValue b -> b.value() ? 1 : 0;
      default -> throw ListChecks.elementType(kind, element.kind());
    };
  }

  /** The text, for people who read tests and debuggers. */
  @Override
  public String toString() {
    return text();
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof NumberList list
        && length == list.length
        && kind.accepts(list.kind)
        && Arrays.equals(elements, 0, length, list.elements, 0, length);
  }

  @Override
  public int hashCode() {
    int hash = length;
    for (int i = 0; i < length; i++) {
      hash = 31 * hash + Double.hashCode(elements[i]);
    }
    return hash;
  }
}
