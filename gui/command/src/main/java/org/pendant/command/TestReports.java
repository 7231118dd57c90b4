package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import org.pendant.controller.disk.AtomicFile;
import org.pendant.controller.disk.FileTrouble;
import org.pendant.testing.SuiteResult;
import org.pendant.testing.TestId;
import org.pendant.testing.coverage.CoverageReport;
import org.pendant.testing.coverage.report.CoberturaCoverage;
import org.pendant.testing.coverage.report.HtmlCoverage;
import org.pendant.testing.coverage.report.LcovCoverage;
import org.pendant.testing.report.FailureAttachment;
import org.pendant.testing.report.FailurePlot;
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
 * @param lcov the file of coverage for lcov
 * @param cobertura the Cobertura XML file
 * @param coverageHtml the folder of the pages about coverage
 * @param recordings the folder of recordings of red tests
 */
record TestReports(
    Optional<OutputFile> junit,
    Optional<OutputFile> tap,
    Optional<Path> html,
    Optional<OutputFile> lcov,
    Optional<OutputFile> cobertura,
    Optional<Path> coverageHtml,
    Optional<Path> recordings,
    TestFilesOnDisk files) {
  private static final int HEAD_BYTES = 512;

  static final Option JUNIT =
      Option.output("--junit", "FILE")
          .documented(
              "tests.xml",
              "write JUnit XML, which CI systems read; replaces an earlier report, see"
                  + " [testing-reports.md](testing-reports.md)");
  static final Option TAP =
      Option.output("--tap", "FILE")
          .documented("tests.tap", "write TAP version 14; replaces an earlier report");
  static final Option COVERAGE =
      Option.flag("--coverage")
          .documented(
              "print what the tests reach of each program: statements, branches, conditions,"
                  + " functions, and the lines that are missing, see [coverage.md](coverage.md)");
  static final Option LCOV =
      Option.output("--lcov", "FILE")
          .documented("coverage.info", "write coverage as lcov and many editors read it");
  static final Option COBERTURA =
      Option.output("--cobertura", "FILE")
          .documented("coverage.xml", "write coverage as Cobertura XML, which CI systems read");
  static final Option COVERAGE_HTML =
      Option.text("--coverage-html", "FOLDER")
          .documented("coverage", "write coverage as pages for people into this folder");
  static final Option RECORD_ON_FAILURE =
      Option.text("--record-on-failure", "FOLDER")
          .documented(
              "red",
              "run each red test once more, exactly as it ran, and write a"
                  + " [recording](recording.md) of it into this folder, to open in the window; at"
                  + " most 20");
  static final Option HTML =
      Option.text("--html", "FOLDER")
          .explained("--html.test")
          .documented("report", "write pages for people into this folder, which is made");

  /** All of them. */
  static final List<Option> ALL =
      List.of(
          JUNIT,
          TAP,
          HTML,
          COVERAGE,
          LCOV,
          COBERTURA,
          COVERAGE_HTML,
          RECORD_ON_FAILURE,
          OutputFile.FORCE);

  static TestReports of(Arguments arguments, TestFilesOnDisk files) throws UsageException {
    return new TestReports(
        file(JUNIT, "<testsuites", arguments),
        file(TAP, "TAP version", arguments),
        folder(HTML, arguments),
        file(LCOV, "SF:", arguments),
        file(COBERTURA, "<coverage", arguments),
        folder(COVERAGE_HTML, arguments),
        folder(RECORD_ON_FAILURE, arguments),
        files);
  }

  /** The file of a report; {@code mark} stands in the beginning of an earlier one. */
  static Optional<OutputFile> file(Option option, String mark, Arguments arguments)
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

  private static Optional<Path> folder(Option option, Arguments arguments) throws UsageException {
    Optional<String> name = arguments.value(option);
    if (name.isEmpty()) {
      return Optional.empty();
    }
    try {
      Path folder = Path.of(name.get());
      if (Files.exists(folder) && !Files.isDirectory(folder)) {
        throw new UsageException(text("fileNotFolder", option.name(), name.get()));
      }
      return Optional.of(folder);
    } catch (InvalidPathException e) {
      throw new UsageException(text("notAFileName", name.get(), e.getReason()));
    }
  }

  /**
   * Writes those that are asked for.
   *
   * @param red makes recordings and pictures of red tests; empty where they cannot be run again
   */
  void write(SuiteResult result, Optional<RedTests> red) throws UsageException {
    if (recordings.isPresent() && red.isPresent()) {
      var _ = red.get().record(result, recordings.get(), "", false);
    }
    if (junit.isPresent()) {
      junit.get().write(out -> JunitReport.write(result, files::source, out));
    }
    if (tap.isPresent()) {
      tap.get().write(out -> TapReport.write(result, out));
    }
    if (html.isPresent()) {
      try {
        Map<TestId, List<FailureAttachment>> attached =
            red.isPresent() ? red.get().record(result, html.get(), "red/", true) : Map.of();
        Map<TestId, FailurePlot> plots = red.map(RedTests::plots).orElse(Map.of());
        new HtmlReport(result, files::source, attached, plots).write(html.get());
      } catch (IOException e) {
        throw new UsageException(text("cannotBeWritten", html.get(), FileTrouble.reason(e)));
      }
    }
  }

  /** Whether anything is asked for about coverage. */
  static boolean wantCoverage(Arguments arguments) {
    return Stream.of(COVERAGE, LCOV, COBERTURA, COVERAGE_HTML).anyMatch(arguments::has);
  }

  /** Writes the files about coverage that are asked for. */
  void write(CoverageReport coverage) throws UsageException {
    if (lcov.isPresent()) {
      String text = LcovCoverage.of(coverage);
      lcov.get().write(out -> out.write(text.getBytes(StandardCharsets.UTF_8)));
    }
    if (cobertura.isPresent()) {
      String text = CoberturaCoverage.of(coverage);
      cobertura.get().write(out -> out.write(text.getBytes(StandardCharsets.UTF_8)));
    }
    if (coverageHtml.isPresent()) {
      try {
        for (Map.Entry<String, String> page : HtmlCoverage.of(coverage).entrySet()) {
          AtomicFile.write(
              coverageHtml.get().resolve(page.getKey()),
              page.getValue().getBytes(StandardCharsets.UTF_8));
        }
      } catch (IOException e) {
        throw new UsageException(
            text("cannotBeWritten", coverageHtml.get(), FileTrouble.reason(e)));
      }
    }
  }
}
