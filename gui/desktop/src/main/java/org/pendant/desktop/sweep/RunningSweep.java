package org.pendant.desktop.sweep;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.pendant.controller.disk.AtomicFile;
import org.pendant.controller.disk.FileTrouble;
import org.pendant.kit.fault.Faults;
import org.pendant.sweep.Sweep;
import org.pendant.sweep.SweepListener;
import org.pendant.sweep.engine.Engine;
import org.pendant.sweep.engine.EngineException;
import org.pendant.sweep.folder.ResultReader;
import org.pendant.sweep.folder.SweepFolder;
import org.pendant.sweep.folder.SweepFolderException;
import org.pendant.sweep.plan.PlanException;
import org.pendant.sweep.plan.PlanReader;
import org.pendant.sweep.plan.SweepPlan;
import org.pendant.sweep.run.SweepResult;

/**
 * Running sweep: a sweep in threads of its own, from its plan to the last row. Any thread may ask
 * how far it is.
 */
final class RunningSweep implements SweepListener {
  private final Order order;
  private final List<RunRow> fresh = new ArrayList<>();
  private volatile Optional<Sweep> sweep = Optional.empty();
  private volatile boolean cancelled;
  private volatile boolean ended;
  private volatile String trouble = "";
  private volatile long first;
  private volatile long size;
  private volatile long done;
  private volatile long beganNs;
  private volatile long lastNs;

  /**
   * What is to be run.
   *
   * @param plan the file of the plan
   * @param text what it is to say
   * @param folder of the results
   * @param start whether earlier results go on or go
   * @param workers how many runs there are at a time
   */
  record Order(Path plan, String text, Path folder, Sweep.Start start, int workers) {}

  RunningSweep(Order order) {
    this.order = order;
    size = 0;
  }

  Order order() {
    return order;
  }

  void begin() {
    Thread.ofPlatform().daemon().name("sweep").start(this::work);
  }

  private void work() {
    try {
      writePlan(order.plan(), order.text());
      Sweep read = Sweep.read(order.plan());
      sweep = Optional.of(read);
      if (order.start() == Sweep.Start.RESUME && SweepFolder.begun(order.folder())) {
        put(rowsOf(order.folder(), read, () -> cancelled));
      }
      try (Engine engine = read.local(order.workers())) {
        done = read.run(order.folder(), order.start(), engine, this, () -> cancelled);
      }
    } catch (SweepFolderException e) {
      trouble = e.earlier().map(this::inTheWay).orElse(e.getMessage());
    } catch (PlanException | EngineException e) {
      trouble = e.getMessage();
    } catch (IOException e) {
      trouble = order.folder() + ": " + FileTrouble.reason(e);
    } catch (RuntimeException | Error fault) {
      trouble = SweepTexts.text("internalError", fault);
      Faults.report(fault);
    } finally {
      ended = true;
    }
  }

  /** What the buttons of the window can do about results that are there already. */
  private String inTheWay(SweepFolderException.Earlier earlier) {
    return switch (earlier) {
      case ANY ->
          SweepTexts.text(
              "hasResults",
              order.folder(),
              SweepTexts.text("resume"),
              SweepTexts.text("startAnew"),
              SweepTexts.text("plan"));
      case OTHER ->
          SweepTexts.text(
              "hasOtherResults",
              order.folder(),
              SweepTexts.text("startAnew"),
              SweepTexts.text("plan"));
    };
  }

  /** Whether it is to end. */
  @FunctionalInterface
  interface Stopped {
    boolean now();
  }

  /** The rows that a folder has, as far as the window shows them. */
  static List<RunRow> rowsOf(Path folder, Sweep sweep, Stopped stopped)
      throws IOException, SweepFolderException {
    List<RunRow> rows = new ArrayList<>();
    Path results = folder.resolve(SweepFolder.RESULTS);
    try (ResultReader reader = new ResultReader(results)) {
      List<String> columns = sweep.table().columns().stream().map(each -> each.name()).toList();
      if (!reader.columns().equals(columns)) {
        throw new SweepFolderException(SweepTexts.text("hasOtherColumnsThanItsPlan", results));
      }
      Optional<List<String>> row = reader.next();
      while (row.isPresent() && rows.size() < RunRows.MAX_ROWS && !stopped.now()) {
        rows.add(RunRow.read(sweep.table().columns(), row.get()));
        row = reader.next();
      }
    }
    return rows;
  }

  /** Writes a plan, unless its file says the same; what it begins with as a comment stays. */
  static void writePlan(Path file, String text) throws IOException {
    StringBuilder comment = new StringBuilder();
    if (Files.exists(file)) {
      String old = Files.readString(file, StandardCharsets.UTF_8);
      if (means(old).equals(means(text)) && means(text).isPresent()) {
        return;
      }
      old.lines()
          .takeWhile(each -> each.startsWith("#"))
          .forEach(each -> comment.append(each).append('\n'));
    } else {
      comment.append("#   pendant sweep ").append(file.getFileName()).append('\n');
    }
    AtomicFile.write(file, (comment + text).getBytes(StandardCharsets.UTF_8));
  }

  /** The plan that a text is; empty where it is none. */
  static Optional<SweepPlan> means(String text) {
    try {
      return Optional.of(PlanReader.read("plan", text));
    } catch (PlanException e) {
      return Optional.empty();
    }
  }

  @Override
  public void begin(long already, long all) {
    beganNs = System.nanoTime();
    first = already;
    done = already;
    size = all;
  }

  @Override
  public void take(SweepResult result, List<Optional<Object>> row) {
    done = result.variant().number() + 1;
    lastNs = System.nanoTime();
    put(List.of(RunRow.of(sweep.orElseThrow().table().columns(), row)));
  }

  private void put(List<RunRow> rows) {
    synchronized (fresh) {
      // those that would not be shown are only counted
      fresh.addAll(rows);
    }
  }

  /** The rows that have come since the last call. */
  List<RunRow> takeRows() {
    synchronized (fresh) {
      List<RunRow> rows = List.copyOf(fresh);
      fresh.clear();
      return rows;
    }
  }

  /** Gives up what runs; what is done stays, and can go on. */
  void cancel() {
    cancelled = true;
  }

  boolean cancelled() {
    return cancelled;
  }

  boolean ended() {
    return ended;
  }

  /** Why it could not go on; empty if nothing went wrong. */
  String trouble() {
    return trouble;
  }

  /** What was read; empty before that. */
  Optional<Sweep> sweep() {
    return sweep;
  }

  /** How many runs have a row. */
  long done() {
    return done;
  }

  /** How many there are in all; 0 as long as that is not known. */
  long size() {
    return size;
  }

  /** Runs a second since it began; 0 before the first. */
  double perS() {
    // what comes behind the last row, such as Parquet, is no part of it
    long now = done == size || ended ? lastNs : System.nanoTime();
    double seconds = (now - beganNs) * 1e-9;
    return beganNs == 0 || seconds <= 0 ? 0 : (done - first) / seconds;
  }
}
