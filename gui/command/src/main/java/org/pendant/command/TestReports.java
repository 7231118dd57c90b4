package org.pendant.command;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.pendant.controller.disk.FileTrouble;
import org.pendant.testing.SuiteResult;
import org.pendant.testing.report.HtmlReport;
import org.pendant.testing.report.JunitReport;
import org.pendant.testing.report.TapReport;

/**
 * Test reports: the files that {@code pendant test} writes. A file that is there is replaced where
 * it is an earlier report of its kind, and anything else with {@code --force} alone.
 *
 * @param junit the JUnit XML file
 * @param tap the TAP file
 * @param html the folder of the HTML report
 */
record TestReports(
    Optional<OutputFile> junit,
    Optional<OutputFile> tap,
    Optional<Path> html,
    TestFilesOnDisk files) {
  private static final int HEAD_BYTES = 512;

  static final Option JUNIT =
      Option.output("--junit", "FILE", "write JUnit XML, which CI systems read")
          .documented(
              "tests.xml",
              "write JUnit XML, which CI systems read; replaces an earlier report, see"
                  + " [testing-reports.md](testing-reports.md)");
  static final Option TAP =
      Option.output("--tap", "FILE", "write TAP version 14")
          .documented("tests.tap", "write TAP version 14; replaces an earlier report");
  static final Option HTML =
      Option.text("--html", "FOLDER", "write pages for people into a folder")
          .documented("report", "write pages for people into this folder, which is made");

  /** All of them. */
  static final List<Option> ALL = List.of(JUNIT, TAP, HTML, OutputFile.FORCE);

  static TestReports of(Arguments arguments, TestFilesOnDisk files) throws UsageException {
    return new TestReports(
        file(JUNIT, "<testsuites", arguments),
        file(TAP, "TAP version", arguments),
        html(arguments),
        files);
  }

  private static Optional<OutputFile> file(Option option, String mark, Arguments arguments)
      throws UsageException {
    Optional<String> name = arguments.value(option);
    if (name.isEmpty()) {
      return Optional.empty();
    }
    return Optional.of(
        isReport(name.get(), mark)
            ? OutputFile.replacing(option, name.get(), arguments)
            : OutputFile.of(option, name.get(), arguments));
  }

  private static boolean isReport(String name, String mark) {
    try (InputStream in = Files.newInputStream(Path.of(name))) {
      return new String(in.readNBytes(HEAD_BYTES), StandardCharsets.UTF_8).contains(mark);
    } catch (IOException | InvalidPathException e) {
      // what cannot be read is said where it is to be written
      return false;
    }
  }

  private static Optional<Path> html(Arguments arguments) throws UsageException {
    Optional<String> name = arguments.value(HTML);
    if (name.isEmpty()) {
      return Optional.empty();
    }
    try {
      Path folder = Path.of(name.get());
      if (Files.exists(folder) && !Files.isDirectory(folder)) {
        throw new UsageException("--html " + name.get() + " is a file, expected a folder");
      }
      return Optional.of(folder);
    } catch (InvalidPathException e) {
      throw new UsageException(name.get() + ": not a file name, " + e.getReason());
    }
  }

  /** Writes those that are asked for. */
  void write(SuiteResult result) throws UsageException {
    if (junit.isPresent()) {
      junit.get().write(out -> JunitReport.write(result, files::source, out));
    }
    if (tap.isPresent()) {
      tap.get().write(out -> TapReport.write(result, out));
    }
    if (html.isPresent()) {
      try {
        new HtmlReport(result, files::source, Map.of()).write(html.get());
      } catch (IOException e) {
        throw new UsageException(html.get() + ": cannot be written, " + FileTrouble.reason(e));
      }
    }
  }
}
