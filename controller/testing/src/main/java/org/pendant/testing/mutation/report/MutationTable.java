package org.pendant.testing.mutation.report;

import java.util.ArrayList;
import java.util.List;
import org.pendant.language.source.Source;
import org.pendant.testing.mutation.Mutant;
import org.pendant.testing.mutation.MutantStatus;
import org.pendant.testing.mutation.MutatedFile;
import org.pendant.testing.mutation.Mutation;
import org.pendant.testing.mutation.MutationKind;
import org.pendant.testing.mutation.MutationReport;
import org.pendant.testing.mutation.MutationScore;
import org.pendant.text.Language;
import org.pendant.text.TerminalColumns;
import org.pendant.text.Texts;

/** Mutation table: a row for each file, and the mutants that no test has noticed. */
public final class MutationTable {
  /** How many survivors are told; more than that nobody reads on a terminal. */
  private static final int MAX_SURVIVORS = 100;

  private final Texts texts;

  private MutationTable(Texts texts) {
    this.texts = texts;
  }

  /** The table in English; its lines end with a line feed. */
  public static String of(MutationReport report) {
    return of(report, Texts.of(MutationTable.class, Language.ENGLISH));
  }

  /** The table in the language of {@code texts}, which are those of this package. */
  public static String of(MutationReport report, Texts texts) {
    return new MutationTable(texts).text(report);
  }

  private String text(MutationReport report) {
    StringBuilder text = new StringBuilder(head(report)).append('\n');
    if (!report.files().isEmpty()) {
      rows(report, text);
    }
    survivors(report, text);
    return text.toString();
  }

  /** How many mutants there are, and which have no place in the rows. */
  private String head(MutationReport report) {
    int tried = report.mutants() + report.notRun();
    String head =
        tried < report.places()
            ? texts.get(tried == 1 ? "oneMutantOf" : "mutantsOf", tried, report.places())
            : texts.get(tried == 1 ? "oneMutant" : "mutantCount", tried);
    if (report.notRun() > 0) {
      head = texts.get("interrupted", head, report.notRun());
    }
    long noPrograms =
        report.files().stream().mapToLong(each -> each.count(MutantStatus.NOT_COMPILED)).sum();
    return noPrograms > 0 ? texts.get("leftAside", head, noPrograms) : head;
  }

  private void rows(MutationReport report, StringBuilder text) {
    List<List<String>> rows = new ArrayList<>();
    rows.add(
        List.of(
            texts.get("file"),
            texts.get("mutants"),
            texts.get("killed"),
            texts.get("survived"),
            texts.get("notCovered"),
            texts.get("score")));
    report.files().forEach(file -> rows.add(row(file.source().name(), file.score())));
    if (report.files().size() > 1) {
      rows.add(row(texts.get("allFiles"), report.score()));
    }
    int[] widths = new int[rows.getFirst().size()];
    for (List<String> row : rows) {
      for (int i = 0; i < widths.length; i++) {
        widths[i] = Math.max(widths[i], TerminalColumns.of(row.get(i)));
      }
    }
    for (List<String> row : rows) {
      for (int i = 0; i < widths.length; i++) {
        String space = " ".repeat(widths[i] - TerminalColumns.of(row.get(i)));
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

  private void survivors(MutationReport report, StringBuilder text) {
    int told = 0;
    int more = 0;
    for (MutatedFile file : report.files()) {
      for (Mutant each : file.mutants()) {
        if (each.status() == MutantStatus.SURVIVED) {
          if (told < MAX_SURVIVORS) {
            text.append(told == 0 ? "\n" + texts.get("survivors") + "\n" : "");
            append(text, file.source(), each.mutation());
            told++;
          } else {
            more++;
          }
        }
      }
    }
    if (more > 0) {
      text.append(texts.get("moreSurvivors", more)).append('\n');
    }
  }

  private void append(StringBuilder text, Source source, Mutation mutation) {
    int start = mutation.range().start();
    String after = mutation.after(source);
    text.append(source.name())
        .append(':')
        .append(source.line(start))
        .append(':')
        .append(source.column(start))
        .append(": ")
        .append(texts.get(key(mutation.kind())))
        .append("\n  - ")
        .append(mutation.before(source))
        .append("\n  + ")
        .append(after.isEmpty() ? texts.get("leftOut") : after)
        .append('\n');
  }

  private static String key(MutationKind kind) {
    return switch (kind) {
      case COMPARISON -> "comparison";
      case CONDITION -> "condition";
      case LOGIC -> "logic";
      case ARITHMETIC -> "arithmetic";
      case CONSTANT -> "constant";
      case MOVE_DROPPED -> "moveDropped";
      case CALL_DROPPED -> "callDropped";
      case IO_SWAPPED -> "ioSwapped";
      case SPEED -> "speed";
      case PAYLOAD -> "payload";
      case RETURN -> "returnValue";
    };
  }
}
