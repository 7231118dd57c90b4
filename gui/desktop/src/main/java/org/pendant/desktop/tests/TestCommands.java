package org.pendant.desktop.tests;

import static org.pendant.desktop.tests.TestsTexts.text;

import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.ThreadLocalRandom;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import javax.swing.JMenuItem;
import javax.swing.JPopupMenu;
import javax.swing.KeyStroke;
import org.pendant.desktop.editor.ScriptEditor;
import org.pendant.desktop.editor.text.Place;
import org.pendant.desktop.session.ProgramDocument;
import org.pendant.desktop.session.Programs;
import org.pendant.desktop.workbench.Workbench;
import org.pendant.kit.action.Action;
import org.pendant.kit.settings.Settings;
import org.pendant.testing.TestPlace;
import org.pendant.testing.source.TestCase;

/** Test commands: what people can do with the tests that are shown. */
final class TestCommands {
  private static final String COVERAGE = "tests.coverage";
  private static final int MAX_SEED = 1_000_000;
  private static final Pattern PROBLEM = Pattern.compile("(.+?):(\\d{1,9}):(\\d{1,9}): .*");

  private final Workbench workbench;
  private final Programs programs;
  private final ScriptEditor editor;
  private final TestsPresenter presenter;
  private final TestsTree tree;
  private final CoverStrip strip;
  private final TestDebugger debugger;
  private final GoldenCard golden;
  private Runnable changed = () -> {};

  TestCommands(
      Workbench workbench,
      Programs programs,
      ScriptEditor editor,
      TestsPresenter presenter,
      TestsTree tree,
      CoverStrip strip,
      TestDebugger debugger,
      GoldenCard golden) {
    this.workbench = workbench;
    this.programs = programs;
    this.editor = editor;
    this.presenter = presenter;
    this.tree = tree;
    this.strip = strip;
    this.debugger = debugger;
    this.golden = golden;
  }

  /** Tells {@code listener} when one of them has done something. */
  void whenChanged(Runnable listener) {
    changed = listener;
  }

  /** Whether it is counted what tests reach. */
  static boolean covers(Settings settings) {
    return settings.get(COVERAGE).map(Boolean::parseBoolean).orElse(false);
  }

  private boolean covers() {
    return covers(workbench.settings());
  }

  void addActions() {
    String id = TestsView.ID;
    var actions = workbench.actions();
    actions.add(
        Action.of(
            id + ".run-all",
            text("testsRunAll"),
            "",
            () -> {
              workbench.show(id);
              runAll();
            }));
    actions.add(
        new Action(
            id + ".run-selected",
            text("testsRunSelected"),
            "",
            () -> presenter.canRun() && !tree.chosenTests().isEmpty(),
            this::runSelected));
    actions.add(
        new Action(
            id + ".debug", text("testsDebugTheSelectedOne"), "", this::canDebug, this::debug));
    actions.add(
        new Action(
            id + ".accept", text("testsAcceptTheNewRunOf"), "", golden::offers, this::accept));
    actions.add(
        new Action(
            id + ".stop",
            text("testsStop"),
            "",
            () -> presenter.running() || debugging().isPresent(),
            this::stop));
    actions.add(
        new Action(
            id + ".look",
            text("testsLookForTestsAgain"),
            "",
            () -> !presenter.running(),
            presenter::look));
    actions.add(
        Action.of(id + ".coverage", text("testsCoverage"), "", this::turnCoverage)
            .checked(this::covers));
    actions.add(
        new Action(
            id + ".next-uncovered",
            text("testsNextLineThatIsNot"),
            "",
            () -> strip.shows(programs.current()),
            this::nextUncovered));
  }

  void runAll() {
    presenter.runAll();
    changed.run();
  }

  void runSelected() {
    presenter.run(tree.chosenTests());
    changed.run();
  }

  /** Ends tests that run, and gives the one up that is debugged. */
  void stop() {
    presenter.stop();
    debugger.stop();
    changed.run();
  }

  /** The test that is debugged. */
  Optional<TestCase> debugging() {
    return debugger.test();
  }

  /** Whether one test is selected, and none is debugged. */
  boolean canDebug() {
    return debugging().isEmpty() && tree.selectedTest().isPresent();
  }

  /** Runs the selected test in the window. */
  void debug() {
    Optional<TestSetup> setup = presenter.setup();
    if (canDebug() && setup.isPresent()) {
      debugger.debug(
          setup.get(),
          tree.selectedTest().orElseThrow(),
          ThreadLocalRandom.current().nextInt(1, MAX_SEED));
      changed.run();
    }
  }

  private void accept() {
    workbench.show(TestsView.ID);
    golden.accept();
  }

  void turnCoverage() {
    workbench.settings().put(COVERAGE, String.valueOf(!covers()));
    strip.refresh();
    changed.run();
  }

  private void nextUncovered() {
    ProgramDocument program = programs.current();
    strip
        .next(program, editor.caretLine())
        .ifPresentOrElse(
            line -> {
              workbench.show(ScriptEditor.ID);
              editor.show(line, 1);
              editor.focus();
            },
            () -> workbench.notify(text("theTestsReachAllOf", program.name())));
  }

  /** What can be done with what is selected. */
  JPopupMenu menu() {
    JPopupMenu menu = new JPopupMenu();
    menu.setName("tests-menu");
    boolean runs = presenter.canRun() && !tree.chosenTests().isEmpty();
    add(menu, text("run"), "control ENTER", runs, this::runSelected);
    add(menu, text("debug"), "control shift ENTER", canDebug(), this::debug);
    add(menu, text("acceptAsGolden"), "", golden.offers(), golden::accept);
    menu.addSeparator();
    add(menu, text("goToTheLine"), "ENTER", tree.front().isPresent(), this::open);
    return menu;
  }

  private static void add(
      JPopupMenu menu, String text, String keys, boolean enabled, Runnable run) {
    JMenuItem item = new JMenuItem(text);
    item.setAccelerator(KeyStroke.getKeyStroke(keys));
    item.setEnabled(enabled);
    item.addActionListener(event -> run.run());
    menu.add(item);
  }

  /** Goes to what is selected. */
  void open() {
    tree.front()
        .ifPresent(
            each -> {
              switch (each) {
                case TestCase test -> go(presenter.target(test));
                case FoundFile file -> go(place(file));
                case CoveredFile file -> go(new TestPlace(file.name(), file.firstMissing(), 1, ""));
                default -> {}
              }
            });
  }

  /** Where the first problem of a file is, or else its beginning. */
  private static TestPlace place(FoundFile file) {
    for (String each : file.problems()) {
      Matcher form = PROBLEM.matcher(each);
      if (form.matches() && form.group(1).equals(file.name())) {
        return new TestPlace(
            file.name(), Integer.parseInt(form.group(2)), Integer.parseInt(form.group(3)), "");
      }
    }
    return new TestPlace(file.name(), 1, 1, "");
  }

  private void go(TestPlace place) {
    presenter
        .folder()
        .map(where -> Path.of(where).resolve(place.file()).normalize())
        .ifPresent(
            file ->
                editor.show(
                    new Place(
                        place.file(),
                        Optional.of(file),
                        place.line(),
                        Math.max(1, place.column()),
                        0,
                        "")));
  }
}
