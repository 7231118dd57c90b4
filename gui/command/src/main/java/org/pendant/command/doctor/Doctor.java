package org.pendant.command.doctor;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.ServiceLoader;
import org.pendant.command.service.Version;

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

  /** Findings as people read them, with the version at the top and a summary at the end. */
  public static List<String> lines(List<Finding> findings) {
    List<String> lines = new ArrayList<>();
    lines.add(Version.line());
    lines.add("");
    for (Finding each : findings) {
      String level = each.level().name().toLowerCase(Locale.ROOT);
      lines.add(
          padded(level, LEVEL_COLUMNS) + padded(each.subject(), SUBJECT_COLUMNS) + each.found());
      if (!each.advice().isEmpty()) {
        lines.add(" ".repeat(LEVEL_COLUMNS + SUBJECT_COLUMNS) + each.advice());
      }
    }
    lines.add("");
    lines.add(summary(findings));
    return lines;
  }

  private static String padded(String text, int columns) {
    return text + " ".repeat(Math.max(1, columns - text.length()));
  }

  private static String summary(List<Finding> findings) {
    long problems = count(findings, Finding.Level.PROBLEM);
    long notes = count(findings, Finding.Level.NOTE);
    return "%s, %s".formatted(counted(problems, "problem"), counted(notes, "note"));
  }

  private static long count(List<Finding> findings, Finding.Level level) {
    return findings.stream().filter(each -> each.level() == level).count();
  }

  private static String counted(long count, String word) {
    return count == 1 ? "1 " + word : count == 0 ? "no " + word + "s" : count + " " + word + "s";
  }
}
