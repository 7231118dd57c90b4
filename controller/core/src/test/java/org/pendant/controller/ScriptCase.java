package org.pendant.controller;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.pendant.language.source.Source;

/**
 * One program of a script test file, with what it is expected to do.
 *
 * <p>A line {@code # --- title} begins a program. Expectations are comments:
 *
 * <ul>
 *   <li>{@code # expect: text}: the next message of the program is exactly this; messages are
 *       compared in the order of the lines
 *   <li>{@code # error: part}: the program stops here with an error that contains this
 *   <li>{@code # stop: part}: the safety functions stop the arm and hold or end the program here,
 *       with a reason that contains this
 *   <li>{@code # compile-error: part}: a diagnostic of this line contains this
 *   <li>{@code # warning: part}: a warning of this line contains this
 *   <li>{@code # fails: part}: one of the two errors; for faults of which the manual does not say
 *       when they are found
 * </ul>
 *
 * @param name file, line and title, for the test report
 * @param text the program, after as many empty lines as make its line numbers those of the file
 */
record ScriptCase(String name, String text, List<Mark> marks) {
  private static final Pattern MARK =
      Pattern.compile("# (expect|error|stop|compile-error|warning|fails):(?: (.*))?$");

  /** What a comment expects. */
  enum Kind {
    EXPECT,
    ERROR,
    STOP,
    COMPILE_ERROR,
    WARNING,
    FAILS
  }

  /**
   * One expectation.
   *
   * @param line 1-based
   */
  record Mark(Kind kind, int line, String text) {}

  ScriptCase {
    marks = List.copyOf(marks);
  }

  List<Mark> marks(Kind kind) {
    return marks.stream().filter(mark -> mark.kind() == kind).toList();
  }

  /** The program with the line ends of Windows or of Unix. */
  Source source(boolean windowsLineEnds) {
    String laidOut = windowsLineEnds ? text.replace("\n", "\r\n") : text;
    return Source.of("test.script", laidOut.getBytes(StandardCharsets.ISO_8859_1));
  }

  /** All programs of {@code file}. */
  static List<ScriptCase> in(Path file) {
    try {
      // Latin-1 keeps every byte, as Source does.
      List<String> lines = Files.readAllLines(file, StandardCharsets.ISO_8859_1);
      List<ScriptCase> cases = new ArrayList<>();
      int start = 0;
      for (int i = 1; i <= lines.size(); i++) {
        if (i == lines.size() || lines.get(i).startsWith("# ---")) {
          if (lines.get(start).startsWith("# ---")) {
            cases.add(of(file, lines, start, i));
          }
          start = i;
        }
      }
      return cases;
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static ScriptCase of(Path file, List<String> lines, int start, int end) {
    List<Mark> marks = new ArrayList<>();
    StringBuilder text = new StringBuilder("\n".repeat(start));
    for (int i = start; i < end; i++) {
      String line = lines.get(i);
      text.append(line).append('\n');
      Matcher mark = MARK.matcher(line);
      if (mark.find()) {
        Kind kind = Kind.valueOf(mark.group(1).toUpperCase(Locale.ROOT).replace('-', '_'));
        String expected = mark.group(2) == null ? "" : mark.group(2);
        marks.add(new Mark(kind, i + 1, kind == Kind.EXPECT ? expected : expected.strip()));
      }
    }
    String title = lines.get(start).substring("# ---".length()).strip();
    return new ScriptCase(
        file.getFileName() + ":" + (start + 1) + " " + title, text.toString(), marks);
  }
}
