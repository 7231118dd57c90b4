package org.pendant.script.value;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/** A struct: named members in order, whose types never change (manual 4.1). */
public final class StructValue extends Container implements Value {
  /** Most structs that may stand within each other. */
  public static final int MAX_DEPTH = 100;

  /** Most members a struct may have together with those of its members. */
  public static final int MAX_MEMBERS = 100_000;

  private final List<String> names;
  private final int depth;
  private final int allMembers;
  private Value[] members;

  private StructValue(
      List<String> names, Value[] members, int depth, int allMembers, long memberBytes) {
    this.names = names;
    this.members = members;
    this.depth = depth;
    this.allMembers = allMembers;
    grow(memberBytes);
  }

  /** A struct that owns {@code members}, one for each of {@code names}. */
  public static StructValue owning(List<String> names, Value... members) {
    if (names.size() != members.length) {
      throw new IllegalArgumentException(names.size() + " names, " + members.length + " members");
    }
    int depth = 0;
    int allMembers = members.length;
    long bytes = 0;
    for (Value member : members) {
      bytes += member.sizeBytes();
      if (inner(member) instanceof StructValue struct) {
        depth = Math.max(depth, struct.depth);
        allMembers += struct.allMembers;
      }
    }
    return new StructValue(List.copyOf(names), members, depth + 1, allMembers, bytes);
  }

  /** The struct that is or stands in {@code member}, if any. */
  private static Value inner(Value member) {
    return member instanceof ObjectList list ? list.sample() : member;
  }

  /**
   * Refuses a struct that is too large for what goes through all its members at once.
   *
   * @throws ScriptError beyond {@link #MAX_DEPTH} and {@link #MAX_MEMBERS}
   */
  public StructValue checked() throws ScriptError {
    if (depth > MAX_DEPTH) {
      throw new ScriptError("too-large", ValueTexts.text("structTooDeep", depth, MAX_DEPTH));
    }
    if (allMembers > MAX_MEMBERS) {
      throw new ScriptError(
          "too-large", ValueTexts.text("structTooLarge", allMembers, MAX_MEMBERS));
    }
    return this;
  }

  /** How many members there are, with those of members that are structs. */
  public int allMembers() {
    return allMembers;
  }

  /** The members, for this package's loops: not a copy. */
  Value[] members() {
    return members;
  }

  @Override
  Object array() {
    return members;
  }

  private Value[] own() {
    if (shared()) {
      members = members.clone();
      setShared(false);
    }
    return members;
  }

  public List<String> names() {
    return names;
  }

  public int length() {
    return members.length;
  }

  /** Member {@code index} in the order of creation, unchecked and not copied. */
  public Value memberAt(int index) {
    return members[index];
  }

  /** Member {@code index} in the order of creation, not copied. */
  public Value get(int index) throws ScriptError {
    if (index < 0 || index >= members.length) {
      throw new ScriptError(
          "index-out-of-range", ValueTexts.text("structIndex", index, members.length - 1));
    }
    return members[index];
  }

  /** Member {@code name}, not copied. */
  public Value get(String name) throws ScriptError {
    return members[indexOf(name)];
  }

  /**
   * Replaces member {@code index} with {@code value}, which this struct then owns. A list keeps its
   * capacity.
   *
   * @throws ScriptError when the index is out of range or the value of another type
   */
  public void set(int index, Value value) throws ScriptError {
    Value old = get(index);
    Optional<String> difference = typeDifference(old, value);
    if (difference.isPresent()) {
      throw new ScriptError(
          "wrong-type", ValueTexts.text("memberDiffers", names.get(index), difference.get()));
    }
    replace(index, value);
  }

  @SuppressWarnings("ReferenceEquality") // whether it is the same object is the question
  private void replace(int index, Value value) throws ScriptError {
    if (members[index] == value) {
      // the machine puts a part back that it changed in its place
      return;
    }
    Value[] mine = own();
    Value before = opened(mine, index);
    long beforeBytes = before.sizeBytes();
    Value replaced = Assignment.replaced(before, value);
    if (replaced != before) {
      mine[index] = replaced;
      adopt(replaced);
      grow(replaced.sizeBytes() - beforeBytes);
    }
  }

  /** Member {@code index} in the order of creation, for a change in its place. */
  public Value open(int index) throws ScriptError {
    get(index);
    return opened(own(), index);
  }

  /** Member {@code name}, for a change in its place. */
  public Value open(String name) throws ScriptError {
    return opened(own(), indexOf(name));
  }

  /** Takes over the members of a struct of the same type, fresh ones; lists keep their capacity. */
  void assign(StructValue source) throws ScriptError {
    for (int i = 0; i < members.length; i++) {
      // a part that the source shares with others is not taken from them
      replace(i, source.open(i));
    }
  }

  /** As {@link #set(int, Value)} for member {@code name}. */
  public void set(String name, Value value) throws ScriptError {
    set(indexOf(name), value);
  }

  /** The place of member {@code name}. */
  public int indexOf(String name) throws ScriptError {
    int index = names.indexOf(name);
    if (index < 0) {
      throw new ScriptError(
          "unknown-member", ValueTexts.text("unknownMember", name, String.join(", ", names)));
    }
    return index;
  }

  /**
   * Why a value of {@code found} cannot take the place of one of {@code expected}, empty when it
   * can; it begins with a blank, to stand behind what it is about. Int and float are one type;
   * structs need the same members in the same order, matrices the same shape. An empty list takes
   * the place of any.
   */
  public static Optional<String> typeDifference(Value expected, Value found) {
    if (!expected.kind().accepts(found.kind())) {
      return Optional.of(
          ValueTexts.text("differs", "", expected.kind().described(), found.kind().described()));
    }
    // asked first, as it takes long to find that something does not have an interface
    if (!(expected instanceof Container)) {
      return Optional.empty();
    }
    if (expected instanceof StructValue a && found instanceof StructValue b) {
      if (a.sameMembers(b)) {
        return Optional.empty();
      }
      if (!a.names.equals(b.names)) {
        return Optional.of(
            ValueTexts.text(
                "differsInMembers", "", String.join(", ", a.names), String.join(", ", b.names)));
      }
      for (int i = 0; i < a.members.length; i++) {
        Optional<String> inner = typeDifference(a.members[i], b.members[i]);
        if (inner.isPresent()) {
          return Optional.of(" member " + a.names.get(i) + inner.get());
        }
      }
    }
    if (expected instanceof MatrixValue a
        && found instanceof MatrixValue b
        && (a.rows() != b.rows() || a.columns() != b.columns())) {
      return Optional.of(
          ValueTexts.text("differs", "", Operators.described(a), Operators.described(b)));
    }
    if (expected instanceof ListValue a && found instanceof ListValue b && b.length() > 0) {
      return elementDifference(a, b);
    }
    return Optional.empty();
  }

  /** Whether the two still share their members. */
  @SuppressWarnings("ReferenceEquality") // whether it is the same array is the question
  private boolean sameMembers(StructValue other) {
    return members == other.members;
  }

  private static Optional<String> elementDifference(ListValue expected, ListValue found) {
    if (!expected.elementKind().accepts(found.elementKind())) {
      return Optional.of(
          ValueTexts.text(
              "differsInElements", "", expected.elementKind().text(), found.elementKind().text()));
    }
    if (expected instanceof ObjectList a && found instanceof ObjectList b) {
      return typeDifference(a.sample(), b.sample()).map(inner -> " element" + inner);
    }
    return Optional.empty();
  }

  @Override
  public ValueKind kind() {
    return ValueKind.STRUCT;
  }

  @Override
  public StructValue copy() {
    StructValue copy = new StructValue(names, members, depth, allMembers, partBytes());
    copy.setShared(true);
    setShared(true);
    return copy;
  }

  @Override
  public long sizeBytes() {
    return HEADER_BYTES + (long) Long.BYTES * members.length + partBytes();
  }

  /** The text, for people who read tests and debuggers. */
  @Override
  public String toString() {
    return text();
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof StructValue struct
        && names.equals(struct.names)
        && Arrays.equals(members, struct.members);
  }

  @Override
  public int hashCode() {
    return 31 * names.hashCode() + Arrays.hashCode(members);
  }
}
