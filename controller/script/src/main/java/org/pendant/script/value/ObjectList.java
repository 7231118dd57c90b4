package org.pendant.script.value;

import java.util.Arrays;
import java.util.Optional;

/** A list of strings, poses, structs or handles. Structs in one list all have the same members. */
public final class ObjectList extends Container implements ListValue {
  /** Parts up to this number are copied one by one: sharing would cost more than it saves. */
  private static final int MAX_COPIED = 64;

  private final Value sample;
  private Value[] elements;
  private int length;

  private ObjectList(Value[] elements, int length, Value sample, long elementBytes) {
    this.elements = elements;
    this.length = length;
    this.sample = sample;
    grow(elementBytes);
  }

  /**
   * A list that owns {@code elements}, of which the first {@code length} are in use; its capacity
   * is the array's length. One and the same element may stand at several places.
   *
   * @param sample a value of the element type, which an empty list still has
   */
  public static ObjectList owning(Value[] elements, int length, Value sample) {
    return new ObjectList(elements, length, sample, bytes(elements, 0, length));
  }

  private static long bytes(Value[] elements, int from, int to) {
    long bytes = 0;
    for (int i = from; i < to; i++) {
      bytes += elements[i].sizeBytes();
    }
    return bytes;
  }

  /** A value of the element type, not copied. */
  public Value sample() {
    return sample;
  }

  /** The element at {@code index}, unchecked and not copied. */
  public Value objectAt(int index) {
    return elements[index];
  }

  /** The elements, for this package's loops: not a copy, and longer than {@link #length}. */
  Value[] elements() {
    return elements;
  }

  @Override
  Object array() {
    return elements;
  }

  private Value[] own() {
    if (shared()) {
      elements = elements.clone();
      setShared(false);
    }
    return elements;
  }

  private void put(Value[] mine, int index, Value element) {
    mine[index] = element;
    adopt(element);
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
    return sample.kind();
  }

  @Override
  public Value get(int index) throws ScriptError {
    ListChecks.index(index, length);
    return elements[index];
  }

  @Override
  public Value open(int index) throws ScriptError {
    ListChecks.index(index, length);
    return opened(own(), index);
  }

  @Override
  @SuppressWarnings("ReferenceEquality") // whether it is the same object is the question
  public void set(int index, Value element) throws ScriptError {
    ListChecks.index(index, length);
    if (elements[index] == element) {
      // the machine puts a part back that it changed in its place
      return;
    }
    check(element);
    Value[] mine = own();
    Value before = opened(mine, index);
    long beforeBytes = before.sizeBytes();
    Value replaced = Assignment.replaced(before, element);
    if (replaced != before) {
      put(mine, index, replaced);
      grow(replaced.sizeBytes() - beforeBytes);
    }
  }

  @Override
  public void append(Value element) throws ScriptError {
    insert(length, element);
  }

  @Override
  public void extend(ListValue source) throws ScriptError {
    int added = source.length();
    ListChecks.room(length + added, elements.length);
    if (added == 0) {
      return;
    }
    check(source.get(0));
    if (!(source instanceof ObjectList other)) {
      throw ListChecks.elementType(elementKind(), source.elementKind());
    }
    Value[] parts = other.parts(0, added);
    System.arraycopy(parts, 0, own(), length, added);
    for (int i = 0; parts.length <= MAX_COPIED && i < added; i++) {
      adopt(parts[i]);
    }
    grow(bytes(parts, 0, added));
    length += added;
  }

  /**
   * Elements {@code from} .. {@code to}-1, which another value may hold: copies where they are few.
   * Otherwise they stay parts of this list as well, and both copy those that they change.
   */
  private Value[] parts(int from, int to) {
    Value[] parts = Arrays.copyOfRange(elements, from, to);
    if (parts.length > MAX_COPIED) {
      setShared(true);
    } else {
      for (int i = 0; i < parts.length; i++) {
        parts[i] = parts[i].copy();
      }
    }
    return parts;
  }

  @Override
  public void insert(int index, Value element) throws ScriptError {
    ListChecks.index(index, length + 1);
    check(element);
    ListChecks.room(length + 1, elements.length);
    Value[] mine = own();
    System.arraycopy(mine, index, mine, index + 1, length - index);
    put(mine, index, element);
    grow(element.sizeBytes());
    length++;
  }

  @Override
  public void remove(int index) throws ScriptError {
    ListChecks.index(index, length);
    Value[] mine = own();
    grow(-mine[index].sizeBytes());
    System.arraycopy(mine, index + 1, mine, index, length - index - 1);
    mine[--length] = null;
  }

  @Override
  public void clear() {
    elements = emptied();
    length = 0;
    grow(-partBytes());
  }

  /** An empty array of the same capacity. */
  private Value[] emptied() {
    if (shared()) {
      setShared(false);
      return new Value[elements.length];
    }
    Arrays.fill(elements, 0, length, null);
    return elements;
  }

  @Override
  public ObjectList slice(int begin, int end) throws ScriptError {
    ListChecks.range(begin, end, length);
    Value[] parts = parts(begin, end);
    return new ObjectList(parts, parts.length, sample, bytes(parts, 0, parts.length));
  }

  @Override
  public void assign(ListValue source) throws ScriptError {
    ListChecks.room(source.length(), elements.length);
    if (source.length() == 0) {
      clear();
      return;
    }
    check(source.get(0));
    if (!(source instanceof ObjectList other)) {
      throw ListChecks.elementType(elementKind(), source.elementKind());
    }
    if (other.elements.length == elements.length) {
      elements = other.elements;
      other.setShared(true);
      setShared(true);
    } else {
      Value[] parts = other.parts(0, other.length);
      elements = emptied();
      System.arraycopy(parts, 0, elements, 0, parts.length);
    }
    length = other.length;
    grow(other.partBytes() - partBytes());
  }

  @Override
  public ObjectList copy() {
    ObjectList copy = new ObjectList(elements, length, sample, partBytes());
    copy.setShared(true);
    setShared(true);
    return copy;
  }

  @Override
  public long sizeBytes() {
    return HEADER_BYTES + (long) Long.BYTES * elements.length + partBytes();
  }

  private void check(Value element) throws ScriptError {
    Optional<String> difference = StructValue.typeDifference(sample, element);
    if (difference.isPresent()) {
      throw new ScriptError("wrong-type", ValueTexts.text("listElement", difference.get()));
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
