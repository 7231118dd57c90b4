package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.SortedSet;
import java.util.TreeSet;
import org.pendant.command.text.CommandLanguage;
import org.pendant.controller.disk.AtomicFile;
import org.pendant.controller.disk.FileTrouble;
import org.pendant.sweep.Sweep;
import org.pendant.sweep.folder.KeptRuns;
import org.pendant.sweep.folder.ResultReader;
import org.pendant.sweep.folder.SweepFolder;
import org.pendant.sweep.folder.SweepFolderException;
import org.pendant.sweep.plan.PlanException;
import org.pendant.sweep.plan.SweepPlan;
import org.pendant.sweep.report.SweepReport;
import org.pendant.sweep.search.SweepSearch;
import org.pendant.sweep.table.ResultTable;

/** Sweep results: what {@code pendant sweep} does with a folder of them. */
final class SweepResults {
  private final DesktopServices services;

  /** What is done. */
  enum Action {
    REPORT,
    OPEN,
    RECORD;

    private String word() {
      return name().toLowerCase(Locale.ROOT);
    }
  }

  SweepResults(DesktopServices services) {
    this.services = services;
  }

  /** What the first operand asks for; empty where it is a plan. */
  static Optional<Action> action(List<String> operands) {
    return Arrays.stream(Action.values())
        .filter(each -> !operands.isEmpty() && operands.getFirst().equals(each.word()))
        .findFirst();
  }

  ExitCode run(Action action, Arguments arguments, Console console) throws UsageException {
    List<String> operands = arguments.operands();
    if (operands.size() < 2) {
      throw new UsageException(text("folderMissing", action.word()));
    }
    try {
      Path folder = Path.of(operands.get(1));
      List<String> rest = operands.subList(2, operands.size());
      return switch (action) {
        case REPORT -> report(folder, rest, console);
        case RECORD -> {
          record(folder, rest).forEach(each -> console.print("pendant open " + each));
          yield ExitCode.DONE;
        }
        case OPEN -> open(folder, rest, console);
      };
    } catch (InvalidPathException e) {
      throw new UsageException(text("notAFileName", operands.get(1), e.getReason()));
    } catch (SweepFolderException | PlanException e) {
      throw UsageException.fromEnglish(e);
    } catch (IOException e) {
      throw new UsageException(
          operands.get(1) + ": " + CommandLanguage.shown(FileTrouble.reason(e)));
    }
  }

  private static ExitCode report(Path folder, List<String> rest, Console console)
      throws UsageException, IOException, SweepFolderException {
    if (!rest.isEmpty()) {
      throw new UsageException(text("oneFolderExpected", rest.getFirst()));
    }
    Path page = folder.resolve(SweepFolder.REPORT);
    AtomicFile.write(page, SweepReport.of(folder).getBytes(StandardCharsets.UTF_8));
    console.print(text("reportIs", page));
    return ExitCode.DONE;
  }

  private ExitCode open(Path folder, List<String> runs, Console console)
      throws UsageException, IOException, SweepFolderException, PlanException {
    if (runs.size() != 1) {
      throw new UsageException(text("oneRunExpected", runs.size()));
    }
    OpenCommand open = new OpenCommand(services);
    String file = record(folder, runs).getFirst().toString();
    return open.run(Arguments.parse(open.options(), List.of(file)), console);
  }

  /** The recordings of some runs, which are made where they are not there. */
  private static List<Path> record(Path folder, List<String> runs)
      throws UsageException, IOException, SweepFolderException, PlanException {
    if (runs.isEmpty()) {
      throw new UsageException(text("runMissing"));
    }
    SortedSet<Long> numbers = new TreeSet<>();
    for (String each : runs) {
      if (!each.matches("\\d{1,18}")) {
        throw new UsageException(text("runMustBe", each));
      }
      numbers.add(Long.parseLong(each));
    }
    return Sweep.of(folder).record(folder, numbers);
  }

  /** The best run of a search, for people. */
  static List<String> best(Path folder, SweepPlan plan, ResultTable table)
      throws IOException, SweepFolderException {
    SweepSearch search = new SweepSearch(plan, table);
    List<String> best = List.of();
    try (ResultReader rows = new ResultReader(folder.resolve(SweepFolder.RESULTS))) {
      Optional<List<String>> row = rows.next();
      while (row.isPresent()) {
        search.take(row.get());
        best = search.best() == rows.rows() - 1 ? row.get() : best;
        row = rows.next();
      }
      if (best.isEmpty()) {
        return List.of();
      }
      String column = plan.search().orElseThrow().column();
      List<String> values = new ArrayList<>();
      for (int i = 0; i < plan.parameters().size(); i++) {
        values.add(plan.parameters().get(i).name() + " = " + best.get(1 + i));
      }
      return List.of(
          text(
              search.bestKeepsLimits() ? "bestRun" : "nearestRun",
              search.best(),
              column,
              best.get(rows.column(column).orElseThrow()),
              String.join(", ", values)));
    }
  }

  /** Writes the recordings that are wanted, and tells how each is opened. */
  static List<String> keep(Path folder, Sweep sweep, KeptRuns kept)
      throws IOException, SweepFolderException {
    SortedSet<Long> chosen;
    try (ResultReader reader = new ResultReader(folder.resolve(SweepFolder.RESULTS))) {
      chosen = kept.choose(reader);
    }
    List<String> told = new ArrayList<>();
    for (long run : chosen) {
      try {
        told.add("pendant open " + sweep.record(folder, run));
      } catch (SweepFolderException e) {
        // one that was refused has nothing to look at; the others are kept all the same
        told.add(text("notKept", e.getMessage()));
      }
    }
    return told;
  }
}
