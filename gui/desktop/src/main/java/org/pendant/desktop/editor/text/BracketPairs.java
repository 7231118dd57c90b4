package org.pendant.desktop.editor.text;

/**
 * Bracket pairs: what happens to the other half of a bracket or quote. It looks at one line only
 * and adds nothing where something follows that the pair would have to hold.
 */
public final class BracketPairs {
  private static final String OPENERS = "([";
  private static final String CLOSERS = ")]";

  private BracketPairs() {}

  /** What to do with a character. */
  public enum Deed {
    /** Put it into the text, as any other. */
    INSERT,
    /** Put its other half behind it as well. */
    INSERT_PAIR,
    /** Go over the same character behind the caret. */
    STEP_OVER
  }

  /**
   * What to do with {@code typed}.
   *
   * @param line without its end
   * @param column of the caret, characters before it
   */
  public static Deed typed(String line, int column, char typed) {
    char next = column < line.length() ? line.charAt(column) : '\n';
    boolean quoted = isQuoted(line, column);
    if (isComment(line, column)) {
      return Deed.INSERT;
    }
    if (typed == '"') {
      if (quoted) {
        return next == '"' ? Deed.STEP_OVER : Deed.INSERT;
      }
      char before = column > 0 ? line.charAt(column - 1) : ' ';
      boolean begins = !Insertion.isWord(before) && before != '"' && canHold(next);
      return begins && quotes(line) % 2 == 0 ? Deed.INSERT_PAIR : Deed.INSERT;
    }
    if (quoted) {
      return Deed.INSERT;
    }
    if (OPENERS.indexOf(typed) >= 0) {
      return canHold(next) && depth(line) >= 0 ? Deed.INSERT_PAIR : Deed.INSERT;
    }
    boolean over = CLOSERS.indexOf(typed) >= 0 && next == typed && depth(line) == 0;
    return over ? Deed.STEP_OVER : Deed.INSERT;
  }

  /** The other half of an opening bracket or quote. */
  public static char closing(char opener) {
    int index = OPENERS.indexOf(opener);
    return index < 0 ? opener : CLOSERS.charAt(index);
  }

  /** Whether {@code typed} is put around a selection. */
  public static boolean surrounds(char typed) {
    return typed == '"' || OPENERS.indexOf(typed) >= 0;
  }

  /** Whether the caret stands in an empty pair that goes as a whole. */
  public static boolean isEmptyPair(String line, int column) {
    if (column == 0 || column >= line.length()) {
      return false;
    }
    char before = line.charAt(column - 1);
    return surrounds(before)
        && line.charAt(column) == closing(before)
        && (before == '"' ? isQuoted(line, column) : depth(line) == 0 && !isQuoted(line, column));
  }

  private static boolean canHold(char next) {
    return Character.isWhitespace(next) || next == ',' || CLOSERS.indexOf(next) >= 0 || next == '#';
  }

  private static boolean isQuoted(String line, int column) {
    return quotes(line.substring(0, column)) % 2 == 1;
  }

  private static long quotes(String text) {
    return text.chars().filter(c -> c == '"').count();
  }

  private static boolean isComment(String line, int column) {
    return AutoIndent.code(line).length() < column;
  }

  /** Brackets that are opened less those that are closed. */
  private static int depth(String line) {
    String code = AutoIndent.code(line);
    int depth = 0;
    boolean quoted = false;
    for (int i = 0; i < code.length(); i++) {
      char c = code.charAt(i);
      quoted ^= c == '"';
      if (!quoted) {
        depth += OPENERS.indexOf(c) >= 0 ? 1 : CLOSERS.indexOf(c) >= 0 ? -1 : 0;
      }
    }
    return depth;
  }
}
