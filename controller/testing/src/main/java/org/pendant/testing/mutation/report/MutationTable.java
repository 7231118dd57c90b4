package org.pendant.testing.mutation.report;

import java.util.ArrayList;
import java.util.List;
import org.pendant.language.source.Source;
import org.pendant.testing.mutation.Mutant;
import org.pendant.testing.mutation.MutantStatus;
import org.pendant.testing.mutation.MutatedFile;
import org.pendant.testing.mutation.Mutation;
import org.pendant.testing.mutation.MutationReport;
import org.pendant.testing.mutation.MutationScore;

/** Mutation table: a row for each file, and the mutants that no test has noticed. */
public final class MutationTable {
  private static final List<String> HEAD =
      List.of("file", "mutants", "killed", "survived", "not covered", "score");

  /** How many survivors are told; more than that nobody reads on a terminal. */
  private static final int MAX_SURVIVORS = 100;

  private MutationTable() {}

  /** The table; its lines end with a line feed. */
  public static String of(MutationReport report) {
    StringBuilder text = new StringBuilder();
    int tried = report.mutants() + report.notRun();
    text.append(count(tried, "mutant"));
    if (tried < report.places()) {
      text.append(" of ").append(report.places()).append(", chosen by the seed");
    }
    if (report.notRun() > 0) {
      text.append("; interrupted: ").append(report.notRun()).append(" not tried");
    }
    long noPrograms =
        report.files().stream().mapToLong(each -> each.count(MutantStatus.NOT_COMPILED)).sum();
    if (noPrograms > 0) {
      text.append("; ").append(noPrograms).append(" left aside that do not compile");
    }
    text.append('\n');
    if (!report.files().isEmpty()) {
      rows(report, text);
    }
    survivors(report, text);
    return text.toString();
  }

  private static String count(int number, String thing) {
    return number + " " + thing + (number == 1 ? "" : "s");
  }

  private static void rows(MutationReport report, StringBuilder text) {
    List<List<String>> rows = new ArrayList<>();
    rows.add(HEAD);
    report.files().forEach(file -> rows.add(row(file.source().name(), file.score())));
    if (report.files().size() > 1) {
      rows.add(row("all", report.score()));
    }
    int[] widths = new int[HEAD.size()];
    for (List<String> row : rows) {
      for (int i = 0; i < widths.length; i++) {
        widths[i] = Math.max(widths[i], row.get(i).length());
      }
    }
    for (List<String> row : rows) {
      for (int i = 0; i < widths.length; i++) {
        String space = " ".repeat(widths[i] - row.get(i).length());
        text.append(i == 0 ? row.get(i) + space : "  " + space + row.get(i));
      }
      text.append('\n');
    }
  }

  private static List<String> row(String name, MutationScore score) {
    return List.of(
        name,
        Long.toString(score.total()),
        Long.toString(score.killed()),
        Long.toString(score.survived()),
        Long.toString(score.notCovered()),
        score.text());
  }

  private static void survivors(MutationReport report, StringBuilder text) {
    int told = 0;
    int more = 0;
    for (MutatedFile file : report.files()) {
      for (Mutant each : file.mutants()) {
        if (each.status() == MutantStatus.SURVIVED) {
          if (told < MAX_SURVIVORS) {
            text.append(told == 0 ? "\nsurvived:\n" : "");
            append(text, file.source(), each.mutation());
            told++;
          } else {
            more++;
          }
        }
      }
    }
    if (more > 0) {
      text.append("and ").append(more).append(" more\n");
    }
  }

  private static void append(StringBuilder text, Source source, Mutation mutation) {
    int start = mutation.range().start();
    String after = mutation.after(source);
    text.append(source.name())
        .append(':')
        .append(source.line(start))
        .append(':')
        .append(source.column(start))
        .append(": ")
        .append(mutation.kind().text())
        .append("\n  - ")
        .append(mutation.before(source))
        .append("\n  + ")
        .append(after.isEmpty() ? "(left out)" : after)
        .append('\n');
  }
}
