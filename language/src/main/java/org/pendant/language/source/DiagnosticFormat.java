package org.pendant.language.source;

import java.util.List;

/**
 * The form of a {@link Diagnostic} for people: {@code file:line:column: error: message}, the source
 * line below it and a caret under the fault.
 */
public final class DiagnosticFormat {
  /** Lines longer than this are shown in part, in bytes. */
  private static final int MAX_LINE = 160;

  /** How much of a long line is shown in front of the fault, in bytes. */
  private static final int LEAD = 60;

  private DiagnosticFormat() {}

  /**
   * Three lines for a terminal, without a line end after the last one. Source bytes are shown as
   * UTF-8; the column counts bytes from 1, as the controller's own messages do.
   */
  public static String format(Source source, Diagnostic diagnostic) {
    return format(
        source,
        diagnostic,
        diagnostic.isError() ? "error" : "warning",
        ByteText.decoded(diagnostic.message()));
  }

  /**
   * The same in another language.
   *
   * @param kind what stands for {@code error} or {@code warning}
   * @param message what stands for that of the diagnostic, decoded
   */
  public static String format(Source source, Diagnostic diagnostic, String kind, String message) {
    int start = Math.min(diagnostic.range().start(), source.text().length());
    int line = source.line(start);
    int column = source.column(start);
    List<String> excerpt = excerpt(source, line, column, diagnostic.range().end() - start);
    return String.format(
        "%s:%d:%d: %s: %s%n%s%n%s",
        printable(source.name()),
        line,
        column,
        kind,
        printable(message),
        excerpt.getFirst(),
        excerpt.getLast());
  }

  /**
   * Two lines for a terminal: a line of a source, or what is around the fault of a long one, and
   * the caret under it.
   *
   * @param line 1-based, one that there is
   * @param column 1-based, in bytes
   * @param length of the fault in bytes
   */
  public static List<String> excerpt(Source source, int line, int column, int length) {
    String text = source.lineText(line);
    int from = Math.min(column - 1, text.length());
    int to = Math.clamp((long) from + length, from, text.length());
    int shownFrom = text.length() > MAX_LINE ? Math.max(0, from - LEAD) : 0;
    int shownTo = Math.min(text.length(), shownFrom + MAX_LINE);
    String before = decoded(text.substring(shownFrom, from));
    String fault = decoded(text.substring(from, Math.max(from, Math.min(to, shownTo))));
    String after = decoded(text.substring(Math.max(from, Math.min(to, shownTo)), shownTo));
    return List.of(
        before + fault + after, blanks(before) + "^" + "~".repeat(Math.max(0, width(fault) - 1)));
  }

  /** As many blanks as {@code text} is wide, with its tabs kept so that the caret lines up. */
  private static String blanks(String text) {
    StringBuilder blanks = new StringBuilder();
    text.codePoints().forEach(point -> blanks.append(point == '\t' ? '\t' : ' '));
    return blanks.toString();
  }

  private static int width(String text) {
    return text.codePointCount(0, text.length());
  }

  /** Text with pieces of a script in it; control bytes cannot disturb the terminal. */
  private static String decoded(String bytes) {
    return printable(ByteText.decoded(bytes));
  }

  private static String printable(String text) {
    StringBuilder printable = new StringBuilder(text.length());
    text.codePoints()
        .map(point -> point != '\t' && Character.isISOControl(point) ? '\uFFFD' : point)
        .forEach(printable::appendCodePoint);
    return printable.toString();
  }
}
