package org.pendant.editors.lsp.text;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.eclipse.lsp4j.Position;
import org.eclipse.lsp4j.Range;
import org.pendant.language.source.SourceRange;

/**
 * Text positions: converts between byte offsets and the positions of the protocol, which count
 * lines from 0 and units of an encoding. Lines end with LF, CR LF or CR.
 */
public final class TextPositions {
  private final String bytes;
  private final PositionEncoding encoding;
  private final int[] lineStarts;
  private final boolean plain;

  /**
   * Positions in a text.
   *
   * @param bytes the text, one {@code char} a byte
   */
  public TextPositions(String bytes, PositionEncoding encoding) {
    this.bytes = bytes;
    this.encoding = encoding;
    lineStarts = lineStarts(bytes);
    plain = isPlain(bytes);
  }

  /** The number of lines, at least 1. */
  public int lineCount() {
    return lineStarts.length;
  }

  /** The byte offset of {@code position}; one beyond a line or the text means its end. */
  public int offset(Position position) {
    if (position.getLine() < 0) {
      return 0;
    }
    if (position.getLine() >= lineStarts.length) {
      return bytes.length();
    }
    int start = lineStarts[position.getLine()];
    int end = lineEnd(position.getLine());
    int units = Math.max(0, position.getCharacter());
    if (plain || encoding == PositionEncoding.UTF8) {
      return characterStart(start, (int) Math.min(end, (long) start + units));
    }
    int at = start;
    while (at < end && units > 0) {
      int length = sequence(at, end);
      units -= encoding.units(length);
      if (units < 0) {
        break;
      }
      at += length;
    }
    return at;
  }

  /** The position of the byte at {@code offset}, 0 to the length of the text. */
  public Position position(int offset) {
    int found = Arrays.binarySearch(lineStarts, offset);
    int line = found >= 0 ? found : -found - 2;
    int start = lineStarts[line];
    if (plain || encoding == PositionEncoding.UTF8) {
      return new Position(line, offset - start);
    }
    int units = 0;
    for (int at = start; at < offset; ) {
      int length = sequence(at, bytes.length());
      if (at + length > offset) {
        break;
      }
      units += encoding.units(length);
      at += length;
    }
    return new Position(line, units);
  }

  public Range range(SourceRange range) {
    return new Range(position(range.start()), position(range.end()));
  }

  /** The bytes of {@code range}; its ends may be the wrong way round. */
  public SourceRange range(Range range) {
    int start = offset(range.getStart());
    int end = offset(range.getEnd());
    return new SourceRange(Math.min(start, end), Math.max(start, end));
  }

  /** The end of {@code line}, counted from 0, before what ends it. */
  public int lineEnd(int line) {
    int start = lineStarts[line];
    int end = line + 1 < lineStarts.length ? lineStarts[line + 1] : bytes.length();
    while (end > start && (bytes.charAt(end - 1) == '\n' || bytes.charAt(end - 1) == '\r')) {
      end--;
    }
    return end;
  }

  /** The start of {@code line}, counted from 0. */
  public int lineStart(int line) {
    return lineStarts[line];
  }

  /** Several positions at once. */
  public List<Range> ranges(List<SourceRange> ranges) {
    return ranges.stream().map(this::range).toList();
  }

  private int characterStart(int lineStart, int offset) {
    int at = offset;
    while (at > lineStart && at < bytes.length() && (bytes.charAt(at) & 0xC0) == 0x80) {
      at--;
    }
    return at;
  }

  /** How many bytes the character at {@code at} has; what is no UTF-8 counts as one. */
  private int sequence(int at, int end) {
    int first = bytes.charAt(at);
    int length = first < 0xC2 ? 1 : first < 0xE0 ? 2 : first < 0xF0 ? 3 : first < 0xF5 ? 4 : 1;
    if (at + length > end) {
      return 1;
    }
    boolean whole =
        IntStream.range(at + 1, at + length).allMatch(i -> (bytes.charAt(i) & 0xC0) == 0x80);
    return whole ? length : 1;
  }

  private static boolean isPlain(String bytes) {
    // A loop, not a stream: it runs for each letter that is typed.
    for (int i = 0; i < bytes.length(); i++) {
      if (bytes.charAt(i) >= 0x80) {
        return false;
      }
    }
    return true;
  }

  private static int[] lineStarts(String bytes) {
    int[] starts = new int[64];
    int count = 1;
    for (int i = 0; i < bytes.length(); i++) {
      char each = bytes.charAt(i);
      boolean ends =
          each == '\n'
              || (each == '\r' && !(i + 1 < bytes.length() && bytes.charAt(i + 1) == '\n'));
      if (ends) {
        if (count == starts.length) {
          starts = Arrays.copyOf(starts, count * 2);
        }
        starts[count++] = i + 1;
      }
    }
    return Arrays.copyOf(starts, count);
  }
}
