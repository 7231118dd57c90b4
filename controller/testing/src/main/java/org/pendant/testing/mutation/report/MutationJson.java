package org.pendant.testing.mutation.report;

import java.io.BufferedWriter;
import java.io.IOException;
import java.io.OutputStream;
import java.io.OutputStreamWriter;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.Map;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.stream.Collectors;
import org.pendant.language.source.ByteText;
import org.pendant.language.source.Source;
import org.pendant.testing.TestId;
import org.pendant.testing.TestPlace;
import org.pendant.testing.TestResult;
import org.pendant.testing.mutation.Mutant;
import org.pendant.testing.mutation.MutantStatus;
import org.pendant.testing.mutation.MutatedFile;
import org.pendant.testing.mutation.Mutation;
import org.pendant.testing.mutation.MutationReport;

/**
 * Mutation JSON: mutants by version 2 of the schema of mutation-testing-elements, which viewers of
 * several languages read.
 */
public final class MutationJson {
  private final Writer out;
  private int number;

  private MutationJson(Writer out) {
    this.out = out;
  }

  /**
   * Writes the file, as UTF-8.
   *
   * @param tests all that ran
   * @param version of this program
   * @param stream is left open
   */
  public static void write(
      MutationReport report, List<TestResult> tests, String version, OutputStream stream)
      throws IOException {
    Writer writer = new BufferedWriter(new OutputStreamWriter(stream, StandardCharsets.UTF_8));
    MutationJson json = new MutationJson(writer);
    writer.write("{\"schemaVersion\": \"2\",\n");
    writer.write("\"framework\": {\"name\": \"Pendant\", \"version\": " + text(version) + "},\n");
    writer.write("\"thresholds\": {\"high\": 80, \"low\": 60},\n\"files\": {");
    String separator = "\n";
    for (MutatedFile file : report.files()) {
      writer.write(separator);
      separator = ",\n";
      json.file(file);
    }
    writer.write("},\n\"testFiles\": {");
    json.tests(tests);
    writer.write("}}\n");
    writer.flush();
  }

  private void file(MutatedFile file) throws IOException {
    Source source = file.source();
    out.write(text(source.name()));
    out.write(": {\"language\": \"python\", \"source\": ");
    out.write(text(ByteText.decoded(source.text())));
    out.write(", \"mutants\": [");
    String separator = "\n";
    for (Mutant each : file.mutants()) {
      out.write(separator);
      separator = ",\n";
      mutant(source, each);
    }
    out.write("]}");
  }

  private void mutant(Source source, Mutant mutant) throws IOException {
    Mutation mutation = mutant.mutation();
    number++;
    out.write("{\"id\": \"" + number + "\", \"mutatorName\": " + text(mutation.kind().text()));
    out.write(", \"replacement\": " + text(ByteText.decoded(mutation.replacement())));
    out.write(", \"location\": {\"start\": " + position(source, mutation.range().start()));
    out.write(", \"end\": " + position(source, mutation.range().end()) + "}");
    out.write(", \"status\": \"" + status(mutant.status()) + "\"");
    if (!mutant.reason().isEmpty()) {
      out.write(", \"statusReason\": " + text(mutant.reason()));
    }
    out.write(", \"coveredBy\": ");
    out.write(
        mutant.covering().stream()
            .map(each -> text(id(each)))
            .collect(Collectors.joining(", ", "[", "]")));
    if (mutant.killer().isPresent()) {
      out.write(", \"killedBy\": [" + text(id(mutant.killer().get())) + "]");
    }
    out.write("}");
  }

  private static String status(MutantStatus status) {
    return switch (status) {
      case KILLED -> "Killed";
      case TIMED_OUT -> "Timeout";
      case SURVIVED -> "Survived";
      case NOT_COVERED -> "NoCoverage";
      case NOT_COMPILED -> "CompileError";
    };
  }

  private static String position(Source source, int offset) {
    int line = source.line(offset);
    String before = source.text().substring(source.lineStart(line), offset);
    return "{\"line\": " + line + ", \"column\": " + (ByteText.decoded(before).length() + 1) + "}";
  }

  private static String id(TestId test) {
    return test.file() + ":" + test.name();
  }

  private void tests(List<TestResult> tests) throws IOException {
    SortedMap<String, List<TestResult>> files =
        tests.stream()
            .collect(
                Collectors.groupingBy(each -> each.id().file(), TreeMap::new, Collectors.toList()));
    String separator = "\n";
    for (Map.Entry<String, List<TestResult>> file : files.entrySet()) {
      out.write(separator);
      separator = ",\n";
      out.write(text(file.getKey()));
      out.write(": {\"tests\": ");
      out.write(
          file.getValue().stream()
              .map(MutationJson::test)
              .collect(Collectors.joining(",\n", "[\n", "]}")));
    }
  }

  private static String test(TestResult test) {
    TestPlace place = test.place();
    return "{\"id\": "
        + text(id(test.id()))
        + ", \"name\": "
        + text(test.id().name())
        + ", \"location\": {\"start\": {\"line\": "
        + place.line()
        + ", \"column\": "
        + Math.max(1, place.column())
        + "}}}";
  }

  private static String text(String value) {
    StringBuilder quoted = new StringBuilder("\"");
    for (int i = 0; i < value.length(); i++) {
      char c = value.charAt(i);
      switch (c) {
        case '"', '\\' -> quoted.append('\\').append(c);
        case '\n' -> quoted.append("\\n");
        default -> {
          if (c < ' ' || Character.isSurrogate(c)) {
            quoted.append(String.format("\\u%04x", (int) c));
          } else {
            quoted.append(c);
          }
        }
      }
    }
    return quoted.append('"').toString();
  }
}
