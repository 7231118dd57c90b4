package org.pendant.script.value;

import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;
import java.util.List;
import org.pendant.models.text.FloatText;

/** Text conversion: makes the text of values piece by piece, as {@link ValueText} describes it. */
final class TextConversion implements LongOperation {
  /** Nanoseconds that a piece takes, roughly; see {@link #advance}. */
  private static final int PIECE_NS = 50_000;

  private static final int NUMBER_NS = 12;
  private static final int OBJECT_NS = 20;

  /** A list, matrix or struct whose text is not complete. */
  private sealed interface Part {
    /** Adds parts while the piece lasts; whether that were all. */
    boolean advance();
  }

  private final Value[] values;
  private final int limit;
  private final StringBuilder text = new StringBuilder();
  private final Deque<Part> open = new ArrayDeque<>();
  private int nextValue;

  /** What is left of the piece. */
  private int leftNs;

  /**
   * The texts of {@code values}, one after the other, up to a number of characters; only as many
   * more are made as follow from each other.
   */
  TextConversion(int limit, Value... values) {
    this.limit = limit;
    this.values = values;
  }

  @Override
  public int advance() {
    leftNs = PIECE_NS;
    while (leftNs > 0 && !done()) {
      if (open.isEmpty()) {
        Value value = values[nextValue++];
        if (value instanceof StringValue string) {
          add(string);
        } else {
          begin(value);
        }
      } else if (open.peek().advance()) {
        open.pop();
      }
    }
    return PIECE_NS - leftNs;
  }

  private boolean withinBudget() {
    return leftNs > 0 && text.length() <= limit;
  }

  private void begin(Value value) {
    leftNs -= OBJECT_NS;
    switch (value) {
      case NumberList list ->
          open(new Numbers(list.elements(), 0, list.length(), list.elementKind()), '[');
      case MatrixValue matrix -> open(new Rows(matrix), '[');
      case ObjectList list ->
          open(new Objects(list.elements(), list.length(), List.of(), ']'), '[');
      case StructValue struct ->
          open(new Objects(struct.members(), struct.length(), struct.names(), '}'), '{');
      case StringValue string -> {
        text.append('"');
        add(string);
        text.append('"');
      }
      case PoseValue pose -> {
        text.append('p');
        open(new Numbers(pose.pose().toArray(), 0, 6, ValueKind.FLOAT), '[');
      }
      case IntValue i -> text.append(i.value());
      case FloatValue f -> leftNs -= FloatText.append(text, f.value());
      case BoolValue b -> text.append(ValueText.bool(b.value()));
      case NoneValue none -> text.append("None");
      case HandleValue handle -> {
        text.append(handle.type().text()).append(' ').append(handle.id());
        if (!handle.path().isEmpty()) {
          text.append('.').append(handle.path());
        }
      }
    }
  }

  private void open(Part part, char bracket) {
    text.append(bracket);
    open.push(part);
  }

  private void add(StringValue string) {
    String start = string.start(Math.max(0, limit + 1 - text.length()));
    leftNs -= start.length() / 8;
    text.append(start);
  }

  private void separate(int index) {
    if (index > 0) {
      text.append(", ");
    }
  }

  /** Numbers or bools, {@code next} .. {@code to}-1 of an array. */
  private final class Numbers implements Part {
    private final double[] numbers;
    private final int from;
    private final int to;
    private final ValueKind kind;
    private int next;

    private Numbers(double[] numbers, int from, int to, ValueKind kind) {
      this.numbers = numbers;
      this.from = from;
      this.to = to;
      this.kind = kind;
      next = from;
    }

    @Override
    public boolean advance() {
      while (next < to && withinBudget()) {
        separate(next - from);
        if (kind == ValueKind.BOOL) {
          text.append(ValueText.bool(numbers[next] != 0));
          leftNs -= NUMBER_NS;
        } else {
          leftNs -= FloatText.append(text, numbers[next]);
        }
        next++;
      }
      if (next == to) {
        text.append(']');
      }
      return next == to;
    }
  }

  private final class Rows implements Part {
    private final double[] elements;
    private final int rows;
    private final int columns;
    private final ValueKind kind;
    private int next;

    private Rows(MatrixValue matrix) {
      elements = matrix.elements();
      rows = matrix.rows();
      columns = matrix.columns();
      kind = matrix.elementKind();
    }

    @Override
    public boolean advance() {
      if (next == rows) {
        text.append(']');
        return true;
      }
      separate(next);
      open(new Numbers(elements, next * columns, (next + 1) * columns, kind), '[');
      leftNs -= OBJECT_NS;
      next++;
      return false;
    }
  }

  /** Elements of a list, or members of a struct. */
  private final class Objects implements Part {
    private final Value[] parts;
    private final int length;
    private final List<String> names;
    private final char bracket;
    private int next;

    private Objects(Value[] parts, int length, List<String> names, char bracket) {
      this.parts = parts;
      this.length = length;
      this.names = names;
      this.bracket = bracket;
    }

    @Override
    public boolean advance() {
      int depth = open.size();
      while (next < length && withinBudget() && open.size() == depth) {
        separate(next);
        if (!names.isEmpty()) {
          text.append(names.get(next)).append(" = ");
        }
        begin(parts[next++]);
      }
      boolean over = next == length && open.size() == depth;
      if (over) {
        text.append(bracket);
      }
      return over;
    }
  }

  @Override
  public boolean done() {
    return text.length() > limit || (open.isEmpty() && nextValue == values.length);
  }

  @Override
  public StringValue result() {
    return new StringValue(text.toString());
  }

  @Override
  public void keep() {
    // what is not begun is copied; what is open keeps its arrays, see Container
    Arrays.setAll(values, i -> values[i].copy());
  }

  @Override
  public long sizeBytes() {
    long bytes = 2L * text.length();
    for (Value value : values) {
      bytes += value.sizeBytes();
    }
    return bytes;
  }
}
