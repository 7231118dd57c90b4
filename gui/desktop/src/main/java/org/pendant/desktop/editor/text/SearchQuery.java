package org.pendant.desktop.editor.text;

import static org.pendant.desktop.editor.text.ScriptTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.regex.PatternSyntaxException;

/**
 * Search query: what is looked for.
 *
 * @param words the text or the regular expression
 * @param matchCase whether capitals differ from small letters
 * @param wholeWord whether a match must not continue as a name at either end
 * @param regex whether {@code words} is a regular expression as {@link Pattern} reads it
 */
public record SearchQuery(String words, boolean matchCase, boolean wholeWord, boolean regex) {
  /** More matches than a user looks at; counting ends here. */
  public static final int MAX_MATCHES = 20_000;

  /** One that finds nothing. */
  public static final SearchQuery NONE = new SearchQuery("", false, false, false);

  /** What is wrong with the regular expression; empty if nothing is. */
  public String complaint() {
    try {
      var _ = regex ? Pattern.compile(words) : pattern();
      return "";
    } catch (PatternSyntaxException e) {
      int index = Math.max(0, e.getIndex());
      return index < words.length()
          ? text("wrongAtCharacter", e.getDescription(), index + 1)
          : text("wrongAtTheEnd", e.getDescription());
    }
  }

  /**
   * Where it stands in {@code text}, at most {@link #MAX_MATCHES} places; matches of no length are
   * left out. Nowhere if there is a {@link #complaint}.
   */
  public List<TextSpan> in(CharSequence text) {
    List<TextSpan> found = new ArrayList<>();
    if (words.isEmpty() || !complaint().isEmpty()) {
      return found;
    }
    Matcher matcher = pattern().matcher(new BoundedText(text));
    try {
      while (found.size() < MAX_MATCHES && matcher.find()) {
        if (matcher.end() > matcher.start()) {
          found.add(new TextSpan(matcher.start(), matcher.end()));
        }
      }
    } catch (BoundedText.TooLong e) {
      return found; // an expression that goes back and forth without end: what it found so far
    }
    return found;
  }

  /**
   * What comes in place of a match: {@code replacement} as it is, or for a regular expression with
   * its groups ({@code $1}, {@code ${name}}) filled in.
   *
   * @throws IllegalArgumentException if the replacement names a group that there is not
   */
  public Edit replacement(CharSequence text, TextSpan match, String replacement) {
    if (!regex) {
      return new Edit(match, replacement);
    }
    Matcher matcher = pattern().matcher(text);
    if (!matcher.find(match.start())) {
      return new Edit(match, replacement);
    }
    try {
      StringBuilder filled = new StringBuilder();
      matcher.appendReplacement(filled, replacement);
      return new Edit(match, filled.substring(matcher.start()));
    } catch (IndexOutOfBoundsException e) {
      throw new IllegalArgumentException(text("namesAGroupThatIsNot", replacement), e);
    }
  }

  private Pattern pattern() {
    String expression = regex ? words : Pattern.quote(words);
    if (wholeWord) {
      expression = "(?<!\\w)(?:" + expression + ")(?!\\w)";
    }
    int flags = matchCase ? 0 : Pattern.CASE_INSENSITIVE | Pattern.UNICODE_CASE;
    return Pattern.compile(expression, flags | Pattern.MULTILINE);
  }
}
