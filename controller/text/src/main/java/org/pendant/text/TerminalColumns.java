package org.pendant.text;

/**
 * Terminal columns: how wide text is on a terminal, where a Chinese character takes two columns.
 */
public final class TerminalColumns {
  private TerminalColumns() {}

  /** How many columns {@code text} takes, one line without control characters. */
  public static int of(String text) {
    return text.codePoints().map(TerminalColumns::ofCharacter).sum();
  }

  private static int ofCharacter(int character) {
    int type = Character.getType(character);
    if (type == Character.NON_SPACING_MARK || type == Character.ENCLOSING_MARK) {
      return 0;
    }
    return isWide(character) ? 2 : 1;
  }

  /** Those that Unicode calls wide or full-width, by the blocks that they are in. */
  private static boolean isWide(int character) {
    return isBetween(0x1100, character, 0x115F) // leading consonants of Korean
        || isBetween(0x2E80, character, 0x303E) // radicals, ideographic space, 、 。 「 」
        || isBetween(0x3041, character, 0xA4CF) // kana, ideographs
        || isBetween(0xAC00, character, 0xD7A3) // Korean syllables
        || isBetween(0xF900, character, 0xFAFF) // ideographs for compatibility
        || isBetween(0xFE30, character, 0xFE6F) // vertical and small forms
        || isBetween(0xFF01, character, 0xFF60) // ， ： ； （ ）
        || isBetween(0xFFE0, character, 0xFFE6) // full-width signs of currencies
        || isBetween(0x1F300, character, 0x1F64F) // pictures
        || isBetween(0x20000, character, 0x3FFFD); // rarer ideographs
  }

  private static boolean isBetween(int first, int character, int last) {
    return first <= character && character <= last;
  }
}
