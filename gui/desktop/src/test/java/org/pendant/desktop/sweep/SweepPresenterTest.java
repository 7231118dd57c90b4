package org.pendant.desktop.sweep;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Consumer;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.pendant.desktop.sweep.DraftParameter.Part;
import org.pendant.kit.background.Background;
import org.pendant.sweep.Sweep;

final class SweepPresenterTest {
  @TempDir private Path folder;
  private final List<String> told = new ArrayList<>();
  private final List<Path> opened = new ArrayList<>();
  private final List<Path> unsaved = new ArrayList<>();
  private Optional<Path> program = Optional.empty();
  private SweepPresenter presenter;

  /** Everything at once, in this thread. */
  private static final class AtOnce implements SweepPresenter.Elsewhere {
    @Override
    public <T> void run(Background.Task<T> task, Consumer<T> then, Consumer<IOException> failed) {
      T result;
      try {
        result = task.run();
      } catch (IOException e) {
        failed.accept(e);
        return;
      }
      then.accept(result);
    }
  }

  @BeforeEach
  void begin() throws IOException {
    Path script = folder.resolve("nap.script");
    Files.writeString(script, "def nap():\n  LONG = 0.5\n  sleep(LONG)\nend\n");
    program = Optional.of(script);
    presenter =
        new SweepPresenter(
            () ->
                new SweepSubject(
                    "nap.script", program, Optional.empty(), Optional.empty(), "ur5e", unsaved),
            new AtOnce(),
            told::add,
            opened::add);
  }

  private void choose(String title, Part part, String text) {
    presenter.change(
        draft ->
            draft.withParameters(
                draft.parameters().stream()
                    .map(each -> each.title().equals(title) ? each.with(part, text) : each)
                    .toList()));
  }

  private RunRows ran(Sweep.Start start) {
    presenter.start(start);
    assertEquals("", presenter.trouble());
    assertTrue(presenter.runs());
    while (presenter.runs()) {
      LockSupport.parkNanos(1_000_000);
      presenter.look();
    }
    return presenter.shown().orElseThrow().rows();
  }

  @Test
  void theOpenProgramIsPlannedRunAndAnyRunIsOpened() throws IOException {
    presenter.planThis();
    assertEquals("Nothing is varied yet: tick one or more parameters", presenter.whyNotStart());
    choose("LONG", Part.STEPS, "3");
    assertEquals(3, presenter.check().plan().orElseThrow().size());
    RunRows rows = ran(Sweep.Start.NEW);
    assertEquals(3, rows.size());
    assertEquals("finished", rows.outcome(rows.get(2)));
    assertEquals(0.75, rows.get(2).number(rows.column("LONG")));
    assertEquals(3, presenter.running().orElseThrow().done());
    assertTrue(Files.readString(folder.resolve("nap.toml")).contains("variable LONG"));
    presenter.openRun(rows.get(2));
    assertEquals(List.of(folder.resolve("nap.sweep/kept/2.rec")), opened);
    assertTrue(Files.exists(opened.getFirst()));
    presenter.report(opened::add);
    assertEquals(folder.resolve("nap.sweep/report.html"), opened.getLast());
  }

  @Test
  void resultsInTheWayAreToldWithTheButtonsThatDealWithThem() throws IOException {
    presenter.planThis();
    choose("LONG", Part.STEPS, "2");
    ran(Sweep.Start.NEW);
    presenter.start(Sweep.Start.NEW);
    while (presenter.runs()) {
      LockSupport.parkNanos(1_000_000);
      presenter.look();
    }
    assertEquals(
        folder.resolve("nap.sweep")
            + " has results already: \"Resume\" goes on with them, \"Start anew\u2026\" under"
            + " \"Plan\" replaces them",
        presenter.trouble());
  }

  @Test
  void aFolderThatWasBegunWithoutARowIsBegunAnew() throws IOException {
    presenter.planThis();
    choose("LONG", Part.STEPS, "2");
    assertEquals(Sweep.Start.NEW, presenter.fromTheFirst());
    ran(Sweep.Start.NEW);
    Path results = folder.resolve("nap.sweep/results.csv");
    Files.writeString(results, Files.readString(results).lines().findFirst().orElseThrow() + "\n");
    begin();
    presenter.open(folder.resolve("nap.toml"));
    assertEquals(0, presenter.rowsThere());
    assertEquals(2, ran(presenter.fromTheFirst()).size());
  }

  @Test
  void aPlanThatWasNotSavedIsNotLostWhenOneIsWantedAgain() {
    presenter.planThis();
    choose("LONG", Part.STEPS, "3");
    presenter.planThis();
    assertEquals(3, presenter.check().plan().orElseThrow().size());
    presenter.save();
    presenter.planThis();
    assertEquals(folder.resolve("nap-2.toml"), presenter.draft().orElseThrow().files().plan());
    assertEquals(List.of(), presenter.draft().get().chosen());
  }

  @Test
  void aPlanIsOpenedWithItsResultsAndGoesOn() throws IOException {
    presenter.planThis();
    choose("LONG", Part.STEPS, "4");
    ran(Sweep.Start.NEW);
    Path results = folder.resolve("nap.sweep/results.csv");
    String whole = Files.readString(results);
    // as if the process had been killed behind the second row
    List<String> lines = whole.lines().toList();
    Files.writeString(results, String.join("\n", lines.subList(0, 3)) + "\n");
    String plan = "# mine\n" + Files.readString(folder.resolve("nap.toml"));
    Files.writeString(folder.resolve("nap.toml"), plan);
    begin();
    presenter.open(folder.resolve("nap.toml"));
    assertEquals(2, presenter.shown().orElseThrow().rows().size());
    assertEquals(2, presenter.rowsThere());
    assertTrue(presenter.canResume());
    choose("LONG", Part.STEPS, "5");
    assertFalse(presenter.canResume(), "of another plan");
    choose("LONG", Part.STEPS, "4");
    assertTrue(presenter.canResume());
    assertEquals("LONG", presenter.draft().orElseThrow().parameters().getFirst().title());
    presenter.start(Sweep.Start.RESUME);
    while (presenter.runs()) {
      LockSupport.parkNanos(1_000_000);
      presenter.look();
    }
    // a plan with another text is another one to the command, and so it is here
    assertEquals(
        folder.resolve("nap.sweep")
            + " has results of another plan, or of files that have changed since: \"Start"
            + " anew\u2026\" under \"Plan\" replaces them",
        presenter.trouble());
    Files.writeString(folder.resolve("nap.toml"), plan.replace("# mine\n", ""));
    assertEquals(4, ran(Sweep.Start.RESUME).size());
    assertFalse(presenter.canResume(), "all have run");
    assertEquals(whole, Files.readString(results));
  }

  @Test
  void aPlanThatIsChangedKeepsItsWordsAtTheTop() throws IOException {
    Path plan = folder.resolve("nap.toml");
    Files.writeString(
        plan,
        """
        # How long may it nap?
        program = "nap.script" # this one
        [[parameter]]
        set = "variable LONG"
        values = [0.1, 0.2]
        """);
    presenter.open(plan);
    String before = Files.readString(plan);
    presenter.save();
    assertEquals(before, Files.readString(plan), "says the same");
    choose("LONG", Part.VALUES, "0.1, 0.3");
    presenter.save();
    assertTrue(Files.readString(plan).startsWith("# How long may it nap?\nprogram = "));
    assertTrue(Files.readString(plan).contains("values = [0.1, 0.3]"));
  }

  @Test
  void aFileThatIsThereIsNotTakenForANewPlan() throws IOException {
    Files.writeString(folder.resolve("nap.toml"), "");
    presenter.planThis();
    assertEquals(folder.resolve("nap-2.toml"), presenter.draft().orElseThrow().files().plan());
    presenter.change(
        draft ->
            draft.with(
                new PlanDraft.Files(
                    folder.resolve("nap.toml"),
                    draft.files().program(),
                    draft.files().installation(),
                    draft.files().scene(),
                    draft.files().robot())));
    assertTrue(presenter.errors().get("plan-file").contains("exists already"));
  }

  @Test
  void whatIsNotSavedIsNotSwept() {
    presenter.planThis();
    choose("LONG", Part.STEPS, "3");
    assertEquals("", presenter.whyNotStart());
    unsaved.add(program.orElseThrow());
    assertTrue(presenter.whyNotStart().contains("not saved"));
    program = Optional.empty();
    assertTrue(presenter.whyNoPlan().contains("no file yet"));
  }

  @Test
  void aPlanThatIsWrongIsToldWithItsPlace() throws IOException {
    Path plan = folder.resolve("p.toml");
    Files.writeString(plan, "program = 3\n");
    presenter.open(plan);
    assertTrue(
        presenter.trouble().contains("p.toml:1:1: error: program is 3"), presenter.trouble());
    assertFalse(presenter.draft().isPresent());
  }

  @Test
  void aCancelledSweepKeepsItsRows() {
    presenter.planThis();
    choose("LONG", Part.STEPS, "2000");
    presenter.start(Sweep.Start.NEW);
    while (presenter.runs()) {
      LockSupport.parkNanos(1_000_000);
      presenter.look();
      if (presenter.shown().filter(each -> each.rows().size() > 3).isPresent()) {
        presenter.cancel();
      }
    }
    long done = presenter.running().orElseThrow().done();
    assertTrue(done > 3 && done < 2000, "done " + done);
    assertEquals(done, presenter.shown().orElseThrow().rows().size());
    assertEquals(done, presenter.rowsThere());
  }
}
