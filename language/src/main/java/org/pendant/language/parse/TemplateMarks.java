package org.pendant.language.parse;

import static org.pendant.language.parse.UrScriptParser.*;

import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import org.pendant.language.source.Source;
import org.pendant.language.source.SourceRange;

/**
 * Template marks: finds the marks of a template, {@code {{name}}}, <code>{% if x %}</code> and
 * <code>${name}</code> , that a driver or another program fills in before it sends the text.
 * Strings and comments are no place for them: there they are text like any other.
 */
final class TemplateMarks {
  /** A mark is no longer than this, in bytes. */
  private static final int LONGEST = 200;

  /** It begins with a name, and is on one line; other texts than scripts have braces, too. */
  private static final Pattern WORDS = Pattern.compile("-? *[A-Za-z_][^\\p{Cntrl}]*");

  private TemplateMarks() {}

  /** Where the first mark among {@code tokens} stands. */
  static Optional<SourceRange> first(Source source, List<ScriptToken> tokens) {
    for (ScriptToken token : tokens) {
      if (token.is(STRANGE) || token.is(LABEL)) {
        Optional<SourceRange> mark = at(source.text(), token.startOffset());
        if (mark.isPresent()) {
          return mark;
        }
      }
    }
    return Optional.empty();
  }

  private static Optional<SourceRange> at(String text, int start) {
    if (text.startsWith("{{", start)) {
      return closed(text, start, "}}");
    }
    if (text.startsWith("{%", start)) {
      return closed(text, start, "%}");
    }
    return text.startsWith("${", start) ? closed(text, start, "}") : Optional.empty();
  }

  private static Optional<SourceRange> closed(String text, int start, String close) {
    int found = text.indexOf(close, start + 2, Math.min(text.length(), start + LONGEST));
    if (found < 0) {
      return Optional.empty();
    }
    return WORDS.matcher(text.substring(start + 2, found)).matches()
        ? Optional.of(new SourceRange(start, found + close.length()))
        : Optional.empty();
  }
}
