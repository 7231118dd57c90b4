package org.pendant.controller.message;

/** Answer of an operator to a {@link Question}. */
public sealed interface Answer {

  /** The answer as a script would write it in a message: {@code True}, {@code 3}, {@code 0.5}. */
  String text();

  /** Yes or no. */
  record Bool(boolean value) implements Answer {
    @Override
    public String text() {
      return value ? "True" : "False";
    }
  }

  /** A whole number. */
  record Whole(int value) implements Answer {
    @Override
    public String text() {
      return Integer.toString(value);
    }
  }

  /** A number, in the unit that the question names. */
  record Decimal(double value) implements Answer {
    @Override
    public String text() {
      return Double.toString(value);
    }
  }

  /**
   * A text, which may be empty.
   *
   * @param bytes one {@code char} (0 to 255) a byte
   */
  record Text(String bytes) implements Answer {
    @Override
    public String text() {
      return bytes;
    }
  }
}
