package org.pendant.controller.external;

import java.util.Arrays;
import java.util.Optional;
import java.util.OptionalInt;
import org.pendant.script.value.NumberList;
import org.pendant.script.value.Value;
import org.pendant.script.value.ValueKind;

/** Socket read: what one read of a script waits for, and what it makes of it. */
public sealed interface SocketRead {
  /** Most characters of a text with its prefix and suffix (manual 18.61). */
  int LONGEST = 1024;

  /** Takes what is wanted out of {@code in}; empty as long as it is not there. */
  Optional<Value> from(ReceivedBytes in);

  /** The answer when it does not come. */
  Value failed();

  /** A string between prefix and suffix; without a suffix all that is there (manual 18.61). */
  record Text(String prefix, String suffix) implements SocketRead {
    @Override
    public Optional<Value> from(ReceivedBytes in) {
      return new Delimited(prefix, suffix).next(in).map(found -> Value.of(found.text()));
    }

    @Override
    public Value failed() {
      return Value.of("");
    }
  }

  /** A line without its end (manual 18.60). */
  record Line() implements SocketRead {
    @Override
    public Optional<Value> from(ReceivedBytes in) {
      return new Delimited("", "\n").next(in).map(found -> Value.of(withoutReturn(found.text())));
    }

    @Override
    public Value failed() {
      return Value.of("");
    }
  }

  /** Numbers as text, in parentheses with commas between (manual 18.57). */
  record Floats(int number) implements SocketRead {
    @Override
    public Optional<Value> from(ReceivedBytes in) {
      return new Delimited("(", ")")
          .next(in)
          .map(found -> list(ReceivedNumbers.parse(found.text())));
    }

    /** How many there are and their values; where fewer came than wanted, the rest is not known. */
    private Value list(double... read) {
      double[] values = unknown();
      int count = Math.min(number, read.length);
      values[0] = count;
      System.arraycopy(read, 0, values, 1, count);
      return NumberList.of(values);
    }

    private double[] unknown() {
      double[] values = new double[number + 1];
      Arrays.fill(values, 1, values.length, Double.NaN);
      return values;
    }

    @Override
    public Value failed() {
      return NumberList.of(unknown());
    }
  }

  /**
   * Numbers of a fixed size, the most significant byte first (manual 18.58, 18.59).
   *
   * @param bytesEach 4 for signed integers, 1 for bytes from 0 to 255
   */
  record Binary(int number, int bytesEach) implements SocketRead {
    @Override
    public Optional<Value> from(ReceivedBytes in) {
      if (in.length() < number * bytesEach) {
        return Optional.empty();
      }
      double[] values = new double[number + 1];
      values[0] = number;
      for (int i = 0; i < number; i++) {
        values[i + 1] = bytesEach == 1 ? in.byteAt(i) : in.integerAt(i * bytesEach);
      }
      in.skip(number * bytesEach);
      return Optional.of(NumberList.owning(values, values.length, ValueKind.INT));
    }

    @Override
    public Value failed() {
      double[] values = new double[number + 1];
      Arrays.fill(values, 1, values.length, -1);
      return NumberList.owning(values, values.length, ValueKind.INT);
    }
  }

  /** The line {@code name value}; other lines are dropped (manual 18.55). */
  record Variable(String name) implements SocketRead {
    @Override
    public Optional<Value> from(ReceivedBytes in) {
      Delimited lines = new Delimited("", "\n");
      for (Optional<Delimited.Found> found = lines.next(in);
          found.isPresent();
          found = lines.next(in)) {
        String line = withoutReturn(found.get().text());
        if (line.startsWith(name + " ")) {
          OptionalInt value = ReceivedNumbers.integer(line.substring(name.length()).strip());
          if (value.isPresent()) {
            return Optional.of(Value.of(value.getAsInt()));
          }
        }
      }
      return Optional.empty();
    }

    @Override
    public Value failed() {
      return Value.of(0);
    }
  }

  private static String withoutReturn(String line) {
    return line.endsWith("\r") ? line.substring(0, line.length() - 1) : line;
  }
}
