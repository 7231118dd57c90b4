package org.pendant.desktop.session;

import java.util.function.IntFunction;
import java.util.regex.MatchResult;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Joints by their number in what the controller says: people know them by their names. */
public final class NumberedJoints {
  private static final String NUMBERED = SessionTexts.text("numberedJoint", "([0-5])");

  private static final Pattern IN_SENTENCE =
      Pattern.compile(
          "\"[^\"]*\"|(?<beside>\\s?[(\uff08]"
              + NUMBERED
              + "[)\uff09])|(?<!\\w)"
              + NUMBERED
              + "(?![\\w.])");

  private NumberedJoints() {}

  /**
   * A message with names for {@code joint 0} to {@code joint 5}, and without them where they stand
   * in brackets behind the name. What people have named is quoted, and stays.
   *
   * @param shown in the language of the window
   * @param name of a joint, 0 to 5
   */
  public static String named(String shown, IntFunction<String> name) {
    return IN_SENTENCE
        .matcher(shown)
        .replaceAll(found -> Matcher.quoteReplacement(replacement(found, name)));
  }

  private static String replacement(MatchResult found, IntFunction<String> name) {
    if (found.group("beside") != null) {
      return "";
    }
    String number = found.group(found.groupCount());
    return number == null ? found.group() : name.apply(Integer.parseInt(number));
  }
}
