package org.pendant.models.calibration;

import static org.pendant.models.calibration.CalibrationTexts.text;

import java.util.LinkedHashMap;
import java.util.Map;
import org.pendant.models.json.FilePosition;

/**
 * YAML reader for mappings of mappings of words and numbers, as blocks or in braces: all that a
 * file of calibrations has. Anything else of YAML is refused, since a list or an alias that is
 * passed over would change an arm without a word.
 */
final class YamlReader {
  private static final int MAX_DEPTH = 8;

  private final String file;
  private final String text;
  private int at;
  private int depth;

  private YamlReader(String file, String text) {
    this.file = file;
    this.text = text;
  }

  /** Reads a file that is one mapping. */
  static Yaml.Mapping read(String file, String text) throws CalibrationTrouble {
    YamlReader reader = new YamlReader(file, text);
    reader.skipBlank();
    if (reader.text.startsWith("---", reader.at) && reader.column() == 1) {
      reader.at += 3;
      reader.requireLineEnd();
      reader.skipBlank();
    }
    Yaml.Mapping root = reader.block(reader.column());
    reader.skipBlank();
    if (!reader.ended()) {
      throw reader.refused(text("keyOrEnd"));
    }
    return root;
  }

  /** Reads entries that begin in one column. */
  private Yaml.Mapping block(int column) throws CalibrationTrouble {
    enter();
    FilePosition begin = place();
    Map<String, Yaml.Entry> entries = new LinkedHashMap<>();
    while (!ended() && column() == column) {
      requireSpacesBefore();
      FilePosition place = place();
      String key = key();
      put(entries, key, new Yaml.Entry(place, blockValue(column)), place);
      skipBlank();
    }
    if (entries.isEmpty() || (!ended() && column() > column)) {
      throw refused(text("keyAsFarIn"));
    }
    depth--;
    return new Yaml.Mapping(entries, begin);
  }

  private Yaml blockValue(int column) throws CalibrationTrouble {
    skipSpaces();
    FilePosition begin = place();
    boolean onThisLine = !lineEnded();
    skipBlank();
    boolean inside = !ended() && column() > column;
    if (!onThisLine && !inside) {
      return new Yaml.Scalar("", begin);
    }
    if (!onThisLine && text.charAt(at) != '{') {
      return block(column());
    }
    Yaml value = text.charAt(at) == '{' ? braces() : scalar(false);
    requireLineEnd();
    return value;
  }

  private Yaml.Mapping braces() throws CalibrationTrouble {
    enter();
    FilePosition begin = place();
    Map<String, Yaml.Entry> entries = new LinkedHashMap<>();
    at++;
    skipBlank();
    while (!ended() && text.charAt(at) != '}') {
      FilePosition place = place();
      String key = key();
      skipBlank();
      Yaml value = !ended() && text.charAt(at) == '{' ? braces() : scalar(true);
      put(entries, key, new Yaml.Entry(place, value), place);
      skipBlank();
      if (!ended() && text.charAt(at) == ',') {
        at++;
        skipBlank();
      } else if (ended() || text.charAt(at) != '}') {
        throw refused("expected , or }");
      }
    }
    if (ended()) {
      throw refused("expected }");
    }
    at++;
    depth--;
    return new Yaml.Mapping(entries, begin);
  }

  private void put(
      Map<String, Yaml.Entry> entries, String key, Yaml.Entry entry, FilePosition place)
      throws CalibrationTrouble {
    if (entries.put(key, entry) != null) {
      throw CalibrationTrouble.at(place, text("foundAgain", key));
    }
  }

  /** Reads a key and its colon. */
  private String key() throws CalibrationTrouble {
    int begin = at;
    while (!ended() && isOfKey(text.charAt(at))) {
      at++;
    }
    String key = text.substring(begin, at);
    if (key.isEmpty()) {
      throw refused(text("keyLetters"));
    }
    skipSpaces();
    if (ended() || text.charAt(at) != ':') {
      throw refused(text("colonAfter", key));
    }
    at++;
    if (!lineEnded() && !isSpace(text.charAt(at))) {
      throw refused(text("spaceAfterColon", key));
    }
    return key;
  }

  private static boolean isOfKey(char c) {
    return Character.isLetterOrDigit(c) || c == '_' || c == '-' || c == '.';
  }

  private Yaml.Scalar scalar(boolean inBraces) throws CalibrationTrouble {
    FilePosition place = place();
    char first = ended() ? ' ' : text.charAt(at);
    if (first == '"' || first == '\'') {
      int end = text.indexOf(first, at + 1);
      String quoted = end < 0 ? "" : text.substring(at + 1, end);
      if (end < 0 || quoted.indexOf('\n') >= 0 || quoted.indexOf('\\') >= 0) {
        throw refused(CalibrationTexts.text("quoted"));
      }
      at = end + 1;
      return new Yaml.Scalar(quoted, place);
    }
    int begin = at;
    while (!ended() && isOfScalar(text.charAt(at), inBraces)) {
      at++;
    }
    if (at == begin) {
      throw refused(text("scalar"));
    }
    return new Yaml.Scalar(text.substring(begin, at), place);
  }

  private static boolean isOfScalar(char c, boolean inBraces) {
    return Character.isLetterOrDigit(c)
        || c == '_'
        || c == '-'
        || c == '.'
        || c == '+'
        || (!inBraces && c == '/');
  }

  private void enter() throws CalibrationTrouble {
    depth++;
    if (depth > MAX_DEPTH) {
      throw refused(text("mappingsTooDeep", MAX_DEPTH));
    }
  }

  private void requireSpacesBefore() throws CalibrationTrouble {
    if (text.substring(lineStart(), at).indexOf('\t') >= 0) {
      throw refused(text("tabBefore"));
    }
  }

  private void requireLineEnd() throws CalibrationTrouble {
    skipSpaces();
    if (!lineEnded()) {
      throw refused(text("lineEnd"));
    }
  }

  /** Whether nothing but a remark is left of the line. */
  private boolean lineEnded() {
    return ended()
        || text.charAt(at) == '\n'
        || text.charAt(at) == '\r'
        || (text.charAt(at) == '#' && (at == 0 || Character.isWhitespace(text.charAt(at - 1))));
  }

  private boolean ended() {
    return at >= text.length();
  }

  private void skipSpaces() {
    while (!ended() && isSpace(text.charAt(at))) {
      at++;
    }
  }

  /** Goes to the next character that is neither white nor part of a remark. */
  private void skipBlank() {
    while (!ended()) {
      if (Character.isWhitespace(text.charAt(at))) {
        at++;
      } else if (lineEnded()) {
        int end = text.indexOf('\n', at);
        at = end < 0 ? text.length() : end;
      } else {
        return;
      }
    }
  }

  private static boolean isSpace(char c) {
    return c == ' ' || c == '\t';
  }

  private int lineStart() {
    return text.lastIndexOf('\n', at - 1) + 1;
  }

  private int column() {
    return at - lineStart() + 1;
  }

  private FilePosition place() {
    int line = 1;
    for (int i = 0; i < at; i++) {
      line += text.charAt(i) == '\n' ? 1 : 0;
    }
    return new FilePosition(file, line, column());
  }

  private CalibrationTrouble refused(String expected) {
    String found = text("endOfFile");
    if (!ended()) {
      char c = text.charAt(at);
      found = c == '\n' || c == '\r' ? text("endOfLine") : "'" + c + "'";
    }
    return CalibrationTrouble.at(place(), text("foundWhere", found, expected));
  }
}
