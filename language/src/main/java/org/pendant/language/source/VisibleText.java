package org.pendant.language.source;

/**
 * Visible text: text from others (clients, files, programs) in a form that a terminal only shows: a
 * control character could move its cursor, rewrite its lines, fill its clipboard.
 */
public final class VisibleText {
  private static final String CONTINUED = "\n    ";

  private VisibleText() {}

  /**
   * {@code text} with control characters written out, {@code \x1b} for an escape and the like, and
   * those that change the direction of writing as well. Tabs and line ends stay.
   */
  public static String of(String text) {
    if (text.chars().noneMatch(VisibleText::acts)) {
      return text;
    }
    StringBuilder visible = new StringBuilder(text.length() + 16);
    text.chars()
        .forEach(
            each -> {
              if (acts(each)) {
                visible.append(String.format(each < 0x100 ? "\\x%02x" : "\\u%04x", each));
              } else {
                visible.append((char) each);
              }
            });
    return visible.toString();
  }

  /** The same as one message: lines after the first are indented, and so do not pass for others. */
  public static String message(String text) {
    return of(text).replace("\n", CONTINUED);
  }

  private static boolean acts(int character) {
    return switch (character) {
      case '\t', '\n' -> false;
      // Line and paragraph separator, and the marks of writing from right to left.
      case 0x2028, 0x2029, 0x200E, 0x200F, 0x061C -> true;
      default ->
          Character.isISOControl(character)
              || (character >= 0x202A && character <= 0x202E)
              || (character >= 0x2066 && character <= 0x2069);
    };
  }
}
