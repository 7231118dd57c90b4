package org.pendant.script.value;

import java.util.ArrayDeque;
import java.util.Deque;

/** Comparison of two large values, by the same rule as {@link Equality} of small ones. */
final class Comparison implements LongOperation {
  /** What one object takes to look at, in numbers. */
  private static final int OBJECT_WEIGHT = 16;

  /** Parts of two values, side by side, and how many of them are compared. */
  private sealed interface Pair {
    /** Compares at most as many parts as {@code most} numbers take; whether they were equal. */
    boolean advance(int most);

    /** What the last {@link #advance} took, in numbers. */
    int taken();

    boolean done();
  }

  /** Numbers side by side. */
  private static final class Numbers implements Pair {
    private final double[] left;
    private final double[] right;
    private final int length;
    private int next;
    private int taken;

    private Numbers(double[] left, double[] right, int length) {
      this.left = left;
      this.right = right;
      this.length = length;
    }

    @Override
    public boolean advance(int most) {
      int to = Math.min(length, next + most);
      boolean equal = Equality.numbers(left, right, next, to);
      taken = to - next;
      next = to;
      return equal;
    }

    @Override
    public int taken() {
      return taken;
    }

    @Override
    public boolean done() {
      return next == length;
    }
  }

  /** Values side by side; those that have parts are put on top of this. */
  private final class Objects implements Pair {
    private final Value[] left;
    private final Value[] right;
    private final int length;
    private int next;
    private int taken;

    private Objects(Value[] left, Value[] right, int length) {
      this.left = left;
      this.right = right;
      this.length = length;
    }

    @Override
    public boolean advance(int most) {
      taken = 0;
      boolean same = true;
      int depth = open.size();
      while (same && taken < most && next < length && open.size() == depth) {
        same = begin(left[next], right[next]);
        // a text is compared at once
        taken += OBJECT_WEIGHT + (left[next] instanceof StringValue text ? text.length() / 8 : 0);
        next++;
      }
      return same;
    }

    @Override
    public int taken() {
      return taken;
    }

    @Override
    public boolean done() {
      return next == length;
    }
  }

  private final Value left;
  private final Value right;

  /**
   * What is not compared to its end. These are arrays, not their owners: those get others when they
   * change, see {@link #keep}.
   */
  private final Deque<Pair> open = new ArrayDeque<>();

  private boolean equal;

  Comparison(Value left, Value right) {
    this.left = left;
    this.right = right;
    equal = begin(left, right);
    dropDone();
  }

  private void dropDone() {
    while (!open.isEmpty() && open.peek().done()) {
      open.pop();
    }
  }

  /** Compares what has no parts; whether that was equal. Parts come on the stack. */
  private boolean begin(Value a, Value b) {
    if (a instanceof NumberList x && b instanceof NumberList y) {
      open.push(new Numbers(x.elements(), y.elements(), Math.min(x.length(), y.length())));
      return x.length() == y.length();
    }
    if (a instanceof MatrixValue x && b instanceof MatrixValue y) {
      boolean shape = x.rows() == y.rows() && x.columns() == y.columns();
      open.push(new Numbers(x.elements(), y.elements(), shape ? x.elements().length : 0));
      return shape;
    }
    if (a instanceof ObjectList x && b instanceof ObjectList y) {
      open.push(new Objects(x.elements(), y.elements(), Math.min(x.length(), y.length())));
      return x.length() == y.length();
    }
    if (a instanceof StructValue x && b instanceof StructValue y) {
      open.push(new Objects(x.members(), y.members(), Math.min(x.length(), y.length())));
      return x.names().equals(y.names());
    }
    return Equality.equal(a, b);
  }

  @Override
  public int advance() {
    int most = PIECE;
    while (equal && most > 0 && !open.isEmpty()) {
      Pair pair = open.peek();
      equal = pair.advance(most);
      most -= pair.taken();
      dropDone();
    }
    return PIECE - most;
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

  @Override
  public long sizeBytes() {
    return left.sizeBytes() + right.sizeBytes();
  }
}
