package org.pendant.desktop.session;

import java.util.function.IntFunction;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Joints by their number in what the controller says: people know them by their names. */
public final class NumberedJoints {
  private static final Pattern NUMBERED =
      Pattern.compile(
          "\"[^\"]*\"|(?<!\\w)" + SessionTexts.text("numberedJoint", "([0-5])") + "(?![\\w.])");

  private NumberedJoints() {}

  /**
   * A message with names for {@code joint 0} to {@code joint 5}. What people have named is quoted,
   * and stays.
   *
   * @param shown in the language of the window
   * @param name of a joint, 0 to 5
   */
  public static String named(String shown, IntFunction<String> name) {
    return NUMBERED
        .matcher(shown)
        .replaceAll(
            found ->
                Matcher.quoteReplacement(
                    found.group(1) == null
                        ? found.group()
                        : name.apply(Integer.parseInt(found.group(1)))));
  }
}
