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
        broken(key, InstallationUrpTexts.text("noNumber"));
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
        broken(key, InstallationUrpTexts.text("noNumbers", count));
      }
      return right ? Optional.of(numbers) : Optional.empty();
    }

    /** Tells that a value cannot be used. */
    void broken(String key, String why) {
      remark(
          key,
          text(key).isEmpty()
              ? InstallationUrpTexts.text("emptyValue", why)
              : InstallationUrpTexts.text("wrongValue", shown(text(key)), why));
    }

    /** Tells something of a value. */
    void remark(String key, String what) {
      Entry entry = entries.get(key);
      tell(
          entry == null ? line : entry.line,
          InstallationUrpTexts.text("remarkOn", shown(key), shown(name), what));
    }

    /** Says that all of it is understood, or need not be. */
    void seeAll() {
      entries.values().forEach(each -> each.read = true);
    }

    /** What was not asked for; empty if all was. */
    private Optional<String> unread() {
      List<String> unread =
          entries.entrySet().stream()
              .filter(each -> !each.getValue().read)
              .map(each -> shown(each.getKey()) + " = " + shown(each.getValue().value))
              .toList();
      int more = unread.size() - MAX_UNREAD;
      String told = String.join(", ", unread.subList(0, Math.min(unread.size(), MAX_UNREAD)));
      if (unread.isEmpty()) {
        return Optional.empty();
      }
      return Optional.of(
          more > 0
              ? InstallationUrpTexts.text("notUnderstoodMore", shown(name), told, more)
              : InstallationUrpTexts.text("notUnderstood", shown(name), told));
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
        tell(line, InstallationUrpTexts.text("tooManyLines", MAX_LINES));
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
          tell(line, InstallationUrpTexts.text("lineLeftOut", shown(each)));
        }
      } else {
        add(section, each.substring(0, equals).strip(), each.substring(equals + 1).strip(), line);
      }
    }
  }

  private void add(Section section, String key, String value, int line) {
    if (section.entries.putIfAbsent(key, new Entry(line, value)) != null) {
      tell(line, InstallationUrpTexts.text("secondLeftOut", shown(key), shown(section.name)));
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
      Optional<String> unread = each.unread();
      if (!each.read) {
        tell(each.line, InstallationUrpTexts.text("sectionUnknown", shown(each.name)));
      } else {
        unread.ifPresent(what -> tell(each.line, what));
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
