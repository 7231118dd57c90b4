package org.pendant.desktop.tests;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.List;
import java.util.Optional;
import java.util.Queue;
import java.util.Set;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ConcurrentLinkedQueue;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import org.pendant.controller.ControllerOptions;
import org.pendant.controller.Drive;
import org.pendant.controller.state.ControllerState;
import org.pendant.kit.background.Background;
import org.pendant.recording.compare.TrackCurves;
import org.pendant.testing.TestId;
import org.pendant.testing.coverage.CoverageReport;
import org.pendant.testing.run.Goldens;
import org.pendant.testing.source.TestCase;

final class TestsPresenterTest {
  private final SortedMap<String, String> disk = new TreeMap<>();
  private final Queue<Runnable> work = new ArrayDeque<>();
  private final Queue<Runnable> told = new ConcurrentLinkedQueue<>();
  private boolean covered;
  private boolean differs;
  private boolean recorded;
  private Optional<String> folder = Optional.of("/cell");
  private Optional<String> unreadable = Optional.empty();
  private final TestsPresenter presenter =
      new TestsPresenter(
          () -> folder.map(name -> new TestSetup(new Files(name), ControllerOptions.headless())),
          new Later(),
          told::add,
          () -> 4711,
          () -> covered);

  /** Does nothing until it is asked to. */
  private final class Later implements TestsPresenter.Worker {
    @Override
    public <T> void run(Background.Task<T> task, Consumer<T> then, Consumer<IOException> failed) {
      work.add(
          () -> {
            try {
              T result = task.run();
              told.add(() -> then.accept(result));
            } catch (IOException e) {
              told.add(() -> failed.accept(e));
            }
          });
    }
  }

  private final class Files implements TestSetup.Files {
    private final String name;
    private final Set<String> read = ConcurrentHashMap.newKeySet();

    Files(String name) {
      this.name = name;
    }

    @Override
    public String folder() {
      return name;
    }

    @Override
    public List<String> find() throws IOException {
      if (unreadable.isPresent()) {
        throw new IOException(unreadable.get());
      }
      return disk.keySet().stream().filter(each -> each.endsWith("_test.script")).toList();
    }

    @Override
    public Goldens goldens(boolean update) {
      recorded |= update;
      return test -> new Compared();
    }

    @Override
    public Optional<TrackCurves> difference(TestId test) {
      return differs && test.function().equals("test_golden")
          ? Optional.of(new TrackCurves("Target of joint 1", "\u00b0", 1, List.of(), List.of()))
          : Optional.empty();
    }

    @Override
    public boolean hasRead(String file) {
      return read.contains(file);
    }

    @Override
    public byte[] read(String file) throws IOException {
      if (!disk.containsKey(file)) {
        throw new IOException("is not there");
      }
      read.add(file);
      return disk.get(file).getBytes(StandardCharsets.UTF_8);
    }
  }

  private final class Compared implements Goldens.Run {
    @Override
    public void begins(Drive drive) {}

    @Override
    public void sees(ControllerState state) {}

    @Override
    public Optional<Goldens.Problem> passed() {
      return differs && !recorded
          ? Optional.of(new Goldens.Problem("golden-differs", "it differs", 0, ""))
          : Optional.empty();
    }

    @Override
    public void close() {}
  }

  private void work() {
    while (!work.isEmpty()) {
      work.remove().run();
      hear();
    }
  }

  private void hear() {
    while (!told.isEmpty()) {
      told.remove().run();
    }
  }

  private void write(String name, String... lines) {
    disk.put(name, String.join("\n", lines) + "\n");
  }

  private void writeTwoFiles() {
    write(
        "grip_test.script",
        "def test_open():",
        "  assert_true(True)",
        "end",
        "def test_closed():",
        "  textmsg(\"half way\")",
        "  assert_equal(1, 2)",
        "end");
    write("sub/pick_test.script", "def test_pick():", "  sleep(0.5)", "end");
  }

  private String tree() {
    StringBuilder text = new StringBuilder();
    for (FoundFile file : presenter.files()) {
      text.append(TestWords.row(presenter, file)).append('\n');
      for (TestCase test : file.tests()) {
        text.append("  ").append(presenter.mark(test.id())).append(' ');
        text.append(TestWords.row(presenter, test).replaceAll("\\d\\.\\d{3} s", "T")).append('\n');
      }
    }
    return text.toString();
  }

  private TestCase test(String name) {
    return presenter.files().stream()
        .flatMap(file -> file.tests().stream())
        .filter(each -> each.id().name().equals(name))
        .findFirst()
        .orElseThrow();
  }

  @Test
  void testsAreFoundByFileBeforeAnyRuns() {
    writeTwoFiles();
    presenter.look();
    assertEquals("Looking for tests\u2026", TestWords.summary(presenter));
    work();
    assertEquals(
        """
        grip_test.script
          NEW test_open
          NEW test_closed
        sub/pick_test.script
          NEW test_pick
        """,
        tree());
    assertEquals("3 tests in 2 files", TestWords.summary(presenter));
    assertFalse(presenter.running());
  }

  @Test
  void allTestsRunAndTellTheirRobotTime() {
    writeTwoFiles();
    presenter.runAll();
    assertTrue(presenter.running());
    work();
    assertEquals(
        """
        grip_test.script   1 of 2 passed
          PASSED test_open   T
          RED test_closed   T
        sub/pick_test.script   1 of 1 passed
          PASSED test_pick   T
        """,
        tree());
    assertEquals("1 red, 2 passed", TestWords.summary(presenter));
    assertTrue(TestWords.more(presenter).contains("--seed 4711"));
    assertEquals(Optional.of(test("test_closed").id()), presenter.firstRed());
    assertEquals(TestMark.RED, presenter.mark(presenter.files().getFirst()));
  }

  @Test
  void whileNoTestIsChosenItIsToldWhatThereIsAndWhatCameOfTheLastRun() {
    writeTwoFiles();
    presenter.look();
    work();
    hear();
    String before = TestWords.overview(presenter);
    assertTrue(before.startsWith("3 tests in 2 files below /cell.\n\nRun all"), before);

    presenter.runAll();
    assertEquals("Looking for tests\u2026", TestWords.overview(presenter));
    work();
    hear();
    String after = TestWords.overview(presenter);
    assertTrue(after.contains("\nLast run: 1 red, 2 passed. Took "), after);
    assertTrue(after.contains("\ntest_closed   "), after);
  }

  @Test
  void resultsComeInWhileOthersStillWait() {
    writeTwoFiles();
    presenter.runAll();
    work.remove().run();
    told.remove().run();
    assertEquals("Running: 0 of 3 tests", TestWords.summary(presenter));
    assertEquals(TestMark.WAITING, presenter.mark(test("test_pick").id()));
    told.remove().run();
    assertEquals("Running: 1 of 3 tests", TestWords.summary(presenter));
    hear();
    assertFalse(presenter.running());
  }

  @Test
  void onlySelectedTestsRunAndTheOthersKeepTheirPlace() {
    writeTwoFiles();
    presenter.look();
    work();
    presenter.run(Set.of(test("test_pick").id()));
    work();
    assertEquals(
        """
        grip_test.script
          NEW test_open
          NEW test_closed
        sub/pick_test.script   1 of 1 passed
          PASSED test_pick   T
        """,
        tree());
  }

  @Test
  void aRedTestTellsWhatWasWrongWhereAndWhatWasLogged() {
    writeTwoFiles();
    presenter.runAll();
    work();
    String details = TestWords.details(presenter, test("test_closed"));
    assertTrue(
        details.startsWith(
            "assert_equal: is 1, must be 2\nat grip_test.script:6:3 in test_closed\n"),
        details);
    assertTrue(details.endsWith("  half way"), details);
    assertEquals(6, presenter.target(test("test_closed")).line());
  }

  @Test
  void aTestThatHoldsLeadsToItsDefinition() {
    writeTwoFiles();
    presenter.runAll();
    work();
    assertEquals(1, presenter.target(test("test_open")).line());
    assertEquals("sub/pick_test.script", presenter.target(test("test_pick")).file());
  }

  @Test
  void aFileThatCannotRunIsRedAndSaysWhy() {
    write("grip_test.script", "def test_open():", "  no_such_thing()", "end");
    presenter.runAll();
    work();
    FoundFile file = presenter.files().getFirst();
    assertEquals(TestMark.RED, presenter.mark(file));
    assertEquals("grip_test.script   cannot run", TestWords.row(presenter, file));
    assertTrue(TestWords.details(file).contains("grip_test.script:2:3: error: "));
    assertEquals("1 broken file, 0 passed", TestWords.summary(presenter));
  }

  @Test
  void afterStopNoMoreTestBegins() {
    writeTwoFiles();
    presenter.runAll();
    presenter.stop();
    assertEquals("Stopping\u2026", TestWords.summary(presenter));
    work();
    assertFalse(presenter.running());
    assertEquals("0 passed, 3 not run", TestWords.summary(presenter));
    assertEquals(TestMark.NEW, presenter.mark(test("test_open").id()));
  }

  @Test
  void whatTestsReachIsCountedWhileThatIsWanted() {
    write(
        "grip.script",
        "def grip():",
        "  if get_standard_digital_in(0):",
        "    sleep(0.1)",
        "  end",
        "end");
    write(
        "grip_test.script", "def test_a():", "  start(\"grip.script\")", "  wait_for_end()", "end");
    presenter.runAll();
    work();
    assertTrue(presenter.coverage().isEmpty());
    covered = true;
    presenter.runAll();
    work();
    CoverageReport report = presenter.coverage().orElseThrow();
    assertEquals("Coverage   50.0 % of statements", CoverageWords.row(report));
    CoveredFile file = CoveredFile.of(report).getFirst();
    assertEquals("grip.script   50.0 %", CoverageWords.row(file));
    assertEquals(
        """
        What the tests reach of grip.script
        Statements: 50.0 %, 1 of 2
        Ways of branches: 50.0 %, 1 of 2
        Truths of conditions: there are none
        Functions: 100 %, 1 of 1
        Lines that are not reached: 3\
        """,
        CoverageWords.details(file));
    assertEquals(3, file.firstMissing());
    assertEquals(1, presenter.reached(Path.of("/cell/grip.script")).orElseThrow().tests());
    covered = false;
    assertTrue(presenter.coverage().isEmpty());
  }

  @Test
  void aGoldenTestThatDiffersHasACurveUntilItIsRecordedAnew() {
    write("grip_test.script", "# @golden", "def test_golden():", "  sleep(0.1)", "end");
    differs = true;
    presenter.runAll();
    work();
    TestCase test = test("test_golden");
    assertEquals(TestMark.RED, presenter.mark(test.id()));
    assertEquals(
        "Target of joint 1", presenter.difference(test.id()).map(TrackCurves::what).orElse(""));
    assertEquals(GoldenOffer.REPLACE, GoldenOffer.of(presenter.result(test.id())));
    presenter.record(test.id());
    differs = false;
    work();
    assertTrue(recorded);
    assertEquals(TestMark.PASSED, presenter.mark(test.id()));
    assertTrue(presenter.difference(test.id()).isEmpty());
    assertEquals(GoldenOffer.NONE, GoldenOffer.of(presenter.result(test.id())));
  }

  @Test
  void theTestsOfAnotherFolderTakeTheirPlaceWhateverStillRuns() {
    writeTwoFiles();
    presenter.runAll();
    disk.clear();
    write("other_test.script", "def test_other():", "end");
    folder = Optional.of("/other");
    presenter.look();
    work();
    assertEquals("other_test.script\n  NEW test_other\n", tree());
  }

  @Test
  void aTestThatIsGoneIsForgotten() {
    writeTwoFiles();
    presenter.runAll();
    work();
    TestId gone = test("test_pick").id();
    disk.remove("sub/pick_test.script");
    presenter.look();
    work();
    assertTrue(presenter.result(gone).isEmpty());
    assertTrue(presenter.result(test("test_open").id()).isPresent());
  }

  @Test
  void whereThereIsNothingASentenceSaysWhatToDo() {
    presenter.look();
    work();
    assertEquals(
        "No tests yet: write functions that are called test_\u2026 in a file *_test.script in"
            + " /cell.",
        TestWords.empty(presenter));
    unreadable = Optional.of("/cell/private: no permission");
    presenter.look();
    work();
    assertEquals("Not found: /cell/private: no permission", TestWords.empty(presenter));
    folder = Optional.empty();
    presenter.look();
    work();
    assertEquals(
        "Tests are in files beside the program: save it first.", TestWords.empty(presenter));
    assertFalse(presenter.canRun());
  }
}
