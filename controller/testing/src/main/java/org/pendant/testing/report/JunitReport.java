package org.pendant.testing.report;

import java.io.BufferedOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Collectors;
import javax.xml.stream.XMLOutputFactory;
import javax.xml.stream.XMLStreamException;
import javax.xml.stream.XMLStreamWriter;
import org.pendant.language.source.Source;
import org.pendant.testing.BrokenTestFile;
import org.pendant.testing.SuiteResult;
import org.pendant.testing.TestFailure;
import org.pendant.testing.TestPlace;
import org.pendant.testing.TestResult;
import org.pendant.testing.TestStatus;

/**
 * JUnit report: the XML that Jenkins, GitLab and actions of GitHub read. Each file of tests is a
 * suite. Times are robot time, so that the same results are the same bytes.
 *
 * <p>There is no standard; the elements and attributes are those of the schema of Jenkins, with the
 * {@code file} and {@code line} of a test case that GitLab and GitHub show.
 */
public final class JunitReport {
  private static final int OUTPUT_LINES = 1_000;
  private static final int OUTPUT_CHARACTERS = 64_000;

  private final XMLStreamWriter xml;
  private final SourceExcerpts excerpts;
  private int depth;

  /** How many test cases of a suite, or of all, came to what. */
  private record Counts(int tests, int failures, int errors, int skipped, double robotTimeS) {
    static Counts of(List<TestResult> results, int brokenFiles) {
      int failures = 0;
      int errors = brokenFiles;
      int skipped = 0;
      double robotTimeS = 0;
      for (TestResult each : results) {
        robotTimeS += each.robotTimeS();
        switch (each.status()) {
          case FAILED -> failures++;
          case ERROR, TIMED_OUT -> errors++;
          case SKIPPED -> skipped++;
          case PASSED -> {}
        }
      }
      return new Counts(results.size() + brokenFiles, failures, errors, skipped, robotTimeS);
    }
  }

  private JunitReport(XMLStreamWriter xml, SourceExcerpts excerpts) {
    this.xml = xml;
    this.excerpts = excerpts;
  }

  /**
   * Writes the text of the file, as UTF-8.
   *
   * @param sources the text of a file by its name in places, if it can be had
   * @param out is left open
   */
  public static void write(
      SuiteResult result, Function<String, Optional<Source>> sources, OutputStream out)
      throws IOException {
    try {
      OutputStream buffered = new BufferedOutputStream(out);
      XMLStreamWriter xml =
          XMLOutputFactory.newDefaultFactory()
              .createXMLStreamWriter(buffered, StandardCharsets.UTF_8.name());
      new JunitReport(xml, new SourceExcerpts(sources)).suites(result);
      xml.close();
      buffered.flush();
    } catch (XMLStreamException e) {
      throw e.getNestedException() instanceof IOException cause ? cause : new IOException(e);
    }
  }

  private void suites(SuiteResult result) throws XMLStreamException {
    xml.writeStartDocument("UTF-8", "1.0");
    begin("testsuites");
    attribute("name", "pendant test");
    counts(Counts.of(result.results(), result.broken().size()), false);
    Map<String, List<TestResult>> files = new LinkedHashMap<>();
    result
        .results()
        .forEach(each -> files.computeIfAbsent(each.id().file(), f -> new ArrayList<>()).add(each));
    for (Map.Entry<String, List<TestResult>> each : files.entrySet()) {
      suite(each.getKey(), result.seed(), Counts.of(each.getValue(), 0));
      String className = className(each.getKey());
      for (TestResult test : each.getValue()) {
        testCase(test, className);
      }
      warnings(result.warningsOf(each.getKey()));
      end();
    }
    for (BrokenTestFile each : result.broken()) {
      suite(each.file(), result.seed(), Counts.of(List.of(), 1));
      brokenFile(each);
      end();
    }
    end();
    xml.writeCharacters("\n");
    xml.writeEndDocument();
  }

  private void warnings(List<String> warnings) throws XMLStreamException {
    if (!warnings.isEmpty()) {
      begin("system-err");
      xml.writeCharacters(ReportText.warnings(warnings).collect(Collectors.joining("\n")));
      end();
    }
  }

  private void suite(String file, long seed, Counts counts) throws XMLStreamException {
    begin("testsuite");
    attribute("name", file);
    counts(counts, true);
    attribute("file", file);
    begin("properties");
    property("seed", Long.toString(seed));
    end();
  }

  private void counts(Counts counts, boolean withSkipped) throws XMLStreamException {
    attribute("tests", Integer.toString(counts.tests()));
    attribute("failures", Integer.toString(counts.failures()));
    attribute("errors", Integer.toString(counts.errors()));
    if (withSkipped) {
      attribute("skipped", Integer.toString(counts.skipped()));
    }
    attribute("time", ReportText.seconds(counts.robotTimeS()));
  }

  private void testCase(TestResult test, String className) throws XMLStreamException {
    ReportText.Output output = ReportText.output(test, OUTPUT_LINES, OUTPUT_CHARACTERS);
    boolean plain = test.status() == TestStatus.PASSED && test.tags().isEmpty();
    if (plain && output.lines().isEmpty()) {
      empty("testcase");
      testAttributes(test, className);
      return;
    }
    begin("testcase");
    testAttributes(test, className);
    if (!test.tags().isEmpty()) {
      begin("properties");
      for (String each : test.tags()) {
        property("tag", each);
      }
      end();
    }
    switch (test.status()) {
      case PASSED -> {}
      case SKIPPED -> {
        empty("skipped");
        attribute("message", test.skipped());
      }
      case FAILED -> red("failure", test);
      case ERROR, TIMED_OUT -> red("error", test);
    }
    if (!output.lines().isEmpty()) {
      String cut = output.left() > 0 ? "(" + output.title() + ")\n" : "";
      begin("system-out");
      endText(cut + String.join("\n", output.lines()) + "\n");
    }
    end();
  }

  private void testAttributes(TestResult test, String className) throws XMLStreamException {
    attribute("classname", className);
    attribute("name", test.id().name());
    attribute("time", ReportText.seconds(test.robotTimeS()));
    attribute("file", test.id().file());
    attribute("line", Integer.toString(line(test)));
  }

  /** Where it failed, if that is in the file of the test, else where the test begins. */
  private static int line(TestResult test) {
    return test.failure()
        .flatMap(TestFailure::place)
        .filter(each -> each.file().equals(test.id().file()))
        .map(TestPlace::line)
        .orElse(test.place().line());
  }

  private void red(String element, TestResult test) throws XMLStreamException {
    String code = test.failure().map(TestFailure::code).orElse(status(test.status()));
    begin(element);
    attribute("message", ReportText.message(test).getFirst());
    attribute("type", code);
    endText(String.join("\n", FailureText.lines(test, excerpts, ReportLanguage.ENGLISH)));
  }

  private static String status(TestStatus status) {
    return ReportText.status(status).replace(' ', '-');
  }

  private void brokenFile(BrokenTestFile broken) throws XMLStreamException {
    begin("testcase");
    attribute("classname", className(broken.file()));
    attribute("name", "(the file itself)");
    attribute("time", ReportText.seconds(0));
    attribute("file", broken.file());
    begin("error");
    attribute("message", "no test of the file could run");
    attribute("type", "broken-file");
    endText(String.join("\n", ReportText.problems(broken)));
    end();
  }

  /**
   * The name of a file as that of a class in a package, as Jenkins and GitLab group test cases:
   * {@code cell.pick_test} for {@code ../cell/pick_test.script}.
   */
  static String className(String file) {
    String path = file.replaceFirst("\\.[A-Za-z]+$", "");
    List<String> parts = new ArrayList<>();
    for (String each : path.split("[/\\\\]", -1)) {
      if (!each.isEmpty() && !each.equals(".") && !each.equals("..")) {
        parts.add(each.replace('.', '_'));
      }
    }
    return parts.isEmpty() ? "tests" : String.join(".", parts);
  }

  private void property(String name, String value) throws XMLStreamException {
    empty("property");
    attribute("name", name);
    attribute("value", value);
  }

  private void attribute(String name, String value) throws XMLStreamException {
    xml.writeAttribute(name, ReportText.line(value));
  }

  private void empty(String element) throws XMLStreamException {
    indent();
    xml.writeEmptyElement(element);
  }

  private void begin(String element) throws XMLStreamException {
    indent();
    xml.writeStartElement(element);
    depth++;
  }

  private void end() throws XMLStreamException {
    depth--;
    indent();
    xml.writeEndElement();
  }

  /** The text of an element and its end: it must not get blanks of ours. */
  private void endText(String text) throws XMLStreamException {
    depth--;
    xml.writeCharacters(text);
    xml.writeEndElement();
  }

  private void indent() throws XMLStreamException {
    xml.writeCharacters("\n" + "  ".repeat(depth));
  }
}
