package org.pendant.desktop.log;

import java.io.IOException;
import java.io.OutputStream;
import java.io.OutputStreamWriter;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import org.pendant.controller.disk.AtomicFile;
import org.pendant.language.source.VisibleText;

/**
 * Log export: messages as text, which may be shown on a terminal: control characters are written
 * out.
 */
enum LogExport {
  /** A line a message; further lines of its text are indented. */
  TEXT {
    @Override
    String header() {
      return "";
    }

    @Override
    String row(Row exported) {
      LogLine line = exported.line();
      String place = line.place().map(at -> line.thread() + ":" + exported.place()).orElse("");
      String head =
          String.format(
              Locale.ROOT,
              "%12s  %s  %-7s  %-10s  %-12s  ",
              line.timeText(),
              line.wallText(),
              line.severity(),
              line.source().title(),
              place);
      return head
          + VisibleText.of(line.text()).replace("\n", "\n" + " ".repeat(head.length()))
          + "\n";
    }
  },
  /** Comma-separated values (RFC 4180). */
  CSV {
    @Override
    String header() {
      return "time_s,wall_time,severity,source,code,thread,line,message\n";
    }

    @Override
    String row(Row exported) {
      LogLine line = exported.line();
      return String.join(
              ",",
              line.timeText(),
              line.isoText(),
              line.severity(),
              line.source().title(),
              quoted(line.code()),
              quoted(line.thread()),
              line.lineText(),
              quoted(VisibleText.of(line.text())))
          + "\n";
    }
  };

  /**
   * A message.
   *
   * @param place what stands beside it for where it comes from; files of values have the line
   */
  record Row(LogLine line, String place) {}

  abstract String header();

  /** One message with the line end. */
  abstract String row(Row row);

  /** The form that the name of a file asks for. */
  static LogExport forFile(Path file) {
    return file.toString().toLowerCase(Locale.ROOT).endsWith(".csv") ? CSV : TEXT;
  }

  /** Writes messages to a file, created or replaced as a whole; not for the dispatch thread. */
  void write(List<Row> rows, Path file) throws IOException {
    AtomicFile.write(file, out -> write(rows, out));
  }

  private void write(List<Row> rows, OutputStream file) throws IOException {
    try (Writer out = new OutputStreamWriter(file, StandardCharsets.UTF_8)) {
      out.write(header());
      for (Row each : rows) {
        out.write(row(each));
      }
    }
  }

  private static String quoted(String text) {
    boolean plain = text.chars().noneMatch(c -> c == ',' || c == '"' || c == '\n' || c == '\r');
    return plain ? text : '"' + text.replace("\"", "\"\"") + '"';
  }
}
