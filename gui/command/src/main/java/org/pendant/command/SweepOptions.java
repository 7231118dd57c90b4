package org.pendant.command;

import static org.pendant.command.CommandTexts.text;

import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.stream.Stream;
import org.pendant.command.text.CommandLanguage;
import org.pendant.sweep.Sweep;
import org.pendant.sweep.folder.KeptRuns;
import org.pendant.sweep.table.ResultTable;
import org.pendant.sweep.table.RowCondition;

/**
 * Options of {@code pendant sweep}.
 *
 * @param out the folder of the results
 * @param engine the name of the engine; empty for the one that there is
 * @param spark what the cluster is told
 * @param workers how many runs there are at a time; empty for one on each core
 * @param resume whether to go on with results that are there
 * @param force whether to begin anew where there are results
 * @param asserted conditions, as they were written
 * @param kept which recordings are kept, as it was written; empty for none
 */
record SweepOptions(
    Path out,
    Optional<String> engine,
    SparkOptions spark,
    OptionalInt workers,
    boolean resume,
    boolean force,
    List<String> asserted,
    Optional<String> kept) {
  private static final String SPARK = "spark";

  private static final String LOCAL = "local";
  private static final int MAX_WORKERS = 1024;

  private static final Option OUT =
      Option.text("--out", "DIR")
          .explained("--out.sweep")
          .documented(
              "results",
              "the folder of the results; default that of the plan with `.sweep` in place of"
                  + " `.toml`, beside the plan");
  private static final Option ENGINE =
      Option.of("--engine", new OptionArgument.Choice(LOCAL, SPARK))
          .documented(
              SPARK,
              "where the runs are: `local` on the cores of this machine, `spark` on the workers of"
                  + " [Apache Spark](sweeps.md#on-a-cluster); default `local`, and `spark` where"
                  + " `spark-submit` runs the command");
  private static final Option WORKERS =
      Option.of("--workers", new OptionArgument.Whole("N", 1, MAX_WORKERS))
          .documented("8", "how many runs there are at a time; default one for each core");
  private static final Option RESUME =
      Option.flag("--resume")
          .documented(
              "go on with the results that are in the folder: runs that have a row are not run"
                  + " again. Plan and files must be the same");
  private static final Option ASSERT =
      Option.text("--assert", "CONDITION")
          .repeated()
          .documented(
              "\"duration < 12\"",
              "what must hold for every run, or the exit code is 1: a column, `<`, `<=`, `>`, `>=`,"
                  + " `==` or `!=`, and a number or word; may be repeated");
  private static final Option KEEP =
      Option.text("--keep", "WHAT=N,...")
          .documented(
              "worst=5,failed=20",
              "recordings of runs, in `kept`: the first 20 that did not end by themselves, the 5"
                  + " that came nearest to a limit of torque or speed; a column, such as"
                  + " `duration=3`, for those with its largest numbers");
  private static final Option FORCE =
      Option.flag("--force")
          .explained("--force.sweep")
          .documented("begin anew in a folder that has results already");

  /** For the usage text. */
  static final List<Option> ALL =
      Stream.concat(
              Stream.of(OUT, WORKERS, RESUME, ASSERT, KEEP, FORCE, ENGINE),
              SparkOptions.ALL.stream())
          .toList();

  SweepOptions {
    asserted = List.copyOf(asserted);
  }

  static SweepOptions of(Arguments arguments, Path plan) throws UsageException {
    boolean resume = arguments.has(RESUME);
    boolean force = arguments.has(FORCE);
    if (resume && force) {
      throw new UsageException(text("resumeOrForce"));
    }
    SparkOptions spark = SparkOptions.of(arguments);
    Optional<String> engine = arguments.word(ENGINE);
    OptionalInt workers = arguments.whole(WORKERS);
    if (workers.isPresent() && engine.equals(Optional.of(SPARK))) {
      throw new UsageException(text("workersOfLocal"));
    }
    if (!engine.equals(Optional.of(SPARK)) && spark.firstGiven().isPresent()) {
      throw new UsageException(text("goesWithEngineSpark", spark.firstGiven().get()));
    }
    return new SweepOptions(
        out(arguments, plan),
        engine,
        spark,
        workers,
        resume,
        force,
        arguments.values(ASSERT),
        arguments.value(KEEP));
  }

  /** Whether it is to run on Spark. */
  boolean onSpark() {
    return engine.equals(Optional.of(SPARK));
  }

  /** The command line that runs a plan with the same options on Spark. */
  List<String> wordsForSpark(Path plan) {
    List<String> words =
        new ArrayList<>(List.of("sweep", ENGINE.name(), SPARK, OUT.name(), out.toString()));
    if (resume) {
      words.add(RESUME.name());
    }
    if (force) {
      words.add(FORCE.name());
    }
    for (String each : asserted) {
      words.addAll(List.of(ASSERT.name(), each));
    }
    kept.ifPresent(each -> words.addAll(List.of(KEEP.name(), each)));
    words.addAll(List.of("--", plan.toString()));
    return words;
  }

  /** How many runs there are at a time on this machine. */
  int localWorkers() {
    return workers.orElse(Math.min(MAX_WORKERS, Runtime.getRuntime().availableProcessors()));
  }

  private static Path out(Arguments arguments, Path plan) throws UsageException {
    String given = arguments.value(OUT).orElse("");
    if (given.isEmpty()) {
      return Sweep.folderOf(plan);
    }
    try {
      return Path.of(given);
    } catch (InvalidPathException e) {
      throw new UsageException(text("outNotAFileName", given, e.getReason()));
    }
  }

  /** How the sweep begins in its folder. */
  Sweep.Start start() {
    return force ? Sweep.Start.ANEW : resume ? Sweep.Start.RESUME : Sweep.Start.NEW;
  }

  /** The runs whose recordings are kept. */
  Optional<KeptRuns> kept(ResultTable table) throws UsageException {
    try {
      return kept.map(each -> KeptRuns.parse(each, table));
    } catch (IllegalArgumentException e) {
      throw new UsageException("--keep " + CommandLanguage.shown(e.getMessage()));
    }
  }

  /** The conditions on the rows of a table. */
  List<RowCondition> conditions(ResultTable table) throws UsageException {
    List<RowCondition> conditions = new ArrayList<>();
    for (String each : asserted) {
      try {
        conditions.add(RowCondition.parse(each, table.columns()));
      } catch (IllegalArgumentException e) {
        throw new UsageException("--assert " + CommandLanguage.shown(e.getMessage()));
      }
    }
    return conditions;
  }
}
