package org.pendant.language.source;

import java.nio.charset.StandardCharsets;
import java.util.Arrays;

/**
 * Source: the text of one script file or one line sent to the controller, with its line table.
 *
 * <p>URScript text is bytes (manual 3), so the text is held as Latin-1: one {@code char} a byte,
 * offsets are byte offsets, and {@link #bytes()} gives back exactly what was read.
 */
public final class Source {
  private final String name;
  private final String text;
  private final int[] lineStarts;

  private Source(String name, String text) {
    this.name = name;
    this.text = text;
    this.lineStarts = lineStarts(text);
  }

  /** A source named {@code name} (a file name for messages) from raw bytes. */
  public static Source of(String name, byte[] bytes) {
    return new Source(name, new String(bytes, StandardCharsets.ISO_8859_1));
  }

  /** A source from a string whose characters are encoded as UTF-8 first, as files are. */
  public static Source of(String name, String text) {
    return of(name, text.getBytes(StandardCharsets.UTF_8));
  }

  public String name() {
    return name;
  }

  /** The text, one {@code char} a byte. */
  public String text() {
    return text;
  }

  public byte[] bytes() {
    return text.getBytes(StandardCharsets.ISO_8859_1);
  }

  /** The text of {@code range}. */
  public String text(SourceRange range) {
    return text.substring(range.start(), range.end());
  }

  public int lineCount() {
    return lineStarts.length;
  }

  /** The 1-based line that holds {@code offset}. */
  public int line(int offset) {
    int found = Arrays.binarySearch(lineStarts, offset);
    return found >= 0 ? found + 1 : -found - 1;
  }

  /** The 1-based column of {@code offset}, counted in bytes. */
  public int column(int offset) {
    return offset - lineStarts[line(offset) - 1] + 1;
  }

  /** The offset at which line {@code line} (1-based) begins. */
  public int lineStart(int line) {
    return lineStarts[line - 1];
  }

  /** Line {@code line} (1-based) without its line end. */
  public String lineText(int line) {
    int start = lineStarts[line - 1];
    int end = line < lineStarts.length ? lineStarts[line] : text.length();
    while (end > start && (text.charAt(end - 1) == '\n' || text.charAt(end - 1) == '\r')) {
      end--;
    }
    return text.substring(start, end);
  }

  private static int[] lineStarts(String text) {
    int[] starts = new int[16];
    int count = 1;
    for (int i = text.indexOf('\n'); i >= 0; i = text.indexOf('\n', i + 1)) {
      if (count == starts.length) {
        starts = Arrays.copyOf(starts, count * 2);
      }
      starts[count++] = i + 1;
    }
    return Arrays.copyOf(starts, count);
  }
}
