package org.pendant.controller.value;

import java.util.ArrayDeque;
import java.util.Deque;

/** Whether two large values are equal, as {@link Equality} says it of small ones. */
final class Comparison implements LongOperation {
  /** What one object takes to look at, in numbers. */
  private static final int OBJECT_WEIGHT = 16;

  /** Two containers of one length and kind, and the next of their parts. */
  private static final class Pair {
    private final Value left;
    private final Value right;
    private final int length;
    private int next;

    private Pair(Value left, Value right, int length) {
      this.left = left;
      this.right = right;
      this.length = length;
    }
  }

  private final Value left;
  private final Value right;
  private final Deque<Pair> open = new ArrayDeque<>();
  private boolean equal;

  Comparison(Value left, Value right) {
    this.left = left;
    this.right = right;
    equal = compare(left, right);
  }

  /** Compares what has no parts that need their own turn; puts the rest on the stack. */
  private boolean compare(Value a, Value b) {
    if (a instanceof ObjectList x && b instanceof ObjectList y) {
      open.push(new Pair(x, y, x.length()));
      return x.length() == y.length();
    }
    if (a instanceof StructValue x && b instanceof StructValue y) {
      open.push(new Pair(x, y, x.length()));
      return x.names().equals(y.names());
    }
    return Equality.equal(a, b);
  }

  @Override
  public int advance() {
    int left = PIECE;
    while (equal && left > 0 && !open.isEmpty()) {
      Pair pair = open.peek();
      if (pair.next == pair.length) {
        open.pop();
      } else {
        Value part = part(pair.left, pair.next);
        left -= weight(part);
        equal = compare(part, part(pair.right, pair.next));
        pair.next++;
      }
    }
    return PIECE - left;
  }

  /** How many numbers compare as fast as {@code part}, not counting parts that have a turn. */
  private static int weight(Value part) {
    boolean has = part instanceof ObjectList || part instanceof StructValue;
    return has ? OBJECT_WEIGHT : OBJECT_WEIGHT + (int) (part.sizeBytes() / Double.BYTES);
  }

  private static Value part(Value container, int index) {
    return container instanceof ObjectList list
        ? list.objectAt(index)
        : ((StructValue) container).memberAt(index);
  }

  @Override
  public boolean done() {
    return !equal || open.isEmpty();
  }

  @Override
  public BoolValue result() {
    return equal ? BoolValue.TRUE : BoolValue.FALSE;
  }

  @Override
  public void keep() {
    left.copy();
    right.copy();
  }
}
