package org.pendant.script.value;

/**
 * A list: elements of one type, a length and a fixed capacity (manual 4.2). Numbers and booleans
 * live unboxed in a {@link NumberList}, everything else in an {@link ObjectList}.
 */
public sealed interface ListValue extends Value permits NumberList, ObjectList {

  /** Most elements any list may hold; {@code make_list} refuses a larger capacity. */
  int MAX_CAPACITY = 1_000_000;

  int length();

  int capacity();

  /** The kind all elements have; INT or FLOAT for numbers. */
  ValueKind elementKind();

  /**
   * The element at {@code index}, not copied.
   *
   * @throws ScriptError when the index is outside 0 .. length-1
   */
  Value get(int index) throws ScriptError;

  /**
   * The element at {@code index}, for a change in its place.
   *
   * @throws ScriptError when the index is outside 0 .. length-1
   */
  default Value open(int index) throws ScriptError {
    return get(index);
  }

  /** Whether a change has to copy all elements first, since copies of this list share them. */
  boolean shared();

  /**
   * Replaces the element at {@code index} with {@code element}, which this list then owns.
   *
   * @throws ScriptError when the index is out of range or the element has another type
   */
  void set(int index, Value element) throws ScriptError;

  /** Adds at the end. Error at capacity or for another type. */
  void append(Value element) throws ScriptError;

  /**
   * Adds copies of all elements of {@code source}, which may be this list itself, at the end: all
   * of them or, with an error at capacity or for another type, none.
   */
  void extend(ListValue source) throws ScriptError;

  /** Inserts before {@code index} (0 .. length). Error at capacity or for another type. */
  void insert(int index, Value element) throws ScriptError;

  /** Removes the element at {@code index}. */
  void remove(int index) throws ScriptError;

  /** Sets the length to 0; the element type stays. */
  void clear();

  /** A new list of elements {@code begin} .. {@code end}-1 (both within 0 .. length). */
  ListValue slice(int begin, int end) throws ScriptError;

  /**
   * Takes over the content of {@code source}, keeping this capacity (manual 4.2).
   *
   * @throws ScriptError when {@code source} is longer than this capacity or of another type
   */
  void assign(ListValue source) throws ScriptError;

  @Override
  ListValue copy();

  @Override
  default ValueKind kind() {
    return ValueKind.LIST;
  }
}
