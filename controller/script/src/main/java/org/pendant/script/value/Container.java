package org.pendant.script.value;

/**
 * Container: a value with parts that can be changed in place. A copy shares the array of parts with
 * the original until one of the two changes (copy on write), so that copying costs the same however
 * much is copied.
 *
 * <p>A container within another one may only be changed while it belongs to the very array that its
 * parent has now: a parent whose parts are shared gets another array when it changes them, and then
 * takes a copy of each part that it opens for a change.
 *
 * <p>Only the frame loop changes values; any other thread may read a copy.
 */
abstract sealed class Container permits NumberList, ObjectList, MatrixValue, StructValue {
  /** What an object and its array take besides their parts. */
  static final int HEADER_BYTES = 80;

  private boolean shared;

  /** Whether {@link #owner} tells more than that this is no container's part. */
  private boolean owned;

  /** The array of {@link #parent} that this is a part of; compared, never read. */
  private Object owner = this;

  private Container parent = this;

  /** What all parts take together, see {@link Value#sizeBytes}. */
  private long partBytes;

  /** Whether another value has the same parts: they are copied before the next change. */
  public final boolean shared() {
    return shared;
  }

  final void setShared(boolean now) {
    shared = now;
  }

  final long partBytes() {
    return partBytes;
  }

  /** The array of parts. */
  abstract Object array();

  /** Counts parts that came or, with a negative number, went; also for what this is a part of. */
  @SuppressWarnings("ReferenceEquality") // whether it is the same array is the question
  final void grow(long bytes) {
    partBytes += bytes;
    Container part = this;
    while (bytes != 0 && part.owned && part.parent.array() == part.owner) {
      part = part.parent;
      part.partBytes += bytes;
    }
  }

  /** Notes that {@code part}, which no other container has, now stands in the array of this. */
  final void adopt(Value part) {
    if (part instanceof Container container) {
      container.owner = array();
      container.parent = this;
      container.owned = true;
    }
  }

  /**
   * The part at {@code index} of the array of this, for a change: a copy takes its place if it may
   * be a part of other values as well.
   */
  @SuppressWarnings("ReferenceEquality") // whether it is the same array is the question
  final Value opened(Value[] array, int index) {
    Value part = array[index];
    if (part instanceof Container container && container.owner != array) {
      part = part.copy();
      array[index] = part;
      adopt(part);
    }
    return part;
  }
}
