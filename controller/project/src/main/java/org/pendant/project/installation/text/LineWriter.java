package org.pendant.project.installation.text;

import org.pendant.project.program.text.LineText;

/** Line writer: writes one line: a word, then fields. */
final class LineWriter {
  private final StringBuilder out;

  private LineWriter(StringBuilder out) {
    this.out = out;
  }

  /** Begins a line with a word, which may have blanks before it. */
  static LineWriter begin(StringBuilder out, String word) {
    out.append(word);
    return new LineWriter(out);
  }

  /** A field whose value is a word, a number or a list already. */
  LineWriter put(String key, String value) {
    out.append(' ').append(key).append('=').append(value);
    return this;
  }

  /** A number. */
  LineWriter put(String key, double value) {
    return put(key, Words.of(value));
  }

  /** A constant. */
  LineWriter put(String key, Enum<?> value) {
    return put(key, Words.of(value));
  }

  /** A level; false is left out. */
  LineWriter flag(String key, boolean value) {
    return value ? put(key, "true") : this;
  }

  /** A text in quotes. */
  LineWriter text(String key, String value) {
    return put(key, LineText.quoted(value));
  }

  /** A text in quotes; an empty one is left out. */
  LineWriter textIfAny(String key, String value) {
    return value.isEmpty() ? this : text(key, value);
  }

  void end() {
    out.append('\n');
  }
}
