package org.pendant.motion.toolpath.nc;

import static org.pendant.motion.toolpath.nc.NcTexts.text;

import java.util.ArrayList;
import java.util.List;
import org.pendant.motion.PlanningException;

/** Toolpath line parser: splits a line of a toolpath file into words. */
final class NcLine {
  /** Digits, sign and point of the longest number that is read. */
  private static final int MAX_NUMBER = 24;

  private final String file;
  private final int line;
  private final String text;
  private int at;

  NcLine(String file, int line, String text) {
    this.file = file;
    this.line = line;
    this.text = text;
  }

  /** The words up to the end or a comment. */
  List<NcWord> words() throws PlanningException {
    List<NcWord> words = new ArrayList<>();
    for (skipBlanks(); at < text.length() && text.charAt(at) != ';'; skipBlanks()) {
      words.add(word());
    }
    return words;
  }

  private void skipBlanks() {
    while (at < text.length() && (text.charAt(at) == ' ' || text.charAt(at) == '\t')) {
      at++;
    }
  }

  private NcWord word() throws PlanningException {
    int begin = at;
    char letter = text.charAt(at);
    if (letter == '(') {
      throw wrong(text("wrongComment"));
    }
    if (letter >= 'a' && letter <= 'z') {
      letter = (char) (letter - 'a' + 'A');
    }
    if (letter < 'A' || letter > 'Z') {
      throw wrong(text("wrongLetter", shown(letter)));
    }
    at++;
    int number = at;
    while (at < text.length() && "+-.0123456789".indexOf(text.charAt(at)) >= 0) {
      at++;
    }
    String digits = text.substring(number, at);
    if (!digits.matches("[+-]?([0-9]+[.]?[0-9]*|[.][0-9]+)")) {
      String found = digits.isEmpty() ? text("noNumber") : cut(digits);
      throw wrong(text("wrongNumber", letter, found));
    }
    if (digits.length() > MAX_NUMBER) {
      throw wrong(text("numberTooLong", letter, MAX_NUMBER));
    }
    return new NcWord(letter, Double.parseDouble(digits), text.substring(begin, at));
  }

  private static String shown(char c) {
    return c > ' ' && c < 127 ? String.valueOf(c) : text("byteCode", (int) c);
  }

  private static String cut(String text) {
    return text.length() > MAX_NUMBER ? text.substring(0, MAX_NUMBER) + "..." : text;
  }

  /** What is wrong with this line. */
  PlanningException wrong(String what) {
    return wrong(file, line, what);
  }

  static PlanningException wrong(String file, int line, String what) {
    return new PlanningException("toolpath-file", file + ":" + line + ": " + what);
  }
}
