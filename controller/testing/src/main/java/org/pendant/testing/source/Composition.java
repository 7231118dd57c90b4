package org.pendant.testing.source;

import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.pendant.language.source.Source;
import org.pendant.language.source.SourceRange;
import org.pendant.testing.TestPlace;
import org.pendant.testing.coverage.LineOrigin;

/**
 * Composition of one text from several: the test file, the files whose functions it uses, and lines
 * that are made. Every place in it is known as one in the file that it came from.
 */
public final class Composition {

  /** A stretch of lines of the text. */
  private sealed interface Part {
    int start();

    int line();

    /** A whole file. */
    record Whole(Source source, int start, int line) implements Part {}

    /** Lines that stand for one place. */
    record Made(TestPlace place, int start, int line) implements Part {}
  }

  private final StringBuilder text = new StringBuilder();
  private final List<Part> parts = new ArrayList<>();
  private int lines = 1;

  /** Adds a file; the first one keeps its lines and offsets. */
  SourceRange add(Source source) {
    endLine();
    int start = text.length();
    parts.add(new Part.Whole(source, start, lines));
    append(source.text());
    return new SourceRange(start, text.length());
  }

  /**
   * Adds a line that stands for a place.
   *
   * @param line without its end
   */
  void add(String line, TestPlace place) {
    endLine();
    parts.add(new Part.Made(place, text.length(), lines));
    append(line);
  }

  private void append(String piece) {
    text.append(piece);
    for (int i = piece.indexOf('\n'); i >= 0; i = piece.indexOf('\n', i + 1)) {
      lines++;
    }
  }

  private void endLine() {
    if (!text.isEmpty() && text.charAt(text.length() - 1) != '\n') {
      append("\n");
    }
  }

  /** The text, of the name of its first file. */
  Source source() {
    return Source.of(
        ((Part.Whole) parts.getFirst()).source().name(),
        text.toString().getBytes(StandardCharsets.ISO_8859_1));
  }

  /**
   * The place of an offset.
   *
   * @param function that it is in, if known
   */
  public TestPlace place(int offset, String function) {
    return switch (parts.get(last(offset, true))) {
      case Part.Whole whole -> {
        int within = Math.clamp(offset - whole.start(), 0, whole.source().text().length());
        yield new TestPlace(
            whole.source().name(),
            whole.source().line(within),
            whole.source().column(within),
            function);
      }
      case Part.Made made -> made.place();
    };
  }

  /** The line of an imported file that a line is; empty for those of tests, and for made ones. */
  public Optional<LineOrigin.Place> imported(int line) {
    int which = last(line, false);
    return which > 0 && parts.get(which) instanceof Part.Whole whole
        ? Optional.of(new LineOrigin.Place(whole.source().name(), line - whole.line() + 1))
        : Optional.empty();
  }

  /** The place of a line, 1-based. */
  public TestPlace placeOfLine(int line, String function) {
    return switch (parts.get(last(line, false))) {
      case Part.Whole whole ->
          new TestPlace(whole.source().name(), line - whole.line() + 1, 0, function);
      case Part.Made made -> made.place();
    };
  }

  /** The last part that begins at {@code at} or before. */
  private int last(int at, boolean byOffset) {
    int low = 0;
    int high = parts.size() - 1;
    while (low < high) {
      int middle = (low + high + 1) >>> 1;
      Part part = parts.get(middle);
      if ((byOffset ? part.start() : part.line()) <= at) {
        low = middle;
      } else {
        high = middle - 1;
      }
    }
    return low;
  }
}
