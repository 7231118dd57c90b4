package org.pendant.controller.value;

import java.util.Arrays;
import java.util.Optional;

/** A list of strings, poses or structs. Structs in one list all have the same members. */
public final class ObjectList implements ListValue {
  private final Value[] elements;
  private final Value sample;
  private int length;

  private ObjectList(Value[] elements, int length, Value sample) {
    this.elements = elements;
    this.length = length;
    this.sample = sample;
  }

  /**
   * A list that owns {@code elements}, of which the first {@code length} are in use; its capacity
   * is the array's length.
   *
   * @param sample a value of the element type, which an empty list still has
   */
  public static ObjectList owning(Value[] elements, int length, Value sample) {
    return new ObjectList(elements, length, sample);
  }

  /** A value of the element type, not copied. */
  public Value sample() {
    return sample;
  }

  /** The element at {@code index}, unchecked and not copied. */
  public Value objectAt(int index) {
    return elements[index];
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
  public Kind elementKind() {
    return sample.kind();
  }

  @Override
  public Value get(int index) throws ScriptError {
    ListChecks.index(index, length);
    return elements[index];
  }

  @Override
  public void set(int index, Value element) throws ScriptError {
    ListChecks.index(index, length);
    check(element);
    elements[index] = Assignment.replaced(elements[index], element);
  }

  @Override
  public void append(Value element) throws ScriptError {
    insert(length, element);
  }

  @Override
  public void extend(ListValue source) throws ScriptError {
    int added = source.length();
    ListChecks.room(length + added, elements.length);
    Value[] copies = new Value[added];
    for (int i = 0; i < added; i++) {
      copies[i] = source.get(i).copy();
      check(copies[i]);
    }
    System.arraycopy(copies, 0, elements, length, added);
    length += added;
  }

  @Override
  public void insert(int index, Value element) throws ScriptError {
    ListChecks.index(index, length + 1);
    check(element);
    ListChecks.room(length + 1, elements.length);
    System.arraycopy(elements, index, elements, index + 1, length - index);
    elements[index] = element;
    length++;
  }

  @Override
  public void remove(int index) throws ScriptError {
    ListChecks.index(index, length);
    System.arraycopy(elements, index + 1, elements, index, length - index - 1);
    elements[--length] = null;
  }

  @Override
  public void clear() {
    Arrays.fill(elements, 0, length, null);
    length = 0;
  }

  @Override
  public ObjectList slice(int begin, int end) throws ScriptError {
    ListChecks.range(begin, end, length);
    Value[] part = new Value[end - begin];
    for (int i = begin; i < end; i++) {
      part[i - begin] = elements[i].copy();
    }
    return new ObjectList(part, part.length, sample);
  }

  @Override
  public void assign(ListValue source) throws ScriptError {
    ListChecks.room(source.length(), elements.length);
    Value[] copies = new Value[source.length()];
    for (int i = 0; i < copies.length; i++) {
      copies[i] = source.get(i).copy();
      check(copies[i]);
    }
    clear();
    System.arraycopy(copies, 0, elements, 0, copies.length);
    length = copies.length;
  }

  @Override
  public ObjectList copy() {
    Value[] copies = new Value[elements.length];
    for (int i = 0; i < length; i++) {
      copies[i] = elements[i].copy();
    }
    return new ObjectList(copies, length, sample);
  }

  private void check(Value element) throws ScriptError {
    Optional<String> difference = StructValue.typeDifference(sample, element);
    if (difference.isPresent()) {
      throw new ScriptError("wrong-type", "list element: " + difference.get());
    }
  }

  /** The text, for people who read tests and debuggers. */
  @Override
  public String toString() {
    return text();
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof ObjectList list
        && Arrays.equals(elements, 0, length, list.elements, 0, list.length);
  }

  @Override
  public int hashCode() {
    return Arrays.hashCode(Arrays.copyOf(elements, length));
  }
}
