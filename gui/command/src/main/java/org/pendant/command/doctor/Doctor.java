package org.pendant.command.doctor;

import static org.pendant.command.doctor.DoctorTexts.text;

import java.util.ArrayList;
import java.util.List;
import java.util.ServiceLoader;
import java.util.function.Function;
import org.pendant.command.service.Version;
import org.pendant.text.TerminalColumns;

/** Doctor: looks at this computer for all that Pendant needs, and says what it means. */
public final class Doctor {
  private static final int SUBJECT_COLUMNS = 14;
  private static final int LEVEL_COLUMNS = 8;

  private final List<Inspection> inspections;

  private Doctor(List<Inspection> inspections) {
    this.inspections = List.copyOf(inspections);
  }

  /** One that looks at some things only. */
  public static Doctor of(Inspection... inspections) {
    return new Doctor(List.of(inspections));
  }

  /** One that looks at everything, what the desktop needs as far as it is on the class path. */
  public static Doctor ofThisComputer() {
    List<Inspection> all = new ArrayList<>();
    all.add(new JavaInspection());
    all.add(new DiskInspection());
    all.add(new CrashInspection(CrashLogs.folders(System.getenv())));
    ServiceLoader.load(Inspection.class).forEach(all::add);
    all.add(new SerialInspection());
    all.add(new PortInspection(StandardPort.ALL, new PortHolder()));
    return new Doctor(all);
  }

  /** Looks at everything; takes about a second. */
  public List<Finding> findings() {
    return inspections.stream().flatMap(each -> each.findings().stream()).toList();
  }

  /**
   * Findings as people read them, in the language of commands, with the version at the top and a
   * summary at the end.
   */
  public static List<String> lines(List<Finding> findings) {
    return lines(findings, FindingText::shown);
  }

  /** The same in English, whatever language commands speak. */
  static List<String> englishLines(List<Finding> findings) {
    return lines(findings, FindingText::english);
  }

  private static List<String> lines(List<Finding> findings, Function<FindingText, String> form) {
    List<String> lines = new ArrayList<>();
    lines.add(Version.line());
    lines.add("");
    for (Finding each : findings) {
      lines.add(
          padded(form.apply(words(each.level())), LEVEL_COLUMNS)
              + padded(form.apply(each.subject()), SUBJECT_COLUMNS)
              + form.apply(each.found()));
      String advice = form.apply(each.advice());
      if (!advice.isEmpty()) {
        lines.add(" ".repeat(LEVEL_COLUMNS + SUBJECT_COLUMNS) + advice);
      }
    }
    lines.add("");
    lines.add(form.apply(summary(findings)));
    return lines;
  }

  private static String padded(String text, int columns) {
    return text + " ".repeat(Math.max(1, columns - TerminalColumns.of(text)));
  }

  private static FindingText words(Finding.Level level) {
    return switch (level) {
      case OK -> text("ok");
      case NOTE -> text("note");
      case PROBLEM -> text("problem");
    };
  }

  private static FindingText summary(List<Finding> findings) {
    return text(
        "problemsAndNotes",
        problems(count(findings, Finding.Level.PROBLEM)),
        notes(count(findings, Finding.Level.NOTE)));
  }

  private static FindingText problems(long count) {
    return count == 0
        ? text("noProblems")
        : count == 1 ? text("oneProblem") : text("problems", count);
  }

  private static FindingText notes(long count) {
    return count == 0 ? text("noNotes") : count == 1 ? text("oneNote") : text("notes", count);
  }

  private static long count(List<Finding> findings, Finding.Level level) {
    return findings.stream().filter(each -> each.level() == level).count();
  }
}
