package org.pendant.desktop.editor.text;

/**
 * Bounded text: a text that can be read only so often: some regular expressions would read it for
 * hours.
 */
final class BoundedText implements CharSequence {
  private static final int READS = 40_000_000;

  private final CharSequence text;
  private int left = READS;

  BoundedText(CharSequence text) {
    this.text = text;
  }

  /** The text was read too often. */
  @SuppressWarnings("serial") // never written to a stream
  static final class TooLong extends RuntimeException {
    TooLong() {
      super("read " + READS + " characters without an end", null, false, false);
    }
  }

  @Override
  public char charAt(int index) {
    if (--left < 0) {
      throw new TooLong();
    }
    return text.charAt(index);
  }

  @Override
  public int length() {
    return text.length();
  }

  @Override
  public CharSequence subSequence(int start, int end) {
    return text.subSequence(start, end);
  }

  @Override
  public String toString() {
    return text.toString();
  }
}
