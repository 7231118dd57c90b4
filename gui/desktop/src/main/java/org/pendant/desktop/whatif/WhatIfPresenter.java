package org.pendant.desktop.whatif;

import static org.pendant.desktop.whatif.WhatIfTexts.text;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.concurrent.CancellationException;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.pendant.kit.fault.Faults;
import org.pendant.recording.replay.RerunRefused;
import org.pendant.recording.whatif.Variant;
import org.pendant.recording.whatif.VariantLimits;
import org.pendant.recording.whatif.VariantRun;
import org.pendant.script.vm.Program;

/**
 * What-if presenter: the variants that people compare, and what came of them. Only for the dispatch
 * thread; the variants run one after the other in a thread of their own.
 */
final class WhatIfPresenter {
  /** More are not told apart in a picture. */
  static final int MOST = 4;

  private final Source source;
  private final Supplier<Start> start;
  private final Executor dispatch;
  private final Executor work;
  private final Runnable changed;
  private final List<VariantRow> rows = new ArrayList<>();
  private final List<VariantResult> results = new ArrayList<>();
  private Optional<Batch> batch = Optional.empty();
  private Duration most = VariantLimits.STANDARD.robotTime();

  /** What the session can do. */
  interface Source {
    /** Prepares a run of a variant; without a frame it goes from the start of the last program. */
    VariantRun begin(OptionalLong frame, Variant variant, VariantLimits limits) throws RerunRefused;

    /** Compiles the program as it is edited now; one of both follows, in the dispatch thread. */
    void compile(Consumer<Program> then, Consumer<String> failed);
  }

  /**
   * Where variants begin.
   *
   * @param frame that is looked at; empty for the start of the last program
   * @param words what the button says that begins there
   * @param refusal why nothing can begin there; empty if something can
   */
  record Start(OptionalLong frame, String words, String refusal) {}

  /** Variants that run, until they are done or given up. */
  private static final class Batch {
    private volatile boolean cancelled;
    private volatile Optional<VariantRun> now = Optional.empty();

    void cancel() {
      cancelled = true;
      now.ifPresent(VariantRun::cancel);
    }
  }

  /** A row whose turn comes. */
  private record Job(int row, Variant variant) {}

  /**
   * Two variants to begin with.
   *
   * @param dispatch runs what comes later in the thread that uses this object
   * @param work runs what takes long
   * @param changed runs after each change of what there is to show
   */
  WhatIfPresenter(
      Source source, Supplier<Start> start, Executor dispatch, Executor work, Runnable changed) {
    this.source = source;
    this.start = start;
    this.dispatch = dispatch;
    this.work = work;
    this.changed = changed;
    put(VariantRow.AS_IT_RAN);
    put(new VariantRow(text("halfTheSpeed"), "50", "", false));
  }

  private void put(VariantRow row) {
    rows.add(row);
    results.add(new VariantResult.None());
  }

  List<VariantRow> rows() {
    return List.copyOf(rows);
  }

  /** What came of each row. */
  List<VariantResult> results() {
    return List.copyOf(results);
  }

  /** Where a run would begin now. */
  Start start() {
    return start.get();
  }

  /** How long variants run at most, robot time. */
  void setMost(Duration robotTime) {
    most = robotTime;
  }

  boolean running() {
    return batch.isPresent();
  }

  /** Why nothing can be run now; empty if it can. */
  String whyNot() {
    return running() ? text("theVariantsAreRunning") : start.get().refusal();
  }

  boolean canAdd() {
    return !running() && rows.size() < MOST;
  }

  boolean canRemove() {
    return !running() && rows.size() > 1;
  }

  /** One more, with the program as it is edited now. */
  void add() {
    if (canAdd()) {
      put(new VariantRow(text("asEditedName"), "", "", true));
      changed.run();
    }
  }

  void remove(int row) {
    if (canRemove() && row >= 0 && row < rows.size()) {
      rows.remove(row);
      results.remove(row);
      changed.run();
    }
  }

  /** Has a row be another one; what came of it goes, unless only its name has changed. */
  void change(int row, VariantRow wanted) {
    VariantRow old = rows.get(row);
    if (running() || old.equals(wanted)) {
      return;
    }
    rows.set(row, wanted);
    if (!old.named(wanted.name()).equals(wanted)) {
      results.set(row, new VariantResult.None());
    }
    changed.run();
  }

  /** Forgets what came of all. */
  void clear() {
    if (!running()) {
      results.replaceAll(_ -> new VariantResult.None());
      changed.run();
    }
  }

  /** Runs all of them. */
  void run() {
    Start from = start.get();
    if (!whyNot().isEmpty()) {
      return;
    }
    Batch begun = new Batch();
    batch = Optional.of(begun);
    results.replaceAll(_ -> new VariantResult.Waiting());
    changed.run();
    if (rows.stream().anyMatch(VariantRow::edited)) {
      source.compile(
          program -> launch(begun, from, Optional.of(program), ""),
          why -> launch(begun, from, Optional.empty(), why));
    } else {
      launch(begun, from, Optional.empty(), "");
    }
  }

  private void launch(Batch begun, Start from, Optional<Program> program, String why) {
    List<Job> jobs = new ArrayList<>();
    for (int i = 0; i < rows.size(); i++) {
      if (rows.get(i).edited() && program.isEmpty()) {
        results.set(i, new VariantResult.Refused(why));
      } else {
        jobs.add(new Job(i, rows.get(i).variant(program)));
      }
    }
    changed.run();
    VariantLimits limits = new VariantLimits(most, VariantLimits.STANDARD.wallTime());
    work.execute(() -> work(begun, from, jobs, limits));
  }

  private void work(Batch begun, Start from, List<Job> jobs, VariantLimits limits) {
    for (Job each : jobs) {
      if (!begun.cancelled) {
        VariantResult result = result(begun, from, each, limits);
        dispatch.execute(() -> set(each.row(), result));
      }
    }
    dispatch.execute(this::ended);
  }

  private VariantResult result(Batch begun, Start from, Job job, VariantLimits limits) {
    try {
      VariantRun run = source.begin(from.frame(), job.variant(), limits);
      begun.now = Optional.of(run);
      if (begun.cancelled) {
        return new VariantResult.None();
      }
      dispatch.execute(() -> set(job.row(), new VariantResult.Running(run)));
      return new VariantResult.Done(run.run());
    } catch (RerunRefused e) {
      return new VariantResult.Refused(e.getMessage());
    } catch (CancellationException _) {
      return new VariantResult.None();
    } catch (RuntimeException | Error fault) {
      Faults.report(fault);
      return new VariantResult.Refused(text("internalError", fault));
    }
  }

  private void set(int row, VariantResult result) {
    results.set(row, result);
    changed.run();
  }

  private void ended() {
    batch = Optional.empty();
    results.replaceAll(each -> each.open() ? new VariantResult.None() : each);
    changed.run();
  }

  /** Gives up what runs; what has come of others stays. */
  void cancel() {
    batch.ifPresent(Batch::cancel);
  }
}
