package org.pendant.gui.log;

import java.io.IOException;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;

/** Messages as text. */
enum LogExport {
  /** A line a message; further lines of its text are indented. */
  TEXT {
    @Override
    String header() {
      return "";
    }

    @Override
    String row(LogLine line) {
      return String.format(
              Locale.ROOT,
              "%12.3f  %-7s  %-11s  %s",
              line.timeS(),
              line.severity(),
              line.source(),
              line.text().replace("\n", "\n" + " ".repeat(36)))
          + "\n";
    }
  },
  /** Comma-separated values (RFC 4180). */
  CSV {
    @Override
    String header() {
      return "time_s,severity,source,message\n";
    }

    @Override
    String row(LogLine line) {
      return String.format(
          Locale.ROOT,
          "%.3f,%s,%s,%s\n",
          line.timeS(),
          line.severity(),
          line.source(),
          quoted(line.text()));
    }
  };

  abstract String header();

  /** One message with the line end. */
  abstract String row(LogLine line);

  /** The form that the name of a file asks for. */
  static LogExport forFile(Path file) {
    return file.toString().toLowerCase(Locale.ROOT).endsWith(".csv") ? CSV : TEXT;
  }

  /** Writes messages to a file, which is created or emptied; not for the dispatch thread. */
  void write(List<LogLine> lines, Path file) throws IOException {
    try (Writer out = Files.newBufferedWriter(file, StandardCharsets.UTF_8)) {
      out.write(header());
      for (LogLine line : lines) {
        out.write(row(line));
      }
    }
  }

  private static String quoted(String text) {
    boolean plain = text.chars().noneMatch(c -> c == ',' || c == '"' || c == '\n' || c == '\r');
    return plain ? text : '"' + text.replace("\"", "\"\"") + '"';
  }
}
