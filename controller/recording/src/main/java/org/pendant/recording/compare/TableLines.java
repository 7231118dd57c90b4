package org.pendant.recording.compare;

import java.io.IOException;
import java.io.Reader;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.Optional;

/**
 * Table lines: a text as lines of cells. Commas, semicolons, tabs or spaces stand between cells,
 * whichever the first line has, in this order; a cell in double quotes may contain them.
 */
final class TableLines {
  /** A longer line is no row of numbers. */
  private static final int MAX_LINE_CHARS = 1 << 20;

  private static final char BYTE_ORDER_MARK = '\uFEFF';
  private static final String SEPARATORS = ",;\t";
  private static final char SPACE = ' ';
  private static final char QUOTE = '"';
  private static final String BRACKETS = "([";
  private static final String CLOSING = ")]";

  private final String file;
  private final Reader in;
  private final StringBuilder line = new StringBuilder();
  private int number;
  private boolean ended;
  private boolean cut;
  private char separator;

  /**
   * Cell of a line.
   *
   * @param text without quotes and surrounding spaces
   * @param column where it begins, from 1
   */
  record Cell(String text, int column) {}

  TableLines(String file, Reader in) {
    this.file = file;
    this.in = in;
  }

  /** The number of the line that was read last, from 1. */
  int number() {
    return number;
  }

  /** Whether the file ended in the middle of that line. */
  boolean cut() {
    return cut;
  }

  /** The cells of the next line that is not blank; empty at the end. */
  Optional<List<Cell>> next() throws IOException, MalformedTable {
    while (!ended) {
      readLine();
      String text = line.toString();
      if (!text.isBlank()) {
        if (separator == 0) {
          separator = separatorOf(text);
        }
        return Optional.of(cells(text));
      }
    }
    return Optional.empty();
  }

  private void readLine() throws IOException, MalformedTable {
    line.setLength(0);
    number++;
    for (int c = in.read(); c != '\n'; c = in.read()) {
      if (c < 0) {
        ended = true;
        cut = !line.isEmpty();
        return;
      }
      if (c == 0) {
        throw wrong(line.length() + 1, CompareTexts.text("zeroByte"));
      }
      if (line.length() == MAX_LINE_CHARS) {
        throw wrong(1, CompareTexts.text("lineTooLong", MAX_LINE_CHARS));
      }
      if (c != '\r' && !(number == 1 && line.isEmpty() && c == BYTE_ORDER_MARK)) {
        line.append((char) c);
      }
    }
  }

  private static char separatorOf(String text) {
    for (int i = 0; i < SEPARATORS.length(); i++) {
      if (text.indexOf(SEPARATORS.charAt(i)) >= 0) {
        return SEPARATORS.charAt(i);
      }
    }
    return SPACE;
  }

  private List<Cell> cells(String text) {
    List<Cell> cells = new ArrayList<>();
    int from = 0;
    while (from <= text.length()) {
      if (separator == SPACE) {
        while (from < text.length() && text.charAt(from) == SPACE) {
          from++;
        }
        if (from == text.length()) {
          break;
        }
      }
      int end = end(text, from);
      cells.add(new Cell(bare(text.substring(from, end)), from + 1));
      from = end + 1;
    }
    return cells;
  }

  /** Where the cell ends that begins at {@code from}: lists in brackets may hold separators. */
  private int end(String text, int from) {
    boolean quoted = false;
    int depth = 0;
    for (int i = from; i < text.length(); i++) {
      char c = text.charAt(i);
      if (c == QUOTE) {
        quoted = !quoted;
      } else if (!quoted && BRACKETS.indexOf(c) >= 0) {
        depth++;
      } else if (!quoted && CLOSING.indexOf(c) >= 0) {
        depth = Math.max(0, depth - 1);
      } else if (!quoted && depth == 0 && c == separator) {
        return i;
      }
    }
    return text.length();
  }

  private static String bare(String cell) {
    String text = cell.strip();
    boolean quoted =
        text.length() >= 2 && text.charAt(0) == QUOTE && text.charAt(text.length() - 1) == QUOTE;
    return quoted ? text.substring(1, text.length() - 1).replace("\"\"", "\"").strip() : text;
  }

  /** What is wrong, at a column of the line that was read last. */
  MalformedTable wrong(int column, String message) {
    return new MalformedTable(
        String.format(Locale.ROOT, "%s:%d:%d: %s", file, number, column, message));
  }
}
