package org.pendant.desktop.debug;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import org.pendant.desktop.editor.TextPlace;
import org.pendant.kit.settings.Settings;
import org.pendant.script.debug.Breakpoint;
import org.pendant.script.debug.HitRule;

/**
 * Kept files: what the settings remember of each file: its breakpoints, the caret and what is
 * folded. A line for each of them, behind one with the file's name; the file that was used last
 * comes last. A part that cannot be read is told and left out.
 */
final class KeptFiles {
  static final String SETTING = "script.files";

  private static final int MAX_FILES = 200;

  /** The settings are far above any real ones with a MiB. */
  private static final int MAX_TEXT = 200_000;

  /** Of breakpoints and of folded blocks of a file. */
  private static final int MAX_EACH = 500;

  private final Settings settings;
  private final Map<String, KeptFile> files = new LinkedHashMap<>();

  private final List<String> damaged = new ArrayList<>();

  /** Those of {@code settings}. */
  KeptFiles(Settings settings) {
    this.settings = settings;
    for (String part : settings.get(SETTING).orElse("").split("(?m)^(?=file\t)", -1)) {
      if (!part.isBlank()) {
        read(part);
      }
    }
  }

  /** What people should know: of which files nothing is remembered as the settings are damaged. */
  Optional<String> notice() {
    return damaged.isEmpty()
        ? Optional.empty()
        : Optional.of(
            DebugTexts.text("breakpointsCaretAndFoldsAreLost", String.join(", ", damaged)));
  }

  /** What is remembered of a file. */
  Optional<KeptFile> of(Path file) {
    return Optional.ofNullable(files.get(name(file)));
  }

  /** Remembers a file; {@link #write} puts it into the settings. */
  void put(Path file, KeptFile kept) {
    KeptFile before = files.get(name(file));
    if (kept.equals(before)) {
      return;
    }
    files.remove(name(file));
    if (!kept.plain()) {
      files.put(name(file), kept);
    }
  }

  /** Hands what has changed to the settings. */
  void write() {
    List<String> parts = new ArrayList<>();
    int length = 0;
    for (Map.Entry<String, KeptFile> each : List.copyOf(files.entrySet()).reversed()) {
      String part = text(each.getKey(), each.getValue());
      length += part.length();
      if (parts.size() == MAX_FILES || length > MAX_TEXT) {
        break;
      }
      parts.addFirst(part);
    }
    String text = String.join("", parts);
    if (!text.equals(settings.get(SETTING).orElse(""))) {
      settings.put(SETTING, text);
    }
  }

  private static String name(Path file) {
    return file.toAbsolutePath().normalize().toString();
  }

  private static String text(String name, KeptFile kept) {
    StringBuilder text = new StringBuilder("file\t" + inLine(name) + "\n");
    TextPlace place = kept.place();
    text.append("caret\t").append(place.line()).append('\t').append(place.column()).append('\n');
    if (!place.folded().isEmpty()) {
      text.append("folded\t")
          .append(
              place.folded().stream()
                  .limit(MAX_EACH)
                  .map(String::valueOf)
                  .collect(Collectors.joining("\t")))
          .append('\n');
    }
    kept.breakpoints().stream()
        .limit(MAX_EACH)
        .forEach(
            each ->
                text.append("breakpoint\t")
                    .append(each.line())
                    .append(each.enabled() ? "\ton\t" : "\toff\t")
                    .append(each.hits().text())
                    .append('\t')
                    .append(inLine(each.condition()))
                    .append('\t')
                    .append(inLine(each.message()))
                    .append('\n'));
    return text.toString();
  }

  private static String inLine(String text) {
    return text.replaceAll("[\t\r\n]", " ");
  }

  private void read(String part) {
    List<String> lines = part.lines().toList();
    String name = lines.getFirst().replaceFirst("^file\t", "");
    TextPlace place = TextPlace.START;
    List<Breakpoint> breakpoints = new ArrayList<>();
    try {
      for (String line : lines.subList(1, lines.size())) {
        List<String> words = List.of(line.split("\t", -1));
        switch (words.getFirst()) {
          case "caret" ->
              place = new TextPlace(number(words.get(1)), number(words.get(2)), place.folded());
          case "folded" ->
              place =
                  new TextPlace(
                      place.line(),
                      place.column(),
                      words.stream().skip(1).map(KeptFiles::number).toList());
          case "breakpoint" -> breakpoints.add(breakpoint(words));
          default -> throw new IllegalArgumentException("no such line: " + line);
        }
      }
      if (!lines.getFirst().startsWith("file\t")) {
        throw new IllegalArgumentException("no file");
      }
      files.put(name, new KeptFile(place, breakpoints));
    } catch (IllegalArgumentException | IndexOutOfBoundsException e) {
      damaged.add(name);
    }
  }

  private static Breakpoint breakpoint(List<String> words) {
    return new Breakpoint(
        number(words.get(1)),
        words.get(2).equals("on"),
        words.get(4),
        HitRule.of(words.get(3))
            .orElseThrow(() -> new IllegalArgumentException(words.get(3) + " is no hit rule")),
        words.get(5));
  }

  private static int number(String word) {
    int number = Integer.parseInt(word);
    if (number < 1) {
      throw new IllegalArgumentException(word + " must be at least 1");
    }
    return number;
  }
}
