package org.pendant.editors.dap;

import java.util.OptionalInt;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** Hit condition: from which hit on a breakpoint stops a program, as people write it. */
final class HitCondition {
  private static final Pattern FORM = Pattern.compile("\\s*(>=|>|)\\s*(\\d{1,9})\\s*");

  private HitCondition() {}

  /**
   * The hit that is the first to stop: {@code 5} and {@code >= 5} mean 5, {@code > 5} means 6.
   * Empty for what is not understood.
   */
  static OptionalInt first(String text) {
    if (text.isBlank()) {
      return OptionalInt.of(1);
    }
    Matcher form = FORM.matcher(text);
    if (!form.matches()) {
      return OptionalInt.empty();
    }
    int number = Integer.parseInt(form.group(2));
    int first = form.group(1).equals(">") ? number + 1 : number;
    return first < 1 ? OptionalInt.empty() : OptionalInt.of(first);
  }
}
