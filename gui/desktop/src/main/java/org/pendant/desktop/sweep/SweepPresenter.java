package org.pendant.desktop.sweep;

import static org.pendant.desktop.sweep.SweepTexts.text;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.function.UnaryOperator;
import org.pendant.controller.disk.AtomicFile;
import org.pendant.kit.background.Background;
import org.pendant.kit.text.Messages;
import org.pendant.models.arm.ArmLibrary;
import org.pendant.sweep.Sweep;
import org.pendant.sweep.folder.KeptRuns;
import org.pendant.sweep.folder.SweepFolder;
import org.pendant.sweep.folder.SweepFolderException;
import org.pendant.sweep.plan.PlanException;
import org.pendant.sweep.plan.PlanReader;
import org.pendant.sweep.plan.SweepPlan;
import org.pendant.sweep.report.SweepReport;
import org.pendant.sweep.run.ParameterOffer;
import org.pendant.sweep.run.ParameterOffers;
import org.pendant.sweep.run.ProgramNodes;

/**
 * Sweep presenter: the plan that people edit, the sweep that runs, and what came of it. Only for
 * the thread that shows it; files and runs are in others.
 */
final class SweepPresenter {
  private static final int MAX_NAMES = 1000;

  private final Supplier<SweepSubject> subject;
  private final Elsewhere elsewhere;
  private final Consumer<String> tell;
  private final Consumer<Path> opener;
  private Runnable changed = () -> {};
  private Optional<PlanDraft> draft = Optional.empty();
  private DraftCheck.Outcome check = new DraftCheck.Outcome(Optional.empty(), "", Map.of());
  private Optional<Path> known = Optional.empty();
  private Found found = Found.NOTHING;
  private Optional<RunningSweep> running = Optional.empty();
  private boolean over = true;
  private Optional<Shown> shown = Optional.empty();
  private String trouble = "";
  private boolean reading;
  private int workers = Math.max(1, Runtime.getRuntime().availableProcessors() - 1);

  /** Where slow work is done: as {@link Background#run}. */
  interface Elsewhere {
    /** Runs a task; its result or the reason of its failure comes back to this thread. */
    <T> void run(Background.Task<T> task, Consumer<T> then, Consumer<IOException> failed);
  }

  /**
   * What is on disk.
   *
   * @param plan the file that was looked for
   * @param there whether there is such a file
   * @param rows how many results there are beside it; 0 for none
   * @param of what these are of; empty where that cannot be read
   */
  record Found(Path plan, boolean there, boolean begun, long rows, Optional<SweepPlan> of) {
    static final Found NOTHING = new Found(Path.of(""), false, false, 0, Optional.empty());
  }

  /**
   * Results that are looked at.
   *
   * @param folder of the results
   * @param plan what they are of
   * @param file the plan
   * @param rows the table
   * @param nodes where lines of the program are in its tree; empty for scripts
   */
  record Shown(
      Path folder, Path file, SweepPlan plan, RunRows rows, Optional<ProgramNodes> nodes) {}

  SweepPresenter(
      Supplier<SweepSubject> subject,
      Elsewhere elsewhere,
      Consumer<String> tell,
      Consumer<Path> opener) {
    this.subject = subject;
    this.elsewhere = elsewhere;
    this.tell = tell;
    this.opener = opener;
  }

  /** {@code listener} runs after each change of what there is to show. */
  void whenChanged(Runnable listener) {
    changed = listener;
  }

  /** The plan; empty before there is one. */
  Optional<PlanDraft> draft() {
    return draft;
  }

  /** The plan that the draft means, or what is wrong with it. */
  DraftCheck.Outcome check() {
    return check;
  }

  /** What went wrong last; empty for nothing. */
  String trouble() {
    return Messages.shown(trouble);
  }

  /** Whether files are being read. */
  boolean reading() {
    return reading;
  }

  int workers() {
    return workers;
  }

  void setWorkers(int wanted) {
    workers = wanted;
  }

  /** The sweep that was started last. */
  Optional<RunningSweep> running() {
    return running;
  }

  boolean runs() {
    return running.isPresent() && !over;
  }

  /** The results that are looked at. */
  Optional<Shown> shown() {
    return shown;
  }

  /** Why no plan of the program in front can be made; empty if one can. */
  String whyNoPlan() {
    SweepSubject now = subject.get();
    return runs()
        ? text("aSweepIsRunning")
        : now.program().isEmpty() ? text("programWithoutFile", now.name()) : "";
  }

  /** Begins a plan of the program in front, unless one is being made that has no file yet. */
  void planThis() {
    SweepSubject now = subject.get();
    if (!whyNoPlan().isEmpty()) {
      trouble = whyNoPlan();
      changed.run();
      return;
    }
    Path program = now.program().orElseThrow();
    if (known.isEmpty()
        && draft.filter(each -> each.files().program().equals(program)).isPresent()) {
      changed.run();
      return;
    }
    reading = true;
    elsewhere.run(
        () -> freeName(program),
        plan -> {
          reading = false;
          known = Optional.empty();
          trouble = "";
          put(
              PlanDraft.of(
                  new PlanDraft.Files(
                      plan, program, now.installation(), now.scene(), now.robot())));
          readOffers();
        },
        this::failed);
  }

  private void failed(IOException failure) {
    reading = false;
    trouble = failure.getMessage();
    changed.run();
  }

  /** A name beside the program that no file has. */
  private static Path freeName(Path program) throws IOException {
    String bare = program.getFileName().toString().replaceFirst("\\.[^.]*$", "");
    for (int i = 1; i <= MAX_NAMES; i++) {
      Path plan = program.resolveSibling(bare + (i == 1 ? "" : "-" + i) + ".toml");
      if (Files.notExists(plan)) {
        return plan;
      }
    }
    throw new IOException(text("tooManyPlans", MAX_NAMES, program));
  }

  /** Takes another draft. */
  private void put(PlanDraft next) {
    draft = Optional.of(next);
    check = DraftCheck.of(next);
    if (!found.plan().equals(next.files().plan())) {
      lookForFiles();
    }
    changed.run();
  }

  /** Changes the draft. */
  void change(UnaryOperator<PlanDraft> how) {
    draft.ifPresent(each -> put(how.apply(each)));
  }

  /** Reads again what the program offers to vary. */
  void readOffers() {
    if (draft.isEmpty()) {
      return;
    }
    PlanDraft.Files files = draft.get().files();
    SweepPlan bare = DraftCheck.bare(draft.get());
    elsewhere.run(
        () -> offers(bare, folder(files.plan())),
        offers -> {
          if (draft.filter(each -> each.files().equals(files)).isPresent()) {
            trouble = "";
            put(draft.orElseThrow().offering(offers));
          }
        },
        this::failed);
  }

  private static Path folder(Path plan) {
    return plan.toAbsolutePath().getParent();
  }

  private static List<ParameterOffer> offers(SweepPlan plan, Path folder) throws IOException {
    try {
      return ParameterOffers.of(plan, folder);
    } catch (PlanException e) {
      throw new IOException(e.getMessage(), e);
    }
  }

  private record Opened(SweepPlan plan, Optional<Shown> results) {}

  /** Opens the file of a plan, with the results that it has. */
  void open(Path file) {
    if (runs()) {
      tell.accept(text("notOpenedASweepIsRunning"));
      return;
    }
    Path plan = file.toAbsolutePath().normalize();
    reading = true;
    changed.run();
    elsewhere.run(
        () -> opened(plan),
        opened -> {
          reading = false;
          trouble = "";
          known = Optional.of(plan);
          shown = opened.results();
          Path folder = folder(plan);
          found = Found.NOTHING;
          put(
              PlanDraft.of(
                  new PlanDraft.Files(
                      plan,
                      folder.resolve(opened.plan().program()).normalize(),
                      opened.plan().installation().map(each -> folder.resolve(each).normalize()),
                      opened.plan().scene().map(each -> folder.resolve(each).normalize()),
                      opened.plan().robot().orElse("")),
                  opened.plan()));
          readOffers();
        },
        this::failed);
  }

  private static Opened opened(Path file) throws IOException {
    try {
      byte[] bytes;
      try (InputStream in = Files.newInputStream(file)) {
        bytes = in.readNBytes(PlanReader.MAX_BYTES + 1);
      }
      if (bytes.length > PlanReader.MAX_BYTES) {
        throw new IOException(text("planTooLarge", file, PlanReader.MAX_BYTES));
      }
      SweepPlan plan = PlanReader.read(file.toString(), new String(bytes, StandardCharsets.UTF_8));
      Path folder = Sweep.folderOf(file);
      return new Opened(
          plan, SweepFolder.begun(folder) ? Optional.of(results(folder, file)) : Optional.empty());
    } catch (PlanException | SweepFolderException e) {
      throw new IOException(e.getMessage(), e);
    }
  }

  private static Shown results(Path folder, Path file)
      throws IOException, PlanException, SweepFolderException {
    Sweep sweep = Sweep.read(file);
    RunRows rows = new RunRows(sweep.table().columns());
    rows.add(RunningSweep.rowsOf(folder, sweep, () -> false));
    return new Shown(folder, file, sweep.plan(), rows, sweep.job().nodes());
  }

  /** Looks whether there are results already. */
  private void lookForFiles() {
    draft.ifPresent(
        each -> {
          Path plan = each.files().plan();
          elsewhere.run(
              () -> found(plan),
              now -> {
                found = now;
                changed.run();
              },
              failure -> {});
        });
  }

  private static Found found(Path plan) throws IOException {
    Path folder = Sweep.folderOf(plan);
    Path copy = folder.resolve(SweepFolder.PLAN);
    return new Found(
        plan,
        Files.exists(plan),
        SweepFolder.begun(folder),
        rows(folder),
        Files.exists(copy)
            ? RunningSweep.means(Files.readString(copy, StandardCharsets.UTF_8))
            : Optional.empty());
  }

  private static long rows(Path folder) throws IOException {
    if (!SweepFolder.begun(folder)) {
      return 0;
    }
    try (var lines = Files.lines(folder.resolve(SweepFolder.RESULTS))) {
      return Math.max(0, lines.count() - 1);
    }
  }

  /** How many results there are of the plan's file. */
  long rowsThere() {
    return draft.filter(each -> each.files().plan().equals(found.plan())).isPresent()
        ? found.rows()
        : 0;
  }

  /** How a sweep of the plan begins with its first run: without a row there is nothing to lose. */
  Sweep.Start fromTheFirst() {
    return draft.filter(each -> each.files().plan().equals(found.plan())).isPresent()
            && found.begun()
        ? Sweep.Start.ANEW
        : Sweep.Start.NEW;
  }

  /** Whether the results that there are can go on: they are of this plan, and not all of them. */
  boolean canResume() {
    return rowsThere() > 0
        && check.plan().isPresent()
        && check.plan().equals(found.of())
        && (check.plan().get().search().isPresent() || rowsThere() < check.plan().get().size());
  }

  /** All that is wrong, by the name of the field. */
  Map<String, String> errors() {
    Map<String, String> errors = new LinkedHashMap<>(check.errors());
    draft.ifPresent(
        each -> {
          Path plan = each.files().plan();
          if (!plan.getFileName().toString().endsWith(".toml")) {
            errors.put("plan-file", text("planNotToml", plan.getFileName()));
          } else if (found.plan().equals(plan)
              && found.there()
              && !known.equals(Optional.of(plan))) {
            errors.put("plan-file", text("planExists", plan.getFileName()));
          }
        });
    unsaved().ifPresent(file -> errors.put("program", text("unsavedChanges", file.getFileName())));
    return errors;
  }

  private Optional<Path> unsaved() {
    List<Path> used = new ArrayList<>();
    draft.ifPresent(
        each -> {
          used.add(each.files().program());
          each.files().installation().ifPresent(used::add);
          each.files().scene().ifPresent(used::add);
        });
    List<Path> changed =
        subject.get().unsaved().stream().map(each -> each.toAbsolutePath().normalize()).toList();
    return used.stream()
        .filter(each -> changed.contains(each.toAbsolutePath().normalize()))
        .findFirst();
  }

  /** Why the sweep cannot be started; empty if it can. */
  String whyNotStart() {
    if (runs()) {
      return text("theSweepIsRunning");
    }
    return draft.isEmpty()
        ? text("thereIsNoPlanYet")
        : errors().values().stream().findFirst().orElse("");
  }

  /** Writes the plan and runs it. */
  void start(Sweep.Start start) {
    if (!whyNotStart().isEmpty()) {
      return;
    }
    Path plan = draft.orElseThrow().files().plan();
    RunningSweep fresh =
        new RunningSweep(
            new RunningSweep.Order(plan, check.text(), Sweep.folderOf(plan), start, workers));
    running = Optional.of(fresh);
    over = false;
    trouble = "";
    known = Optional.of(plan);
    shown = Optional.empty();
    fresh.begin();
    changed.run();
  }

  /** Gives up what runs; what is done stays. */
  void cancel() {
    running.ifPresent(RunningSweep::cancel);
    changed.run();
  }

  /** Takes what has come of the sweep since the last call. */
  void look() {
    if (!runs()) {
      return;
    }
    RunningSweep now = running.orElseThrow();
    boolean ended = now.ended();
    if (shown.isEmpty()) {
      now.sweep()
          .ifPresent(
              each ->
                  shown =
                      Optional.of(
                          new Shown(
                              now.order().folder(),
                              now.order().plan(),
                              each.plan(),
                              new RunRows(each.table().columns()),
                              each.job().nodes())));
    }
    shown.ifPresent(each -> each.rows().add(now.takeRows()));
    if (ended) {
      over = true;
      trouble = now.trouble();
      lookForFiles();
    }
    changed.run();
  }

  /** Makes the recording of a run and opens it. */
  void openRun(RunRow row) {
    Shown of = shown.orElseThrow();
    tell.accept(text("runOnceMore", row.run()));
    elsewhere.run(
        () -> recorded(of, row),
        file -> {
          tell.accept(text("runRecorded", row.run(), file));
          opener.accept(file);
        },
        failure -> tell.accept(text("runCannotBeShown", row.run(), failure.getMessage())));
  }

  private static Path recorded(Shown of, RunRow row) throws IOException {
    try {
      List<String> cells = new ArrayList<>();
      for (int i = 0; i < of.plan().parameters().size(); i++) {
        cells.add(row.cell(1 + i));
      }
      return KeptRuns.record(
          of.folder(),
          Sweep.read(of.file()).job(),
          of.plan().variantOfRow(row.run(), cells),
          row.text(of.rows().column("digest")));
    } catch (PlanException | SweepFolderException e) {
      throw new IOException(e.getMessage(), e);
    }
  }

  /**
   * Writes the report of the rows that are on disk.
   *
   * @param then takes the page
   */
  void report(Consumer<Path> then) {
    Shown of = shown.orElseThrow();
    elsewhere.run(
        () -> {
          try {
            Path page = of.folder().resolve(SweepFolder.REPORT);
            AtomicFile.write(page, SweepReport.of(of.folder()).getBytes(StandardCharsets.UTF_8));
            return page;
          } catch (SweepFolderException e) {
            throw new IOException(e.getMessage(), e);
          }
        },
        then,
        failure -> tell.accept(text("noReport", failure.getMessage())));
  }

  /** Saves the plan without running it. */
  void save() {
    if (check.plan().isEmpty()) {
      return;
    }
    Path plan = draft.orElseThrow().files().plan();
    String text = check.text();
    elsewhere.run(
        () -> {
          RunningSweep.writePlan(plan, text);
          return plan;
        },
        file -> {
          known = Optional.of(file);
          lookForFiles();
          tell.accept(text("saved", file));
        },
        failure -> tell.accept(text("notSaved", failure.getMessage())));
  }

  /** The arms that there are, by name. */
  static List<String> arms() {
    return ArmLibrary.ids();
  }
}
