package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.ServiceLoader;
import org.pendant.command.text.CommandLanguage;
import org.pendant.controller.disk.FileTrouble;
import org.pendant.sweep.Sweep;
import org.pendant.sweep.engine.Engine;
import org.pendant.sweep.engine.EngineException;
import org.pendant.sweep.engine.EngineProvider;
import org.pendant.sweep.folder.KeptRuns;
import org.pendant.sweep.folder.ResultReader;
import org.pendant.sweep.folder.SweepFolder;
import org.pendant.sweep.folder.SweepFolderException;
import org.pendant.sweep.plan.PlanException;
import org.pendant.sweep.remote.JobArchive;
import org.pendant.sweep.table.ResultTable;
import org.pendant.sweep.table.RowCondition;

/**
 * Command {@code pendant sweep}: runs the variants of a plan on all cores; and what is done with
 * the results.
 */
final class SweepCommand implements Subcommand {
  /** A table of millions of rows is written once more at the end. */
  private static final int PATIENCE_S = 120;

  private final DesktopServices services;

  SweepCommand(DesktopServices services) {
    this.services = services;
  }

  @Override
  public String name() {
    return "sweep";
  }

  @Override
  public String operands() {
    return "PLAN.toml | report DIR | open DIR RUN | record DIR RUN...";
  }

  @Override
  public List<Option> options() {
    return SweepOptions.ALL;
  }

  @Override
  public ExitCode run(Arguments arguments, Console console) throws UsageException {
    Optional<SweepResults.Action> action = SweepResults.action(arguments.operands());
    if (action.isPresent()) {
      return new SweepResults(services).run(action.get(), arguments, console);
    }
    if (arguments.operands().size() != 1) {
      throw new UsageException(text("onePlanExpected", arguments.operands().size()));
    }
    Path plan = arguments.files().path("thePlan", arguments.operands().getFirst());
    SweepOptions options = SweepOptions.of(arguments, plan);
    try {
      Sweep sweep = Sweep.read(plan);
      Optional<EngineProvider> cluster = cluster(options);
      if (cluster.isEmpty() && options.onSpark()) {
        // what is wrong is told before Spark is started
        options.conditions(sweep.table());
        options.kept(sweep.table());
        JobArchive.check(plan, sweep.job());
        return new SparkSubmission(options.spark(), System.getenv())
            .run(options.wordsForSpark(plan), console);
      }
      return run(sweep, plan, cluster, options, console);
    } catch (PlanException e) {
      e.reports().forEach(console::complainInLines);
      return ExitCode.WRONG_USAGE;
    } catch (SweepFolderException e) {
      throw UsageException.fromEnglish(e);
    } catch (IOException e) {
      throw new UsageException(options.out() + ": " + CommandLanguage.shown(FileTrouble.reason(e)));
    } catch (EngineException e) {
      console.complain("pendant sweep: " + CommandLanguage.shown(e.getMessage()));
      return ExitCode.UNAVAILABLE;
    }
  }

  /** The engine of a cluster, in a process that was started for one. */
  private static Optional<EngineProvider> cluster(SweepOptions options)
      throws UsageException, EngineException {
    Optional<EngineProvider> found =
        ServiceLoader.load(EngineProvider.class).stream()
            .map(ServiceLoader.Provider::get)
            .filter(EngineProvider::available)
            .findFirst();
    if (found.isEmpty() && SparkSubmission.submitted()) {
      throw new EngineException(text("noEngineInJar"));
    }
    if (found.isPresent() && options.spark().firstGiven().isPresent()) {
      throw new UsageException(text("tooLateForSpark", options.spark().firstGiven().get()));
    }
    return found.filter(each -> options.engine().orElse(each.name()).equals(each.name()));
  }

  private static Engine engine(
      Sweep sweep, Path plan, Optional<EngineProvider> cluster, SweepOptions options)
      throws EngineException, PlanException {
    return cluster.isPresent()
        ? cluster.get().create(plan, sweep.job())
        : sweep.local(options.localWorkers());
  }

  private static ExitCode run(
      Sweep sweep,
      Path plan,
      Optional<EngineProvider> cluster,
      SweepOptions options,
      Console console)
      throws UsageException, IOException, SweepFolderException, EngineException, PlanException {
    ResultTable table = sweep.table();
    List<RowCondition> conditions = options.conditions(table);
    Optional<KeptRuns> kept = options.kept(table);
    try (Interruption interruption = Interruption.listen("theSweep", PATIENCE_S)) {
      if (SparkSubmission.submitted()) {
        interruption.listenToEndOf(System.in);
      }
      try (Engine engine = engine(sweep, plan, cluster, options)) {
        SweepProgress progress = new SweepProgress(console, engine.description(), interruption);
        long done =
            sweep.run(options.out(), options.start(), engine, progress, interruption::requested);
        progress.end(done, System.nanoTime());
      }
      SweepSummary summary = summary(options.out(), table, conditions);
      summary.lines().forEach(console::print);
      console.print("");
      console.print(text("resultsAre", options.out().resolve(SweepFolder.RESULTS)));
      if (kept.isPresent() && !interruption.requested()) {
        SweepResults.keep(options.out(), sweep, kept.get()).forEach(console::print);
      }
      if (interruption.requested()) {
        console.complain(text("sweepEndedEarly"));
      }
      if (sweep.plan().search().isPresent()) {
        SweepResults.best(options.out(), sweep.plan(), table).forEach(console::print);
      }
      summary.broken().forEach(each -> console.complain("pendant sweep: " + each));
      // Before the interruption is closed: after that the process may be gone at any moment.
      console.flush();
      return summary.allHold() ? ExitCode.DONE : ExitCode.LIMIT_EXCEEDED;
    }
  }

  /** Of the whole table: rows of an earlier process count as well. */
  private static SweepSummary summary(Path out, ResultTable table, List<RowCondition> conditions)
      throws IOException, SweepFolderException {
    try (ResultReader reader = new ResultReader(out.resolve(SweepFolder.RESULTS))) {
      SweepSummary summary = new SweepSummary(table, conditions);
      Optional<List<String>> row = reader.next();
      while (row.isPresent()) {
        summary.take(row.get());
        row = reader.next();
      }
      return summary;
    }
  }
}
