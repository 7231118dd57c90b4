package org.pendant.project.program.text;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;

/**
 * Line text: one line, a word, then fields {@code key=value}. A value is a word, a number, a text
 * in quotes or a list of these in brackets.
 *
 * @param word with which it begins
 * @param fields by key, in order
 */
public record LineText(String word, Map<String, Value> fields) {
  private static final int MAX_LIST = 1000;

  /** A value, and where it begins, in characters from 1. */
  public sealed interface Value {
    int column();

    /** A text in quotes. */
    record Quoted(int column, String text) implements Value {}

    /** A word or a number. */
    record Word(int column, String text) implements Value {}

    /** Several. */
    record Items(int column, List<Value> values) implements Value {
      public Items {
        values = List.copyOf(values);
      }
    }
  }

  /**
   * Reads a line.
   *
   * @param text without the blanks at its beginning
   * @param column of its first character in the file, from 1
   * @throws WrongText for the first thing that is wrong
   */
  public static LineText parse(String text, int column) throws WrongText {
    return new Scan(text, column).line();
  }

  /** A text in quotes. */
  public static String quoted(String text) {
    StringBuilder quoted = new StringBuilder("\"");
    for (int i = 0; i < text.length(); i++) {
      char c = text.charAt(i);
      switch (c) {
        case '"' -> quoted.append("\\\"");
        case '\\' -> quoted.append("\\\\");
        case '\n' -> quoted.append("\\n");
        case '\t' -> quoted.append("\\t");
        case '\r' -> quoted.append("\\r");
        default -> {
          if (plain(c)) {
            quoted.append(c);
          } else {
            quoted.append(String.format("\\u%04x", (int) c));
          }
        }
      }
    }
    return quoted.append('"').toString();
  }

  /** Whether a character can stand in a line as it is. */
  static boolean plain(char c) {
    return c >= ' '
        && c != 0x7f
        && c != 0x85
        && c != 0x2028
        && c != 0x2029
        && !Character.isSurrogate(c)
        && c < 0xfffe;
  }

  /** Where the reading is. */
  private static final class Scan {
    private final String text;
    private final int firstColumn;
    private int at;

    Scan(String text, int firstColumn) {
      this.text = text;
      this.firstColumn = firstColumn;
    }

    LineText line() throws WrongText {
      String word = word("lineWord");
      Map<String, Value> fields = new LinkedHashMap<>();
      while (skipBlanks()) {
        int keyAt = at;
        String key = word("exampleField");
        if (!accept('=')) {
          throw wrong(at, ProgramLineTexts.text("equalsMissing", key));
        }
        if (fields.putIfAbsent(key, value()) != null) {
          throw wrong(keyAt, ProgramLineTexts.text("fieldTwice", key));
        }
      }
      return new LineText(word, fields);
    }

    private Value value() throws WrongText {
      int column = firstColumn + at;
      if (accept('"')) {
        return new Value.Quoted(column, quotedRest());
      }
      return accept('[')
          ? new Value.Items(column, items())
          : new Value.Word(column, word("aValue"));
    }

    private List<Value> items() throws WrongText {
      List<Value> items = new ArrayList<>();
      skipBlanks();
      if (accept(']')) {
        return items;
      }
      while (true) {
        skipBlanks();
        if (items.size() == MAX_LIST) {
          throw wrong(at, ProgramLineTexts.text("listTooLong", MAX_LIST));
        }
        if (at < text.length() && text.charAt(at) == '[') {
          throw wrong(at, ProgramLineTexts.text("listInList"));
        }
        items.add(value());
        skipBlanks();
        if (accept(']')) {
          return items;
        }
        if (!accept(',')) {
          throw wrong(at, ProgramLineTexts.text("listOpen"));
        }
      }
    }

    private String quotedRest() throws WrongText {
      int begin = at - 1;
      StringBuilder value = new StringBuilder();
      while (at < text.length()) {
        char c = text.charAt(at++);
        if (c == '"') {
          return value.toString();
        }
        value.append(c == '\\' ? escaped() : c);
      }
      throw wrong(begin, ProgramLineTexts.text("quoteOpen"));
    }

    private char escaped() throws WrongText {
      char c = at < text.length() ? text.charAt(at++) : ' ';
      return switch (c) {
        case 'n' -> '\n';
        case 't' -> '\t';
        case 'r' -> '\r';
        case '"', '\\' -> c;
        case 'u' -> code();
        default -> throw wrong(at - 2, ProgramLineTexts.text("unknownEscape"));
      };
    }

    private char code() throws WrongText {
      String digits = text.substring(at, Math.min(at + 4, text.length()));
      if (!digits.matches("[0-9a-fA-F]{4}")) {
        throw wrong(at - 2, ProgramLineTexts.text("wrongCode"));
      }
      at += 4;
      return (char) Integer.parseInt(digits, 16);
    }

    /** A word; {@code expectedKey} names what must stand here, for the message. */
    private String word(String expectedKey) throws WrongText {
      int begin = at;
      while (at < text.length() && inWord(text.charAt(at))) {
        at++;
      }
      if (begin == at) {
        String found =
            at < text.length() ? "'" + text.charAt(at) + "'" : ProgramLineTexts.text("endOfLine");
        throw wrong(
            at, ProgramLineTexts.text("foundInstead", found, ProgramLineTexts.text(expectedKey)));
      }
      return text.substring(begin, at);
    }

    private static boolean inWord(char c) {
      return (c >= 'a' && c <= 'z')
          || (c >= 'A' && c <= 'Z')
          || (c >= '0' && c <= '9')
          || c == '-'
          || c == '+'
          || c == '.'
          || c == '_';
    }

    private boolean accept(char c) {
      boolean there = at < text.length() && text.charAt(at) == c;
      at += there ? 1 : 0;
      return there;
    }

    /** Whether anything follows. */
    private boolean skipBlanks() {
      while (at < text.length() && text.charAt(at) == ' ') {
        at++;
      }
      return at < text.length();
    }

    private WrongText wrong(int index, String message) {
      return new WrongText(firstColumn + index, message);
    }
  }
}
