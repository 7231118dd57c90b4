package org.pendant.testing.mutation;

import java.nio.charset.StandardCharsets;
import org.pendant.language.source.ByteText;
import org.pendant.language.source.Source;
import org.pendant.language.source.SourceRange;

/**
 * Mutation: one mistake that is made in the text of a program.
 *
 * @param range what is replaced
 * @param replacement by what, one {@code char} a byte; empty where it is left out
 * @param reach the line, 1-based, of the statement that has to be reached for it to matter
 */
public record Mutation(MutationKind kind, SourceRange range, String replacement, int reach) {

  /** The text with the mistake in it. */
  byte[] in(Source source) {
    String text = source.text();
    return (text.substring(0, range.start()) + replacement + text.substring(range.end()))
        .getBytes(StandardCharsets.ISO_8859_1);
  }

  /** The line that it begins on, for people. */
  public String before(Source source) {
    return ByteText.decoded(source.lineText(source.line(range.start()))).strip();
  }

  /** What becomes of that line, for people. */
  public String after(Source source) {
    int line = source.line(range.start());
    String text = source.lineText(line);
    int from = range.start() - source.lineStart(line);
    int to = Math.min(range.end() - source.lineStart(line), text.length());
    return ByteText.decoded(text.substring(0, from) + replacement + text.substring(to)).strip();
  }
}
