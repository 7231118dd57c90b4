package org.pendant.project.installation.urp;

import java.util.ArrayList;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.regex.Pattern;

/**
 * Safety sections: the text of safety settings, in sections, each a heading in brackets and lines
 * {@code key = value}. It notes which of them have been asked for, so that the rest can be told.
 */
final class SafetySections {
  /** Real ones have 200 lines. */
  private static final int MAX_LINES = 5000;

  private static final int MAX_LINE = 2000;

  /** Lines of one section that a remark repeats. */
  private static final int MAX_UNREAD = 20;

  /** Characters of a file that a remark repeats. */
  private static final int SHOWN = 60;

  private static final Pattern NUMBER =
      Pattern.compile("[-+]?(\\d+(\\.\\d*)?|\\.\\d+)([eE][-+]?\\d+)?");

  /** A line of a section. */
  private static final class Entry {
    private final int line;
    private final String value;
    private boolean read;

    Entry(int line, String value) {
      this.line = line;
      this.value = value;
    }
  }

  /** What stands below one heading. */
  final class Section {
    private final String name;
    private final int line;
    private final Map<String, Entry> entries = new LinkedHashMap<>();
    private boolean read;

    private Section(String name, int line) {
      this.name = name;
      this.line = line;
    }

    List<String> keys() {
      return List.copyOf(entries.keySet());
    }

    boolean has(String key) {
      return entries.containsKey(key);
    }

    /** The text of a value; empty if it is not there. */
    String text(String key) {
      Entry entry = entries.get(key);
      if (entry == null) {
        return "";
      }
      entry.read = true;
      return entry.value;
    }

    /** A number; tells if it is there and is none. */
    OptionalDouble number(String key) {
      OptionalDouble number = SafetySections.number(text(key));
      if (number.isEmpty() && has(key)) {
        broken(key, "must be a number");
      }
      return number;
    }

    /** So many numbers; none if they are not there. Tells if they are there and are others. */
    Optional<double[]> numbers(String key, int count) {
      List<String> items = items(text(key));
      double[] numbers = new double[count];
      boolean right = items.size() == count;
      for (int i = 0; i < count && right; i++) {
        OptionalDouble number = SafetySections.number(items.get(i));
        right = number.isPresent();
        numbers[i] = number.orElse(0);
      }
      if (!right && has(key)) {
        broken(key, "must be " + count + " numbers in brackets");
      }
      return right ? Optional.of(numbers) : Optional.empty();
    }

    /** Tells that a value cannot be used. */
    void broken(String key, String why) {
      remark(key, text(key).isEmpty() ? "is empty, " + why : "is " + shown(text(key)) + ", " + why);
    }

    /** Tells something of a value. */
    void remark(String key, String what) {
      Entry entry = entries.get(key);
      tell(entry == null ? line : entry.line, shown(key) + " in [" + shown(name) + "] " + what);
    }

    /** Says that all of it is understood, or need not be. */
    void seeAll() {
      entries.values().forEach(each -> each.read = true);
    }

    private String unread() {
      List<String> unread =
          entries.entrySet().stream()
              .filter(each -> !each.getValue().read)
              .map(each -> shown(each.getKey()) + " = " + shown(each.getValue().value))
              .toList();
      int more = unread.size() - MAX_UNREAD;
      return String.join(", ", unread.subList(0, Math.min(unread.size(), MAX_UNREAD)))
          + (more > 0 ? " and " + more + " more" : "");
    }
  }

  private final SafetyRemarks remarks;
  private final Map<String, Section> sections = new LinkedHashMap<>();

  /**
   * Takes a text apart.
   *
   * @param firstLine of the text in the file
   */
  SafetySections(String text, int firstLine, SafetyRemarks remarks) {
    this.remarks = remarks;
    Section section = new Section("", firstLine);
    Iterator<String> lines = text.lines().iterator();
    for (int line = firstLine; lines.hasNext(); line++) {
      String each = lines.next().strip();
      if (line - firstLine == MAX_LINES) {
        tell(line, "the safety settings have more than " + MAX_LINES + " lines, the rest is left");
        return;
      }
      int equals = each.indexOf('=');
      boolean tooLong = each.length() > MAX_LINE;
      if (!tooLong && each.startsWith("[") && each.endsWith("]") && equals < 0) {
        String name = each.substring(1, each.length() - 1).strip();
        int at = line;
        section = sections.computeIfAbsent(name, key -> new Section(key, at));
      } else if (tooLong || equals <= 0 || section.name.isEmpty()) {
        if (!each.isEmpty()) {
          tell(
              line,
              "\""
                  + shown(each)
                  + "\" in the safety settings is left out, must be a key and"
                  + " a value below a heading in brackets");
        }
      } else {
        add(section, each.substring(0, equals).strip(), each.substring(equals + 1).strip(), line);
      }
    }
  }

  private void add(Section section, String key, String value, int line) {
    if (section.entries.putIfAbsent(key, new Entry(line, value)) != null) {
      tell(line, "the second " + shown(key) + " in [" + shown(section.name) + "] is left out");
    }
  }

  /** A section; one without anything in it if it is not there. */
  Section section(String name) {
    Section found = sections.getOrDefault(name, new Section(name, 0));
    found.read = true;
    return found;
  }

  boolean has(String name) {
    return sections.containsKey(name);
  }

  /** Tells of all that were not asked for. */
  void tellUnread() {
    for (Section each : sections.values()) {
      String unread = each.unread();
      if (!each.read) {
        tell(each.line, "the section [" + shown(each.name) + "] is not understood");
      } else if (!unread.isEmpty()) {
        tell(each.line, "not understood in [" + shown(each.name) + "]: " + unread);
      }
    }
  }

  private void tell(int line, String what) {
    remarks.add(line, what);
  }

  /** A text of the file, short enough for a remark. */
  static String shown(String text) {
    String begin = text.length() <= SHOWN ? text : text.substring(0, SHOWN) + "...";
    return begin.replaceAll("\\p{Cntrl}", "?");
  }

  /** A finite number as files write them; empty for anything else. */
  private static OptionalDouble number(String text) {
    if (!NUMBER.matcher(text).matches()) {
      return OptionalDouble.empty();
    }
    double number = Double.parseDouble(text);
    return Double.isFinite(number) ? OptionalDouble.of(number) : OptionalDouble.empty();
  }

  /** What stands in brackets with commas between, lists in it as they are. */
  static List<String> items(String list) {
    List<String> items = new ArrayList<>();
    if (!list.startsWith("[") || !list.endsWith("]") || list.length() < 2) {
      return items;
    }
    int depth = 0;
    int begin = 1;
    for (int i = 1; i < list.length(); i++) {
      char c = list.charAt(i);
      boolean last = i == list.length() - 1;
      if (last || (c == ',' && depth == 0)) {
        items.add(list.substring(begin, i).strip());
        begin = i + 1;
      }
      depth += c == '[' ? 1 : c == ']' ? -1 : 0;
    }
    return items;
  }
}
