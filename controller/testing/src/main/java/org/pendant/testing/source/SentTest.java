package org.pendant.testing.source;

import java.util.ArrayList;
import java.util.List;
import org.pendant.testing.remote.SentText;

/**
 * Sent test: a test that starts no program, as a program for a robot elsewhere, and where its lines
 * come from.
 */
public final class SentTest implements SentText {
  private static final String INDENT = "  ";

  /**
   * Where a line comes from.
   *
   * @param line of the composed text
   * @param shift columns that are missing in front of it
   * @param same whether it is as it was, so that columns can be told
   */
  private record Origin(int line, int shift, boolean same) {}

  private final Origin test;
  private final StringBuilder text = new StringBuilder();
  private final List<Origin> origins = new ArrayList<>();

  /**
   * An empty one.
   *
   * @param line of the test in the composed text, which stands for lines that are made
   */
  SentTest(int line) {
    test = new Origin(line, 0, false);
  }

  /** Adds the first or last line. */
  void addOuter(String line) {
    text.append(line).append('\n');
    origins.add(test);
  }

  /** Adds a line that is made. */
  void add(String line) {
    addOuter(INDENT + line);
  }

  /**
   * Adds a line of the composed text.
   *
   * @param from its number
   * @param shift columns that are missing in front of it
   * @param same whether nothing in it is changed
   */
  void add(String line, int from, int shift, boolean same) {
    text.append(line.isEmpty() ? "" : INDENT).append(line).append('\n');
    origins.add(new Origin(from, shift, same));
  }

  @Override
  public String text() {
    return text.toString();
  }

  private Origin origin(int sent) {
    return sent >= 1 && sent <= origins.size() ? origins.get(sent - 1) : test;
  }

  @Override
  public int lineOf(int sent) {
    return origin(sent).line();
  }

  @Override
  public int columnOf(int sent, int column) {
    Origin origin = origin(sent);
    return origin.same() ? Math.max(1, column - INDENT.length() + origin.shift()) : 1;
  }
}
