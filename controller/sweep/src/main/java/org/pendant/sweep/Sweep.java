package org.pendant.sweep;

import static org.pendant.sweep.SweepFolderTexts.text;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SortedMap;
import java.util.SortedSet;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.BooleanSupplier;
import org.pendant.sweep.engine.Engine;
import org.pendant.sweep.engine.EngineException;
import org.pendant.sweep.engine.LocalEngine;
import org.pendant.sweep.engine.ResultSink;
import org.pendant.sweep.folder.KeptRuns;
import org.pendant.sweep.folder.ResultReader;
import org.pendant.sweep.folder.SweepFolder;
import org.pendant.sweep.folder.SweepFolderException;
import org.pendant.sweep.plan.PlanException;
import org.pendant.sweep.plan.SweepPlan;
import org.pendant.sweep.plan.SweepVariant;
import org.pendant.sweep.run.SweepJob;
import org.pendant.sweep.search.SweepSearch;
import org.pendant.sweep.table.ResultTable;

/**
 * Sweep: a plan, what runs it, and the folder that its results go to. Immutable: the same plan, run
 * anywhere, leaves the same bytes in the table.
 */
public final class Sweep {
  private final Path file;
  private final SweepJob job;
  private final ResultTable table;

  /** How a sweep begins in a folder. */
  public enum Start {
    /** In one without results; others are refused. */
    NEW,
    /** Behind the rows that there are, or with the first where there are none. */
    RESUME,
    /** With the first run; the results that there are are removed. */
    ANEW
  }

  private Sweep(Path file, SweepJob job) {
    this.file = file;
    this.job = job;
    table = ResultTable.of(job.plan());
  }

  /**
   * Reads a plan and all that it names.
   *
   * @throws PlanException with all that is wrong, each with its place
   */
  public static Sweep read(Path plan) throws PlanException {
    Sweep sweep = new Sweep(plan, SweepJob.read(plan));
    if (sweep.plan().search().isPresent()) {
      try {
        var _ = new SweepSearch(sweep.plan(), sweep.table);
      } catch (IllegalArgumentException e) {
        throw new PlanException(plan + ": error: [search]: " + e.getMessage());
      }
    }
    return sweep;
  }

  /** What runs, with which values. */
  public SweepPlan plan() {
    return job.plan();
  }

  /** Runs single variants. */
  public SweepJob job() {
    return job;
  }

  /** The columns of the results. */
  public ResultTable table() {
    return table;
  }

  /** The folder of the results, beside the plan, where nobody says otherwise. */
  public static Path folderOf(Path plan) {
    String name = plan.getFileName().toString();
    return plan.resolveSibling(name.replaceFirst("\\.toml$", "") + ".sweep");
  }

  /**
   * Threads of this process that run the variants.
   *
   * @param workers how many runs there are at a time, 1 or more
   */
  public Engine local(int workers) {
    return new LocalEngine(job, workers);
  }

  /**
   * Runs what is missing in a folder of results, and returns when all has run, or when it was
   * stopped. Whatever happens, the folder has whole rows that {@link Start#RESUME} goes on behind.
   *
   * @param stopped asked now and then, from the thread that calls this
   * @return how many rows there are then
   * @throws SweepFolderException if the folder has results that this cannot begin with
   * @throws IOException if the results cannot be written
   * @throws EngineException if nothing can be run any more
   */
  public long run(
      Path folder, Start start, Engine engine, SweepListener listener, BooleanSupplier stopped)
      throws IOException, SweepFolderException, EngineException {
    if (start == Start.ANEW) {
      SweepFolder.clear(folder);
    }
    long done;
    try (SweepFolder results =
        start == Start.RESUME && SweepFolder.begun(folder)
            ? SweepFolder.resume(folder, job)
            : SweepFolder.create(folder, file, job)) {
      listener.begin(results.next(), plan().size());
      ResultSink sink =
          result -> {
            List<Optional<Object>> row = table.row(result);
            results.add(row);
            listener.take(result, row);
          };
      done =
          plan().search().isPresent()
              ? new SearchLoop(plan(), results, engine).run(folder, sink, stopped)
              : engine.run(plan()::variant, results.next(), plan().size(), sink, stopped);
    }
    SweepFolder.writeParquet(folder, table);
    return done;
  }

  /** What a row tells of its run. */
  private record Row(SweepVariant variant, String digest) {}

  /**
   * The recording of a run, which is made by running its variant once more where it is not there.
   *
   * @throws SweepFolderException if the folder has no such row, or the run comes out otherwise
   */
  public Path record(Path folder, long run) throws IOException, SweepFolderException {
    return record(folder, new TreeSet<>(List.of(run))).getFirst();
  }

  /** As {@link #record(Path, long)}, of several runs. */
  public List<Path> record(Path folder, SortedSet<Long> runs)
      throws IOException, SweepFolderException {
    SortedMap<Long, Row> rows = rows(folder, runs);
    List<Path> files = new ArrayList<>();
    for (long run : runs) {
      if (!rows.containsKey(run)) {
        throw new SweepFolderException(text("noRow", folder, run));
      }
      files.add(KeptRuns.record(folder, job, rows.get(run).variant(), rows.get(run).digest()));
    }
    return files;
  }

  private SortedMap<Long, Row> rows(Path folder, SortedSet<Long> runs)
      throws IOException, SweepFolderException {
    SortedMap<Long, Row> found = new TreeMap<>();
    try (ResultReader rows = new ResultReader(folder.resolve(SweepFolder.RESULTS))) {
      int column =
          rows.column("digest")
              .orElseThrow(() -> new SweepFolderException(text("noDigests", folder)));
      Optional<List<String>> row = rows.next();
      while (row.isPresent() && found.size() < runs.size()) {
        long number = rows.rows() - 1;
        if (runs.contains(number)) {
          List<String> values = row.get().subList(1, 1 + plan().parameters().size());
          found.put(number, new Row(plan().variantOfRow(number, values), row.get().get(column)));
        }
        row = rows.next();
      }
    }
    return found;
  }

  /**
   * The sweep whose results are in a folder.
   *
   * @throws SweepFolderException if it is none, or its plan is not there any more
   * @throws PlanException if the plan or what it names has become wrong since
   */
  public static Sweep of(Path folder) throws IOException, SweepFolderException, PlanException {
    Path plan = SweepFolder.planOf(folder);
    if (!Files.isRegularFile(plan)) {
      throw new SweepFolderException(text("planGone", plan));
    }
    return read(plan);
  }
}
