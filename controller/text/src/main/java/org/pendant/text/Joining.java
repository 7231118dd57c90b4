package org.pendant.text;

/**
 * How pieces of a sentence are joined: in Chinese with a space between its characters and others.
 */
final class Joining {
  private final boolean spaced;

  private Joining(boolean spaced) {
    this.spaced = spaced;
  }

  /** That of a language. */
  static Joining of(Language language) {
    return new Joining(language == Language.CHINESE);
  }

  /**
   * Appends a piece, behind a space where a Chinese character and a Latin letter or a digit meet.
   */
  void append(StringBuilder sentence, String piece) {
    if (spaced && !sentence.isEmpty() && !piece.isEmpty()) {
      int last = sentence.codePointBefore(sentence.length());
      int first = piece.codePointAt(0);
      if ((isChinese(last) && isLatin(first)) || (isLatin(last) && isChinese(first))) {
        sentence.append(' ');
      }
    }
    sentence.append(piece);
  }

  private static boolean isChinese(int character) {
    return Character.UnicodeScript.of(character) == Character.UnicodeScript.HAN;
  }

  private static boolean isLatin(int character) {
    return Character.isDigit(character)
        || Character.UnicodeScript.of(character) == Character.UnicodeScript.LATIN;
  }
}
