package org.pendant.language.parse;

import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.pendant.language.source.SourceRange;
import org.pendant.language.syntax.Statement;

/**
 * Label text: what a program label line says (manual 11): {@code $ 2 "text" "flag"...}. Nothing in
 * it is required, since hand-edited programs lose parts of it and the line has no effect anyway.
 */
record LabelText(Optional<Integer> number, String text) {
  private static final Pattern NUMBER = Pattern.compile("\\$\\s*(\\d{1,9})(?=\\s|$)");
  private static final Pattern FLAG = Pattern.compile("\"\\s+\"\\w+\"\\s*$");

  static LabelText parse(String line) {
    Matcher numbered = NUMBER.matcher(line);
    boolean found = numbered.lookingAt();
    String rest = line.substring(found ? numbered.end() : 1);
    // The text itself may hold quotes, so the flags are taken off from the end.
    for (Matcher flag = FLAG.matcher(rest); flag.find(); flag = FLAG.matcher(rest)) {
      rest = rest.substring(0, flag.start() + 1);
    }
    rest = rest.strip();
    if (rest.length() > 1 && rest.startsWith("\"") && rest.endsWith("\"")) {
      rest = rest.substring(1, rest.length() - 1);
    }
    return new LabelText(
        found ? Optional.of(Integer.valueOf(numbered.group(1))) : Optional.empty(), rest);
  }

  Statement.Label at(SourceRange range) {
    return new Statement.Label(number, text, range);
  }
}
