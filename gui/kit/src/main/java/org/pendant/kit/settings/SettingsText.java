package org.pendant.kit.settings;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;

/**
 * Settings as a text file: a line {@code name = value} each, sorted by name; {@code #} begins a
 * comment. In a value {@code \n} is a line end and {@code \\} a backslash.
 *
 * @param values by name
 * @param wrongLines the numbers of lines that are none, from 1
 */
record SettingsText(SortedMap<String, String> values, List<Integer> wrongLines) {
  private static final String HEADING =
      "# Pendant's settings. Pendant writes this file when something changes.\n";

  static SettingsText parse(String text) {
    SortedMap<String, String> values = new TreeMap<>();
    List<Integer> wrong = new ArrayList<>();
    List<String> lines = text.lines().toList();
    for (int i = 0; i < lines.size(); i++) {
      String line = lines.get(i).strip();
      int equals = line.indexOf('=');
      if (line.isEmpty() || line.startsWith("#")) {
        continue;
      }
      String name = line.substring(0, Math.max(0, equals)).strip();
      if (name.isEmpty() || !name.matches("[\\w.:-]+")) {
        wrong.add(i + 1);
      } else {
        values.put(name, unescape(line.substring(equals + 1).strip()));
      }
    }
    return new SettingsText(values, wrong);
  }

  static String format(Map<String, String> values) {
    StringBuilder text = new StringBuilder(HEADING);
    new TreeMap<>(values)
        .forEach(
            (name, value) -> text.append(name).append(" = ").append(escape(value)).append('\n'));
    return text.toString();
  }

  private static String escape(String value) {
    String escaped = value.replace("\\", "\\\\").replace("\n", "\\n").replace("\r", "\\r");
    // Blanks at the ends would not survive.
    boolean blankEnds = !escaped.equals(escaped.strip());
    return blankEnds ? "\\e" + escaped + "\\e" : escaped;
  }

  private static String unescape(String text) {
    StringBuilder value = new StringBuilder();
    boolean escaped = false;
    for (int i = 0; i < text.length(); i++) {
      char c = text.charAt(i);
      if (escaped) {
        value.append(meaning(c));
        escaped = false;
      } else if (c == '\\' && i + 1 < text.length()) {
        escaped = true;
      } else {
        value.append(c);
      }
    }
    return value.toString();
  }

  private static String meaning(char escaped) {
    return switch (escaped) {
      case 'n' -> "\n";
      case 'r' -> "\r";
      case 'e' -> "";
      default -> String.valueOf(escaped);
    };
  }
}
